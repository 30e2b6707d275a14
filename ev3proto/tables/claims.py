"""Ours and not ours: when traffic is taken for this protocol, and when it is left to others.

The ports, channels and reports that bricks use belong to others as well: debuggers on TCP port 5555, file exchange on
RFCOMM channel 1, any other device on USB. So traffic is claimed by what it says, not by where it is found. The
dissector and the built-in reader of captures follow the same rule, and this module is where it stands:

- A frame is *flawless* when all of it can be read, by the instructions of some firmware, and it goes the right way: a
  command to the brick, a reply from it. Where it is to claim anything, it must make sense, too: zeros in others' data
  are direct commands without an operation, or with one that nobody sends (`NEVER_SENT`). And on TCP and Bluetooth it
  must not be what may be a telegram of LEGO's NXT, nor an error reply with memory, as the brick sends none.
- A TCP connection is claimed when its data begin with the unlock text, with the answer to it, or with a flawless
  frame. After `STRANGE_PACKETS` packets with data that are none of these it is left alone. Packets that have no more
  bytes than a frame's header do not count until they have more than a frame together: one may be cut into them.
- A flawless frame *tells* that it is ours when others' data hardly ever are like it: a system command, or a direct
  command with an operation from `FIRST_TELLING` on that is none of `NOT_TELLING`, and with variables, numbers and texts
  in their places. A frame that does not tell claims a TCP connection where it and other flawless frames are all that
  there is in the packet. Replies alone do not, after a strange packet from the brick's side, unless the packet before
  was replies as well. After a frame that tells there may be anything, if it begins with the packet; if it begins inside
  of it, frames. The reader, which can look back, also gives the frames with faults before it.
- Such a claim is *proven* by one of the texts, by a reply just as a command asked for it, or by flawless frames: each
  packet with some counts one, each telling operation one more, up to `MOST_PROOFS`, and `PROOFS` are enough. A claim
  that nothing has proven ends after `STRANGE_IN_A_ROW` packets in a row without a flawless frame, and then it takes two
  telling operations to claim the connection again. Where no frame told, the first strange packet ends it, but as many
  as that may be at the beginning of each side: what is left of a frame. Then one telling operation is enough.
- Not strange are up to `STRANGE_PACKETS` packets, counted anew after a frame that tells, that hold nothing but frames,
  with faults or in the wrong direction; `STRANGE_IN_A_ROW`, where there were only replies without a fault. Where no
  frame told, those before such a packet prove nothing. On TCP not strange either is the beginning of such a frame, from
  its header on, while there may be another, and after a gap, where the reader sees one, what may be left of a frame.
- Where the capture has only the beginning of a packet, on TCP, a frame that would end with the packet counts as one
  that does not tell, if there is no fault in what is there. It claims nothing if it has only a header, nor a direct
  command of which no operation is there, nor what the NXT may have sent.
- Bluetooth's channel is claimed like a TCP connection, but by a command alone, which may come in several packets, as
  long as the other side says nothing in between. A system command in several packets does not tell: it may have any
  bytes. After a command that tells there may be others, fewer than a header has. Such claims are proven and end as on
  TCP, but of packets too small to count there as many count as one as have more bytes than `STRANGE_PACKETS` headers
  together. The channel is never left alone: after `STRANGE_PACKETS` packets it takes two telling operations. A proven
  claim ends, too: after `FAULTS_IN_A_ROW` packets without anything that can be a frame, if they have more bytes than as
  many frames. What is left of a frame of which something is missing may come in many packets. The built-in reader,
  which can look back, takes the replies, too, with which a capture begins.
- USB devices that nobody knows as bricks are claimed by a flawless command. A reply is taken when it answers a command,
  and what has faults once such a reply was seen. After more than `ODD_REPORTS` reports that have a frame's length and
  not its type, or not the size of its type's reports, no command is taken either until a reply answers one; daisy
  messages in a computer's reports that are not taken count, too. In reports of a daisy chain, both ways, daisy messages
  are taken without any of that, and nothing else; so are the bootloader's faulty replies. The claim ends after
  `FAULTS_IN_A_ROW` packets without anything that can be a frame. The next one may begin.
- A datagram is a beacon when it begins with the labels of a beacon's first two lines, as far as it was captured, and
  names no other protocol. It is an answer to a beacon when it goes to a brick whose beacon was seen: to the port where
  the beacon came from, the one that it names, or the one for beacons.
- On other TCP ports connections are claimed by the unlock text, and where a beacon named the port.
"""

