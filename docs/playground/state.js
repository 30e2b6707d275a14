// What the page knows, in one object. What elements show follows from it: they are drawn again when it changes.

import { NOTHING } from "./places.js";

/**
 * @typedef {object} State
 * @property {boolean} isReady  whether Python answers
 * @property {string} status  a sentence in the head of the page
 * @property {string} error  what is wrong with the input
 * @property {string} note  what was done last
 * @property {import("./headline.js").Headline} headline  what the input is, and what is wrong with it
 * @property {string} about  what the frame in the dump does, of several
 * @property {string} byte  what the byte says that was chosen last
 * @property {boolean} isProgram  whether the input is a program
 * @property {string} file  the name of the file that is read in place of the input; empty for the input
 * @property {string} kept  a sentence about whether the input outlives a reload; empty for no input
 * @property {string} filter  which frames are shown; empty for all
 * @property {boolean} canFilter  whether the input has several frames
 * @property {boolean} isStale  whether what is shown belongs to an older input
 * @property {{part: number, count: number} | null} progress  of what takes long: the part that is done, the frames so far
 * @property {"none" | "usb" | "bluetooth"} connection  the carrier of the real brick
 * @property {boolean} isConnecting  whether a connection is being opened
 * @property {boolean} isComparing  whether the real brick is being compared with the virtual one
 * @property {Readonly<Record<string, string>>} flashes  what a button says for a moment, by its id
 */

/** @type {State} */
let now = {
  isReady: false,
  status: "Loading …",
  error: "",
  note: "",
  headline: NOTHING.headline,
  about: "",
  byte: "",
  isProgram: false,
  file: "",
  kept: "",
  filter: "",
  canFilter: false,
  isStale: false,
  progress: null,
  connection: "none",
  isConnecting: false,
  isComparing: false,
  flashes: {},
};

/** @type {((state: Readonly<State>) => void)[]} */
const drawings = [];

/** Returns what the page knows. @returns {Readonly<State>} */
export const state = () => now;

/** Changes some of it, and has it drawn. @param {Partial<State>} changes */
export const change = (changes) => {
  now = { ...now, ...changes };
  for (const draw of drawings) draw(now);
};

/** Draws now, and after each change. @param {(state: Readonly<State>) => void} draw */
export const follow = (draw) => {
  drawings.push(draw);
  draw(now);
};

/**
 * The texts of the buttons that change.
 *
 * @type {Readonly<Record<string, (state: Readonly<State>) => string>>}
 */
const TEXTS = {
  send: ({ connection }) => (connection === "none" ? "Send to the brick" : "Send to the real brick"),
  link: () => "Copy a link",
  copy: () => "Copy",
  compare: ({ isComparing }) => (isComparing ? "Stop comparing" : "Compare with the virtual brick"),
};

/** Returns the text of each button. @param {Readonly<State>} known @returns {[id: string, text: string][]} */
export const buttonTexts = (known) => Object.entries(TEXTS).map(([id, text]) => [id, known.flashes[id] ?? text(known)]);

/** How long a flash lasts, in milliseconds. */
const MOMENT = 1500;
/** @type {Map<string, ReturnType<typeof setTimeout>>} */
const timers = new Map();

/** Shows a text in a button for a moment. @param {string} id @param {string} text */
export const flash = (id, text) => {
  clearTimeout(timers.get(id));
  change({ flashes: { ...now.flashes, [id]: text } });
  timers.set(id, setTimeout(() => {
    const { [id]: _, ...rest } = now.flashes;
    change({ flashes: rest });
  }, MOMENT));
};
