"""No judgement is made twice: what it is made from is read in one place, and by those who ask another question.

`CONTRIBUTING.md`, "Where things are decided", has the questions and their rooms.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

READERS = {
    # The legal numbers, by which `semantics/judgement` judges.
    "ev3proto.semantics.domain.domain_of": {
        "semantics/facts": "derives the facts by which `judge` judges",
        "semantics/drafts/functions": "names the legal numbers",
        "testing": "draws legal numbers; a test asks `judge` about them",
        "generate/dissector/tables": "writes them into the dissector, which a test compares",
        "generate/pages/examples": "chooses one for an example",
    },
    "ev3proto.tables.encoding.limits_of": {
        "schema/argument": "what can be encoded is another question",
        "semantics/domain": "derives the legal numbers",
        "semantics/facts": "derives the facts by which `judge` judges",
        "link/whitelist": "the proxy needs an upper bound of a count",
        "testing": "draws what can be encoded",
    },
    "ev3proto.tables.encoding.BITS": {
        "schema/argument": "what can be encoded is another question",
        "semantics/domain": "derives the legal numbers",
        "semantics/judgement": "is the room",
        "testing": "draws what can be encoded",
        "text/assembly/disassembly": "writes a number as it is without a sign",
        "text/assembly/objects": "the types of lmsasm are another question",
    },
    # The memory of operations, which `semantics/footprint.memory_of` adds up.
    "ev3proto.semantics.footprint.footprints": {
        "semantics/drafts/draft": "keeps the places of a draft",
        "semantics/drafts/functions": "names a misaligned variable",
        "checking/rules/programs": "whether a variable is ever filled is another question",
    },
    "ev3proto.semantics.footprint.needed": {
        "checking/rules/memory": "what is certainly unused is another question",
    },
}
"""By the name of a fact, who reads it, and for what."""


def _named(path: Path) -> Iterator[str]:
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom):
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


@cache
def _imports() -> dict[str, set[str]]:
    files = sorted((ROOT / "ev3proto").rglob("*.py"))
    return {str(path.relative_to(ROOT / "ev3proto").with_suffix("")): set(_named(path)) for path in files}


@pytest.mark.parametrize("fact", READERS)
def test_only_these_read_what_a_judgement_is_made_from(fact: str) -> None:
    assert {module for module, names in _imports().items() if fact in names} == set(READERS[fact])


def test_the_rooms_of_the_table_exist() -> None:
    page = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    table = page.partition("| question | decided in |")[2].partition("\n\n")[0]
    rooms = re.findall(r"`([a-z_]+(?:/[a-z_]+)*)`", "\n".join(row.split("|")[2] for row in table.splitlines()[2:]))
    modules = {*_imports(), *(module.removesuffix("/__init__") for module in _imports())}
    assert len(rooms) > 15
    assert [room for room in rooms if "/" in room and room not in modules and f"{room}/__init__" not in modules] == []
    assert {"semantics/judgement", "semantics/footprint", "semantics/identify"} <= set(rooms)
