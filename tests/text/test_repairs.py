"""Frames that something happened to on their way into a text: letters of other alphabets, lost zeros, lost bytes."""

from __future__ import annotations

from support.cases import each

from ev3proto.text.paste import Pasted, read_text


def pieces(text: str) -> list[Pasted]:
    return list(read_text(text.splitlines(keepends=True)))


READ = (
    ("\uff10\uff25002a0080000094010182b80182e803", "0e002a0080000094010182b80182e803", "full-width"),
    ("\uff10\uff26\u3000\uff10\uff10 00 00 80 00 00 94 01 81 02 82 E8 03 82 E8 03", "", "full-width"),
    (
        "right: 0d002a00ffffff800000ffffffa40001ffffff81ffffffceffffffa60001",
        "0d002a00800000a4000181cea60001",
        "ffffff80",
    ),
    ("reply: 07002a0002ffffffa470fffffffd40", "07002a0002a470fd40", "32 bits"),
    (r"\0D\00*\00\80\00\00\A4\00\01\81d\A6\00\01", "0d002a00800000a400018164a60001", "LabVIEW"),
    (r"sent \08\00\s\00\00\04\00\81\01`", "0800200000040081" + "0160", "LabVIEW"),
    (r"\07\00*\00\02\A4p\FD@", "07002a0002a470fd40", "LabVIEW"),
)


@each("text, data, note", READ)
def test_a_frame_that_is_read(text: str, data: str, note: str) -> None:
    (piece,) = pieces(text)
    if data:
        assert piece.data.hex() == data
    assert piece.problem is None
    assert note in piece.notes[0]


TOLD = (
    ("0D 00 00 00 80 00 00 \u04104 00 01 81 32 \u04106 00 01", "did you mean 'A4'"),
    ("0D 00 00 00 80 00 00 \u03915 00 01 81 32 \u03916 00 01", "did you mean 'A5'"),
    ("06 00 2a 00 8O 00 00 01", "did you mean '80'"),
    ("0D002A00800000A40001815A60001", "0D 00 2A 00 80 00 00 A4 00 01 81 05 A6 00 01"),
    ("F0000008000009401810282E80382E803", "0F 00 00 00 80 00 00 94 01 81 02 82 E8 03 82 E8 03"),
    ("f000800094181282e8382e83", "0F 00 00 00 80 00 00 94 01 81 02 82 E8 03 82 E8 03"),
    ("recv: 70102a470fd40", "07 00 01 00 02 A4 70 FD 40"),
)


@each("text, meant", TOLD)
def test_a_frame_that_is_named(text: str, meant: str) -> None:
    (piece,) = pieces(text)
    assert meant in (piece.problem or "")


def test_a_word_that_lost_its_last_digit_was_cut() -> None:
    (piece,) = pieces("0e002a0080000094010182b80182e80")
    assert piece.data.hex() == "0e002a0080000094010182b80182e8"
    assert "odd number of hex digits (31)" in (piece.problem or "")
