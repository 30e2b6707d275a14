// Which frames are shown of many, and the way to the others.

import { find } from "./elements.js";

/** A number behind every frame. */
const LAST = 1e9;

const pages = find("pages");

/**
 * Shows which frames are shown.
 *
 * @param {import("./answer.js").Page["page"]} page
 * @param {number} count  of all frames
 * @param {(frame: number) => void} turnTo  shows the page that has a frame
 */
export const showPager = ({ first, next, begin, end }, count, turnTo) => {
  pages.hidden = !first && !next;
  /** @param {number} number */
  const text = (number) => number.toLocaleString("en");
  const said = `Frames ${text(begin)} to ${text(end)} of ${text(count)}`;
  if (find("shown-frames").textContent !== said) find("shown-frames").textContent = said;
  /** Where each button leads. @type {Record<string, number | false>} */
  const ways = { "first-page": first > 0 && 0, "previous-page": first > 0 && first - 1, "next-page": next > 0 && next, "last-page": next > 0 && LAST };
  for (const [id, frame] of Object.entries(ways)) {
    // Not disabled: that would take the focus away from a button that has done its work.
    find(id).setAttribute("aria-disabled", String(frame === false));
    find(id).onclick = () => { if (frame !== false) turnTo(frame); };
  }
};
