"""All generated pages, as text, and the first one: the contents of the reference, and how to read an entry."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.generate.pages import (
    checker_codes,
    enumerations,
    filters,
    house,
    numbers,
    operations,
    read_only,
    system_commands,
)
from ev3proto.generate.pages.markdown import block, listed, page, table
from ev3proto.tables import AREA_TITLES, AREAS
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


def _contents() -> Iterator[str]:
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


FOLDER = "docs/reference"
"""Their folder. A page there that has the generated mark and is not generated now is stale."""


def build() -> dict[str, str]:
    """Generates all pages except those about the package itself; the same text every time."""
    pages = {
        "index.md": page("Reference", _contents()),
        **{f"{area}.md": page(f"{AREA_TITLES[area]} ({area})", operations.blocks(area)) for area in AREAS},
        "enumerations.md": page("Enumerations", enumerations.blocks()),
        "system-commands.md": page("System commands", system_commands.blocks()),
        "checker-codes.md": page("What check finds", checker_codes.blocks()),
        "filters.md": page("Filters", filters.blocks()),
        "numbers.md": page("Numbers and names", numbers.blocks()),
        "read-only.md": page("What only reads", read_only.blocks()),
    }
    return {f"{FOLDER}/{name}": text for name, text in {**pages, house.NAME: house.build()}.items()}
