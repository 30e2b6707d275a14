// Which line is about which byte: what marks and the dump need to know of an answer.

/** @typedef {import("./answer.js").Row} Row */
/** @typedef {{frame: number, offset: number, length: number, row: number, at?: number, line?: number, block?: number, part?: number}} Target
 *  Bytes of a frame, and the line about them. `at` is a byte that was chosen, `line` a line of the input, `block` a finding,
 *  `part` a field of the header. */

/** What is shown of no input. @type {import("./answer.js").Answer} */
export const NOTHING = {
  headline: { sentence: "", verdict: "", kind: "none", severity: "" },
  error: "", count: 0, isProgram: false, made: { lesson: "" }, dialogues: 0, found: {}, findings: [],
  lines: [], frames: {}, rows: [], page: { first: 0, next: 0, begin: 1, end: 0 },
};

/** Bytes of a frame that are in the page at once. */
export const MOST_BYTES = 4096;
/** Parts of a long frame begin at a multiple of this. */
const STEP = 16;

/** Returns the lines of each frame, by their number. @param {Row[]} lines @returns {Map<number, number[]>} */
export const rowsByFrame = (lines) => {
  /** @type {Map<number, number[]>} */
  const rows = new Map();
  for (const [number, [, frame]] of lines.entries()) {
    if (frame < 0) continue;
    const found = rows.get(frame);
    if (found) found.push(number); else rows.set(frame, [number]);
  }
  return rows;
};

/** Returns the line of the fewest bytes around one; -1 for none. @param {Row[]} lines @param {number[]} rows @param {number} at */
export const rowAt = (lines, rows, at) => {
  let best = -1;
  for (const row of rows) {
    const [, , offset, length] = lines[row];
    if (at >= offset && at < offset + length && (best < 0 || length <= lines[best][3])) best = row;
  }
  return best;
};

/** Returns what a line is about. @param {Row[]} lines @param {number} row @returns {Target} */
export const targetOf = (lines, row) => {
  const [, frame, offset, length] = lines[row];
  return { frame, offset, length, row };
};

/** Returns where a part of a frame begins that has a byte in it. @param {number} size @param {number} at */
export const partOf = (size, at) => (size <= MOST_BYTES ? 0 : Math.max(0, Math.floor((at - MOST_BYTES / 2) / STEP) * STEP));

/** Returns whether two ranges share a byte. @param {{offset: number, length: number}} one @param {{offset: number, length: number}} other */
export const overlap = (one, other) => one.offset < other.offset + other.length && other.offset < one.offset + one.length;
