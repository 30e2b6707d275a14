"""The floors of the house, as in CONTRIBUTING.md: files import from lower floors only, and never in a circle."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "ev3proto"

FLOORS = (
    {"tables", "errors", "version", "temporary", "whole_files", "bounded", "extras"},
    {"messages"},
    {"schema", "enums"},
    {"stream", "system"},
    {"semantics"},
    {"compose", "dialogue", "ops"},
    {"checking"},
    {"text", "scapy"},
    {"program"},
    {"testing", "sampling"},
    {"capture"},
    {"generate"},
    {"pyshark"},
    {"brick"},
    {"link"},
    {"cli"},
    {"__main__"},
)
"""From below. Parts of one floor do not import each other."""


def _module(path: Path) -> str:
    return ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")


FILES = {_module(path): path for path in sorted(PACKAGE.rglob("*.py"))}


def _imports(path: Path) -> Iterator[str]:
    """The modules of the project that a file imports: at its top, in functions and for type checkers."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module is not None:
            assert node.level == 0, f"{path}: relative imports are not followed here"
            names = [f"{node.module}.{alias.name}" for alias in node.names]
        elif isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        else:
            continue
        for name in names:
            # An import names a module, or a name in one.
            found = name if name in FILES else name.rpartition(".")[0]
            if found in FILES:
                yield found


IMPORTS = {module: set(_imports(path)) - {module} for module, path in FILES.items()}


def _part(module: str) -> str:
    return module.split(".")[1] if "." in module else ""


def test_every_part_has_a_floor() -> None:
    placed = [part for floor in FLOORS for part in floor]
    assert len(placed) == len(set(placed))
    # The package itself offers names of all floors.
    assert {_part(module) for module in FILES} == {"", *placed}


def test_the_floors_are_those_of_the_table() -> None:
    table = re.findall(r"^\| (\d+) \| (`.*?) \|", (ROOT / "CONTRIBUTING.md").read_text(), re.MULTILINE)
    listed = {int(number): set(re.findall(r"`(\w+)`", parts)) for number, parts in table}
    assert listed == dict(enumerate(FLOORS))


def test_everything_leans_on_lower_floors_only() -> None:
    height = {part: number for number, floor in enumerate(FLOORS) for part in floor}
    leaning = [
        f"{module} imports {other}"
        for module, others in IMPORTS.items()
        for other in others
        if _part(module) not in ("", _part(other)) and height.get(_part(other), len(FLOORS)) >= height[_part(module)]
    ]
    assert leaning == []


def test_no_files_import_each_other_in_a_circle() -> None:
    try:
        TopologicalSorter(IMPORTS).prepare()
    except CycleError as error:
        raise AssertionError(" -> ".join(reversed(error.args[1]))) from None
