// What the input says: findings, the bytes as a dump, header and tree. Pointing at one of them marks all; a click keeps it.

import { classesOf, drawDump } from "./dump.js";
import { filled, find, make } from "./elements.js";
import { showFindings } from "./findings.js";
import { byteAt, lineOf, mark, unmark } from "./marks.js";
import { colour } from "./paint.js";
import { MOST_BYTES, NOTHING, partOf, rowAt, rowsByFrame, targetOf } from "./places.js";
import { showRows } from "./dialogues.js";
import { showPager } from "./pager.js";
import { home, newest } from "./reading.js";
import { change, state } from "./state.js";

/** @typedef {import("./answer.js").Answer} Answer */
/** @typedef {import("./places.js").Target} Target */
/** @typedef {{name: string, offset: number, length: number, text: string}} Part  a field of a header */
/** @typedef {{sentence: string, parts: Part[], bytes: string[]}} About  what a frame says in words, see bridge/words.py */

const COLUMNS = 16, FEW_COLUMNS = 8;
/** The width of a page that has room for all columns, in pixels. */
const WIDE = 640;
const MOST_ROWS_SHOWN = 10;
/** @type {About} */
const UNKNOWN = { sentence: "", parts: [], bytes: [] };

const bytesBox = find("bytes"), headerBox = find("header"), treeBox = find("tree"), findingsBox = find("findings"), readBox = find("read");

/** @returns {number} */
const columns = () => (readBox.clientWidth < WIDE ? FEW_COLUMNS : COLUMNS);

/**
 * What is shown: the answer; its lines by frame; what is kept by a click or key, and what is marked now; the frame in the
 * dump, its first byte there, and what it says.
 */
const now = {
  shown: NOTHING,
  rows: rowsByFrame([]),
  kept: /** @type {Target | null} */ (null),
  marked: /** @type {Target | null} */ (null),
  isKept: false,
  frame: -1, start: 0, columns: columns(),
  about: UNKNOWN,
};

/** Whether Python says what was shown before it was there: then that stays as it is. @param {Answer} answer */
const isConfirmed = ({ lines, frames }) => now.shown.about !== undefined && JSON.stringify([lines, frames]) === JSON.stringify([now.shown.lines, now.shown.frames]);
/** Whether there is more of an input than before, of which this page was shown. @param {Answer} answer */
const isGrown = ({ lines }) => now.shown.page.first > 0 || (now.shown.lines.length === lines.length && now.shown.page.next > 0);

/**
 * Shows an answer of Python.
 *
 * @param {Answer} answer
 * @param {boolean} isMore  whether it is about the same input as the one before: then the page stays, and what is chosen on it
 */
export const view = (answer, isMore) => {
  const { lines, frames, rows, page, findings } = now.shown;
  const isSame = isConfirmed(answer), isThere = isSame || (isMore && isGrown(answer));
  now.shown = isThere ? { ...answer, lines, frames, rows, page: page.first ? page : answer.page } : answer;
  readBox.hidden = !now.shown.lines.length;
  change({ headline: answer.headline });
  if (!isMore || JSON.stringify(findings) !== JSON.stringify(answer.findings)) showFindings(answer.findings, (code) => home().ask("explain", code));
  if (isThere) showPager(now.shown.page, answer.count, turnTo); else showPage();
  if (isSame) tell(now.frame);
};

/** Shows the page that is there now. */
const showPage = () => {
  const { lines, rows, page, count } = now.shown;
  Object.assign(now, { rows: rowsByFrame(lines), marked: null, isKept: false, frame: -1, columns: columns(), about: UNKNOWN });
  change({ about: "", byte: "" });
  showPager(page, count, turnTo);
  showRows(rows);
  showTree();
  showHeader();
  fitDump();
  const first = lines.findIndex(([, frame]) => frame >= 0);
  // The first message is chosen for the keyboard, but a mark over all of it would say nothing.
  now.kept = first < 0 ? null : targetOf(lines, first);
  if (now.kept) dump(now.kept.frame, 0);
};

/** Shows the page that has a frame. Returns whether it does. @param {number} frame */
const turnTo = async (frame) => {
  const input = newest();
  /** @type {import("./answer.js").Page} */
  const page = await home().ask("page", frame);
  if (input !== newest()) return false;
  now.shown = { ...now.shown, ...page };
  showPage();
  treeBox.scrollTop = 0;
  return true;
};

/** Returns the number of bytes of a frame. @param {number} frame */
const sizeOf = (frame) => hexOf(frame).length / 2;

/** Returns a frame in hex: of this page, or one with findings. @param {number} frame */
const hexOf = (frame) => now.shown.frames[frame] ?? now.shown.found[frame] ?? "";

// The tree, and the header above it

