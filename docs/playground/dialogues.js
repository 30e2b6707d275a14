// The dialogues of a log or a capture: a table, and the timeline, which is drawn on request.

import { find, inside, make } from "./elements.js";
import { source } from "./reading.js";

const table = find("dialogues", HTMLDetailsElement), timeline = find("timeline", HTMLDetailsElement);

/** @param {string[][]} found */
const fill = (found) => inside(table, "tbody", HTMLTableSectionElement).replaceChildren(...found.map((cells) => {
  const row = make("tr");
  row.append(...cells.map((each) => make("td", each)));
  return row;
}));

/** Shows the dialogues of an answer. @param {import("./answer.js").Dialogues} dialogues */
export const showDialogues = ({ count, rows }) => {
  table.hidden = timeline.hidden = !count;
  inside(table, "summary", HTMLElement).textContent = `Dialogues (${count.toLocaleString("en")})`;
  fill(rows);
  const fillAll = async () => {
    if (table.open && rows.length < count) fill(await source().ask("all_dialogues"));
  };
  table.ontoggle = fillAll;
  fillAll();
  showTimeline();
};

/** Draws the timeline, if it is open. Vega interprets its expressions: the page's policy forbids eval. */
const showTimeline = async () => {
  const place = inside(timeline, "div", HTMLDivElement);
  place.replaceChildren();
  if (!timeline.open || timeline.hidden) return;
  const { drawTimeline } = await import("./timeline.js");
  const chart = await source().ask("timeline");
  if (chart) await drawTimeline(chart, place);
  else place.textContent = "Nothing to draw.";
};
timeline.ontoggle = showTimeline;
