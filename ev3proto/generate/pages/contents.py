"""The first page of the reference: its contents, and how to read an entry."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.generate.areas import AREA_TITLES
from ev3proto.generate.pages.markdown import block, listed, table
from ev3proto.tables import AREAS
from ev3proto.tables.declaration import Declaration, declarations

OTHERS = {
    "system-commands.md": "System commands: files, mailboxes, the bootloader",
    "enumerations.md": "Enumerations: the names of numbers",
    "numbers.md": "Everything by number and by name",
    "checker-codes.md": "What `check` finds: all codes with examples",
    "filters.md": "Filters: all that `--filter` can ask for",
    "read-only.md": "What only reads: the list of `proxy --read-only` and `replay`",
    "command-line.md": "The command line",
    "python.md": "The Python API",
}
"""The other pages of the reference, in order."""


def blocks() -> Iterator[str]:
    """Yields the blocks of the page."""
    yield "This reference is generated from the tables of ev3proto and from the program itself."
    yield "## The instruction set"
    rows = (
        (f"[{AREA_TITLES[area]}]({area}.md)", f"`{area}`", str(len(list(declarations(opcodes)))), _first(area))
        for area, opcodes in AREAS.items()
    )
    yield table(("page", "area", "operations", "among them"), rows)
    yield "## Everything else"
    yield listed(f"[{title}]({name})" for name, title in OTHERS.items())
    yield "## How to read an entry"
    yield (
        "Names are the firmware's. A parameter is `in` if the operation reads it, `out` if the operation writes it to"
        " a variable, `inout` if it does both. `DATA8`, `DATA16` and `DATA32` are signed numbers of 1, 2 and 4 bytes,"
        ' `DATAF` is a float of 4 bytes; the lowest number of each type means "not a number". A range has the values'
        " that make sense to the brick."
    )
    yield (
        "The Python call needs `import ev3proto` and `from ev3proto import ops, system`; operations of other firmwares"
        " need `from ev3proto.ops import xtended, compat`; variables such as `LV(0)` and `Global()` are attributes of"
        " `ev3proto`. Outputs that a call omits get a place in global memory. Below the call is its frame in"
        " hexadecimal, a line per part. The last word of a line is the encoding."
    )
    yield (
        "The fields of Wireshark are those of the dissector; `ev3.op` has every opcode, `ev3.cmd` every operation by"
        " name."
    )
    yield block("{toctree}", [":hidden:", "", *(f"{area}" for area in AREAS), *(each[:-3] for each in OTHERS)])


def _first(area: str) -> str:
    named: list[Declaration] = list(declarations(AREAS[area]))
    return ", ".join(f"`{each.name}`" for each in named[:3])
