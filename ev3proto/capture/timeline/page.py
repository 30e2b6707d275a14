"""The page: chart, data and all JavaScript in one file, which needs no network and asks for none."""

from __future__ import annotations

import html
import json
from typing import Any

# Nothing may be fetched, whatever stands in the capture. Vega makes functions of its expressions: 'unsafe-eval'.
_POLICY = "default-src 'none'; script-src 'unsafe-inline' 'unsafe-eval'; style-src 'unsafe-inline'; img-src data: blob:"

_STYLE = """
body { margin: 0; background: white; font-family: Helvetica, Arial, "Liberation Sans", sans-serif; color: #222; }
#hint { margin: 14px 20px 0; font-size: 13px; color: #555; }
#timeline { max-width: 100%; overflow-x: auto; }
#vg-tooltip-element { max-width: min(520px, 90vw); font-size: 12px; }
#vg-tooltip-element table tr td.value { max-width: 400px; max-height: none; white-space: normal;
  overflow-wrap: anywhere; display: table-cell; }
#vg-tooltip-element table tr td.key { white-space: nowrap; max-width: none; }
"""

_HINT = (
    "Turn the wheel to zoom in on a time, drag to move along, double-click to see it all again. "
    "Point at a mark to see what it says. Click words in the legend to see only those marks."
)

LEAST = 120
"""Pixels that the chart has at least for what it draws over time."""

_EDGES = 60
"""Pixels left and right of the chart: padding, and the scroll bar."""

# As wide as the window; on a phone narrower than what the labels were laid out for, rather than wider than the screen.
_SCRIPT = """
{
  const chart = JSON.parse(document.getElementById("chart").textContent);
  const width = Math.max(@LEAST@, document.documentElement.clientWidth - @MARGIN@);
  for (const view of chart.vconcat) view.width = width;
  const actions = { export: true, source: false, compiled: false, editor: false };
  vegaEmbed("#timeline", chart, { mode: "vega-lite", renderer: "canvas", actions, downloadFileName: "timeline" })
    .catch((error) => { document.getElementById("hint").textContent = `The chart cannot be drawn: ${error.message}`; });
}
"""


def page(specification: dict[str, Any], title: str, margin: float, javascript: str) -> str:
    """The HTML.

    specification  the chart, with its data
    title          what the browser shows as the page's name
    margin         pixels of the chart beside what it draws over time
    javascript     vega, vega-lite and vega-embed
    """
    script = _SCRIPT.replace("@LEAST@", str(LEAST)).replace("@MARGIN@", str(round(margin + _EDGES)))
    return "\n".join(
        (
            "<!DOCTYPE html>",
            '<html lang="en">',
            "<head>",
            '<meta charset="utf-8">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            f'<meta http-equiv="Content-Security-Policy" content="{html.escape(_POLICY)}">',
            f"<title>{html.escape(title)}</title>",
            f"<style>{_STYLE}</style>",
            "</head>",
            "<body>",
            f'<p id="hint">{html.escape(_HINT)}</p>',
            '<div id="timeline"></div>',
            "<noscript>This page draws its chart with JavaScript, all of which is in it.</noscript>",
            f'<script type="application/json" id="chart">{_inert(specification)}</script>',
            f"<script>{javascript}</script>",
            f"<script>{script}</script>",
            "</body>",
            "</html>",
            "",
        )
    )


def _inert(data: dict[str, Any]) -> str:
    """JSON in which nothing can end the script element around it."""
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"))
    return text.replace("<", r"\u003c").replace(">", r"\u003e").replace("&", r"\u0026")
