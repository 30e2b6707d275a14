"""Every code that a check of a program can give. They start with 0, to differ from those of frames, and are as stable.

The examples are whole images.
"""

from __future__ import annotations

from functools import partial

from ev3proto.checking.codes import FindingCode, Words, registered

PROGRAM_CODES: dict[str, FindingCode] = {}
"""The codes by name, in order."""

_code = partial(registered, PROGRAM_CODES)


def _image(
    main: str, sub: str = "0181 08 0A", *, locals_: int = 4, globals_: int = 4, offset: int = 0, count: int = 0
) -> bytes:
    """Returns an image with a thread and, if it has code, a subcall, from their codes in hex.

    `offset` is added to each header's own; `count` is the number of objects, even of those without code.
    """
    codes = [bytes.fromhex(text) for text in (main, sub) if text] or [b""] * count
    at = 16 + 12 * len(codes)
    table = b""
    for number, code in enumerate(codes):
        start = (at + offset).to_bytes(4, "little")
        table += start + bytes(2) + number.to_bytes(2, "little") + locals_.to_bytes(4, "little")
        at += len(code)
    head = b"LEGO" + at.to_bytes(4, "little") + b"\x6d\x00" + len(codes).to_bytes(2, "little")
    return head + globals_.to_bytes(4, "little") + table + b"".join(codes)


_FIX = "fix the operation, or what precedes it"
_FINE = _image("30 05 60 09 02 01 05 0A")

