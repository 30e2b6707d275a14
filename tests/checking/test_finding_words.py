"""The words of findings: each comes from a template of its code, none is written in a rule."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest
from hypothesis import given, settings
from support.effort import effort

import ev3proto
from ev3proto import check
from ev3proto.checking.codes import CODES, FindingCode, Words
from ev3proto.checking.program_codes import PROGRAM_CODES
from ev3proto.checking.report import Finding, Report
from ev3proto.program import check_program
from ev3proto.testing import accepted_frames, frames, mutated_frames

ALL = CODES | PROGRAM_CODES
PACKAGE = Path(ev3proto.__file__).parent


def pattern(template: str) -> str:
    """Returns what a template may become: its words with anything for a part, with or without those in brackets."""
    words = re.sub(r"\\\{[^}]*\}", ".+", re.escape(template))
    return re.sub(r"\\\[(.*?)\\\]", r"(?:\1)?", words)


def is_said_by(code: FindingCode, finding: Finding) -> bool:
    return any(
        re.fullmatch(pattern(words.message), finding.message, re.S) and re.fullmatch(pattern(words.help), finding.help)
        for words in code.words.values()
    )


def others(report: Report) -> list[Finding]:
    """Returns the findings whose words are not those of their codes."""
    return [finding for finding in report.findings if not is_said_by(ALL[finding.code], finding)]


def test_what_is_in_brackets_is_said_if_its_value_is_known() -> None:
    words = Words("at most {most}[ on {carrier}]", "omit {it}[, or {other}]")
    assert words.filled({"most": 8, "carrier": "USB", "it": "[1]"}) == ("at most 8 on USB", "omit [1]")
    assert words.filled({"most": 8, "carrier": None, "it": 1, "other": 2}) == ("at most 8", "omit 1, or 2")


@pytest.mark.parametrize("name", ALL)
def test_the_words_about_the_example_of_a_code_are_its_own(name: str) -> None:
    code = ALL[name]
    if name in PROGRAM_CODES:
        report: Report = check_program(code.example)
    else:
        report = check(code.example, carrier=code.carrier, alone=code.alone)
    assert others(report) == []


@settings(max_examples=effort(100, 3000), deadline=None)
@given(frames() | accepted_frames() | mutated_frames())
def test_the_words_about_any_frame_are_those_of_codes(frame: bytes) -> None:
    assert others(check(frame, alone=True)) == []


SENTENCE = re.compile(r"[a-z]+ [a-z]+ [a-z]+")


def sentences(path: Path) -> list[str]:
    """Returns the texts in a module that have three words, other than docstrings and the names of words."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    statements = {id(one.value) for one in ast.walk(tree) if isinstance(one, ast.Expr)}
    found = [one for one in ast.walk(tree) if isinstance(one, ast.Constant) and id(one) not in statements]
    texts = [one.value for one in found if isinstance(one.value, str)]
    keys = {key for code in ALL.values() for key in code.words}
    return [text for text in texts if text not in keys and SENTENCE.search(text)]


def test_no_rule_has_a_sentence() -> None:
    rooms = [*(PACKAGE / "checking/rules").glob("*.py"), PACKAGE / "program/checking.py"]
    assert {path.name: found for path in rooms if (found := sentences(path))} == {}
