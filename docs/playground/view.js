// What the input says: findings, the bytes as a dump, the tree. Pointing at one of them marks all three; a click keeps it.

import { filled, find, make } from "./elements.js";
import { MOST_BYTES, NOTHING, overlap, partOf, rowAt, rowsByFrame, targetOf } from "./places.js";

/** @typedef {import("./answer.js").Answer} Answer */
/** @typedef {import("./places.js").Target} Target */

const COLUMNS = 16, FEW_COLUMNS = 8;
const WIDE = 560;
const MOST_ROWS_SHOWN = 10;
const HEADER = [2, 4, 5, 7];
/** A line of bytes below a finding, or of marks under them. */
const EXCERPT = /^ *(\+\d+)? \|/;

const bytesBox = find("bytes"), treeBox = find("tree"), findingsBox = find("findings"), readBox = find("read");

/** @type {Answer} */
let shown = NOTHING;
let rowsOf = rowsByFrame([]);
/** What is kept by a click, and what is marked now. @type {Target | null} */
let kept = null, /** @type {Target | null} */ marked = null, isKept = false;
/** The frame in the dump, and its first byte that is shown. */
let dumped = { frame: -1, start: 0, columns: COLUMNS };

/**
 * Shows an answer of Python.
 *
 * @param {Answer} answer
 * @param {(code: string) => Promise<string>} explain  tells what a code means
 */
export const view = (answer, explain) => {
  shown = answer;
  rowsOf = rowsByFrame(shown.lines);
  find("read").hidden = !shown.lines.length;
  find("count").textContent = shown.count > 1 ? `${shown.count.toLocaleString("en")} frames` : "";
  showTree();
  showFindings(explain);
  marked = null;
  isKept = false;
  dumped = { frame: -1, start: 0, columns: columns() };
  fitDump();
  const first = shown.lines.findIndex(([, frame]) => frame >= 0);
  // The first message is chosen for the keyboard, but a mark over all of it would say nothing.
  kept = first < 0 ? null : targetOf(shown.lines, first);
  if (kept) dump(kept.frame, 0);
};

/** Returns the line about a byte; -1 for none. @param {number} frame @param {number} at */
const lineAt = (frame, at) => rowAt(shown.lines, rowsOf.get(frame) ?? [], at);

/** Returns the number of bytes of a frame. @param {number} frame */
const sizeOf = (frame) => (shown.frames[frame]?.length ?? 0) / 2;

// The tree

const showTree = () => {
  treeBox.replaceChildren(...shown.lines.map(([pieces, frame], number) => {
    const row = filled(make("span"), pieces);
    row.append("\n");
    if (frame >= 0) {
      row.role = "treeitem";
      row.id = `line-${number}`;
      row.dataset.row = String(number);
    }
    return row;
  }));
};

// Findings

/** @param {(code: string) => Promise<string>} explain */
const showFindings = (explain) => {
  const { summary, blocks, accepted, places } = shown.findings;
  /** @type {HTMLElement[]} */
  const elements = summary ? [make("p", `${summary}\n`, "summary")] : [];
  find("check").hidden = !summary && !blocks.length;
  blocks.forEach((block, number) => {
    const box = make("div", "", `finding ${block.severity}`);
    if (block.frame >= 0) box.dataset.block = String(number);
    /** @type {HTMLElement | null} */
    let excerpt = null;
    for (const pieces of block.lines) {
      const text = pieces.map(([it]) => it).join("");
      const line = filled(make("div", "", text ? "" : "gap"), pieces);
      line.append("\n");
      if (!EXCERPT.test(text)) {
        excerpt = null;
        box.append(line);
      } else {
        // The bytes and their marks scroll together.
        if (!excerpt) {
          excerpt = make("div", "", "excerpt");
          box.append(excerpt);
        }
        excerpt.append(line);
      }
    }
    for (const code of block.codes) box.append(explanation(code, explain));
    elements.push(box);
  });
  if (accepted) {
    const more = make("details", "", "accepted");
    const left = accepted - places.length;
    const lines = [...places.map((place) => `${place}: accepted: no findings`), ...(left ? [`... and ${left} more`] : [])];
    more.append(make("summary", `${accepted.toLocaleString("en")} accepted`), make("pre", lines.join("\n")));
    elements.push(more);
  }
  findingsBox.replaceChildren(...elements);
};