const showTree = () => {
  treeBox.replaceChildren(...now.shown.lines.map(([pieces, frame], number) => {
    const row = filled(make("span"), pieces);
    row.append("\n");
    if (frame >= 0) asItem(row, `line-${number}`, pieces[0]?.[0].match(/^ */)?.[0].length ?? 0);
    if (frame >= 0) row.dataset.row = String(number);
    return row;
  }));
};

/** Makes a line an item of a tree. @param {HTMLElement} row @param {string} id @param {number} indent  its level follows from it */
const asItem = (row, id, indent) => {
  row.setAttribute("role", "treeitem");
  row.id = id;
  row.setAttribute("aria-level", String(indent ? 2 : 1));
  row.setAttribute("aria-selected", "false");
};

const showHeader = () => {
  headerBox.hidden = !now.about.parts.length;
  headerBox.replaceChildren(...now.about.parts.map(({ name, offset, text }, number) => {
    const row = filled(make("span"), [[String(offset).padStart(6), "aside"], [`  ${name}`, `name field-${name}`], [` = ${text}`, "plain"]]);
    asItem(row, `part-${number}`, 0);
    row.dataset.part = String(number);
    return row;
  }));
};

// The dump

/** Makes the box high enough for the longest frame, so that pointing at another one moves nothing. */
const fitDump = () => {
  const most = Math.max(0, ...Object.values(now.shown.frames).map((hex) => hex.length / 2));
  bytesBox.style.setProperty("--rows", String(Math.min(Math.ceil(most / now.columns), MOST_ROWS_SHOWN)));
  if (!most) bytesBox.replaceChildren();
};

/** Has a byte of a frame in the dump. @param {number} frame @param {number} at */
const dump = (frame, at) => {
  const isFrame = now.frame === frame;
  // Of a long program only a part is in the page.
  const isPart = sizeOf(frame) <= MOST_BYTES || (at >= now.start && at < now.start + MOST_BYTES);
  if (isFrame && isPart) return;
  now.frame = frame;
  now.start = partOf(sizeOf(frame), at);
  if (!isFrame) now.about = UNKNOWN;
  draw();
  if (!isFrame) tell(frame);
};

const draw = () => {
  const { frame, start, shown, about } = now;
  const hex = hexOf(frame), size = sizeOf(frame);
  const parts = (now.rows.get(frame) ?? []).map((row) => targetOf(shown.lines, row));
  const classes = classesOf(size, about.parts, parts);
  drawDump(bytesBox, { hex, start, end: Math.min(size, start + MOST_BYTES), columns: now.columns, classes });
  const same = Object.entries(shown.frames).filter(([number, other]) => Number(number) < frame && other === hex);
  colour(shown.isProgram || shown.page.first ? "" : hex, classes, same.length);
};

/** Says what a frame means, as soon as Python has told. @param {number} frame */
const tell = async (frame) => {
  if (frame < 0 || now.shown.isProgram) return;
  const hex = hexOf(frame);
  /** @type {About} */
  const about = now.shown.about ?? await home().ask("about", hex);
  if (frame !== now.frame || hex !== hexOf(frame)) return;
  now.about = about;
  // Of a single frame, the headline says it.
  change({ about: now.shown.count > 1 ? about.sentence : "" });
  showHeader();
  draw();
  show(now.marked);
};

// Marks

/** Marks a target, or nothing. @param {Target | null} target */
const show = (target) => {
  now.marked = target;
  if (!target) {
    unmark();
    return;
  }
  dump(target.frame, target.offset);
  mark(target, now.shown.findings, sizeOf(target.frame));
};

/** @param {Element} box @param {Element | null} element */
const scroll = (box, element) => {
  if (!element) return;
  const { top, bottom } = element.getBoundingClientRect(), outer = box.getBoundingClientRect();
  if (top < outer.top) box.scrollTop -= outer.top - top;
  else if (bottom > outer.bottom) box.scrollTop += bottom - outer.bottom;
};

/** Keeps a target marked, and says what its byte means. @param {Target} target */
const keep = (target) => {
  now.kept = target;
  now.isKept = true;
  show(target);
  const at = target.at ?? target.offset;
  scroll(treeBox, lineOf(target));
  scroll(bytesBox, byteAt(at));
  change({ byte: now.about.bytes[at] ?? "" });
};

/** Keeps a target marked, on its page. @param {Target} target */
const open = async (target) => {
  if (!(target.frame in now.shown.frames) && !await turnTo(target.frame)) return;
  keep({ ...target, row: target.row < 0 && target.part === undefined ? lineAt(target.frame, target.offset) : target.row });
  // A finding of a file may be far from its frame.
  if (target.block !== undefined && state().file) lineOf(now.kept ?? target)?.scrollIntoView({ block: "nearest" });
};

