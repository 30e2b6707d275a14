// The dialogues of a log or a capture: a table of those on the page, and the timeline of all, which is drawn on request.

import { find, inside, make } from "./elements.js";
import { counted, home } from "./reading.js";

const table = find("dialogues", HTMLDetailsElement), timeline = find("timeline", HTMLDetailsElement);

/** Shows the dialogues of a page. @param {string[][]} rows */
export const showRows = (rows) => inside(table, "tbody", HTMLTableSectionElement).replaceChildren(...rows.map((cells) => {
  const row = make("tr");
  row.append(...cells.map((each) => make("td", each)));
  return row;
}));

/** Shows how many dialogues an input has, and the timeline once it is read. @param {number} count @param {boolean} isWhole */
export const showDialogues = (count, isWhole) => {
  table.hidden = !count;
  timeline.hidden = !count || !isWhole;
  inside(table, "summary", HTMLElement).textContent = `Dialogues (${count.toLocaleString("en")})`;
  showTimeline();
};

let turn = 0;
/** What is drawn, and how wide. */
let drawn = { chart: "", width: 0 };

/** Draws the timeline, if it is open. Vega interprets its expressions: the page's policy forbids eval. */
const showTimeline = async () => {
  const place = inside(timeline, "div", HTMLDivElement), mine = ++turn;
  place.replaceChildren();
  if (!timeline.open || timeline.hidden) return;
  const bar = make("progress"), said = make("span", "Reading …"), row = make("p", "", "row");
  bar.max = 1;
  bar.setAttribute("aria-label", "Timeline");
  row.append(bar, said);
  place.append(row);
  /** @type {string | null} */
  const chart = await home().follow(({ part, count }) => {
    bar.value = part;
    said.textContent = `Reading: ${counted(count)}`;
  }, "timeline");
  if (mine !== turn) return;
  bar.removeAttribute("value");
  said.textContent = "Drawing …";
  drawn = { chart: chart ?? "", width: 0 };
  if (chart) await draw(); else said.textContent = "Nothing to draw.";
};
timeline.ontoggle = showTimeline;

/** Draws the chart in the width and the colours of the page, in place of what is there. */
const draw = async () => {
  const place = inside(timeline, "div", HTMLDivElement), mine = turn, box = make("div");
  drawn.width = place.clientWidth;
  const { drawTimeline } = await import("./timeline.js");
  // The message that it is being drawn is painted first.
  await new Promise((resolve) => { setTimeout(resolve, 50); });
  await drawTimeline(drawn.chart, box, place);
  if (mine === turn) place.replaceChildren(box);
};
const drawAgain = () => { if (timeline.open && inside(timeline, "div", HTMLDivElement).querySelector("canvas")) draw(); };
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", drawAgain);
/** Milliseconds that a window has one width before the timeline has it, too. */
const STEADY = 300;
/** @type {ReturnType<typeof setTimeout> | undefined} */
let steady;
new ResizeObserver(() => {
  clearTimeout(steady);
  steady = setTimeout(() => { if (inside(timeline, "div", HTMLDivElement).clientWidth !== drawn.width) drawAgain(); }, STEADY);
}).observe(inside(timeline, "div", HTMLDivElement));
