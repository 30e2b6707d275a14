"""How Sphinx builds the documentation: `python -m sphinx -W docs build/docs`, with what the extra `docs` installs."""

import sys
from pathlib import Path

from ev3proto.version import VERSION

sys.path.insert(0, str(Path(__file__).parent))

project = "ev3proto"
release = version = VERSION
html_title = f"ev3proto {VERSION}"
extensions = ["myst_parser", "playground.build", "search_index"]
myst_heading_anchors = 3
exclude_patterns: list[str] = []
templates_path = ["_templates"]
html_theme = "furo"
html_favicon = "../ev3proto/brick/servers/page/static/icon.svg"
# Furo's default, with a link to the playground.
html_sidebars = {
    "**": [
        f"sidebar/{part}.html" for part in ("brand", "search", "playground", "scroll-start", "navigation", "scroll-end")
    ]
}
html_show_copyright = False
html_show_sphinx = False
html_copy_source = False
# The pages show bytes and texts of the firmware, so quotes and dashes must stay unchanged.
smartquotes = False
highlight_language = "none"
