"""A record of what is found in many texts, to compare before and after a change of `ev3proto.text.paste`.

    .venv/bin/python tests/support/pasted_texts.py make build/texts.jsonl [FILE ...]
    .venv/bin/python tests/support/pasted_texts.py compare build/texts.jsonl

The first command, before the change, runs the tests that read text and keeps every text that they read, those of the
pages and of the benchmarks, and of any other files. The second reads them again and shows what differs. It takes some
ten seconds; nothing else shows that a rule can go.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

import pytest

from ev3proto.text.paste import Pasted, read_argument, read_text
from ev3proto.text.paste.reader import Reader

ROOT = Path(__file__).parents[2]
MEASURES = ("tests/text", "tests/reading", "tests/cli/test_cli_texts.py", "tests/link/test_lesson.py")
LONGEST = 20_000
"""Characters of a text that are kept: longer ones are copies of a few lines."""
MOST_SHOWN = 40


class Recorder:
    """Keeps the texts that are read while it is active."""

    def __init__(self) -> None:
        self.texts: dict[str, None] = {}

    def __enter__(self) -> Recorder:
        self._read = read = Reader.read

        def keeps(reader: Reader, lines: Iterable[str], is_silent: Callable[[], bool]) -> Iterator[Pasted]:
            kept: list[str] = []
            try:
                yield from read(reader, self._noted(lines, kept), is_silent)
            finally:
                self.texts["".join(kept)[:LONGEST]] = None

        Reader.read = keeps  # type: ignore[method-assign,assignment]
        return self

    def __exit__(self, *_: object) -> None:
        Reader.read = self._read  # type: ignore[method-assign]

    @staticmethod
    def _noted(lines: Iterable[str], kept: list[str]) -> Iterator[str]:
        for line in lines:
            if len(kept) * len(line) < LONGEST and isinstance(line, str):
                kept.append(line if line.endswith("\n") else f"{line}\n")
            yield line


def texts_of_pages() -> Iterator[str]:
    """Yields the pages, their blocks, and each line of these."""
    for page in sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")]):
        text = page.read_text(encoding="utf-8")
        yield text
        for block in re.findall(r"```\w*\n(.*?)\n```", text, re.DOTALL):
            yield block
            yield from block.split("\n")


def texts_of_benchmarks() -> Iterator[str]:
    """Yields the lines that `benchmarks/test_texts.py` reads."""
    sys.path.insert(0, str(ROOT))
    from benchmarks.test_texts import LINES

    yield from (line.format(7) for line in LINES.values())


def _shown(piece: Pasted) -> dict[str, Any]:
    return {name: value for name, value in piece._asdict().items() if value}


def result(text: str) -> list[Any]:
    """Returns what is read from a text, and from one line as an argument of a command line."""
    try:
        found = [_shown(piece) for piece in read_text(text.splitlines(keepends=True))]
        argument = [_shown(read_argument(text))] if text.count("\n") <= 1 and len(text) < LONGEST else []
    except Exception as error:  # the fault of the code that is tried
        found, argument = [{"error": repr(error)}], []
    read: list[Any] = json.loads(json.dumps([found, argument], default=bytes.hex))
    return read


def make(record: Path, more: list[Path]) -> None:
    """Writes the record."""
    with Recorder() as recorder:
        pytest.main(["-q", "-p", "no:cacheprovider", *(str(ROOT / name) for name in MEASURES)])
    others = (path.read_text(encoding="utf-8", errors="replace") for path in more)
    texts = recorder.texts | dict.fromkeys([*texts_of_pages(), *texts_of_benchmarks(), *others])
    record.parent.mkdir(exist_ok=True)
    record.write_text("".join(json.dumps([text, result(text)]) + "\n" for text in texts if text.strip()))
    print(f"{len(texts)} texts")


def _differences(before: list[Any], now: list[Any]) -> Iterator[str]:
    for kind, old, new in zip(("text", "argument"), before, now, strict=True):
        yield from (f"- {kind} {one}" for one in old if one not in new)
        yield from (f"+ {kind} {one}" for one in new if one not in old)


def compare(record: Path) -> int:
    """Shows what differs from the record, and returns in how many texts."""
    count = 0
    for line in record.read_text().splitlines():
        text, before = json.loads(line)
        if (now := result(text)) != before:
            count += 1
            if count <= MOST_SHOWN:
                print(f"--- {text[:600]!r}", *_differences(before, now), sep="\n")
    print(f"{count} texts differ")
    return count


if __name__ == "__main__":
    action, name, *more = sys.argv[1:]
    if action == "make":
        make(Path(name), [*map(Path, more)])
    else:
        sys.exit(compare(Path(name)) > 0)
