"""WiFi discovery: the ports, the lines of the beacon, and the texts exchanged before the first frame."""

BEACON_PORT = 3015
"""UDP port to which a brick broadcasts its beacon every few seconds."""

TCP_PORT = 5555
"""TCP port on which a brick listens, announced in its beacon."""

BEACON_LINES = {"serial": "Serial-Number", "port": "Port", "name": "Name", "protocol": "Protocol"}
"""The lines of a beacon, in order: name in this package, label in the text."""

PROTOCOL = "EV3"
"""The protocol named in the beacon and requested by the host."""

UNLOCK_REQUEST = "GET /target?sn="
"""Start of the host's first line; the brick's serial number follows."""

UNLOCK_VERSION = "VMTP1.0"
"""End of the host's first line, after a space that some senders omit; others omit all of it."""

UNLOCK_PROTOCOL = "Protocol:"
"""Start of the host's second line, before a space (which some senders omit) and the name of the protocol."""

MOST_UNLOCK = 128
"""Upper bound for the length of an unlock text, in bytes; a serial number has 12."""

UNLOCK_ENDINGS = 2
"""Maximum number of line ends after the second line: none, one, or one and an empty line."""

NOT_UNLOCKED = f"the connection begins without the unlock text ({UNLOCK_REQUEST}...): a brick ignores its commands"
"""What is said of a command on a connection whose beginning is known, without that text and without any reply."""

ACCEPT = b"Accept:EV340\r\n\r\n"
"""The brick's answer to the unlock text; the firmware also sends the zero after it."""
