"""What bytes are: every room says the same of them."""

from __future__ import annotations

import pytest

from ev3proto.schema.frame import frame_reader
from ev3proto.semantics.identify import Kind, identify

TONE = "0E 00 2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03"

BYTES = {
    "right": (TONE, Kind.FRAME, ""),
    "right reply": ("05 00 2A 00 02 10 27", Kind.FRAME, ""),
    "length counts itself": ("10" + TONE[2:], Kind.SLIP, "length-self"),
    "length swapped": ("00 0E" + TONE[5:], Kind.SLIP, "length-swapped"),
    "length": ("0D" + TONE[2:], Kind.SLIP, "length"),
    "cut": (TONE[:-9], Kind.SLIP, "cut"),
    "type": ("0E 00 2A 00 40" + TONE[14:], Kind.SLIP, "type"),
    "as UTF-8": ("0E 00 2A 00 C2 80 00 00 C2 94 01 01 C2 82 C2 B8 01 C2 82 C3 A8 03", Kind.SLIP, "utf-8"),
    "no length": (TONE[6:], Kind.NO_LENGTH, ""),
    "operations": (TONE[21:], Kind.OPERATIONS, ""),
    "length of one byte": ("0E " + TONE[6:], Kind.HALF_LENGTH, ""),
    "length of one byte that counts itself": ("0A 2A 00 00 04 00 81 01 60", Kind.HALF_LENGTH, ""),
    "a reply's start without its length": ("2A 00 02 66 66", Kind.NO_LENGTH, ""),
    "a header, cut": ("0F 00 00 00 80", Kind.NOTHING, ""),
    "hex digits": (TONE.replace(" ", "").encode().hex(), Kind.DIGITS, TONE.replace(" ", "")),
    "text": (b"forward\r\n".hex(), Kind.TEXT, "forward"),
    "NXT": ("06 00 80 03 B8 01 E8 03", Kind.NXT, "PLAYTONE"),
    "NXT, motor on C": ("0C 00 80 04 02 64 07 00 00 20 00 00 00 00", Kind.FRAME, ""),
    "NXT, reset of B": ("04 00 80 0A 01 00", Kind.NXT, "RESETMOTORPOSITION"),
    "no operations": ("05 00 02 06 00 00 00", Kind.FRAME, ""),
    "hub": ("08 00 81 32 11 51 00 64", Kind.HUB, "port output command"),
    "hub, wrong start": ("08 00 81 32 77 51 00 64", Kind.NOTHING, ""),
    "zeros": ("00" * 16, Kind.NOTHING, ""),
    "a dump's head": (bytes(range(16)).hex(), Kind.NOTHING, ""),
}


@pytest.mark.parametrize("name", BYTES)
def test_what_bytes_are(name: str) -> None:
    data, kind, said = BYTES[name]
    found = identify(bytes.fromhex(data))
    assert (found.kind, found.name) == (kind, said)


ALSO = {
    "0C 00 80 04 02 64 07 00 00 20 00 00 00 00": "SETOUTPUTSTATE",
    "0C 00 80 04 02 65 07 00 00 20 00 00 00 00": "",  # a power of 101 %
    "0C 00 80 04 02 64 07 00 00 30 00 00 00 00": "",  # an unknown run state
    "04 00 80 0A 02 01": "RESETMOTORPOSITION",
    "08 00 80 0A 00 01 00 81 12 60": "",  # the battery of an EV3: a reset has four bytes
    "05 00 02 0B 00 40 1F": "the reply to GETBATTERYLEVEL",
    "03 00 02 03 02": "",  # an NXT has no status 2
    TONE: "",
}


@pytest.mark.parametrize("data", ALSO)
def test_a_right_frame_is_an_nxts_telegram_too_where_all_of_it_fits(data: str) -> None:
    found = identify(bytes.fromhex(data))
    assert (found.kind, found.also) == (Kind.FRAME, ALSO[data])


def test_operations_of_other_firmwares_are_known_by_their_reader() -> None:
    operations = bytes.fromhex("E5 01 60 E5 01 64")
    assert identify(operations).kind is Kind.NOTHING
    assert identify(operations, reader=frame_reader("xtended")).kind is Kind.OPERATIONS
