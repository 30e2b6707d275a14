"""All generated pages, as text."""

from __future__ import annotations

from ev3proto.generate.areas import AREA_TITLES
from ev3proto.generate.pages import (
    checker_codes,
    contents,
    enumerations,
    filters,
    house,
    numbers,
    operations,
    read_only,
    system_commands,
)
from ev3proto.generate.pages.markdown import page
from ev3proto.tables import AREAS

FOLDER = "docs/reference"
"""Their folder. A page there that has the generated mark and is not generated now is stale."""


def build() -> dict[str, str]:
    """Generates all pages except those about the package itself; the same text every time."""
    pages = {
        "index.md": page("Reference", contents.blocks()),
        **{f"{area}.md": page(f"{AREA_TITLES[area]} ({area})", operations.blocks(area)) for area in AREAS},
        "enumerations.md": page("Enumerations", enumerations.blocks()),
        "system-commands.md": page("System commands", system_commands.blocks()),
        "checker-codes.md": page("What check finds", checker_codes.blocks()),
        "filters.md": page("Filters", filters.blocks()),
        "numbers.md": page("Numbers and names", numbers.blocks()),
        "read-only.md": page("What only reads", read_only.blocks()),
    }
    return {f"{FOLDER}/{name}": text for name, text in {**pages, house.NAME: house.build()}.items()}
