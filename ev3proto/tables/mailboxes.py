"""Mailboxes: their capacity, and the three kinds of messages that EV3-G programs send and expect.

A frame carries the bytes of a message, but not its kind. All clients follow the blocks of EV3-G: a text is ISO-8859-1
with a zero at its end, a number is a single (4 bytes), a logic value is one byte, 0 or 1. More than one can fit.
"""

import math
import struct

from ev3proto.tables.encoding import STRING_CODING

BOXES = 30
"""Numbered from 0."""

MOST_NAME = 49
"""Bytes of a name without its zero."""

MOST_CONTENT = 250
"""Bytes of a message. WRITEMAILBOX has no limit of its own: a longer message overwrites the next mailbox."""

TEXT_MESSAGE = "text"
NUMBER_MESSAGE = "number"
LOGIC_MESSAGE = "logic"

Reading = str | float | bool

_MOST_NUMBER = 1e9
_USUAL_FLOAT = (1e-4, 1e7)
_MOST_USUAL_INTEGER = 1_000_000
_NUMBER = struct.Struct("<f")
_LOGIC = {b"\0": False, b"\1": True}
_OTHER_NUMBERS = (
    ("a big-endian float", struct.Struct(">f")),
    ("a whole number of 4 bytes", struct.Struct("<i")),
    ("a big-endian whole number of 4 bytes", struct.Struct(">i")),
    ("a double", struct.Struct("<d")),
    ("a big-endian double", struct.Struct(">d")),
    ("a whole number of 8 bytes", struct.Struct("<q")),
    ("a whole number of 2 bytes", struct.Struct("<h")),
    ("a big-endian whole number of 2 bytes", struct.Struct(">h")),
)
"""How other libraries write numbers: the first one that gives a usual number is likeliest."""

_PRINTABLE = frozenset({*range(0x20, 0x7F), *range(0xA0, 0x100)})


def readings(payload: bytes) -> dict[str, Reading]:
    """Returns each reading that fits a message: `{"number": 1.5}`, `{"text": "hi"}`, `{"logic": True}`.

    One byte 0 or 1 is a logic value, 4 bytes are a number. Bytes that end in their only zero are a text; 4
    bytes only if the first three are printable.
    """
    found: dict[str, Reading] = {}
    if payload in _LOGIC:
        found[LOGIC_MESSAGE] = _LOGIC[payload]
    is_number = len(payload) == _NUMBER.size
    if is_number:
        (found[NUMBER_MESSAGE],) = _NUMBER.unpack(payload)
    text, zero, rest = payload.partition(b"\0")
    if zero and not rest and (not is_number or is_printable(text)):
        found[TEXT_MESSAGE] = text.decode(STRING_CODING)
    return found


def is_printable(text: bytes) -> bool:
    """Returns whether all bytes are letters that ISO-8859-1 shows."""
    return _PRINTABLE.issuperset(text)


def lacks_zero(payload: bytes) -> bool:
    """Returns whether a message looks like a text without the zero that ends it.

    Four letters are also a number, but too large for a program to mean it.
    """
    if not payload or not is_printable(payload):
        return False
    number = readings(payload).get(NUMBER_MESSAGE)
    return number is None or abs(number) >= _MOST_NUMBER  # type: ignore[arg-type]


def number_of_another_type(payload: bytes) -> tuple[str, float] | None:
    """Returns the type and value of a number that a program would not read as one; None if it is likely no such number.

    A number in a mailbox is a single. `0A 00 00 00` is 10 as a whole number, and 1.4E-44 as a single.
    """
    found = readings(payload)
    text = found.get(TEXT_MESSAGE)
    if LOGIC_MESSAGE in found or (is_printable(payload.rstrip(b"\0")) and (text or not payload.strip(b"\0"))):
        return None
    if _is_usual(found.get(NUMBER_MESSAGE, math.inf)):
        return None
    for kind, layout in _OTHER_NUMBERS:
        if layout.size == len(payload):
            (value,) = layout.unpack(payload)
            if _is_usual(value):
                return kind, value
    return None


def _is_usual(number: Reading) -> bool:
    """Returns whether a number is one that people send: not far too small or large."""
    if isinstance(number, int):
        return abs(number) <= _MOST_USUAL_INTEGER
    low, high = _USUAL_FLOAT
    return isinstance(number, float) and (number == 0 or math.isnan(number) or low <= abs(number) < high)


def message_of(value: Reading | bytes) -> bytes:
    """Returns the bytes of a message: a text with its zero, a number as a single, True and False as one byte.

    Raises:
        UnicodeEncodeError: The text has a letter outside ISO-8859-1.
        OverflowError: The number is too large for a single.
    """
    if isinstance(value, bytes):
        return value
    if isinstance(value, bool):
        return bytes((value,))
    if isinstance(value, str):
        text = value.encode(STRING_CODING)
        return text if text.endswith(b"\0") else text + b"\0"
    return _NUMBER.pack(value)