/** @param {string} code @param {(code: string) => Promise<string>} explain */
const explanation = (code, explain) => {
  const more = make("details"), body = make("pre");
  more.append(make("summary", `What ${code} means`), body);
  more.ontoggle = async () => { if (!body.textContent) body.textContent = await explain(code); };
  return more;
};

// The dump

const columns = () => (readBox.clientWidth < WIDE ? FEW_COLUMNS : COLUMNS);

/** Makes the box high enough for the longest frame, so that pointing at another one moves nothing. */
const fitDump = () => {
  const most = Math.max(0, ...Object.values(shown.frames).map((hex) => hex.length / 2));
  bytesBox.style.setProperty("--rows", String(Math.min(Math.ceil(most / dumped.columns), MOST_ROWS_SHOWN)));
  if (!most) bytesBox.replaceChildren();
};

/** @param {number} frame @param {number} at */
const dump = (frame, at) => {
  const hex = shown.frames[frame] ?? "";
  const size = sizeOf(frame);
  // Of a long program only a part is in the page.
  const start = partOf(size, at);
  const isThere = dumped.frame === frame && (size <= MOST_BYTES || (at >= dumped.start && at < dumped.start + MOST_BYTES));
  if (isThere) return;
  dumped = { frame, start, columns: dumped.columns };
  const cuts = new Set(shown.isProgram ? [] : HEADER);
  for (const row of rowsOf.get(frame) ?? []) {
    const [, , offset, length] = shown.lines[row];
    cuts.add(offset);
    cuts.add(offset + length);
  }
  const end = Math.min(size, start + MOST_BYTES);
  let tint = false;
  const rows = [];
  for (let row = start; row < end; row += dumped.columns) {
    const line = make("div"), letters = make("code");
    line.append(make("i", row.toString(16).toUpperCase().padStart(4, "0")));
    for (let index = row; index < Math.min(end, row + dumped.columns); index++) {
      if (cuts.has(index)) tint = !tint;
      const text = hex.slice(2 * index, 2 * index + 2).toUpperCase();
      const byte = make("span", text, tint ? "tint" : "");
      byte.role = "option";
      byte.id = `byte-${index}`;
      byte.dataset.at = String(index);
      const number = parseInt(text, 16);
      const letter = make("samp", number > 31 && number < 127 ? String.fromCharCode(number) : "·");
      letter.dataset.letter = String(index);
      letters.append(letter);
      line.append(byte);
    }
    for (let index = end; index < row + dumped.columns; index++) line.append(make("u"));
    line.append(letters);
    rows.push(line);
  }
  const isCut = start > 0 || end < size;
  bytesBox.replaceChildren(...rows, ...(isCut ? [make("div", `bytes ${start} to ${end - 1} of ${size}`, "aside")] : []));
};

// Marks

/** Marks a target in all three, and takes the marks of the one before away. @type {(target: Target | null) => void} */
const mark = (target) => {
  for (const element of document.querySelectorAll("#bytes .chosen, #bytes .named, #tree .chosen, #findings .chosen")) {
    element.classList.remove("chosen", "named");
    if (element.role) element.setAttribute("aria-selected", "false");
  }
  marked = target;
  if (!target) return;
  const { frame, offset, length, row } = target;
  dump(frame, offset);
  const at = target.at ?? offset;
  for (let index = offset; index < offset + length; index++) {
    const byte = byteAt(index);
    byte?.classList.add("chosen");
    byte?.setAttribute("aria-selected", "true");
  }
  for (const letter of /** @type {NodeListOf<HTMLElement>} */ (bytesBox.querySelectorAll("[data-letter]"))) {
    const index = Number(letter.dataset.letter);
    if (index >= offset && index < offset + length) letter.classList.add("named");
  }
  bytesBox.setAttribute("aria-activedescendant", `byte-${at}`);
  const line = treeBox.children[row];
  line?.classList.add("chosen");
  line?.setAttribute("aria-selected", "true");
  treeBox.setAttribute("aria-activedescendant", line?.id ?? "");
  shown.findings.blocks.forEach((block, number) => {
    const isAbout = block.codes.length && block.frame === frame && overlap(block, target);
    if (isAbout && (length < sizeOf(frame) || target.block === number)) {
      findingsBox.querySelector(`[data-block="${number}"]`)?.classList.add("chosen");
    }
  });
};

