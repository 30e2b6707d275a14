"""Every help of `check` that names a number is tried: with it, the finding is gone, and nothing new is wrong there.

`support.advice` applies a help. The inputs are the examples of all codes, those with other bytes around, and
frames with one thing wrong, drawn from the tables.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.advice import Advised
from support.careful import KNOWN, careful_operation
from support.effort import effort

import ev3proto
from ev3proto import GV, Finding, check
from ev3proto.checking.codes import CODES
from ev3proto.errors import BuildError
from ev3proto.messages import Variable
from ev3proto.schema.argument import encode_as, encode_integer, encode_string, encode_variable
from ev3proto.schema.header import with_length, write_memory
from ev3proto.tables.carriers import CARRIERS
from ev3proto.tables.declaration import DIALECTS
from ev3proto.tables.system import SYSTEM, Kind
from ev3proto.testing import mutated_frames, raw_operations

some = settings(max_examples=effort(100, 3000), deadline=None)

WITHOUT_A_NUMBER_TO_TRY = {
    "E102": "the bytes that are missing are not known",
    "E108": "the numbers are those of bytes in a text",
    "E207": "it is a count only where the operation can be read",
    "E210": "the names of encodings have numbers in them",
    "E802": "the names of types have numbers in them",
    "W804": "the length in front of the message changes, too",
}
"""Codes whose helps may have digits but no number to apply, with the reason."""


def trouble(
    frame: bytes, carrier: str | None = None, dialect: str = "official", *, alone: bool = False
) -> Iterator[str]:
    """Returns what is wrong with the helps of a frame's findings."""
    report = check(frame, carrier=carrier, dialect=dialect, alone=alone)
    known = {(it.code, it.offset) for it in report.findings}
    for finding in report.findings:
        for what, changed, place in Advised(frame, finding, dialect).frames():
            tried[finding.code] += 1
            after = check(changed, carrier=carrier, dialect=dialect, alone=alone)
            again = [it for it in after.findings if it.offset == place and is_same(it, finding)]
            fresh = [it for it in after.errors if it.offset == place and (it.code, finding.offset) not in known]
            for left in again + fresh:
                yield f"{frame.hex()} {finding.code}: {what!r} gives {changed.hex()}: {left.code} {left.message}"


tried: Counter[str] = Counter()
"""How often helps were tried, by code."""


def is_same(one: Finding, other: Finding) -> bool:
    """Returns whether two findings at one place are the same; the header requests two memories at one place."""
    scopes = [re.findall("local|global", it.message)[:1] for it in (one, other)]
    return one.code == other.code and scopes[0] == scopes[1]


@pytest.mark.parametrize("code", CODES)
def test_the_helps_for_the_examples_of_all_codes(code: str) -> None:
    entry = CODES[code]
    assert list(trouble(entry.example, entry.carrier, alone=entry.alone)) == []
    (finding, *_) = [
        it for it in check(entry.example, carrier=entry.carrier, alone=entry.alone).findings if it.code == code
    ]
    if re.search(r"\d", finding.help):
        assert any(Advised(entry.example, finding).frames()) or code in WITHOUT_A_NUMBER_TO_TRY


def with_header(type_: int, globals_: int, locals_: int, body: bytes) -> bytes:
    return with_length(bytes((1, 0, type_)) + write_memory(globals_, locals_) + body)


TYPES = st.sampled_from([0x00, 0x80])
SIZES = st.integers(0, 40) | st.integers(0, 1023)


@st.composite
def with_a_wrong_argument(draw: st.DrawFn) -> bytes:
    """A careful operation with one number in it that may be anything."""
    operation = draw(st.sampled_from(KNOWN).flatmap(careful_operation))
    frame = ev3proto.direct_command(operation, global_size=60, local_size=60, reply=True).build()
    (parsed,) = ev3proto.parse(frame).operations  # type: ignore[attr-defined]
    if not parsed.arguments:
        return frame
    argument = draw(st.sampled_from(parsed.arguments))
    number = draw(
        st.sampled_from([200, 300, -128, -129, 70000, -70000, 99, 31, 32]) | st.integers(-(2**31) + 1, 2**31 - 1)
    )
    wrong = encode_as("LC4", number) if number not in range(-127, 128) else encode_as("LC1", number)
    start, end = argument.offset, argument.offset + argument.length
    return with_length(frame[2:start] + wrong + frame[end:])