/** How to find what an event is about: by the data of an element. @type {Record<string, (number: number) => Target>} */
const TARGETS = {
  row: (number) => targetOf(now.shown.lines, number),
  part: (number) => partTarget(number),
  at: (number) => byteTarget(now.frame, number),
  letter: (number) => byteTarget(now.frame, number),
  block: (number) => {
    const { frame, offset, length, line } = now.shown.findings[number];
    return { frame, offset, length, line, block: number, row: lineAt(frame, offset) };
  },
};

/** Returns what an event is about: a row, a byte or letter, a finding. @param {Event} event @returns {Target | null} */
const pointed = ({ target }) => {
  const element = target instanceof Element ? target.closest("[data-row], [data-part], [data-at], [data-letter], [data-block]") : null;
  if (!(element instanceof HTMLElement)) return null;
  const kind = Object.keys(TARGETS).find((name) => element.dataset[name] !== undefined);
  return kind ? TARGETS[kind](Number(element.dataset[kind])) : null;
};

/** Returns the line about a byte; -1 for none. @param {number} frame @param {number} at */
const lineAt = (frame, at) => rowAt(now.shown.lines, now.rows.get(frame) ?? [], at);

/** @param {number} number @returns {Target} */
const partTarget = (number) => {
  const { offset, length } = now.about.parts[number];
  return { frame: now.frame, offset, length, row: -1, part: number };
};

/** @param {number} frame @param {number} at @returns {Target} */
const byteTarget = (frame, at) => {
  const part = frame === now.frame ? now.about.parts.findIndex(({ offset, length }) => at >= offset && at < offset + length) : -1;
  if (part >= 0) return { ...partTarget(part), at };
  const row = lineAt(frame, at);
  return row < 0 ? { frame, offset: at, length: 1, row, at } : { ...targetOf(now.shown.lines, row), at };
};

/** Calls a function when a finding is chosen that is in a line of the text. @param {(line: number) => void} choose */
export const onLine = (choose) => {
  findingsBox.addEventListener("click", (event) => {
    const target = pointed(event);
    if (target?.line) choose(target.line);
  });
};

for (const box of [bytesBox, headerBox, treeBox, findingsBox]) {
  box.addEventListener("pointerover", (event) => {
    if (event.pointerType === "touch") return;
    const target = pointed(event);
    if (!target) return;
    show(target);
    if (box !== bytesBox) scroll(bytesBox, byteAt(target.offset));
  });
  box.addEventListener("pointerleave", (event) => {
    if (event.pointerType !== "touch" && now.marked !== now.kept) show(now.isKept ? now.kept : null);
  });
  box.addEventListener("click", (event) => {
    if (event.target instanceof Element && event.target.closest("a, summary, details")) return;
    const target = pointed(event);
    if (target) open(target);
  });
}

/**
 * Has keys move what is kept.
 *
 * @param {HTMLElement} box
 * @param {(key: string) => number | undefined} stepOf
 * @param {(kept: Target, step: number) => Target | null} next
 */
const onKeys = (box, stepOf, next) => box.addEventListener("keydown", (event) => {
  const step = stepOf(event.key);
  if (!step || !now.kept) return;
  event.preventDefault();
  const target = next(now.kept, step);
  if (target) keep(target);
});
/** @type {Record<string, number>} */
const UP_DOWN = { ArrowDown: 1, ArrowUp: -1 };

onKeys(treeBox, (key) => UP_DOWN[key], (kept, step) => {
  const { lines } = now.shown;
  let next = kept.row + step;
  while (lines[next] && lines[next][1] < 0) next += step;
  return lines[next] ? targetOf(lines, next) : null;
});
onKeys(headerBox, (key) => UP_DOWN[key], (kept, step) => {
  const next = kept.part === undefined ? 0 : kept.part + step;
  return now.about.parts[next] ? partTarget(next) : null;
});
onKeys(
  bytesBox,
  (key) => ({ ArrowRight: 1, ArrowLeft: -1, ArrowDown: now.columns, ArrowUp: -now.columns })[key],
  (kept, step) => {
    const next = (kept.at ?? kept.offset) + step;
    return next >= 0 && next < sizeOf(kept.frame) ? byteTarget(kept.frame, next) : null;
  },
);
findingsBox.addEventListener("keydown", (event) => {
  if (event.key !== "Enter" || !(event.target instanceof HTMLElement) || event.target.dataset.block === undefined) return;
  event.preventDefault();
  event.target.click();
});

new ResizeObserver(() => {
  const count = columns();
  if (count === now.columns) return;
  now.columns = count;
  fitDump();
  if (now.frame >= 0) draw();
  show(now.marked);
}).observe(readBox);
