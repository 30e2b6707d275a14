"""The page: chart, data and all JavaScript in one file, which needs no network and asks for none."""

from __future__ import annotations

import html
import json
import re
from typing import Any

from ev3proto.capture.timeline.layout import KINDS_WIDTH, LEGEND_HEIGHT

# Nothing may be fetched, whatever stands in the capture. Vega makes functions of its expressions: 'unsafe-eval'.
_POLICY = "default-src 'none'; script-src 'unsafe-inline' 'unsafe-eval'; style-src 'unsafe-inline'; img-src data: blob:"

_STYLE = """
body { margin: 0; background: white; font-family: Helvetica, Arial, "Liberation Sans", sans-serif; color: #222; }
#hint { margin: 14px 20px 0; font-size: 13px; color: #555; }
html { scrollbar-gutter: stable; }
#timeline { max-width: 100%; overflow-x: auto; }
#timeline canvas { touch-action: pan-y pinch-zoom; }
#vg-tooltip-element { max-width: min(520px, 90vw); font-size: 12px; pointer-events: none; }
#vg-tooltip-element table tr td.value { max-width: 400px; max-height: none; white-space: normal;
  overflow-wrap: anywhere; display: table-cell; }
#vg-tooltip-element table tr td.key { white-space: nowrap; max-width: none; }
"""

_HINT = (
    "Turn the wheel to zoom in on a time, drag to move along, double-click to see it all again. "
    "Point at a mark to see what it says. Click words in the legend to see only those marks."
)

_TOUCH_HINT = (
    "Drag sideways to move along. Tap a mark to see what it says. Tap words in the legend to see only those marks."
)

LEAST = 120
"""Pixels that the chart has at least for what it draws over time."""

_EDGES = 40
"""Pixels left and right of the chart."""

_LEAST_MARGIN = 110
"""Pixels for what stands beside the rows, in the narrowest window."""

_MARGIN_SHARE = 0.36
"""How much of the window may stand beside the rows."""

_KINDS_FROM = 700
"""Pixels that a window must have for the names of kinds."""

# As wide as the window. In a narrow one less stands beside the rows, texts have more lines, and words that would stand
# on each other are omitted: a tap on their mark shows them.
_SCRIPT = """
{
  const given = document.getElementById("chart").textContent;
  const place = document.getElementById("timeline");
  const actions = { export: true, source: false, compiled: false, editor: false };
  let width = 0;

  const lines = (texts, most) => [texts].flat().flatMap((text) =>
    text.match(new RegExp(`.{1,${most}}(?:\\\\s+|$)|.{${most}}`, "gu")) ?? [text]);

  function fit(chart, whole) {
    const margin = Math.round(Math.min(@MARGIN@, Math.max(@LEAST_MARGIN@, @MARGIN_SHARE@ * whole)));
    const sizes = { margin, kinds: whole < @KINDS_FROM@ ? 0 : @KINDS@, room: Math.max(@LEAST@, whole - margin) };
    for (const parameter of chart.params) if (parameter.name in sizes) parameter.value = sizes[parameter.name];
    for (const { title } of [chart, ...chart.vconcat]) {
      if (!title) continue;
      title.text = lines(title.text, Math.floor(whole / 9));
      title.subtitle = lines(title.subtitle, Math.floor(whole / 6.2));
    }
    for (const view of chart.vconcat) view.width = sizes.room;
    let x = 0;
    let y = @LEGEND_HEIGHT@ / 2;
    for (const entry of chart.datasets.legend) {
      const length = entry.x2 - entry.x;
      if (x && (entry.breaks || x + length > whole)) {
        x = 0;
        y += @LEGEND_HEIGHT@;
      }
      Object.assign(entry, { x: x + 6 - margin, x2: x + 6 - margin + length, y });
      x += length + 30;
    }
    chart.vconcat[0].height = y + @LEGEND_HEIGHT@ / 2;
  }

  async function draw(less) {
    width = document.documentElement.clientWidth;
    const chart = JSON.parse(given);
    fit(chart, width - @EDGES@ - less);
    await vegaEmbed(place, chart, { mode: "vega-lite", renderer: "canvas", actions, downloadFileName: "timeline" });
    const over = place.scrollWidth - place.clientWidth;
    // Letters of this device are wider than elsewhere: again, with less room for the rest.
    if (over > 0 && less < @MOST_LESS@) await draw(less + over + 4);
  }

  const start = () => draw(0).catch((error) => {
    document.getElementById("hint").textContent = `The chart cannot be drawn: ${error.message}`;
  });
  start();
  // A finger is nowhere before it touches, and after it: the chart has to work out what is under it, as for a mouse.
  let isTouched = false;
  const tell = (event) => {
    if (isTouched) event.target.dispatchEvent(new PointerEvent("pointermove", event));
  };
  place.addEventListener("pointerdown", (event) => { isTouched = event.pointerType !== "mouse"; tell(event); }, true);
  place.addEventListener("click", tell, true);
  if (matchMedia("(hover: none)").matches) document.getElementById("hint").textContent = "@TOUCH_HINT@";
  let resized;
  window.addEventListener("resize", () => {
    clearTimeout(resized);
    resized = setTimeout(() => { if (document.documentElement.clientWidth !== width) start(); }, 200);
  });
}
"""


_MOST_LESS = 100
"""Pixels that a chart gives up for wide letters; with all that is in it, no chart is narrower."""

_FACTS = {
    "MOST_LESS": _MOST_LESS,
    "EDGES": _EDGES,
    "KINDS": KINDS_WIDTH,
    "KINDS_FROM": _KINDS_FROM,
    "LEAST": LEAST,
    "LEAST_MARGIN": _LEAST_MARGIN,
    "LEGEND_HEIGHT": LEGEND_HEIGHT,
    "MARGIN_SHARE": _MARGIN_SHARE,
    "TOUCH_HINT": _TOUCH_HINT,
}


def page(specification: dict[str, Any], title: str, margin: float, javascript: str) -> str:
    """The HTML.

    Args:
        specification: The chart, with its data.
        title: What the browser shows as the page's name.
        margin: Pixels of the chart beside what it draws over time.
        javascript: The libraries vega, vega-lite and vega-embed.
    """
    script = re.sub(r"@(\w+)@", lambda found: str(_FACTS[found[1]]), _SCRIPT.replace("@MARGIN@", str(round(margin))))
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