DAMAGED = _code(
    "E001",
    "the image is damaged",
    """
    The header does not match the file: it has no objects, or the file was cut off or partly overwritten. The brick
    does not start such a program.
    """,
    _FINE[:-1],
    _FINE,
    words=Words("{reason}", "give the whole image"),
)
REFUSED = _code(
    "E002",
    "the brick refuses the program",
    """
    Before it starts a program, the firmware reads all code from the end of the headers to the end of the image, object
    after object, wherever the headers say that the code is. One fault is enough to refuse the program: an unknown
    operation, a first constant out of range of its type, a misaligned variable, or bytes after the last object.
    Commands added after the release of 2013 are known if the image's version, 105 to 109, is of newer firmware.
    """,
    _image("30 05 60 DF 0A"),
    _FINE,
    words={
        "": Words("{operation} of object {object}: {reason}", _FIX),
        "newer": Words("{operation} of object {object}: {reason}; firmware of 2013 does not know it", _FIX),
    },
)
NO_SUCH_OBJECT = _code(
    "E003",
    "no such object",
    """
    Objects are numbered from 1 in the order of the table. The operation names one that the program does not have, so
    the brick reads its header from the bytes after the table.
    """,
    _image("05 03 0A"),
    _image("05 02 0A"),
    words=Words("{owner} is about object {number}, and the program has 1 to {count}", "give 1 to {count}"),
)
NOT_A_SUBCALL = _code(
    "E004",
    "a call of something that is not a subcall",
    """
    A subcall starts with a table of its parameters, which CALL reads. A thread or a block has none, and its first
    operations would be read as that table.
    """,
    _image("09 01 00 0A"),
    _FINE,
    words=Words(
        "object {number} is a {kind}, and only a subcall can be called",
        "start it with OBJECT_START, or call a subcall",
    ),
)
CALL_COUNT = _code(
    "E005",
    "a call with a wrong number of parameters",
    """
    CALL takes as many arguments as the subcall declares, whatever the call says: with fewer, the next operations are
    taken for arguments; with more, the extra arguments are taken for operations.
    """,
    _image("09 02 02 05 05 0A"),
    _FINE,
    words=Words("object {number} takes {declared}, not {given}", "give {declared}"),
)
CALL_OUTPUT = _code(
    "W006",
    "a constant for a subcall's output",
    """
    The subcall declares the parameter as an output, and writes it back when it returns. A value written into a constant
    is lost.
    """,
    _image("09 02 01 05 0A", "0141 08 0A"),
    _image("09 02 01 62 0A", "0141 08 0A"),
    words=Words("object {number} writes {name}, but the argument is a constant", "give a variable"),
)
OUTSIDE_MEMORY = _code(
    "E007",
    "a variable outside its memory",
    """
    The header of the image requests the bytes of globals, that of the object its locals. The variable ends beyond
    them: what the brick reads there belongs to something else, and what it writes destroys that.
    """,
    _image("30 05 64 0A"),
    _image("30 05 63 0A"),
    words=Words(
        "{name} ends at {scope} byte {end}, and there are {size}",
        "ask for {bytes} of {scope} memory, or use a lower index",
    ),
)
BAD_JUMP = _code(
    "E008",
    "a jump that leads to no operation",
    """
    A jump distance is counted from the end of its operation. This one leads into the middle of another operation, or
    out of the object, and the brick runs whatever bytes are there.
    """,
    _image("40 01 30 05 60 0A"),
    _image("40 03 30 05 60 0A"),
    words=Words(
        "{owner} leads to offset {target}, where no operation of object {number} starts",
        "let it lead to the start of an operation of the same object",
    ),
)
UNREACHABLE = _code(
    "W009",
    "unreachable operations",
    """
    They follow a jump or a return, and no jump leads to them: they never run. Either a label is at the wrong place,
    or they can be omitted.
    """,
    _image("40 03 30 05 60 0A"),
    _FINE,
    words=Words("no way leads to {owner}[ and what follows up to {last}]", "omit it, or let a jump lead there"),
)
NO_END = _code(
    "W010",
    "an object without its end",
    """
    An object ends with OBJECT_END, a subcall with RETURN before it. Without it the brick continues with the code of the
    next object. The validator accepts that: it continues there, too.
    """,
    _image("30 05 60", ""),
    _image("30 05 60 0A", ""),
    words=Words("object {number} does not end with OBJECT_END", "put an OBJECT_END after its last operation"),
)
LEFT_OVER = _code(
    "W011",
    "unused bytes",
    """
    There are bytes after the end of an object, or between the table and the first code. No compiler puts any
    there; a file written over a longer one may have some.
    """,
    _image("0A 01", ""),
    _image("0A", ""),
    words={
        "": Words("{bytes} {belong} to no object", "omit {them}"),
        "after the image": Words(
            "the header says that the image has {stated}; {more} more follow", "omit the last {bytes}"
        ),
    },
)
OTHER_CODE = _code(
    "W012",
    "an object whose header points elsewhere",
    """
    The firmware validates the code of one object after the other, in order, and runs what the headers point to. This
    header points to a place where no validated code begins, so the object does something else than what the verdict is
    about.
    """,
    _image("30 05 60 0A", "", offset=1),
    _image("30 05 60 0A", ""),
    words=Words(
        "the brick runs object {number} from offset {offset}[, and validates the code at {start}]",
        "let the header say where the code of the object is",
    ),
)
NOTHING_TO_RUN = _code(
    "W013",
    "nothing to run",
    """
    The firmware accepts a program without any code. Object 1, which starts with the program, has none.
    """,
    _image("", "", offset=0, count=1),
    _image("0A", ""),
    words=Words("the code of object 1, which is started with the program, is empty", "give it an operation"),
)
UNREAD = _code(
    "W014",
    "an operation that cannot be read",
    """
    The firmware's validator accepts an unknown CMD of a family, and takes what follows for the next operation. What
    the brick does when it runs it is not documented.
    """,
    _image("8D 1F 0A", ""),
    _FINE,
    words=Words(
        "the brick accepts object {number}, and what it runs here is unknown: {reason}",
        "use an operation that the firmware has",
    ),
)
UNKNOWN_JUMP = _code(
    "W015",
    "a jump that may lead anywhere",
    """
    The distance of this jump is in a variable, or behind a handle or an address. What runs then depends on numbers
    outside the code, so unreachable operations are not reported.
    """,
    _image("40 60 0A"),
    _image("40 00 0A"),
    words=Words(
        "{name} is not a number in the code, so the target of {owner} is unknown",
        "jump by a constant, or by a condition for each place",
    ),
)
