"""Mutation testing: which small faults in the core do the narrow tests not see?

    python -m benchmarks.mutation [--sample 60] [--seed 1] [schema semantics checking framing session]

draws mutants of the files of each part at random (cosmic-ray makes them), runs the tests of that part in a copy of the
project, and prints the survivors, each with its change. All mutants of all parts would take days; the figures in
README.md are those of a sample. What only types or docstrings can show is not counted.
"""

from __future__ import annotations

import argparse
import ast
import difflib
import os
import random
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from cosmic_ray import plugins
from cosmic_ray.ast import get_ast
from cosmic_ray.mutating import mutate_code

ROOT = Path(__file__).parents[1]
_MOST_SECONDS = 180


class Part(NamedTuple):
    """Files, and the tests that should see faults in them, quick ones first."""

    files: tuple[str, ...]
    tests: tuple[str, ...]


_SIDE_BY_SIDE = ("tests/schema/test_frame_buffer.py", "tests/schema/test_boundaries.py")
_SCHEMA = ("test_schema", "test_byte_code", "test_system_frames", "test_discovery", "test_stream")
_CHECKING = (
    "test_checking",
    "test_advice",
    "test_devices",
    "test_verdict",
    "test_alone",
    "test_nearest",
    "test_fixing",
)

PARTS = {
    "schema": Part(
        ("ev3proto/schema/*.py",),
        (
            *_SIDE_BY_SIDE,
            *(f"tests/schema/{name}.py" for name in _SCHEMA),
            "tests/compose/test_names.py",
            "tests/schema/test_wire_format.py",
        ),
    ),
    "semantics": Part(
        ("ev3proto/semantics/*.py", "ev3proto/semantics/drafts/*.py"),
        (_SIDE_BY_SIDE[1], "tests/semantics", "tests/compose", *(f"tests/checking/{name}.py" for name in _CHECKING)),
    ),
    "checking": Part(
        ("ev3proto/checking/*.py", "ev3proto/checking/rules/*.py"),
        (_SIDE_BY_SIDE[1], *(f"tests/checking/{name}.py" for name in _CHECKING)),
    ),
    "framing": Part(
        ("ev3proto/capture/framing.py",),
        (_SIDE_BY_SIDE[0], "tests/capture/test_capture_streams.py", "tests/capture/test_resynchronising.py"),
    ),
    "session": Part(("ev3proto/link/session.py",), ("tests/link/test_link_session.py",)),
}


class Mutant(NamedTuple):
    """One change of one file."""

    path: str
    operator: str
    occurrence: int


def mutants(part: Part) -> list[Mutant]:
    """Returns all mutants of a part."""
    found: list[Mutant] = []
    for pattern in part.files:
        for path in sorted(ROOT.glob(pattern)):
            tree = get_ast(path.read_text(encoding="utf-8"))
            for name in filter(_is_telling, plugins.operator_names()):
                operator = plugins.get_operator(name)()
                count = sum(len(list(operator.mutation_positions(node))) for node in _nodes(tree))
                found += [Mutant(path.relative_to(ROOT).as_posix(), name, number) for number in range(count)]
    return found


def _is_telling(operator: str) -> bool:
    """Returns whether an operator needs no arguments, and changes more than `is` to `==`, which enumerations share."""
    return "/Variable" not in operator and not operator.endswith(("_Is_Eq", "_IsNot_NotEq"))


def _nodes(node: Any) -> Iterator[Any]:
    yield node
    for child in getattr(node, "children", ()):
        yield from _nodes(child)


def _meaning(source: str) -> str:
    """Returns what a file does, without annotations and docstrings."""
    tree = ast.parse(source)
    for node in ast.walk(tree):
        if isinstance(node, ast.arg | ast.AnnAssign):
            node.annotation = ast.Constant(None)
        elif isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            node.returns = None
        if isinstance(node, ast.FunctionDef | ast.ClassDef | ast.Module) and ast.get_docstring(node) is not None:
            node.body = [*node.body[1:], ast.Pass()]
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.dump(node.test):
            node.body = [ast.Pass()]
    return ast.dump(tree)


def mutated(mutant: Mutant) -> tuple[str, str] | None:
    """Returns the file before and after the change; None if it does the same."""
    before = (ROOT / mutant.path).read_text(encoding="utf-8")
    after = mutate_code(before, plugins.get_operator(mutant.operator)(), mutant.occurrence)
    if after is None:
        return None
    try:
        is_same = _meaning(before) == _meaning(after)
    except SyntaxError:
        return None
    return None if is_same else (before, after)


def survives(folder: Path, part: Part, path: str, changed: str) -> bool:
    """Returns whether the tests of a part pass with a changed file."""
    file = folder / path
    before = file.read_text(encoding="utf-8")
    file.write_text(changed, encoding="utf-8")
    words = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", "-p", "no:xdist", *part.tests]
    environment = os.environ | {"PYTHONPATH": str(folder), "PYTHONDONTWRITEBYTECODE": "1"}
    try:
        done = subprocess.run(
            words, cwd=folder, env=environment, capture_output=True, timeout=_MOST_SECONDS, check=False
        )
        return done.returncode == 0
    except subprocess.TimeoutExpired:
        return False
    finally:
        file.write_text(before, encoding="utf-8")


def main() -> None:
    """Prints the survivors of a sample, and their share."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", default=list(PARTS), metavar="PART")
    parser.add_argument("--sample", type=int, default=60, help="number of mutants of each part")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "project"
        shutil.copytree(ROOT, folder, ignore=shutil.ignore_patterns(".*", "__pycache__", "build", "*.egg-info"))
        for part_name in options.parts:
            part = PARTS[part_name]
            drawn = mutants(part)
            random.Random(options.seed).shuffle(drawn)
            tried = survived = 0
            for mutant in drawn:
                change = mutated(mutant)
                if change is None:
                    continue
                if tried == options.sample:
                    break
                tried += 1
                if survives(folder, part, mutant.path, change[1]):
                    survived += 1
                    before, after = (text.splitlines() for text in change)
                    lines = difflib.unified_diff(before, after, lineterm="", n=0)
                    print(f"{mutant.path}: {mutant.operator}", *list(lines)[2:], sep="\n    ", flush=True)
            print(f"{part_name}: {survived} of {tried} survive, of {len(drawn)} mutants", flush=True)


if __name__ == "__main__":
    main()
