"""Texts of which it is known what they hold: frames of many kinds, right and wrong, in every form; and none."""

from __future__ import annotations

import random
from itertools import product

from support.cases import each
from support.notations import FORMS
from support.typical import COMMANDS, REPLIES, SYSTEM, frame, with_length

import ev3proto
from ev3proto.text.paste import Pasted, read_text

CONTENTS = [*COMMANDS.values(), *SYSTEM.values()]
AMBIGUOUS = {"hexdump": "words have an even number of bytes"}
"""Forms in which a wrong length may be the right one of other bytes."""
WITHOUT_ENDS = ("Add", "index and number")
"""Forms in which nothing tells where one frame ends and the next begins."""


def pieces(text: str) -> list[Pasted]:
    return list(read_text(text.splitlines(keepends=True)))


def drawn(*seed: object) -> random.Random:
    return random.Random(repr(seed))


def frames_of(*seed: object, count: int = 5) -> list[bytes]:
    rng = drawn(*seed)
    return [frame(rng.choice(CONTENTS), rng.randrange(1 << 16)) for _ in range(count)]


def without_padding(data: bytes) -> bytes:
    size = int.from_bytes(data[:2], "little") + 2
    return data if any(data[size:]) else data[:size]


@each("name, frame", [(name, one) for name in FORMS for one in frames_of("right", name)])
def test_a_right_frame_gives_its_bytes(name: str, frame: bytes) -> None:
    assert [(without_padding(one.data), one.problem) for one in pieces(FORMS[name](frame))] == [(frame, None)]


@each("name, frame", [(name, one) for name in FORMS for one in frames_of("more", name)])
def test_a_right_frame_with_more_bytes_is_never_accepted(name: str, frame: bytes) -> None:
    rng = drawn("more", name, frame)
    more = bytes(rng.randrange(1, 256) for _ in range(rng.randint(1, 3)))
    found = pieces(FORMS[name](frame + more))
    assert found
    assert any(one.problem is not None or ev3proto.check(one.data).findings for one in found), found


UNREAD_SWAPPED = (
    "bits",
    "base64",
    "hexdump",
    "pairs of bytes",
    "dotted pairs",
    "xxd",
    "tcpdump",
    "gdb's x",
    "continued",
)
"""Forms in which a length with its high byte first is other bytes, or may be anything."""


SWAPPED = [frame(COMMANDS[name], 0x9F9F) for name in ("tone", "file", "start motors", "steer")]


@each("name, frame", product([name for name in FORMS if name not in UNREAD_SWAPPED], SWAPPED))
def test_a_length_with_the_high_byte_first_is_named(name: str, frame: bytes) -> None:
    swapped = frame[1::-1] + frame[2:]
    (piece,) = pieces(FORMS[name](swapped))
    assert (without_padding(piece.data), piece.problem) == (swapped, None)
    assert ev3proto.check(piece.data).findings


@each("prefix", ["", "sent ", "data="])
def test_half_a_byte_behind_a_frame_is_named(prefix: str) -> None:
    (frame,) = frames_of("half", count=1)
    (piece,) = pieces(f"{prefix}{frame.hex()}1")
    assert piece.data == frame
    assert piece.problem is not None
    assert "odd number of hex digits" in piece.problem


def test_frames_of_which_one_is_wrong_are_read_line_by_line() -> None:
    first, second = frames_of("rows", count=2)
    wrong = with_length(second, len(second))
    for rows in ((wrong, first), (first, wrong), (wrong, wrong)):
        texts = [
            '12:30:45.123 write(3, "{}", 16) = 16'.format("".join(f"\\{byte:03o}" for byte in row)) for row in rows
        ]
        assert [piece.data for piece in pieces("\n".join(texts))] == list(rows)


def test_an_index_that_begins_anew_begins_a_frame() -> None:
    frames = frames_of("index", count=2)
    wrong = with_length(frames[0], len(frames[0]))
    lines = [f"buf[{at}] = 0x{byte:02X};" for frame in (frames[1], wrong, frames[1]) for at, byte in enumerate(frame)]
    assert [piece.data for piece in pieces("\n".join(lines))] == [frames[1], wrong, frames[1]]


def test_columns_with_a_word_in_front_of_the_first_row() -> None:
    (frame,) = frames_of("columns", count=1)
    names = {0: "size", 2: "number", 4: "type", 5: "memory", 7: "operation"}
    lines = [f"{'' if at else 'Byte:':5} {at:2}  0x{byte:02X}  {names.get(at, '')}" for at, byte in enumerate(frame)]
    assert [piece.data for piece in pieces("\n".join(lines))] == [frame]


def test_a_type_in_brackets_is_not_an_unknown_byte() -> None:
    frames = frames_of("type", count=2)
    lines = [f"let bytes: [UInt8] = [{', '.join(f'0x{byte:02x}' for byte in frame)}]" for frame in frames]
    assert [(piece.data, piece.unknown) for piece in pieces("\n".join(lines))] == [(frame, ()) for frame in frames]


