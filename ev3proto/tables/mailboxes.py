"""Mailboxes: their capacity, and the three kinds of messages that EV3-G programs send and expect.

A frame carries the bytes of a message, but not its kind. All clients follow the blocks of EV3-G: a text is ISO-8859-1
with a zero at its end, a number is a single (4 bytes), a logic value is one byte, 0 or 1. More than one can fit.
"""

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
_NUMBER = struct.Struct("<f")
_LOGIC = {b"\0": False, b"\1": True}
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
    if zero and not rest and (not is_number or _PRINTABLE.issuperset(text)):
        found[TEXT_MESSAGE] = text.decode(STRING_CODING)
    return found


def lacks_zero(payload: bytes) -> bool:
    """Returns whether a message looks like a text without the zero that ends it.

    Four letters are also a number, but too large for a program to mean it.
    """
    if not payload or not _PRINTABLE.issuperset(payload):
        return False
    number = readings(payload).get(NUMBER_MESSAGE)
    return number is None or abs(number) >= _MOST_NUMBER  # type: ignore[arg-type]


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
