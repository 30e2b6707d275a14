"""Ours and not ours: when traffic is taken for this protocol, and when it is left to others.

The ports, channels and reports that bricks use belong to others as well: debuggers on TCP port 5555, file exchange on
RFCOMM channel 1, any other device on USB. So traffic is claimed by what it says, not by where it is found. The
dissector and the built-in reader of captures follow the same rule, and this module is where it stands:

- A frame is *flawless* when all of it can be read, by the instructions of some firmware, and it goes the right way: a
  command to the brick, a reply from it.
- A TCP connection is claimed when its data begin with the unlock text, with the answer to it, or with a flawless
  frame. After `STRANGE_PACKETS` packets with data that are none of these it is left alone.
- Bluetooth's channel and USB devices that nobody knows as bricks are claimed by a flawless command that makes sense:
  it has at least one operation, and none of those that nobody sends (`NEVER_SENT`). On USB a reply is taken when it
  answers a command, and what has faults once such a reply was seen. On Bluetooth a command may come in several packets,
  as long as the other side says nothing in between.
- On Bluetooth and USB the claim ends after `FAULTS_IN_A_ROW` packets without anything that can be a frame. The next one
  may begin.
- A datagram is a beacon when it begins like one. It is an answer to a beacon when it goes to a brick whose beacon was
  seen: to the port where the beacon came from, the one that it names, or the one for beacons.
- On other TCP ports connections are claimed by the unlock text, and where a beacon named the port.
"""

STRANGE_PACKETS = 8
"""Packets of a TCP connection without anything of ours after which it is left alone.

It is more than one, because a capture may begin inside a frame.
"""

FAULTS_IN_A_ROW = 3
"""Packets in a row that hold nothing like a frame, after which a claim of Bluetooth or USB ends."""

NEVER_SENT = ("ERROR",)
"""Operations that stand for a fault. The number of this one is that of the bytes of an empty report."""
