// Python, which reads the input step by step, so that it answers other questions between them. Only the newest input counts.

import { Python } from "./python.js";
import { change, state } from "./state.js";

/** @typedef {import("./answer.js").Answer} Answer */
/** @typedef {(answer: Answer, isMore: boolean, isWhole: boolean) => void} Show  `isMore`: of the same input as the one before */

/** Characters or bytes that are read in one step, as a rule. */
const LITTLE = 4000;
/** Milliseconds: until a long text that is typed is read; until reading is said; until its progress is shown; that a step may take to end. */
const PAUSE = 400, SOON = 300, LATE = 1000, STUCK = 1500;
const READING = "Reading …";

/**
 * Python, and what it is doing; `turn` is the number of the newest input.
 *
 * @type {{
 *   python: Python | null, isBusy: boolean, turn: number, short: Promise<void>, current: Promise<void>,
 *   hear: (said: import("./python.js").Said) => void, show: Show, clear: () => void, restarted: () => void,
 * }}
 */
const work = {
  python: null, isBusy: false, turn: 0, short: Promise.resolve(), current: Promise.resolve(),
  hear: () => {}, show: () => {}, clear: () => {}, restarted: () => {},
};

/** Returns Python, which starts at the first call. @returns {Python} */
export const home = () => (work.python ??= new Python((said) => work.hear(said)));

/** Returns the number of the newest input. */
export const newest = () => work.turn;

/** Is resolved when the newest input is read. @returns {Promise<void>} */
export const current = () => work.current;

/**
 * Starts Python.
 *
 * @param {object} takes
 * @param {(said: import("./python.js").Said) => void} takes.hear  what Python says by itself
 * @param {Show} takes.show  an answer, or what there is of it so far
 * @param {() => void} takes.clear  that the old answer is wrong, and a new one will take a while
 * @param {() => void} takes.restarted  that Python was ended, and the bricks with it
 */
export const begin = (takes) => {
  Object.assign(work, takes);
  home();
};

/**
 * Has Python read something, and shows what it says as it comes. It gives up what it was reading.
 *
 * @param {number} size  how much it is
 * @param {boolean} isTyped  whether more may be typed at once
 * @param {string} call  the function of bridge
 * @param {unknown[]} given
 */
export const look = (size, isTyped, call, ...given) => {
  const mine = ++work.turn, isLong = size > LITTLE;
  change({ isStale: true });
  if (isLong) work.clear();
  const reading = (async () => {
    if (isLong && isTyped) await new Promise((resolve) => { setTimeout(resolve, PAUSE); });
    else if (!isLong) await work.short;
    if (mine === work.turn) await read(mine, call, given);
  })();
  if (!isLong) work.short = reading;
  work.current = reading;
};

/** @param {number} mine @param {string} call @param {unknown[]} given */
const read = async (mine, call, given) => {
  const isNow = () => mine === work.turn;
  let isMore = false;
  const soon = setTimeout(() => { if (isNow()) change({ status: READING }); }, SOON);
  const late = setTimeout(() => { if (isNow()) change({ progress: { part: 0, count: 0 } }); }, LATE);
  /** @param {{answer?: Answer, part: number, count: number}} part */
  const hearPart = ({ answer, ...progress }) => {
    if (!isNow()) return;
    if (answer) {
      // A part is never taken for the whole.
      if (!state().status) change({ status: READING });
      work.show(answer, isMore, false);
      isMore = true;
    }
    if (state().progress) change({ progress });
  };
  work.isBusy = true;
  try {
    const answer = await home().follow(hearPart, call, ...given);
    if (isNow()) work.show(answer, isMore, true);
  } catch (error) {
    change({ error: error instanceof Error ? error.message : String(error) });
  }
  clearTimeout(soon);
  clearTimeout(late);
  if (isNow()) endReading();
};

const endReading = () => {
  work.isBusy = false;
  change({ status: "", progress: null, isStale: false });
};

/** Ends what is being read. What was read so far stays. */
export const cancel = async () => {
  if (!work.isBusy) return;
  work.turn++;
  const python = home(), count = state().progress?.count;
  change({ note: count ? `Cancelled after ${counted(count)}.` : "Cancelled." });
  endReading();
  const isStuck = await Promise.race([python.ask("give_up"), new Promise((resolve) => { setTimeout(resolve, STUCK, true); })]);
  if (!isStuck || python !== work.python) return;
  change({ note: "Cancelled. The virtual brick was switched off and on." });
  work.restarted();
  python.end();
  work.python = null;
  work.short = work.current = Promise.resolve();
  home();
};

/** Returns a number of frames in words. @param {number} count */
export const counted = (count) => `${count.toLocaleString("en")} frames`;
