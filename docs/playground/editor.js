// The input: edits that Ctrl-Z undoes, and completion.

import { find, make } from "./elements.js";

const input = find("input", HTMLTextAreaElement), list = find("words");

/** Chromium's own edits take seconds for more lines than this. */
const MOST_LINES = 200;
const MOST_UNDOS = 10;

let isOurs = false;
/** Long edits, each with the text before and after it. @type {{before: string, after: string}[]} */
const undos = [];

/** Replaces a part of the input as typing does: Ctrl-Z undoes it, and `input` events follow. @param {string} text */
export const edit = (text, start = 0, end = input.value.length) => {
  isOurs = true;
  input.focus({ preventScroll: true });
  input.setSelectionRange(start, end);
  const before = input.value;
  const isLong = [text, before.slice(start, end)].some((each) => each.split("\n").length > MOST_LINES);
  const isDone = !isLong && (start === end && !text || document.execCommand(text ? "insertText" : "delete", false, text));
  if (!isDone) {
    input.setRangeText(text, start, end, "end");
    undos.push({ before, after: input.value });
    undos.splice(0, undos.length - MOST_UNDOS);
    input.dispatchEvent(new Event("input"));
  }
  isOurs = false;
  // Only who types needs the keyboard of a phone.
  if (matchMedia("(pointer: coarse)").matches) input.blur();
};

input.addEventListener("keydown", (event) => {
  const last = undos.at(-1);
  if (event.key !== "z" || !(event.ctrlKey || event.metaKey) || event.shiftKey || input.value !== last?.after) return;
  event.preventDefault();
  undos.pop();
  isOurs = true;
  input.value = last.before;
  input.dispatchEvent(new Event("input"));
  isOurs = false;
});

/** Replaces the whole text, as something that is edited elsewhere: the focus stays there. @param {string} text */
export const put = (text) => {
  isOurs = true;
  input.value = text;
  input.dispatchEvent(new Event("input"));
  isOurs = false;
};

/** Replaces the whole text, but only the lines that differ are edited. @param {string} text */
export const replace = (text) => {
  const before = input.value;
  let start = 0, end = 0;
  const most = Math.min(before.length, text.length);
  while (start < most && before[start] === text[start]) start++;
  while (end < most - start && before.at(-1 - end) === text.at(-1 - end)) end++;
  edit(text.slice(start, text.length - end), start, before.length - end);
};

/**
 * Offers completions.
 *
 * @param {(before: string) => Promise<{word: string, words: string[][], hint: string}>} complete  what fits at the cursor
 */
export const offerCompletions = (complete) => {
  /** @type {string[][]} */
  let words = [];
  let chosen = -1, word = "";
  const hide = () => { list.hidden = true; };

  const suggest = async () => {
    const before = input.value.slice(0, input.selectionStart);
    const answer = await complete(before.slice(before.lastIndexOf("\n") + 1));
    if (input.value.slice(0, input.selectionStart) !== before || document.activeElement !== input) return;
    word = answer.word;
    words = answer.words;
    chosen = -1;
    const items = words.map(([, label], number) => {
      const item = make("li", label);
      item.setAttribute("role", "option");
      item.id = `word-${number}`;
      item.onpointerdown = (/** @type {PointerEvent} */ event) => { event.preventDefault(); insert(number); };
      return item;
    });
    const hint = make("li", answer.hint, "aside");
    hint.setAttribute("role", "option");
    hint.setAttribute("aria-disabled", "true");
    list.replaceChildren(...items, ...(answer.hint ? [hint] : []));
    list.hidden = !list.children.length;
    input.removeAttribute("aria-activedescendant");
  };

  /** @param {number} number */
  const insert = (number) => {
    const [name] = words[number];
    const [head, cmd] = name.split(".");
    const start = input.selectionStart - word.length;
    const isCall = !/\([^()]*$/.test(input.value.slice(0, start).split("\n").at(-1) ?? "");
    edit(isCall ? (cmd ? `${head}(${cmd}, ` : `${head}(`) : name, start, input.selectionStart);
    suggest();
  };

  /** @param {number} number */
  const mark = (number) => {
    list.children[chosen]?.classList.remove("chosen");
    chosen = number;
    for (const [at, item] of [...list.children].entries()) item.setAttribute("aria-selected", String(at === chosen));
    list.children[chosen].classList.add("chosen");
    list.children[chosen].scrollIntoView({ block: "nearest" });
    input.setAttribute("aria-activedescendant", `word-${chosen}`);
  };

  input.addEventListener("input", () => { if (isOurs) hide(); else suggest(); });
  input.addEventListener("blur", hide);
  input.addEventListener("keydown", (event) => {
    if (list.hidden || !words.length) return;
    const step = { ArrowDown: 1, ArrowUp: -1 }[/** @type {"ArrowDown"} */ (event.key)];
    if (step) mark(Math.max(0, Math.min(words.length - 1, chosen + step)));
    else if ((event.key === "Enter" || event.key === "Tab") && chosen >= 0) insert(chosen);
    else if (event.key === "Escape") hide();
    else return;
    event.preventDefault();
  });
};
