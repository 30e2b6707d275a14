"""Frames that something happened to on their way into a text: letters of other alphabets, lost zeros, lost bytes."""

from __future__ import annotations

from support.cases import each
from support.cli import run_ev3proto_text

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
    ("<0D><00>*<00><80><00><00><A4><00><01><81>d<A6><00><01>", "0d002a00800000a400018164a60001", "in brackets"),
    ("[07][00]*[00][02][A4]p[FD]@", "07002a0002a470fd40", "in brackets"),
    ("%07%00*%00%02%A4p%FD%40", "07002a0002a470fd40", "in brackets"),
    ("d 0 2a 0 -80 0 0 -5c 0 1 -7f -32 -5a 0 1", "0d002a00800000a4000181cea60001", "& 0xff"),
    ("0d 00 2a 00 ff80 00 00 ffa4 00 01 ff81 ffce ffa6 00 01", "0d002a00800000a4000181cea60001", "& 0xff"),
    ("13 0 42 0 65408 0 0 65444 0 1 65409 65486 65446 0 1", "0d002a00800000a4000181cea60001", "& 0xff"),
    ("7 0 42 0 2 4294967204 112 4294967293 64", "07002a0002a470fd40", "& 0xff"),
    ("07002a0002ffffffffffffffa470fffffffffffffffd40", "07002a0002a470fd40", "& 0xff"),
    ("rx = {0xd, 0x0, 0x2a, 0x0, 0x2, 0x0 <repeats 10 times>}", "0d002a000200000000000000000000", "debugger"),
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
    ("const cmd = 'f000800094181282e8382e83'", "0F 00 00 00 80 00 00 94 01 81 02 82 E8 03 82 E8 03"),
    ("0D 00 00 00 80 00 00 A4 00 01 81 \u04172 A6 00 01", "did you mean '32'"),
    ("0D 00 00 00 80 00 00 A4 00 01 81 3Z A6 00 01", "did you mean '32'"),
)


@each("text, meant", TOLD)
def test_a_frame_that_is_named(text: str, meant: str) -> None:
    (piece,) = pieces(text)
    assert meant in (piece.problem or "")


def test_a_frame_whose_length_counts_itself_lost_no_zeros() -> None:
    # Read so, it would be a reply: 0B 00 00 D2 02 30 00 91 48 A9 20 20 72.
    (piece,) = pieces("0b00d223009148a9202072")
    assert (piece.data.hex(), piece.problem) == ("0b00d223009148a9202072", None)


def test_a_word_that_lost_its_last_digit_was_cut() -> None:
    (piece,) = pieces("0e002a0080000094010182b80182e80")
    assert piece.data.hex() == "0e002a0080000094010182b80182e8"
    assert "odd number of hex digits (31)" in (piece.problem or "")


CUT = (
    ("RX <Buffer f7 00 05 00 03 99 00 ed 00 00 00 00 33 45 32 31 ... 233 more bytes>", 16),
    ("RX <Buffer f7 00 05 ... 246 more bytes>", 3),
    ("Uint8Array(249) [247, 0, 5, 0, 3, 153, 0, 240, 0, 0, 0, 0, 51, 69, 50, 49, 70, 69, 52, 48, \u2026]", 20),
    ("[\n  247, 0, 5, 0,\n    3, 153, 0, 240,\n  ... 241 more items\n]", 8),
    ("{length = 249, bytes = 0xf7000500 039900f0 00000000 33453231 ... 30303030 }", 16),
    ("array([247,   0,   5, ...,  48,  48,  48], dtype=uint8)", 3),
    ("received [247   0   5 ...  48  48  48]", 3),
    ("Data: f7 00 05 00 03 99 00 ed 06 00 2a 00 02 00 00 00 (truncated)", 16),
    ("f7 00 05 00 03 99 00 ed 00 00 00 00 33 45 [235 bytes omitted]", 14),
    ("f7 00 05 00 03 99 00 ed 00 00 00 00 33 45 (+235 bytes)", 14),
    ("<<247,0,5,0,3,153,0,237,0,0,0,0,51,69,50,49,...>>", 16),
    ("249-element Vector{UInt8}:\n 0xf7\n 0x00\n 0x05\n 0x00\n 0x03\n 0x99\n 0x00\n 0xed\n    \u22ee\n 0x30", 8),
    ('read(3, "\\xf7\\x00\\x05\\x00\\x03\\x99\\x00\\xed"..., 1024) = 249', 8),
    ("Uint8Array(249) [Buffer] [\n  247, 0, 5, 0,\n    3, 153, 0, 240,\n  ... 241 more items\n]", 8),
)


@each("text, count", CUT)
def test_a_frame_that_the_text_cuts_is_shown_as_far_as_it_goes(text: str, count: int) -> None:
    (piece,) = pieces(text)
    assert (piece.data[:3], len(piece.data), piece.cut, piece.problem) == (b"\xf7\0\5", count, True, None)


def test_an_object_of_javascript_with_its_length_has_no_byte_too_many() -> None:
    bytes_of = ", ".join(f"{at}: {byte}" for at, byte in enumerate(bytes.fromhex("07002a0002a470fd40")))
    (piece,) = pieces(f"{{ {bytes_of}, length: 9, parent: undefined, offset: 0 }}")
    assert piece.data.hex() == "07002a0002a470fd40"


def test_hex_of_each_byte_in_a_row() -> None:
    (piece,) = pieces("0x70x00x2a0x00x20xa40x700xfd0x40")
    assert piece.data.hex() == "07002a0002a470fd40"


def test_nothing_else_is_proposed_for_a_frame_that_the_text_cuts() -> None:
    done = run_ev3proto_text("decode", "-", stdin="{length = 249, bytes = 0xf7000500 039900f0 00000000 ... 3030 }")
    assert "12 bytes of 249" in done.stdout
    assert "did you mean" not in done.stderr


def test_numbers_with_an_ellipsis_are_not_a_frame() -> None:
    for text in (
        "[2, 3, 5, ..., 23, 27, 29]",
        "[1, 2, 3, ...]",
        "array([1, 2, 3, ..., 8])",
        "[9, 7, 0 ... 12 more items]",
    ):
        assert pieces(text) == [], text