@each("form, frame", product(("{}", "sent {}", "12:30:45 {}", "0x{}"), frames_of("behind")))
def test_hex_behind_a_frame_belongs_to_it(form: str, frame: bytes) -> None:
    for more in ("01", "b122", "0x01", "01 02", "b12200"):
        (piece,) = pieces(f"{form.format(frame.hex())} {more}")
        assert piece.data == frame + bytes.fromhex(more.removeprefix("0x")), more
        assert "E103" in {finding.code for finding in ev3proto.check(piece.data).findings}


def test_what_a_line_says_of_a_frame_is_not_a_part_of_it() -> None:
    (frame,) = frames_of("said", count=1)
    for said in ("16 bytes", "(16)", "= 16", "| 16", "250 ms", "12:30:45", "# 16", "; 16"):
        assert [piece.data for piece in pieces(f"{frame.hex()} {said}")] == [frame], said


@each("name, frame", [(name, one) for name in FORMS if name not in AMBIGUOUS for one in frames_of("length", name)])
def test_a_length_that_counts_itself_is_named(name: str, frame: bytes) -> None:
    wrong = with_length(frame, len(frame))
    (piece,) = pieces(FORMS[name](wrong))
    assert (without_padding(piece.data), piece.problem) == (wrong, None)
    assert "E102" in {finding.code for finding in ev3proto.check(piece.data).findings}


RIGHT_REPLIES = [
    (name, frame(one, 0x9F9F))
    for name, one in product(FORMS, REPLIES.values())
    if name != "octal"  # as decimal numbers they are a reply, too: any bytes are one
]


@each("name, frame", RIGHT_REPLIES)
def test_a_right_reply_gives_its_bytes(name: str, frame: bytes) -> None:
    assert [(without_padding(one.data), one.problem) for one in pieces(FORMS[name](frame))] == [(frame, None)]


@each("name, frame", RIGHT_REPLIES)
def test_a_right_reply_with_more_bytes_is_never_accepted(name: str, frame: bytes) -> None:
    for piece in pieces(FORMS[name](frame + b"\x07\xb1")):
        assert piece.problem is not None or ev3proto.check(piece.data).findings, piece


@each("name, frames", [(name, frames_of("between", name, count=3)) for name in FORMS if name not in WITHOUT_ENDS])
def test_a_wrong_frame_between_two_right_ones_is_spoken_of(name: str, frames: list[bytes]) -> None:
    first, second, third = frames
    for wrong in (with_length(second, len(second)), second + b"\x07"):
        texts = [FORMS[name](one) for one in (first, wrong, third)]
        starts = [1, 2 + texts[0].count("\n"), 3 + texts[0].count("\n") + texts[1].count("\n")]
        found = pieces("\n".join(texts))
        for start, end in zip(starts, [*starts[1:], 1 << 20], strict=True):
            assert any(start <= one.line < end for one in found), (start, found)
        assert [without_padding(one.data) for one in (found[0], found[-1])] == [first, third]


WORDS = ("sensor", "motor", "port", "battery", "volume", "channel", "socket", "service", "started", "timeout")


class Drawn:
    """Lines of other texts."""

    def __init__(self, rng: random.Random) -> None:
        self.rng = rng

    def number(self, most: int = 99_999) -> int:
        return self.rng.randrange(most)

    def log(self) -> str:
        time = f"11-25 22:{self.number(60):02}:{self.number(60):02}.{self.number(1000):03}"
        words = " ".join(self.rng.choices(WORDS, k=5))
        return (
            f"{time}  {self.number()} {self.number()} D Ev3: {words} {self.number()} 0x{self.rng.getrandbits(32):08x}"
        )

    def price(self) -> str:
        amount = f"{self.number(9)},{self.number(1000):03}.{self.number(100):02}"
        return f"{self.rng.choice(WORDS)}, {self.number(20)} x {self.number(90)}.{self.number(100):02}, {amount} EUR"

    def date(self) -> str:
        day = f"{2000 + self.number(30)}-{1 + self.number(12):02}-{1 + self.number(28):02}"
        return f"{day}T{self.number(24):02}:{self.number(60):02}:{self.number(60):02}Z"

    def digest(self) -> str:
        return f"{self.rng.getrandbits(self.rng.choice((128, 160, 256))):032x}  {self.rng.choice(WORDS)}.bin"

    def version(self) -> str:
        numbers = f"{self.number(9)}.{self.number(20)}.{self.number(99)}-{self.number(9)}"
        return f"{self.rng.choice(WORDS)} {numbers}+deb{self.number(13)}u{self.number(4)}"

    def address(self) -> str:
        mac = ":".join(f"{self.number(256):02x}" for _ in range(6))
        return f"{self.rng.choice(WORDS)} at {mac}, 192.168.{self.number(256)}.{self.number(256)}"


@each(
    "kind, number", product((Drawn.log, Drawn.price, Drawn.date, Drawn.digest, Drawn.version, Drawn.address), range(99))
)
def test_other_texts_have_no_frames(kind: object, number: int) -> None:
    assert callable(kind)
    lines = [kind(Drawn(drawn(number, row))) for row in range(5)]
    assert pieces("\n".join(lines)) == []
