"""Plain hex is read as a frame, as an argument and as a line, with any separators and any meaning."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ev3proto.testing import frames
from ev3proto.text.paste import read_argument, read_text

TONE = "0e002a0080000094010182b80182e803"


@st.composite
def with_any_body(draw: st.DrawFn) -> bytes:
    """Bytes of a known type whose length field fits, most of them without meaning."""
    counter = draw(st.binary(min_size=2, max_size=2))
    kind = draw(st.sampled_from(b"\x00\x80\x02\x04\x01\x81\x03\x05"))
    after = counter + bytes((kind,)) + draw(st.binary(max_size=60))
    return len(after).to_bytes(2, "little") + after


@given(frames() | with_any_body(), st.sampled_from(["", ":"]), st.booleans())
def test_the_frame_is_found(frame: bytes, separator: str, is_upper: bool) -> None:
    digits = frame.hex(separator) if separator else frame.hex()
    text = digits.upper() if is_upper else digits
    assert read_argument(text).data == frame
    assert [(piece.data, piece.problem, piece.column) for piece in read_text([text])] == [(frame, None, 1)]


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        pytest.param(TONE[:-2], None, id="shorter than its length field says"),
        pytest.param(TONE + "00", None, id="with padding"),
        pytest.param(TONE[:-1], "odd number of hex digits (31)", id="half a byte"),
        pytest.param("03002a007f", None, id="an unknown type"),
        pytest.param("0e 0 02a0080000094010182b80182e803", "odd number of hex digits", id="groups of half a byte"),
        pytest.param("０e002a0080000094010182b80182e803", "is not a hex digit", id="a digit of another script"),
    ],
)
def test_other_input_is_read_as_bytes(text: str, problem: str | None) -> None:
    found = read_argument(text)
    if problem is None:
        assert (found.data.hex(), found.problem) == (text, None)
    else:
        assert problem in (found.problem or "")