/** @param {Element} box @param {Element | null} element */
const scroll = (box, element) => {
  if (!element) return;
  const { top, bottom } = element.getBoundingClientRect(), outer = box.getBoundingClientRect();
  if (top < outer.top) box.scrollTop -= outer.top - top;
  else if (bottom > outer.bottom) box.scrollTop += bottom - outer.bottom;
};

/** @param {Target} target */
const keep = (target) => {
  kept = target;
  isKept = true;
  mark(target);
  scroll(treeBox, treeBox.children[target.row]);
  scroll(bytesBox, byteAt(target.at ?? target.offset));
};

/** Returns the byte in the dump, if it is there. @param {number} at */
const byteAt = (at) => document.getElementById(`byte-${at}`);

/** What an event is about: a row, a byte or letter, a finding. @param {Event} event @returns {Target | null} */
const pointed = ({ target }) => {
  const element = target instanceof Element ? target.closest("[data-row], [data-at], [data-letter], [data-block]") : null;
  if (!(element instanceof HTMLElement)) return null;
  if (element.dataset.row !== undefined) return targetOf(shown.lines, Number(element.dataset.row));
  if (element.dataset.block !== undefined) {
    const number = Number(element.dataset.block);
    const { frame, offset, length, line } = shown.findings.blocks[number];
    return { frame, offset, length, line, block: number, row: lineAt(frame, offset) };
  }
  const at = Number(element.dataset.at ?? element.dataset.letter);
  return byteTarget(dumped.frame, at);
};

/** @param {number} frame @param {number} at @returns {Target} */
const byteTarget = (frame, at) => {
  const row = lineAt(frame, at);
  return row < 0 ? { frame, offset: at, length: 1, row, at } : { ...targetOf(shown.lines, row), at };
};

/** Calls a function when a finding is chosen that is in a line of the text. @param {(line: number) => void} choose */
export const onLine = (choose) => {
  findingsBox.addEventListener("click", (event) => {
    const target = pointed(event);
    if (target?.line) choose(target.line);
  });
};

for (const box of [bytesBox, treeBox, findingsBox]) {
  box.addEventListener("pointerover", (event) => {
    if (event.pointerType === "touch") return;
    const target = pointed(event);
    if (!target) return;
    mark(target);
    if (box !== bytesBox) scroll(bytesBox, byteAt(target.offset));
  });
  box.addEventListener("pointerleave", (event) => {
    if (event.pointerType !== "touch" && marked !== kept) mark(isKept ? kept : null);
  });
  box.addEventListener("click", (event) => {
    if (event.target instanceof Element && event.target.closest("a, summary, details")) return;
    const target = pointed(event);
    if (target) keep(target);
  });
}
treeBox.addEventListener("keydown", (event) => {
  const step = { ArrowDown: 1, ArrowUp: -1 }[/** @type {"ArrowDown"} */ (event.key)];
  if (!step || !kept) return;
  event.preventDefault();
  let next = kept.row + step;
  while (shown.lines[next] && shown.lines[next][1] < 0) next += step;
  if (shown.lines[next]) keep(targetOf(shown.lines, next));
});
bytesBox.addEventListener("keydown", (event) => {
  const step = { ArrowRight: 1, ArrowLeft: -1, ArrowDown: dumped.columns, ArrowUp: -dumped.columns }[/** @type {"ArrowRight"} */ (event.key)];
  if (!step || !kept) return;
  event.preventDefault();
  const next = (kept.at ?? kept.offset) + step;
  if (next >= 0 && next < sizeOf(kept.frame)) keep(byteTarget(kept.frame, next));
});
new ResizeObserver(() => {
  const now = columns();
  if (now === dumped.columns) return;
  dumped = { frame: -1, start: 0, columns: now };
  fitDump();
  if (kept) dump(kept.frame, kept.offset);
  mark(marked);
}).observe(readBox);
