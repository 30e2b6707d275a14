"""Each rule of pasted text is needed: it is taken out, and what its own example gives is then something else."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pytest
from support.cases import each

from ev3proto.semantics import advice
from ev3proto.tables.strangers import LINES, StrangeLine
from ev3proto.text.paste import elements, read_text, repairs, runs
from ev3proto.text.paste.elements import BYTES, FORMS, Form, elements_of
from ev3proto.text.paste.repairs import REPAIRS, SLIPS, Repair, Slip, slip_in

FASTER = ("run", "digits", "word")
"""Kinds of forms of which one row only saves time."""


@contextmanager
def without(module: Any, table: str, row: object) -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(module, table, tuple(one for one in getattr(module, table) if one is not row))
        elements._splitter.cache_clear()
        yield
    elements._splitter.cache_clear()


def elements_in(form: Form) -> Any:
    example = form.example.split("|") if form.example.count("|") == 2 else ("", form.example, "")
    before = "0f " if form.kind in ("blank", "other") and not example[0] else example[0]
    found, after = elements_of(f"{before}{example[1]}{example[2]}")
    return [(one.kind, one.text, one.gap) for one in found], after


@each("form", [form for form in FORMS if form.kind not in FASTER or "|" in form.example])
def test_a_form_is_needed_by_its_example(form: Form) -> None:
    whole = elements_in(form)
    with without(elements, "FORMS", form):
        assert elements_in(form) != whole


@each("way", elements._WAYS)
def test_a_way_to_write_bytes_is_needed_by_its_example(way: elements.Way) -> None:
    whole = [elements._bytes_of(way.example, base) for base in BYTES]
    with without(elements, "_WAYS", way):
        assert [elements._bytes_of(way.example, base) for base in BYTES] != whole


@each("row", runs._BY_DIGITS)
def test_a_row_of_bases_is_needed_by_one_of_its_examples(row: Any) -> None:
    examples = [elements_of(example)[0] for example in row[0].split(", ") if " " in example] or [elements_of(row[0])[0]]
    whole = [runs.Run(example).bases for example in examples]
    with without(runs, "_BY_DIGITS", row), pytest.MonkeyPatch.context() as patched:
        patched.setattr(runs, "_BY_DIGITS", (*runs._BY_DIGITS, ("", lambda _: True, ("nothing",))))
        assert [runs.Run(example).bases for example in examples] != whole


@each("row", runs._BY_WIDTH)
def test_a_base_that_any_digits_may_have_is_needed_by_its_example(row: Any) -> None:
    assert [piece.data for piece in read_text([row[0]])] == [bytes.fromhex("06002a0080000001")]
    with without(runs, "_BY_WIDTH", row):
        assert [piece.data for piece in read_text([row[0]])] != [bytes.fromhex("06002a0080000001")]


@each("line", LINES)
def test_a_line_about_something_else_is_needed_by_its_example(line: StrangeLine) -> None:
    assert [piece.problem for piece in read_text([line.example])] == [line.says]
    with without(advice, "LINES", line):
        assert line.says not in [piece.problem for piece in read_text([line.example])]


@each("slip", SLIPS[:-1])
def test_a_slip_is_needed_by_its_example(slip: Slip) -> None:
    whole = slip_in(slip.example)
    with without(repairs, "SLIPS", slip):
        assert slip_in(slip.example) != whole


@each("repair", REPAIRS)
def test_a_repair_is_needed_by_its_example(repair: Repair) -> None:
    whole = list(read_text([repair.example]))
    assert [piece for piece in whole if piece.notes or piece.problem]
    with without(repairs, "REPAIRS", repair):
        assert list(read_text([repair.example])) != whole
