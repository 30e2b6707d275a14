// The first frame without Python: the second path beside Python's tree, since a link's frame is there after 0.25 s in place of 12 at 10 Mbit/s.
// It reads one frame in hex and no more.

import { decode } from "./ev3-decode.mjs";
import { NOTHING } from "./places.js";
import { bytesOf, partsOf, rowsOf } from "./rows.js";

/** Returns the bytes of a text that is one frame in hex: a word, the lesson's bars, or pairs that cannot be decimal. @param {string} text */
const frameOf = (text) => {
  const isWord = /^(?:[0-9a-f]{2}){5,}$/i.test(text), isBars = /^0x\|(?:[0-9a-f]{2}[:|])+$/i.test(text), isPairs = /^[0-9a-f]{2}(?:[ :][0-9a-f]{2}){4,}$/i.test(text) && /[a-f]/i.test(text);
  return isWord || isBars || isPairs ? Uint8Array.from(bytesOf(text.replace(/^0x|[:| ]/gi, ""))) : null;
};

/**
 * Whether Python certainly reads these bytes as one frame, and says no more of it. It may take what is longer than its length says for
 * several frames, and what is shorter for bytes that lost their zeros, and says how much of a file came.
 *
 * @param {any} message
 */
const isSure = ({ type, length, hex, fields = {} }) => type && length + 2 === hex.length / 2 && fields.path === undefined;

/** Returns what the page shows of a frame until Python has read it; null for any other text. @param {string} text */
export const firstAnswer = (text) => {
  const frame = frameOf(text.trim());
  if (!frame) return null;
  const message = decode(frame);
  if (!isSure(message)) return null;
  const lines = rowsOf(message), spoken = message.fault ? lines.at(-1) : lines[0];
  const sentence = (spoken?.[0] ?? []).map(([piece]) => piece).join("").trim();
  return {
    ...NOTHING, headline: { sentence, verdict: "It is being checked.", kind: /** @type {const} */ ("none"), severity: /** @type {const} */ ("") },
    count: 1, lines, frames: { 0: message.hex }, page: { ...NOTHING.page, end: 1 }, about: { sentence, parts: partsOf(message), bytes: [] },
  };
};
