"""The interactive page: chart, data and JavaScript in one file that never uses the network."""

from __future__ import annotations

import html
import json
from typing import Any

# Nothing may be fetched, whatever the capture contains. Vega compiles its expressions to functions: 'unsafe-eval'.
_POLICY = "default-src 'none'; script-src 'unsafe-inline' 'unsafe-eval'; style-src 'unsafe-inline'; img-src data: blob:"

_STYLE = """
body { margin: 0; background: white; font-family: Helvetica, Arial, "Liberation Sans", sans-serif; color: #222; }
h1, p { margin: 6px 20px 0; font-size: 13px; color: #444; overflow-wrap: anywhere; }
h1 { margin-top: 14px; font-size: 18px; color: #222; }
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

# The chart fits the window. A narrow window gets a narrower margin and fewer labels; a tap on a mark shows its label.
_SCRIPT = """
{
  const chart = JSON.parse(document.getElementById("chart").textContent);
  const parameter = (name) => chart.params.find((each) => each.name === name);
  const place = document.getElementById("timeline");
  const actions = { export: true, source: false, compiled: false, editor: false };
  const [widest, kinds] = [parameter("margin").value, parameter("kinds").value];
  let width = 0;

  async function draw(less) {
    width = document.documentElement.clientWidth;
    const whole = width - 40 - less;
    const margin = Math.round(Math.min(widest, Math.max(110, 0.36 * whole)));
    const room = Math.max(120, whole - margin);
    const sizes = { margin, room, kinds: whole < 700 ? 0 : kinds };
    for (const name in sizes) parameter(name).value = sizes[name];
    for (const view of chart.vconcat) view.width = room;
    await vegaEmbed(place, chart, { mode: "vega-lite", renderer: "canvas", actions, downloadFileName: "timeline" });
    const over = place.scrollWidth - place.clientWidth;
    // This device has wider letters: draw again with less room for the rest.
    if (over > 0 && less < 100) await draw(less + over + 4);
  }

  const start = () => draw(0).catch((error) => {
    document.getElementById("hint").textContent = `The chart cannot be drawn: ${error.message}`;
  });
  start();
  // A touch has no hover: tell the chart what is under the finger, as if a mouse had moved there.
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


def page(specification: dict[str, Any], title: str, lines: list[str], javascript: str) -> str:
    """Returns the HTML, with the libraries vega, vega-lite and vega-embed in it."""
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
            f"<h1>{html.escape(title)}</h1>",
            *(f"<p>{html.escape(line)}</p>" for line in lines),
            f'<p id="hint">{html.escape(_HINT)}</p>',
            '<div id="timeline"></div>',
            "<noscript>This page draws its chart with JavaScript, all of which is in it.</noscript>",
            f'<script type="application/json" id="chart">{_inert(specification)}</script>',
            f"<script>{javascript}</script>",
            f"<script>{_SCRIPT.replace('@TOUCH_HINT@', _TOUCH_HINT)}</script>",
            "</body>",
            "</html>",
            "",
        )
    )


def _inert(data: dict[str, Any]) -> str:
    """Returns JSON that cannot end the script element around it."""
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"))
    return text.replace("<", r"\u003c").replace(">", r"\u003e").replace("&", r"\u0026")
