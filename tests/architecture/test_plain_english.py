"""Phrases that read as if translated, kept out of everything that a person reads: texts, messages, comments."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

GAP = r"(?:[^\S\n]|\n\s*(?:#|--|//|>|\*)?[^\S\n]*)+"
"""Between two words of a phrase: blanks, or the end of a line with the sign of a comment on the next one."""

PHRASES = {
    r"is (?-i:none)": "does not exist, has none, is not one",
    r"(?:is|are) no": "is not an X, unknown X, no such X",
    r"whoever": "the caller, the client, the reader",
    r"(?<!`)nobody": "not ... by anyone; or the passive",
    r"somebody": "a user, a client; or the passive",
    r"so many": "this number of",
    r"that which": "what",
    r"stands?": "is, has",
}
"""Regular expressions, each with what to write instead."""

RIGHT = (
    r"there (?:is|are) no(?:ne)?",  # "there is no reply", "0 if there is none"
    r"(?:is|are) no (?:longer|more)",
    r"stands? (?:for|still)|stand-in",
)
"""Longer phrases that are plain English."""

FOLDERS = (
    ".ci",
    ".github",
    "benchmarks",
    "bin",
    "captures",
    "dissector",
    "docs",
    "ev3proto",
    "exports",
    "fuzz",
    "tests",
)
SUFFIXES = {"", ".css", ".h", ".html", ".js", ".ksy", ".lua", ".md", ".py", ".toml", ".yml"}
NOT_READ = {"tests/architecture/test_plain_english.py"}

_PHRASE = re.compile(
    rf"\b(?:{'|'.join(RIGHT)}|{'|'.join(f'({phrase})' for phrase in PHRASES)})(?!\w)".replace(" ", GAP), re.IGNORECASE
)


def _found(text: str) -> Iterator[tuple[int, str, str]]:
    """Yields line, phrase, and what to write instead."""
    for found in _PHRASE.finditer(text):
        if found.lastindex:
            line = text.count("\n", 0, found.start()) + 1
            yield line, re.sub(GAP, " ", found[0].lower()), list(PHRASES.values())[found.lastindex - 1]


def _files() -> Iterator[tuple[str, str]]:
    """Yields names and contents; names of tests are read as words."""
    inside = (path for folder in FOLDERS for path in (ROOT / folder).rglob("*") if path.suffix in SUFFIXES)
    for path in [*ROOT.glob("*.md"), ROOT / "pyproject.toml", *inside]:
        name = path.relative_to(ROOT).as_posix()
        if path.is_file() and name not in NOT_READ:
            text = path.read_text(encoding="utf-8", errors="replace")
            yield name, re.sub(r"(?<=def )test_\w+", lambda test: test[0].replace("_", " "), text)


@pytest.mark.parametrize(
    ("text", "phrases"),
    [
        ("# it is no\n# message type", ["is no"]),
        ("Nobody stands here, so many that none is.", ["nobody", "stands", "so many"]),
        ("# nil if there\n# is none; there is no longer a reply; M stands for a motor", []),
    ],
)
def test_a_phrase_is_found(text: str, phrases: list[str]) -> None:
    assert [phrase for _, phrase, _ in _found(text)] == phrases


def test_texts_are_plain_english() -> None:
    wrong = [
        f"{name}:{line}: {phrase!r}: write {instead}"
        for name, text in _files()
        for line, phrase, instead in _found(text)
    ]
    assert not wrong, "\n".join(wrong)