STRANGE_PACKETS = 8
"""Packets of a TCP connection without anything of ours after which it is left alone; of Bluetooth see above.

It is more than one, because a capture may begin inside a frame.
"""

FAULTS_IN_A_ROW = 3
"""Packets in a row that hold nothing like a frame, after which a claim of USB ends, and a proven one of Bluetooth."""

PROOFS = 8
"""How much of what flawless frames tell proves a claim."""

MOST_PROOFS = PROOFS // 2
"""How much of that a packet tells at most: in texts of others each letter may be an operation."""

STRANGE_IN_A_ROW = 2
"""Strange packets in a row after which a claim of TCP or Bluetooth ends that nothing has proven."""

FIRST_TELLING = "ADD8"
"""The operations before this one, whose numbers are the smallest, are in others' data by chance."""

NOT_TELLING = ("JR",)
"""Others that are in others' data by chance: 16,384, the size of many blocks, is one with its argument."""

SYSTEM_TELLS = 2
"""How many operations of a direct command a system command is worth."""

ODD_REPORTS = 2
"""USB reports that a device may have that begin with a frame's length and are none, before its commands alone claim it
no more."""

NEVER_SENT = ("ERROR",)
"""Opcodes that stand for a fault. The number of this one is that of the bytes of an empty report."""

NXT_REPLY_FLAG = 0x80
"""Set in the third byte of the NXT's telegrams that want no reply. Without it that byte is 0 for direct commands, 1 for
system commands and 2 for replies. The fourth byte is the command. In a frame these two are the message counter.
"""

NXT_DIRECT = 0
"""Third byte of the NXT's direct commands."""

NXT_SYSTEM = 1
"""Third byte of the NXT's system commands."""

NXT_REPLY = 2
"""Third byte of the NXT's replies."""

NXT_ANSWERED = (*range(0x06, 0x14), *range(0x80, 0x9C))
"""The NXT's commands whose replies are long enough to be a command of ours, which they are where they say success."""

NXT_LENGTHS = {0x02: 23, 0x03: 6, 0x04: 12}
"""Length fields of the NXT's direct commands that may be a command of ours, as they are long enough and have no
letter of a file's name in the place of the type."""

NXT_COUNTED = {0x09: 4, 0x0F: 5}
"""The same of messages and I2C data: this, and as many bytes as the sixth byte of the telegram says."""

NXT_COUNT_AT = 5
"""Offset of that byte."""

NXT_ANY_LENGTH = 0x83
"""The NXT's system command that writes a piece of a file."""


def may_be_of_nxt(telegram: bytes) -> bool:
    """Says whether a frame may be a telegram of LEGO's NXT, which uses the same channel and has the same length field.

    Args:
        telegram: All bytes of a frame that could be one of ours.

    Returns:
        True where the NXT has a command with these bytes in the place of the message counter, and with this length.

    """
    if len(telegram) <= NXT_COUNT_AT:
        return False
    length, kind, command = telegram[0] | telegram[1] << 8, telegram[2] & ~NXT_REPLY_FLAG, telegram[3]
    if kind == NXT_SYSTEM:
        return command == NXT_ANY_LENGTH
    if kind == NXT_REPLY:
        return command in NXT_ANSWERED
    if kind != NXT_DIRECT:
        return False
    if command in NXT_COUNTED:
        return length == NXT_COUNTED[command] + telegram[NXT_COUNT_AT]
    return NXT_LENGTHS.get(command) == length
