"""WiFi discovery: the ports, the lines of the beacon, and the texts that go back and forth before any frame does."""

BEACON_PORT = 3015
"""UDP port to which a brick broadcasts its beacon every few seconds."""

TCP_PORT = 5555
"""TCP port on which a brick listens, as its beacon says."""

BEACON_LINES = {"serial": "Serial-Number", "port": "Port", "name": "Name", "protocol": "Protocol"}
"""The lines of a beacon in their order: what each is called here, and its label."""

PROTOCOL = "EV3"
"""The protocol that the beacon names and the host asks for."""

UNLOCK_REQUEST = "GET /target?sn="
"""What the host's first line begins with; the brick's serial number follows."""

UNLOCK_VERSION = "VMTP1.0"
"""What the host's first line ends with, after a space that some senders omit; some omit all of it."""

UNLOCK_PROTOCOL = "Protocol:"
"""What the host's second line begins with; after a space, which some senders omit, comes the name of the protocol."""

MOST_UNLOCK = 128
"""Bytes that an unlock text surely stays below: a serial number has 12."""

UNLOCK_ENDINGS = 2
"""Most line ends after the second line: none, one, or one and an empty line."""

ACCEPT = b"Accept:EV340\r\n\r\n"
"""What the brick answers to the unlock text; the firmware sends the zero after it too."""
