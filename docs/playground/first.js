// The first frame without Python: the second path beside Python's tree, since a link's frame is there after 0.3 s in place of 10 at 10 Mbit/s,
// in Chromium, Firefox and WebKit; after 0.6 s at 1.6 Mbit/s.
// It reads one frame in hex and no more.

import { decode } from "./ev3-decode.mjs";
import { NOTHING } from "./places.js";
import { bytesOf, partsOf, rowsOf } from "./rows.js";

/** The notations that can be nothing else, for Python, which knows many more: a word, the lesson's bars, pairs of which one has a letter. */
const HEX = /^(?:(?:[0-9a-f]{2}){5,}|0x\|(?:[0-9a-f]{2}[:|]){5,}|(?=.*[a-f])[0-9a-f]{2}(?:[ :][0-9a-f]{2}){4,})$/i;

/**
 * Whether Python certainly reads these bytes as one frame, and says no more of it. A wrong length may be that of several frames, or of bytes
 * that lost their zeros; of a file it says how much came.
 *
 * @param {any} message
 */
const isSure = ({ length, hex, fields = {} }) => length + 2 === hex.length / 2 && fields.path === undefined;

/** Returns what the page shows of a frame until Python has read it, only the headline if Python may see another one; null for any other text. @param {string} text */
export const firstAnswer = (text) => {
  if (!HEX.test(text.trim())) return null;
  const message = decode(Uint8Array.from(bytesOf(text.replace(/0x|\W/gi, ""))));
  if (message.kind === "unknown") return null;
  const lines = rowsOf(message), spoken = message.fault ? lines.at(-1) : lines[0];
  const sentence = (spoken?.[0] ?? []).map(([piece]) => piece).join("").trim();
  const said = { ...NOTHING, headline: { sentence, verdict: "It is being checked.", kind: /** @type {const} */ ("none"), severity: /** @type {const} */ ("") } };
  if (!isSure(message)) return said;
  return { ...said, count: 1, lines, frames: { 0: message.hex }, page: { ...NOTHING.page, end: 1 }, about: { sentence, parts: partsOf(message), bytes: [] } };
};
