"""Makes the documentation's search find names and numbers: an extension of docs/conf.py.

Operations by name and by what they do, opcodes, system commands and the names of values become objects of a domain,
which Sphinx's search lists with a link to the entry itself.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from docutils.nodes import make_id
from sphinx.application import Sphinx
from sphinx.domains import Domain, ObjType

from ev3proto.generate.pages.system_commands import heading
from ev3proto.tables import AREAS
from ev3proto.tables.declaration import declarations
from ev3proto.tables.enumerations import ENUMERATIONS
from ev3proto.tables.system import SYSTEM

Entry = tuple[str, str, str, str, str, int]
"""Name, name shown, type, page, anchor, priority, as the search gets them from a domain."""

FIRST, SECOND = 0, 1
"""Priorities of Sphinx: before and after pages that contain a word."""

MOST_USERS = 5
"""The names of an enumeration are listed at its operations if there are at most this many."""


def setup(app: Sphinx) -> dict[str, Any]:
    """Registers the domain."""
    app.add_domain(Instructions)
    return {"parallel_read_safe": True}


class Instructions(Domain):
    """The instruction set and the system commands."""

    name = "ev3"
    label = "EV3"
    object_types: ClassVar = {kind: ObjType(kind) for kind in ("opcode", "operation", "system command", "value")}

    def get_objects(self) -> Iterator[Entry]:
        """Yields an entry for each heading in the reference."""
        users: dict[str, list[tuple[str, str]]] = {}
        for area, opcodes in AREAS.items():
            page = f"reference/{area}"
            for opcode in opcodes:
                yield _entry(f"0x{opcode.number:02X} {opcode.name}", "opcode", page, opcode.name)
            for each in declarations(opcodes):
                yield _entry(each.name, "operation", page, each.name)
                yield _entry(f"{each.name}: {each.text}", "operation", page, each.name, SECOND)
                for enumeration in {it.enum.name for it in each.parameters if it.enum}:
                    users.setdefault(enumeration, []).append((each.name, page))
        for command in SYSTEM:
            name, page = heading(command), "reference/system-commands"
            yield _entry(name, "system command", page, name)
            yield _entry(f"0x{command.number:02X} {name}", "system command", page, name, SECOND)
        for declared in ENUMERATIONS:
            named = users.get(declared.name, [])
            for member in declared.members:
                if len(named) <= MOST_USERS:
                    for operation, page in named:
                        yield _entry(f"{operation} {member}", "value", page, operation)
                yield _entry(f"{declared.name}.{member}", "value", "reference/enumerations", declared.name, SECOND)

    def resolve_any_xref(self, *_: Any, **__: Any) -> list[Any]:
        """Returns an empty list: the pages link to headings."""
        return []

    def merge_domaindata(self, docnames: Any, otherdata: Any) -> None:
        """Does nothing: the tables are the same in every process."""


def _entry(name: str, kind: str, page: str, heading: str, priority: int = FIRST) -> Entry:
    return (name, name, kind, page, make_id(heading), priority)
