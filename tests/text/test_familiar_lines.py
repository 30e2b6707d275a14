"""Lines that are read the short way give what the long way gives, whatever numbers, times and frames stand in them."""

from __future__ import annotations

from collections.abc import Callable
from unittest.mock import patch

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.effort import effort

from ev3proto.text.paste import Pasted, read_text
from ev3proto.text.paste.familiar import Familiar

TONE = "0f 00 00 00 80 00 00 94 01 81 02 82 e8 03 82 e8 03"

HEX: dict[str, Callable[[bytes], str]] = {
    "blanks": lambda frame: frame.hex(" "),
    "glued": bytes.hex,
    "colons": lambda frame: frame.hex(":").upper(),
    "dashes": lambda frame: frame.hex("-").upper(),
    "lesson": lambda frame: f"0x|{frame[:2].hex(':')}|{frame[2:].hex(':')}|",
    "0x": lambda frame: " ".join(f"0x{byte:02x}" for byte in frame),
    "0x, commas": lambda frame: ", ".join(f"0x{byte:02X}" for byte in frame),
    "decimals": lambda frame: str(list(frame)),
    "cut": lambda frame: frame[:-1].hex(" "),
    "too long": lambda frame: frame.hex(" ") + " 00 17",
    "HID": lambda frame: "00 " + frame.hex(" "),
    "wrapped": lambda frame: frame[:6].hex(" ") + "\n" + frame[6:].hex(" "),
    "twice": lambda frame: f"{frame.hex(' ')} -> {frame.hex(' ')}",
}
_LOGGERS = ["sent", "recv:", "DEBUG", "EV3", "EV3Client:", "->", "<-", "[main]", "data=", "at", "ev3d:", "bytes", "="]
_ODD = [
    "-",
    "D",
    "be",
    "TX,",
    "(TONE)",
    "x",
    "{",
    '"frame":',
    "#",
    "//",
    "+0 |",
    "0x",
    "b'",
    "LC0(",
    "opSOUND,",
    "*",
    "$",
]
WORDS = st.sampled_from([*_LOGGERS, *_ODD])
NUMBERS = st.integers(0, 99_999).map(str) | st.sampled_from(
    ["0", "00", "0000", "0000:", "0010:", "[0]", "(1234)", "17:"]
)
TIMES = st.builds(
    "{0}{1:02}:{2:02}:{3:02}{4}".format,
    st.sampled_from(["", "2024-01-31 ", "31.01.2024 ", "["]),
    st.integers(0, 29),
    st.integers(0, 69),
    st.integers(0, 69),
    st.sampled_from(["", ".123", ",5", "]", "Z", " +01:00", "-"]),
)
BEFORE = st.lists(WORDS | NUMBERS | TIMES | st.sampled_from(["  ", "\t"]), max_size=6).map(" ".join)
AFTER = st.sampled_from(["", ".", ",", '"}', "'", ")", " |", ";", " 12", " ok", "];", "...", " {"])


FRAMES = st.builds(
    lambda counter, kind, rest: (3 + len(rest)).to_bytes(2, "little") + counter + bytes((kind,)) + rest,
    st.binary(min_size=2, max_size=2),
    st.sampled_from([0x00, 0x80, 0x01, 0x81, 0x02, 0x04, 0x03, 0x05, 0x07]),
    st.binary(max_size=12)
    | st.sampled_from([bytes.fromhex(TONE)[5:], bytes(4), bytes.fromhex("10 10 20 00 00 80 01")]),
)


@st.composite
def texts(draw: st.DrawFn) -> list[str]:
    """Lines of few kinds, each of them several times with other numbers, as logs have them."""
    kinds = draw(st.lists(st.tuples(BEFORE, st.sampled_from(sorted(HEX)), AFTER), min_size=1, max_size=3))
    lines = []
    for before, name, after in draw(st.lists(st.sampled_from(kinds), min_size=2, max_size=8)):
        frame = draw(FRAMES)
        digits = draw(st.permutations("123456789"))
        varied = "".join(digits[int(one) - 1] if one in "123456789" and draw(st.booleans()) else one for one in before)
        lines += f"{varied} {HEX[name](frame)}{after}".lstrip().splitlines(keepends=True)
        lines[-1] += "\n"
    return lines


def long_way(lines: list[str]) -> list[Pasted]:
    with patch.object(Familiar, "read", lambda *_: None):
        return list(read_text(lines))


@settings(max_examples=effort(80, 1500))
@given(texts())
def test_the_short_way_gives_what_the_long_way_gives(lines: list[str]) -> None:
    assert list(read_text(lines)) == long_way(lines)


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("", ""),
        ("2024-01-31 12:30:{:02}.123 DEBUG robot: sent ", ""),
        ("01-31 12:30:{:02}.123  1234  1250 D EV3: send ", ""),
        ("frame {}: EV3 <- ", ""),
        ('{{"t": {}, "dir": "tx", "data": "', '"}'),
        ("[{}] received [", "]"),
    ],
)
def test_lines_of_a_log_are_read_the_short_way(before: str, after: str) -> None:
    lines = [f"{before.format(second)}{TONE}{after}\n" for second in range(10, 50)]
    familiar = Familiar()
    found = []
    for number, line in enumerate(lines, 1):
        piece = familiar.read(line, number)
        if piece is None:
            familiar.learn(list(read_text([line])))
        else:
            found.append(piece)
    assert len(found) >= 39
    assert all(piece.data == bytes.fromhex(TONE) for piece in found)
