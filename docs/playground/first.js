// The first frame without Python: the second path beside Python's tree, since a link's frame is there after 0.3 s in place of 10 at 10 Mbit/s,
// in Chromium, Firefox and WebKit; after 0.6 s at 1.6 Mbit/s.
// It reads one frame in hex and no more.

import { decode } from "./ev3-decode.mjs";
import { NOTHING } from "./places.js";
import { bytesOf, partsOf, rowsOf } from "./rows.js";

/** The notations that can be nothing else, for Python, which knows many more: a word, the lesson's bars, pairs of which one has a letter. */
const HEX = /^(?:(?:[0-9a-f]{2}){5,}|0x\|(?:[0-9a-f]{2}[:|]){5,}|(?=.*[a-f])[0-9a-f]{2}(?:[ :][0-9a-f]{2}){4,})$/i;

/**
 * Whether Python certainly reads these bytes as one frame, and says no more of it. It may take what is longer than its length says for
 * several frames, what may be any bytes for something else, and says how much of a file came.
 *
 * @param {any} message @param {Uint8Array} frame
 */
const isSure = ({ kind, length, fields = {}, operations = [] }, frame) => {
  const missing = length + 2 - frame.length;
  if (missing === 0 || fields.path !== undefined) return fields.path === undefined;
  return missing > 0 && kind.endsWith("command") && isKnown(frame, missing) && (isFlawless(frame) || (missing <= NEARLY && operations.length > 0));
};

/** How many bytes a command with mistakes may lack, how often the length of another one may have its bytes, and how many different bytes anything has. */
const NEARLY = 2, MOST = 8, FEW = 2;
/** @param {Uint8Array} frame @param {number} missing */
const isKnown = (frame, missing) => {
  const isLikely = missing <= (MOST - 1) * frame.length && new Set(frame.subarray(5)).size > FEW;
  return isLikely && !frame.some((_, at) => at > 0 && hasFrame(frame, at));
};
/** Whether a frame is right but for its length. @param {Uint8Array} frame */
const isFlawless = (frame) => !decode(Uint8Array.of((frame.length - 2) & 0xff, (frame.length - 2) >> 8, ...frame.subarray(2))).fault;

/** Whether a frame may begin at an offset that ends within these bytes. @param {Uint8Array} bytes @param {number} at */
const hasFrame = (bytes, at) => {
  const { type, length = 0 } = /** @type {any} */ (decode(bytes.subarray(at, at + 5)));
  return type && length >= 3 && at + 2 + length <= bytes.length;
};

/** Returns what the page shows of a frame until Python has read it, only the headline if Python may see another one; null for any other text. @param {string} text */
export const firstAnswer = (text) => {
  if (!HEX.test(text.trim())) return null;
  const frame = Uint8Array.from(bytesOf(text.replace(/0x|\W/gi, ""))), message = decode(frame);
  if (message.kind === "unknown") return null;
  const lines = rowsOf(message), spoken = message.fault ? lines.at(-1) : lines[0];
  const sentence = (spoken?.[0] ?? []).map(([piece]) => piece).join("").trim();
  const said = { ...NOTHING, headline: { sentence, verdict: "It is being checked.", kind: /** @type {const} */ ("none"), severity: /** @type {const} */ ("") } };
  if (!isSure(message, frame)) return said;
  return { ...said, count: 1, lines, frames: { 0: message.hex }, page: { ...NOTHING.page, end: 1 }, about: { sentence, parts: partsOf(message), bytes: [] } };
};
