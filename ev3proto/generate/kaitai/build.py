"""Puts the description together: what it is, a stream of frames, the types, the names of numbers."""

from __future__ import annotations

from ev3proto.generate.kaitai.messages import enumerations, message_types
from ev3proto.generate.kaitai.naming import identifier
from ev3proto.generate.kaitai.operations import opcode_enum, operation_types, used_enumerations
from ev3proto.generate.kaitai.yaml import Block, Value, written
from ev3proto.tables import check_dialect
from ev3proto.tables.declaration import DIALECTS, Enumeration
from ev3proto.version import VERSION

FILE_NAME = "ev3.ksy"

DOC = """\
Frames between a computer and a brick: all of a stream, from its first frame on. On USB each report starts with one
frame, and the rest of it is padding. On WiFi two texts come first, which are no frames.

Operations are those of the {dialect} firmware. An argument's type does not say whether its encoding is the shortest.
What a description cannot say: what the bytes of a direct reply mean, which only the command tells; which CMD a family
does not have (then what follows is read as the next operation); names of sets of bits.

Made by ev3proto {version} from its tables (ev3proto export kaitai): change those, not this."""


def build(dialect: str = DIALECTS[0]) -> str:
    """The text of ev3.ksy. ValueError for an unknown dialect."""
    return written(description(dialect))


def description(dialect: str = DIALECTS[0]) -> dict[str | int, Value]:
    """All that the description says. ValueError for an unknown dialect."""
    check_dialect(dialect)
    return {
        "meta": {
            "id": "ev3",
            "title": "LEGO MINDSTORMS EV3",
            "license": "MIT",
            "ks-version": "0.11",
            "endian": "le",
            "bit-endian": "be",
            "encoding": "ISO-8859-1",
        },
        "doc": Block(DOC.format(dialect=dialect, version=VERSION)),
        "seq": [{"id": "frames", "type": "frame", "repeat": "eos"}],
        "types": {**dict(message_types()), **dict(operation_types(dialect))},
        "enums": {
            **dict(enumerations()),
            "opcode": opcode_enum(dialect),
            **{identifier(enum.name): _members(enum) for enum in used_enumerations(dialect)},
        },
    }


def _members(enum: Enumeration) -> dict[str | int, Value]:
    names: dict[int, str] = {}
    for name, number in enum.members.items():
        names.setdefault(number, name)
    return {number: identifier(name) for number, name in names.items()}
