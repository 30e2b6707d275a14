"""The floors of the house, as CONTRIBUTING.md lists them: nothing leans on a floor above its own."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

PACKAGE = Path(__file__).parents[2] / "ev3proto"

FLOORS = (
    {"errors", "extras", "bounded", "starting", "tables", "temporary", "version", "whole_files"},
    {"enums", "messages", "schema"},
    {"stream"},
    {"semantics"},
    {"compose", "dialogue"},
    {"capture", "checking", "generate", "ops", "program", "sampling", "scapy", "system", "testing", "text"},
    {"brick", "pyshark"},
    {"link"},
    {"cli"},
)


def _modules() -> Iterator[tuple[str, Path]]:
    """Every file of the package, and the part of the house that it is in."""
    for path in sorted(PACKAGE.rglob("*.py")):
        part = path.relative_to(PACKAGE).parts[0].removesuffix(".py")
        # The package itself offers what all floors have; what starts a program stands on the top floor.
        if part != "__init__" and path.name != "__main__.py":
            yield part, path


def _imports(path: Path) -> Iterator[str]:
    """The parts of the house that a file imports, at its top or in a function."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module is not None:
            names = [f"{node.module}.{alias.name}" for alias in node.names]
        elif isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        else:
            continue
        yield from (name.split(".")[1] for name in names if name.startswith("ev3proto."))


def test_every_part_has_a_floor() -> None:
    placed = [part for floor in FLOORS for part in floor]
    assert len(placed) == len(set(placed))
    assert {part for part, _ in _modules()} <= set(placed)


def test_the_floors_are_those_of_the_table() -> None:
    table = re.findall(r"^\| (\d?) ?\| (`.*?) \|", (PACKAGE.parent / "CONTRIBUTING.md").read_text(), re.MULTILINE)
    listed: dict[int, set[str]] = {}
    height = -1
    for number, parts in table:
        height = int(number) if number else height
        listed.setdefault(height, set()).update(re.findall(r"`(\w+)`", parts))
    assert listed == dict(enumerate(FLOORS))


def test_nothing_leans_upwards() -> None:
    height = {part: number for number, floor in enumerate(FLOORS) for part in floor}
    leaning = [
        f"{path.relative_to(PACKAGE)} imports {other}"
        for part, path in _modules()
        for other in _imports(path)
        if other in height and height[other] > height[part]
    ]
    assert leaning == []


def test_the_tables_import_nothing_of_the_project() -> None:
    others = {other for part, path in _modules() if part == "tables" for other in _imports(path)}
    assert others == {"tables"}


def test_no_group_is_repeated_possessively() -> None:
    """Before 3.11.5, Python matches too little with `(?:ab?|c)*+`: the atomic group `(?>(?:ab?|c)*)` says the same."""
    group = re.compile(r"[^(]\)(?:[*+?]|\{+\d*,?\d*\}+)\+(?![\s\w])")
    found = [
        f"{path.relative_to(PACKAGE)}:{number}"
        for _, path in _modules()
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
        if not line.lstrip().startswith("#") and group.search(line)
    ]
    assert found == []
