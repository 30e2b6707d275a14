"""The slips that people make in frames, one row each: how common it is, what to say, and an example.

A new kind of slip is a row here and a generator of its edits in `edits`.
"""

from __future__ import annotations

from typing import NamedTuple


class Slip(NamedTuple):
    """One kind of slip.

    cost      how unlikely it is, 2 for the commonest; 1 more is about a third as likely
    sentence  what is wrong and what would be right; the generator of its edits fills in the braces
    wrong     a frame with it, in hex
    right     the frame that was meant
    """

    cost: float
    sentence: str
    wrong: str
    right: str


_BATTERY = "0800 0100 00 0400 81 01 60"
_SPEED = "0D00 0100 80 0000 A5 00 01 8132 A6 00 01"
_TONE = "0E00 0100 80 0000 94 01 02 82E803 82F401"
_PLAY = "0E00 0100 80 0000 94 02 02 84 68656C6C00"
_ROOT = "0D00 0100 00 0400 8D 08 83 00000040 60"
_MAILBOX = "0A00 0100 81 9E 02 6100 0100 01"

SLIPS = {
    # The whole frame went through a text.
    "utf-8": Slip(1, "the frame was encoded as UTF-8: {0} is here for {1}; send bytes, not a text",
        "0E00 0100 C280 0000 C294 01 02 C282C3A803 C282C3B401", _TONE),
    "digits": Slip(1, "these are the digits of a frame as characters; send the bytes, not their text",
        b"0600 0100 80 0000 01".hex(), "0600 0100 80 0000 01"),
    "text-mode": Slip(1, "0D 0A is here for 0A: the frame went through text mode; open the file or port in binary mode",
        "0800 0D0A00 00 0400 81 01 60", "0800 0A00 00 0400 81 01 60"),
    "replaced": Slip(1, "EF BF BD is here for a byte above 7F: the frame was decoded as UTF-8; keep it as bytes",
        "0E00 0100 EFBFBD 0000 EFBFBD 01 02 EFBFBDEFBFBD03 EFBFBDEFBFBD01", _TONE),
    "ascii": Slip(1, "3F is here for every byte above 7F: the frame was encoded as ASCII; send bytes, not a text",
        "0E00 0100 3F 0000 3F 01 02 3F3F03 3F3F01", _TONE),
    # The header.
    "length": Slip(3, "the length field says that {4} it, but there are {0}: {0} is written {1}",
        "0B00 0100 80 0000 A5 00 01 8132 A6 00 01", _SPEED),
    "length-self": Slip(2, "the length does not count its own two bytes: it is {0} ({1})",
        "0F00 0100 80 0000 A5 00 01 8132 A6 00 01", _SPEED),
    "length-swapped": Slip(2, "the two bytes of the length are swapped: {0} is {1}, the low one first",
        "000D 0100 80 0000 A5 00 01 8132 A6 00 01", _SPEED),
    "length-decimal": Slip(2, "the length is written in hex: {0} is {1}, but {3} is {2}",
        "1300 0100 80 0000 A5 00 01 8132 A6 00 01", _SPEED),
    "length-missing": Slip(3, "the two bytes of the length are missing: {0}",
        "0100 80 0000 A5 00 01 8132 A6 00 01", _SPEED),
    "length-half": Slip(3.5, "the length has two bytes, the low one first",
        "0D 0100 80 0000 A5 00 01 8132 A6 00 01", _SPEED),
    "left-over": Slip(3.2, "{0} at the end {1} not part of the frame",
        "0D00 0100 80 0000 A5 00 01 8132 A6 00 01 0D0A", _SPEED),
    "report-number": Slip(3, "the first byte, the number of a USB report, is not part of the frame",
        "00 0D00 0100 80 0000 A5 00 01 8132 A6 00 01", _SPEED),
    "counter-missing": Slip(3.5, "the two bytes of the message counter are missing",
        "0800 81 9E 02 6100 0100 01", "0A00 0000 81 9E 02 6100 0100 01"),
    "memory-missing": Slip(3, "the two bytes that request memory are missing after the type",
        "0B00 0100 80 A5 00 01 8132 A6 00 01", _SPEED),
    "memory-half": Slip(4, "one of the two bytes that request memory is missing",
        "0C00 0100 80 00 A5 00 01 8132 A6 00 01", _SPEED),
    "memory-swapped": Slip(2.5, "the two bytes that request memory are swapped: the low one comes first",
        "0800 0100 00 0004 81 01 60", _BATTERY),
    "memory-shift": Slip(2.5, "the size of local memory is in the upper six bits of its byte: {0} is {1} there",
        "0C00 0100 80 0004 85 82E803 40 86 40", "0C00 0100 80 0010 85 82E803 40 86 40"),
    "memory-size": Slip(2, "{0} of global and {1} of local memory are used; the header requests {2} and {3}",
        "0800 0100 00 0200 81 01 60", _BATTERY),
    "header-long": Slip(4.5, "two bytes too many: the header has the length, the counter, one byte of type, the memory",
        "0F00 0100 0000 80 0000 A5 00 01 8132 A6 00 01", _SPEED),
    "header-missing": Slip(4, "these are operations without a header: its length, counter, type and memory come first",
        "A5 00 01 8132 A6 00 01", "0D00 0000 80 0000 A5 00 01 8132 A6 00 01"),
    "header-short": Slip(5, "a byte of the header is missing",
        "0400 01 01 9D", "0400 0100 01 9D"),
    "header-order": Slip(3.5, "the fields of the header are in another order: {0}; right is {1}",
        "0800 0100 0400 00 81 01 60", _BATTERY),
    "decimals": Slip(2.5, "0x is forgotten: the digits of hex were taken for decimals, so that {0} became {1}",
        "0E00 0100 50 0000 5E 01 02 52E803 52F401", _TONE),
    "type": Slip(3.5, "the type {0:02X} is wrong: {1:02X}, {2}, fits",
        "0D00 0100 08 0000 A5 00 01 8132 A6 00 01", _SPEED),
    "no-reply": Slip(2, "the type asks for no reply, which alone carries the results of {0}",
        "0800 0100 80 0400 81 01 60", _BATTERY),
    # Operations.
    "opcode": Slip(4.5, "{0} also takes {1}; {2} does not",
        "0D00 0100 80 0000 A5 00 01 8132 A5 00 01", _SPEED),
    "opcode-digit": Slip(6, "the opcode {0} is wrong: {1}, {2}, fits what follows",
        "0E00 0100 80 0000 93 01 02 82E803 82F401", _TONE),
    "digit": Slip(5.5, "{0} of {1} has a wrong digit: {3} fits, {2} does not",
        "0D00 0100 80 0000 A5 0E 01 8132 A6 00 01", _SPEED),
    "no-cmd": Slip(4.5, "the CMD of {0} is missing",
        "0D00 0100 80 0000 94 02 82E803 82F401", _TONE),
    "cmd-place": Slip(3, "the CMD of {0} comes right after the opcode, before LAYER and NO",
        "0D00 0100 00 0400 99 00 03 1D 00 00 01 60", "0D00 0100 00 0400 99 1D 00 03 00 00 01 60"),
    "end": Slip(3, "OBJECT_END ends the code, but operations follow",
        "0E00 0100 80 0000 A5 00 01 8132 0A A6 00 01", _SPEED),
    # Arguments.
    "missing": Slip(4, "{0} of {1} is missing",
        "0C00 0100 80 0000 A5 01 8132 A6 00 01", _SPEED),
    "no-results": Slip(2.5, "{0} of {1} {2} missing: each result needs a variable, here {3}",
        "0900 0100 00 0200 99 05 00 00", "0B00 0100 00 0200 99 05 00 00 60 61"),
    "cut": Slip(4, "the frame ends before {0} of {1}",
        "0A00 0100 80 0000 AA 00 01 94 01", "0F00 0100 80 0000 AA 00 01 94 01 01 82FA00 00"),
    "extra": Slip(5, "{0} of {1} is given twice, or is one value too many",
        "0E00 0100 80 0000 A5 00 00 01 8132 A6 00 01", _SPEED),
    "order": Slip(4, "{0} and {1} of {2} are in the wrong order",
        "0D00 0100 80 0000 A5 00 8132 01 A6 00 01", _SPEED),
    "raw": Slip(2.5, "{0} of {1} is a raw number: {2} is written {3}",
        "0C00 0100 80 0000 A5 00 01 4B A6 00 01", "0D00 0100 80 0000 A5 00 01 814B A6 00 01"),
    "width": Slip(3, "{0} of {1} has the identification byte {2}, but {3} announces {4}",
        "0E00 0100 80 0000 94 01 02 81E803 82F401", _TONE),
    "swapped": Slip(3, "the bytes of {0} of {1} are swapped: {2} is written {3}, the low one first",
        "0E00 0100 80 0000 94 01 02 8203E8 82F401", _TONE),
    "label": Slip(3, "{0} of {1} is encoded as a label: {2} is written {3}",
        "0D00 0100 80 0000 A5 00 01 A114 A6 00 01", "0C00 0100 80 0000 A5 00 01 2C A6 00 01"),
    "sign": Slip(2.5, "{0} of {1} is negative: {2} is written {3}",
        "0E00 0100 80 0000 A5 00 01 82CE00 A6 00 01", "0D00 0100 80 0000 A5 00 01 81CE A6 00 01"),
    "float": Slip(2.5, "{0} of {1} is a float: {2} is written {3}",
        "0900 0100 00 0400 8D 08 02 60", _ROOT),
    "no-zero": Slip(3, "the text {0} of {1} has no zero at its end",
        "0D00 0100 80 0000 94 02 02 84 68656C6C", _PLAY),
    "no-84": Slip(3, "the text {0} of {1} begins with its identification byte, 84",
        "0D00 0100 80 0000 94 02 02 68656C6C00", _PLAY),
    "length-84": Slip(3, "the text {0} of {1} begins with 84, not with its length, and ends with a zero",
        "0E00 0100 80 0000 94 02 02 04 68656C6C00", _PLAY),
    "aligned": Slip(2.5, "{0} of {1} must start at a multiple of {2}: {3} is written {4}",
        "0800 0100 00 0800 81 01 61", "0800 0100 00 0800 81 01 64"),
    "scope": Slip(2, "no reply carries the local variable of {0} of {1}: in global memory, it is {2}",
        "0800 0100 00 0400 81 01 40", _BATTERY),
    "variable-81": Slip(2.5, "{0} of {1} is a variable, which is one byte: {2} without 81",
        "0900 0100 00 0400 81 01 8160", _BATTERY),
    "variable": Slip(3, "{0} of {1} is a result, which needs a variable: {2} is written {3}",
        "0800 0100 00 0400 81 01 00", _BATTERY),
    # Copying.
    "doubled": Slip(5, "the byte {0:02X} is there twice",
        "0F00 0100 80 0000 94 01 02 8282E803 82F401", _TONE),
    "transposed": Slip(5, "two bytes changed places: {0} is {1}",
        "0D00 0100 80 0000 A5 00 01 3281 A6 00 01", _SPEED),
    "lost": Slip(6, "a byte of {0} of {1} is missing",
        "0C00 0100 80 0000 A5 00 01 81 A6 00 01", _SPEED),
    # System commands.
    "no-field": Slip(4, "{0} of {1} is missing",
        "0900 0100 81 9E 6100 0100 01", _MAILBOX),
    "field": Slip(3, "{0} of {1} is {2}, but {3} fits",
        "0A00 0100 81 9E 02 6100 0200 01", _MAILBOX),
}  # fmt: skip
"""The slips by the kinds of edits that undo them."""

HABITS = frozenset(
    ("missing", "raw", "width", "swapped", "label", "float", "no-zero", "no-84", "length-84", "scope", "variable")
)
"""The slips that people make at every place where they can."""

CHOICES = frozenset(("aligned",))
"""The slips of which only the author knows how to undo them, such as where a variable is best moved."""
