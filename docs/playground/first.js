// The first frame without Python: the second path beside Python's tree, since a link's frame is there after 0.25 s in place of 12 at 10 Mbit/s.
// It reads one frame in hex and no more.

import { decode } from "./ev3-decode.mjs";
import { NOTHING } from "./places.js";
import { bytesOf, partsOf, rowsOf } from "./rows.js";

/** The notations that can be nothing else, for Python, which knows many more: a word, the lesson's bars, pairs of which one has a letter. */
const HEX = /^(?:(?:[0-9a-f]{2}){5,}|0x\|(?:[0-9a-f]{2}[:|]){5,}|(?=.*[a-f])[0-9a-f]{2}(?:[ :][0-9a-f]{2}){4,})$/i;

/** Of a wrong length, Python knows the frame again: the fewest bytes, how many any frame may lack, how often a right command those that are there. */
const LEAST = 7, NEARLY = 2, MOST = 8;

/**
 * Whether Python certainly reads these bytes as one frame, and says no more of it. It may take what is longer than its length says for
 * several frames, what lacks much for another text, and says how much of a file came.
 *
 * @param {any} message @param {Uint8Array} frame
 */
const isSure = ({ kind, length, fields = {} }, frame) => {
  const size = frame.length, missing = length + 2 - size;
  if (fields.path !== undefined || missing < 0 || (missing > 0 && size < LEAST)) return false;
  const mended = () => decode(Uint8Array.of((size - 2) & 0xff, (size - 2) >> 8, ...frame.subarray(2)));
  return missing <= NEARLY || (length + 2 <= MOST * size && kind.endsWith("command") && !mended().fault);
};

/** Returns what the page shows of a frame until Python has read it, only the headline if Python may see another one; null for any other text. @param {string} text */
export const firstAnswer = (text) => {
  if (!HEX.test(text.trim())) return null;
  const frame = Uint8Array.from(bytesOf(text.replace(/0x|\W/gi, ""))), message = decode(frame);
  if (!message.type) return null;
  const lines = rowsOf(message), spoken = message.fault ? lines.at(-1) : lines[0];
  const sentence = (spoken?.[0] ?? []).map(([piece]) => piece).join("").trim();
  const said = { ...NOTHING, headline: { sentence, verdict: "It is being checked.", kind: /** @type {const} */ ("none"), severity: /** @type {const} */ ("") } };
  if (!isSure(message, frame)) return said;
  return { ...said, count: 1, lines, frames: { 0: message.hex }, page: { ...NOTHING.page, end: 1 }, about: { sentence, parts: partsOf(message), bytes: [] } };
};
