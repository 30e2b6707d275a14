"""The short way for plain hex: it finds what the other forms find, and leaves the rest to them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ev3proto.testing import frames
from ev3proto.text.paste import Pasted, read_any_form
from ev3proto.text.paste.plain import plain_frame

TONE = "0e002a0080000094010182b80182e803"
FRAME = bytes.fromhex(TONE)


@st.composite
def with_any_body(draw: st.DrawFn) -> bytes:
    """Bytes of a known type whose length field fits, most of them without a meaning."""
    counter = draw(st.binary(min_size=2, max_size=2))
    kind = draw(st.sampled_from(b"\x00\x80\x02\x04\x01\x81\x03\x05"))
    after = counter + bytes((kind,)) + draw(st.binary(max_size=60))
    return len(after).to_bytes(2, "little") + after


@given(frames() | with_any_body(), st.sampled_from(["", " ", ":"]), st.booleans())
def test_the_other_forms_find_the_same(frame: bytes, separator: str, is_upper: bool) -> None:
    digits = frame.hex(separator) if separator else frame.hex()
    text = digits.upper() if is_upper else digits
    found = plain_frame(text)
    assert found is not None or separator
    if found is not None:
        assert found == read_any_form(text)


@pytest.mark.parametrize("text", [TONE, TONE.upper(), FRAME.hex(" "), FRAME.hex(":").upper()])
def test_plain_hex_is_the_frame(text: str) -> None:
    assert plain_frame(text) == Pasted(FRAME, 1, text)


@pytest.mark.parametrize(
    "text",
    [
        pytest.param("", id="nothing"),
        pytest.param(TONE[:-2], id="shorter than its length field says"),
        pytest.param(TONE + "00", id="longer"),
        pytest.param(TONE[:-1], id="half a byte"),
        pytest.param("03002a007f", id="a type that there is not"),
        pytest.param("03 00 42 00 05", id="numbers that may be decimal"),
        pytest.param("0e 0 02a0080000094010182b80182e803", id="groups that are no bytes"),
        pytest.param(f"{FRAME.hex(' ')} ", id="a blank at the end"),
        pytest.param(f"sent {TONE}", id="a word"),
        pytest.param("０e002a0080000094010182b80182e803", id="a digit that is none of hex"),
    ],
)
def test_what_is_not_plain_is_left_to_the_other_forms(text: str) -> None:
    assert plain_frame(text) is None
