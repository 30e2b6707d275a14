"""Phrases that read as if translated, kept out of everything that a person reads: texts, messages, comments."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

GAP = r"(?:[^\S\n]|\n\s*(?:#|--|//|>)?[^\S\n]*)+"
"""Between two words of a phrase: blanks, or the end of a line with the sign of a comment on the next one."""

PHRASES = {
    r"(?<!there\s)is (?-i:none)": "does not exist, has none, is not one",
    r"(?<!there\s)(?:is|are) no(?! longer| more)": "not an X, unknown X ('there is no X' and 'is no longer' are right)",
    r"whoever": "the caller, the client, the reader",
    r"(?<!`)nobody": "not ... by anyone; or the passive",
    r"somebody": "a user, a client; or the passive",
    r"so many": "this number of",
    r"that which": "what",
    r"stands?(?! for| still|-in)": "is, has ('stands for' and 'stands still' are right)",
}
"""Regular expressions, each with what to write instead."""

FOLDERS = ("docs", "captures", "benchmarks", "fuzz", "bin", "ev3proto", "tests", "dissector")
SUFFIXES = {".md", ".html", ".js", ".lua", ".py", ""}
NOT_READ = {"tests/house/test_plain_english.py"}
NOT_YET = ("ev3proto/", "dissector/", "docs/reference/")

_PHRASE = re.compile(
    r"\b(?:" + "|".join(f"({phrase.replace(' ', GAP)})" for phrase in PHRASES) + r")(?!\w)", re.IGNORECASE
)


def _files() -> Iterator[tuple[str, str]]:
    inside = (path for folder in FOLDERS for path in (ROOT / folder).rglob("*") if path.suffix in SUFFIXES)
    for path in [*ROOT.glob("*.md"), *inside]:
        name = path.relative_to(ROOT).as_posix()
        if path.is_file() and name not in NOT_READ and not name.startswith(NOT_YET):
            yield name, path.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("# it is no\n# message type", ["is no"]),
        ("Nobody stands here, so many that none is.", ["nobody", "stands", "so many"]),
    ],
)
def test_a_phrase_is_found(text: str, found: list[str]) -> None:
    assert [re.sub(GAP, " ", each[0].lower()) for each in _PHRASE.finditer(text)] == found


def test_texts_are_plain_english() -> None:
    wrong = []
    for name, text in _files():
        for found in _PHRASE.finditer(text):
            instead = list(PHRASES.values())[(found.lastindex or 1) - 1]
            line = text.count("\n", 0, found.start()) + 1
            wrong.append(f"{name}:{line}: {' '.join(found[0].split())!r}: write {instead}")
    assert not wrong, "\n".join(wrong)
