"""All generated pages, as text."""

from __future__ import annotations

from ev3proto.generate.pages import (
    checker_codes,
    contents,
    enumerations,
    filters,
    numbers,
    operations,
    python_api,
    system_commands,
)
from ev3proto.tables import AREAS

FOLDER = "docs/reference"
"""Their folder. A page there that has the generated mark and is not generated now is stale."""


def build() -> dict[str, str]:
    """Generates all pages except that of the command line; the same text every time.

    Returns:
        Each file by its path in the project's folder.
    """
    pages = {
        "index.md": contents.text(),
        **{f"{area}.md": operations.text(area) for area in AREAS},
        "enumerations.md": enumerations.text(),
        "system-commands.md": system_commands.text(),
        "checker-codes.md": checker_codes.text(),
        "filters.md": filters.text(),
        "numbers.md": numbers.text(),
        "python.md": python_api.text(),
    }
    return {f"{FOLDER}/{name}": text for name, text in pages.items()}
