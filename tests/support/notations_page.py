"""The page docs/notations.md: the notations that are read, each with the same frame in it.

`python tests/support/notations_page.py` writes it anew. A test reads every example on it.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent))

from support.notations import LINE, LINES

PAGE = Path(__file__).parent.parent.parent / "docs" / "notations.md"
FRAME = bytes.fromhex("0f 00 00 00 80 00 00 94 01 81 02 82 e8 03 82 e8 03")

_MARK = "<!-- Drawn by tests/support/notations_page.py: edit what it is drawn from, not this page. -->"
_ABOUT = """\
# Notations

`ev3proto decode`, `check` and all other commands that read a text find frames in it by one rule: a run of byte values
whose length field fits it is a frame, in whatever notation it stands and whatever stands around it. What looks like a
frame and is none is reported, with line and column.

These are the notations that are tested. Each example has the same frame: length 15, counter 0, a direct command without
a reply, a tone of 1000 Hz. For bytes that you do not know, such as those of a counter, write `xx` or `MM` each.
"""


def page() -> str:
    """The text of the page."""
    rows = [f"| {_plain(name)} | {_code(notation(FRAME))} |" for name, notation in LINE.items()]
    blocks = [f"{_plain(name)}:\n\n````text\n{notation(FRAME)}\n````" for name, notation in LINES.items()]
    table = ["| notation | example |", "| --- | --- |", *rows]
    parts = [_MARK, _ABOUT.rstrip(), "## On one line", "\n".join(table), "## On several lines", *blocks]
    return "\n\n".join(parts) + "\n"


def examples(text: str) -> Iterator[str]:
    """The examples on a page, as its readers see them."""
    for row in re.findall(r"^\| (?!notation|---).*? \| (``? ?.*?) \|$", text, re.MULTILINE):
        yield re.sub(r"^(``?) ?(.*?) ?\1$", r"\2", row).replace(r"\|", "|")
    yield from re.findall(r"^````text\n(.*?)\n````$", text, re.MULTILINE | re.DOTALL)


def _plain(name: str) -> str:
    """A name as it is, in Markdown."""
    return re.sub(r"([\\`*_{}\[\]<>#|$%])", r"\\\1", name)


def _code(text: str) -> str:
    """Code in a cell of a table."""
    mark = "``" if "`" in text else "`"
    blank = " " if mark == "``" else ""
    return mark + blank + text.replace("|", r"\|") + blank + mark


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
    print(f"{PAGE} is written")