@st.composite
def with_jumps(draw: st.DrawFn) -> bytes:
    """Jumps to any place, in any encoding, among other operations."""
    pieces = []
    for _ in range(draw(st.integers(1, 5))):
        number = draw(st.integers(-60, 60) | st.integers(-3000, 3000))
        try:
            distance = encode_as(draw(st.sampled_from(["LC0", "LC1", "LC2", "LC4", "LAB1"])), number)
        except BuildError:
            distance = encode_as("LC4", number)
        jump = draw(st.sampled_from([b"\x40", b"\x41\x40", b"\x41\x41"])) + distance
        other = draw(st.sampled_from([b"\x01", bytes.fromhex("82 1b 02"), b"\x0d\x01", b"\x01" * 35]))
        pieces.append(draw(st.sampled_from([jump, other])))
    return with_header(draw(TYPES), 4, 4, b"".join(pieces))


@st.composite
def with_long_fields(draw: st.DrawFn) -> bytes:
    """System commands whose paths and names are too long."""
    entry = draw(st.sampled_from([it for it in SYSTEM if any(field.kind is Kind.TEXT for field in it.request)]))
    path = st.lists(st.text("ab.", max_size=140), max_size=4).map("/".join)
    values: dict[str, Any] = {
        field.name: draw(path) if field.kind is Kind.TEXT else b"" if field.kind is Kind.DATA else 1
        for field in entry.request
    }
    try:
        return ev3proto.system_command(entry.number, **values).build()
    except BuildError:
        return ev3proto.system_command("DELETE_FILE", path=draw(path)).build()


LISTS = [it for it in KNOWN if any(isinstance(each.length, str) or each.most is not None for each in it.parameters)]
"""Operations with texts or arrays whose lengths, or maximum lengths, are in the tables."""


@st.composite
def with_wrong_lists(draw: st.DrawFn) -> bytes:
    """Texts instead of arrays and names, and lengths that may belong to other parameters."""
    declaration = draw(st.sampled_from(LISTS))
    told = {each.length for each in declaration.parameters}
    values = [
        argument.value if not argument.is_variable else GV(0)
        for argument in draw(careful_operation(declaration)).arguments
    ]
    for number, parameter in enumerate(declaration.parameters[: len(values)]):
        if not parameter.is_output and (parameter.length is not None or parameter.most is not None):
            values[number] = draw(st.text("ab", max_size=20) | st.text("ab", min_size=100, max_size=160))
        elif parameter.name in told:
            values[number] = draw(st.integers(0, 40) | st.integers(-5, 200))
    body = bytes((declaration.opcode.number,)) + (
        encode_integer(declaration.command.number) if declaration.command else b""
    )
    body += b"".join(map(encoded, values))
    return with_header(draw(TYPES), 60, 60, body)


def encoded(value: Any) -> bytes:
    if isinstance(value, Variable):
        return encode_variable(value)
    if isinstance(value, float):
        return encode_as("LC4", value)
    return encode_string(value) if isinstance(value, str) else encode_integer(value)


EFFECTS = [
    "94 01 01 82 b8 01 82 e8 03",
    "94 00",
    "96",
    "ae 00 01 32 00 0a 00 01",
    "ae 00 03 32 00 0a 00 01",
    "a3 00 01 01",
    "aa 00 01",
    "84 01",
    "84 00",
    "84 02 01 00 00",
    "85 0a 40",
]
"""Sounds, moves and drawings, and operations that wait for them or show them."""


@st.composite
def with_effects(draw: st.DrawFn) -> bytes:
    """Sounds, moves and drawings in any order."""
    body = b"".join(map(bytes.fromhex, draw(st.lists(st.sampled_from(EFFECTS), min_size=1, max_size=6))))
    return with_header(draw(TYPES), 4, 4, body)


@st.composite
def like_an_example(draw: st.DrawFn) -> bytes:
    """The example of a code after other operations, or with one byte changed."""
    frame = draw(st.sampled_from(list(CODES.values()))).example
    if draw(st.booleans()) and len(frame) > 7 and len(frame) < 1000 and frame[4] in (0x00, 0x80):
        before = draw(st.lists(raw_operations(), max_size=2).map(b"".join))
        length = int.from_bytes(frame[:2], "little") + len(before)
        return length.to_bytes(2, "little") + frame[2:7] + before + frame[7:]
    at = draw(st.integers(0, len(frame) - 1))
    return frame[:at] + bytes((draw(st.integers(0, 255)),)) + frame[at + 1 :]


@pytest.mark.parametrize(
    "strategy",
    [
        with_a_wrong_argument(),
        with_jumps(),
        with_wrong_lists(),
        with_effects(),
        with_long_fields(),
        like_an_example(),
        mutated_frames(),
    ],
    ids=["argument", "jumps", "lists", "effects", "fields", "examples", "mutated"],
)
def test_the_helps_for_drawn_faults(strategy: st.SearchStrategy[bytes]) -> None:
    @some
    @given(strategy, st.sampled_from((None, *CARRIERS)), st.sampled_from(DIALECTS))
    def helps(frame: bytes, carrier: str | None, dialect: str) -> None:
        assert list(trouble(frame, carrier, dialect)) == []

    helps()
