"""What was read in a few facts: what it is, how many frames it has, what is wrong. Words are up to others."""

from __future__ import annotations

from enum import StrEnum
from typing import NamedTuple

from ev3proto.checking.report import Report
from ev3proto.dialogue import Exchange
from ev3proto.messages import Message


class Subject(StrEnum):
    """What an input is."""

    EMPTY = "empty"  # without anything in it
    TEXT = "text"  # without a frame
    FILE = "file"  # without one, too
    MISTAKEN = "mistaken"  # operations with mistakes
    SOURCE = "source"  # of a program, with mistakes
    NO_HEADER = "no-header"  # operations
    NO_LENGTH = "no-length"  # a frame or a reply but for its length
    HALF_LENGTH = "half-length"  # a command whose length has one byte
    LETTERS = "letters"  # a frame but for letters that look like digits
    PART = "part"  # a frame up to a mistake in its text
    FRAME = "frame"
    REPLY = "reply"
    FRAMES = "frames"  # several of operations, or in a file of bytes
    LOG = "log"
    CAPTURE = "capture"
    PROGRAM = "program"


NOTHING = Exchange(Message())


class Headline(NamedTuple):
    """What is said first about an input.

    subject   what it is
    frames    their number; that of the objects of a program
    commands  those of its frames that go to the brick
    refused   those of them that the brick refuses
    wrong     those that it takes, but that have errors
    doubtful  those that it takes with no more than warnings
    failed    the replies that say that a command failed
    faulty    the replies with a fault, or with bytes after them
    unread    the number of its pieces that cannot be read
    read      the frames among which a filter chose; the bytes of a program
    exchange  its only message; NOTHING for none or several
    missing   bytes at the end of that message that the input has left out
    rest      the number of bytes after it
    worst     the report on the first of the worst frames, or on the program; None if there is nothing to report
    place     of that frame; empty for a frame by itself
    """

    subject: Subject
    frames: int = 0
    commands: int = 0
    refused: int = 0
    wrong: int = 0
    doubtful: int = 0
    failed: int = 0
    faulty: int = 0
    unread: int = 0
    read: int = 0
    exchange: Exchange = NOTHING
    missing: int = 0
    rest: int = 0
    worst: Report | None = None
    place: str = ""


class Proposal(NamedTuple):
    """What was probably meant by a piece of an input.

    kind    of the slip, as in `checking.slips`; `letters`, `name`, `shorter` or `all` for a change of other kinds
    line    of the text that changes, from 1 on; 0 for several
    before  what is there: the bytes of a frame, or a name
    after   what was meant
    text    the whole input with it
    """

    kind: str
    line: int
    before: bytes | str
    after: bytes | str
    text: str
