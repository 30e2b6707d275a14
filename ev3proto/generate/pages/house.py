"""The map of the house: a picture of the packages and of what each builds on, from the imports at the top of files.

A package is above all that it imports. Lines show only imports from the row below, which is clear enough.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from html import escape
from pathlib import Path
from textwrap import wrap

NAME = "map.svg"

_PACKAGE = Path(__file__).parents[2]
_IMPORT = re.compile(r"^from ev3proto(?:\.(\w+)\S*)? import (\([^)]*\)|.*)$", re.MULTILINE)
_WIDTH, _HEIGHT, _BETWEEN = 180, 74, 10
_COLUMN, _ROW = _WIDTH + _BETWEEN, _HEIGHT + 22
_IN_A_ROW = 4
_CHARACTERS, _MOST_LINES = 30, 3

Uses = Mapping[str, set[str]]


def build() -> str:
    """Returns the picture, as SVG."""
    texts, uses = _packages()
    heights: dict[str, int] = {}
    for name in uses:
        _place(name, uses, heights)
    users = Counter(name for found in uses.values() for name in found)
    rows: list[list[str]] = []
    for height in range(max(heights.values()), -1, -1):
        row = sorted((name for name in heights if heights[name] == height), key=lambda name: (-users[name], name))
        rows += [row[start : start + _IN_A_ROW] for start in range(0, len(row), _IN_A_ROW)]
    width = _IN_A_ROW * _COLUMN + _BETWEEN
    boxes = {
        name: ((width - len(row) * _COLUMN + _BETWEEN) // 2 + column * _COLUMN, number * _ROW + _BETWEEN)
        for number, row in enumerate(rows)
        for column, name in enumerate(row)
    }
    parts = [*_lines(uses, heights, boxes)]
    parts += [line for name, box in boxes.items() for line in _box(name, texts[name], *box)]
    size = f'width="{width}" height="{len(rows) * _ROW}" viewBox="0 0 {width} {len(rows) * _ROW}"'
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="sans-serif" font-size="10">',
            "<title>The packages of ev3proto: each is above those that it imports</title>",
            '<rect width="100%" height="100%" fill="#ffffff"/>',
            *parts,
            "</svg>\n",
        ]
    )


def _packages() -> tuple[dict[str, str], Uses]:
    """Returns the first sentence of each package, or module beside them, and the names of those that it imports."""
    texts, uses = {}, {}
    for top in sorted(_PACKAGE.iterdir()):
        files = sorted(top.rglob("*.py")) or [top]
        main = top / "__init__.py" if top.is_dir() else top
        if main.suffix == ".py" and main.is_file() and top.stem != "__init__":
            paragraph = main.read_text(encoding="utf-8").split('"""', 2)[1].split("\n\n")[0]
            texts[top.stem] = re.split(r"(?<=[\w)])\.(?= |$)", " ".join(paragraph.replace("`", "").split()))[0]
            uses[top.stem] = {name for file in files for name in _imported(file)} - {top.stem}
    return texts, {name: {each for each in found if each in uses} for name, found in uses.items()}


def _imported(file: Path) -> Iterator[str]:
    if file.name != "__main__.py" or file.parent == _PACKAGE:
        for package, names in _IMPORT.findall(file.read_text(encoding="utf-8")):
            yield from [package] if package else re.findall(r"\w+", names)


def _place(name: str, uses: Uses, heights: dict[str, int]) -> int:
    if name not in heights:
        heights[name] = max((_place(each, uses, heights) + 1 for each in uses[name]), default=0)
    return heights[name]


def _lines(uses: Uses, heights: Mapping[str, int], boxes: Mapping[str, tuple[int, int]]) -> Iterator[str]:
    for name, found in uses.items():
        for other in sorted(found):
            if heights[name] == heights[other] + 1:
                (left, top), (end, bottom) = boxes[name], boxes[other]
                start = f"{left + _WIDTH // 2} {top + _HEIGHT}"
                yield f'<path d="M{start} L{end + _WIDTH // 2} {bottom}" stroke="#8899aa"/>'


def _box(name: str, text: str, left: int, top: int) -> Iterator[str]:
    yield f'<rect x="{left}" y="{top}" width="{_WIDTH}" height="{_HEIGHT}" rx="5" fill="#eef3f8" stroke="#8899aa"/>'
    yield f'<text x="{left + 8}" y="{top + 18}" font-size="13" font-weight="bold" fill="#112233">{name}</text>'
    for number, line in enumerate(wrap(text, _CHARACTERS, max_lines=_MOST_LINES, placeholder=" ...")):
        yield f'<text x="{left + 8}" y="{top + 34 + 13 * number}" fill="#223344">{escape(line)}</text>'
