// The colours behind the input: the header's fields, and what is marked. They are in an element of the same size behind the
// text area, with the same text in it.

import { find, make } from "./elements.js";
import { state } from "./state.js";

/** @typedef {{start: number, end: number}} Span  of the text */

const input = find("input", HTMLTextAreaElement), behind = find("paint");
/** Between two bytes in hex. */
const GAP = String.raw`(?:0x|\\x|\W)*`;

/** Characters of a text in which bytes are looked for; a longer one has no colours. */
const MOST_TEXT = 20_000;

/** What is painted: where each byte of the frame is, and the class of each. @type {{spans: Span[], classes: string[]}} */
let painted = { spans: [], classes: [] };

/**
 * Returns where the bytes of a frame are in a text of hex.
 *
 * @param {string} text
 * @param {string} hex  the frame
 * @param {number} count  how often the same frame was in the text before
 * @returns {Span[]}  empty where the text has it in another form
 */
export const spansOf = (text, hex, count) => {
  const bytes = hex.match(/../g) ?? [];
  if (!bytes.length) return [];
  const pattern = new RegExp(bytes.map((byte) => `(${byte})`).join(GAP), "dgi");
  const found = [...text.matchAll(pattern)].at(count);
  return found?.indices?.slice(1).map(([start, end]) => ({ start, end })) ?? [];
};

/** Takes the frame whose bytes have colours in the input. @param {string} hex @param {string[]} classes @param {number} count */
export const colour = (hex, classes, count) => {
  const isPlain = !state().file && input.value.length <= MOST_TEXT;
  painted = { spans: isPlain ? spansOf(input.value, hex, count) : [], classes };
  paint(null);
};

/** Marks bytes in the input. @param {{offset: number, length: number} | null} target */
export const paint = (target) => {
  const text = input.value;
  const pieces = [];
  let done = 0;
  for (const [at, { start, end }] of painted.spans.entries()) {
    const isMarked = target && at >= target.offset && at < target.offset + target.length;
    pieces.push(text.slice(done, start), make("span", text.slice(start, end), isMarked ? "chosen" : painted.classes[at]));
    done = end;
  }
  behind.replaceChildren(...(pieces.length ? [...pieces, text.slice(done), "\n"] : []));
  follow();
};

const follow = () => {
  behind.style.height = `${input.clientHeight}px`;
  behind.style.width = `${input.clientWidth}px`;
  behind.scrollTop = input.scrollTop;
};
input.addEventListener("scroll", follow);
input.addEventListener("input", () => {
  painted = { spans: [], classes: [] };
  behind.replaceChildren();
});
new ResizeObserver(follow).observe(input);
