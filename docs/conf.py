"""How Sphinx builds the documentation: `python -m sphinx -W docs build/docs`, with what the extra `docs` installs."""

import subprocess
import sys
from pathlib import Path

from ev3proto.version import VERSION

sys.path.insert(0, str(Path(__file__).parent))

_addresses = subprocess.run(
    ["bash", Path(__file__).parents[1] / "bin" / "addresses"], capture_output=True, text=True, check=False
)

project = "ev3proto"
release = version = VERSION
html_title = f"ev3proto {VERSION}"
extensions = ["myst_parser", "playground.build", "root_pages", "search_index"]
myst_heading_anchors = 3
exclude_patterns: list[str] = []
templates_path = ["_templates"]
html_theme = "furo"
html_favicon = "../ev3proto/brick/servers/page/static/icon.svg"
# Empty where the repository has no public address.
html_context = {"repository": _addresses.stdout.strip()}
# Furo's default, with links to the playground and the repository.
html_sidebars = {
    "**": [
        f"sidebar/{part}.html"
        for part in ("brand", "search", "playground", "scroll-start", "navigation", "repository", "scroll-end")
    ]
}
html_show_copyright = False
html_show_sphinx = False
html_copy_source = False
# The pages show bytes and texts of the firmware, so quotes and dashes must stay unchanged.
smartquotes = False
highlight_language = "none"
