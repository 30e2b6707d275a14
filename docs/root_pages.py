"""Shows the repository's own pages on the site: an extension of docs/conf.py.

CONTRIBUTING.md and its like stay where people look for them. A page of the documentation has only a sentence;
the text of the file takes its place when Sphinx reads it.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

PAGES = {
    "changelog": "CHANGELOG.md",
    "contributing": "CONTRIBUTING.md",
    "fuzzing": "fuzz/README.md",
    "security": "SECURITY.md",
}
"""Page of the documentation -> file of the repository, whose links are as from the top folder."""

ROOT = Path(__file__).parents[1]
_LINK = re.compile(r"\]\((?!https?:|#)([^)#\s]+)")


def setup(app: Sphinx) -> dict[str, Any]:
    """Registers the reader."""
    app.connect("source-read", _read)
    return {"parallel_read_safe": True}


def _read(app: Sphinx, page: str, source: list[str]) -> None:
    if page in PAGES:
        app.env.note_dependency(str(ROOT / PAGES[page]))
        source[0] = _LINK.sub(_from_here, (ROOT / PAGES[page]).read_text(encoding="utf-8"))


def _from_here(link: re.Match[str]) -> str:
    """Returns the beginning of a link as it is from the folder of the documentation."""
    shown = {file: f"{page}.md" for page, file in PAGES.items()}
    target = link[1]
    if target in shown:
        return f"]({shown[target]}"
    return f"]({target.removeprefix('docs/')}" if target.startswith("docs/") else f"](../{target}"
