// Who reads the input: the Python that has the bricks what is short, a second one what takes long. Only the newest question counts.

import { Python } from "./python.js";
import { change, state } from "./state.js";

/** @typedef {import("./answer.js").Answer} Answer */
/** @typedef {(answer: Answer, isMore: boolean, isWhole: boolean) => void} Show  `isMore`: of the same input as the one before */

/** Characters or bytes that the Python of the bricks reads itself, at once. */
export const LITTLE = 4000;
/** Milliseconds: until a long text that is typed is read; until reading is said; until its progress is shown. */
const PAUSE = 400, SOON = 300, LATE = 1000;
const READING = "Reading …";

/**
 * The pythons, and what they are doing.
 *
 * @type {{
 *   home: Python | null, reader: Python | null, source: Python | null, busy: Python | null,
 *   turn: number, atHome: Promise<void>, current: Promise<void>,
 *   hear: (said: import("./python.js").Said) => void, show: Show, clear: () => void, restarted: () => void,
 * }}
 */
const work = {
  home: null, reader: null, source: null, busy: null,
  turn: 0, atHome: Promise.resolve(), current: Promise.resolve(),
  hear: () => {}, show: () => {}, clear: () => {}, restarted: () => {},
};

/** The Python that has the bricks. @returns {Python} */
export const home = () => (work.home ??= new Python("brick", (said) => work.hear(said)));

/** The one that has read what is shown. @returns {Python} */
export const source = () => work.source ?? home();

/** Is resolved when the newest input is read. @returns {Promise<void>} */
export const current = () => work.current;

/**
 * Starts Python.
 *
 * @param {object} takes
 * @param {(said: import("./python.js").Said) => void} takes.hear  what the Python of the bricks says by itself
 * @param {Show} takes.show  an answer, or what there is of it so far
 * @param {() => void} takes.clear  that the old answer is wrong, and a new one will take a while
 * @param {() => void} takes.restarted  that the Python of the bricks was ended
 */
export const begin = (takes) => {
  Object.assign(work, takes);
  home();
};

/**
 * Has Python read something, and shows what it says as it comes.
 *
 * @param {number} size  how much it is
 * @param {boolean} isTyped  whether more may be typed at once
 * @param {string} call  the function of bridge
 * @param {unknown[]} given
 */
export const look = (size, isTyped, call, ...given) => {
  const mine = ++work.turn, isLong = size > LITTLE;
  if (work.busy && work.busy === work.reader) endReader();
  change({ isStale: true });
  if (isLong) work.clear();
  const reading = (async () => {
    if (isLong && isTyped) await new Promise((resolve) => { setTimeout(resolve, PAUSE); });
    else if (!isLong) await work.atHome;
    if (mine === work.turn) await readBy(isLong ? theReader() : home(), mine, call, given);
  })();
  if (!isLong) work.atHome = reading;
  work.current = reading;
};

const theReader = () => (work.reader ??= new Python("reader", (said) => { if (said.failed) work.hear(said); }));

/** @param {Python} python @param {number} mine @param {string} call @param {unknown[]} given */
const readBy = async (python, mine, call, given) => {
  const isNow = () => mine === work.turn;
  let isMore = false;
  const soon = setTimeout(() => { if (isNow()) change({ status: READING }); }, SOON);
  const late = setTimeout(() => { if (isNow()) change({ progress: { part: 0, count: 0 } }); }, LATE);
  /** @param {{answer?: Answer, part: number, count: number}} part */
  const hearPart = ({ answer, ...progress }) => {
    if (!isNow()) return;
    // A part is never taken for the whole.
    if (!state().status) change({ status: READING });
    work.source = python;
    if (answer) {
      work.show(answer, isMore, false);
      isMore = true;
    }
    if (state().progress) change({ progress });
  };
  work.busy = python;
  try {
    const answer = await python.follow(hearPart, call, ...given);
    if (isNow()) {
      work.source = python;
      work.show(answer, isMore, true);
    }
  } catch (error) {
    change({ error: `ev3proto has a bug, please report it: ${error instanceof Error ? error.message : error}` });
  }
  clearTimeout(soon);
  clearTimeout(late);
  if (isNow()) endReading();
};

const endReading = () => {
  work.busy = null;
  change({ status: "", progress: null, isStale: false });
};
const endReader = () => {
  work.reader?.end();
  work.reader = work.busy = null;
};

/** Ends what is being read. What was read so far stays. */
export const cancel = () => {
  if (!work.busy) return;
  work.turn++;
  if (work.busy === work.reader) {
    const count = state().progress?.count;
    change({ note: count ? `Cancelled after ${counted(count)}.` : "Cancelled." });
    endReader();
  } else {
    change({ note: "Cancelled. The virtual brick was switched off and on." });
    work.restarted();
    work.home?.end();
    work.home = work.source = null;
    home();
  }
  work.atHome = work.current = Promise.resolve();
  endReading();
};

/** Returns a number of frames in words. @param {number} count */
export const counted = (count) => `${count.toLocaleString("en")} frames`;
