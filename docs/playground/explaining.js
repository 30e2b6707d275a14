// Words explain themselves where they are: pointed at, with the focus, or tapped. The page's own words have their text in
// the HTML, as data-explain; what encodings and parameters mean is in Python's tables.

import { find, make } from "./elements.js";
import { home } from "./reading.js";

/** Where encodings, parameters and offsets are explained. */
const PLACES = "#tree, #header, #findings, #byte";
const ENCODING = /\b(?:(?:L[CV]|GV)[0124]|LCS|LAB1)\b/g;
const OFFSET = /^\s*\d+\s*$|\boffset\b/;
const OFFSET_TEXT = "offset: the number of bytes before this one in the frame; the first byte has the offset 0";
/** Pixels between a tip and what it explains, and the edges of the window. */
const GAP = 4;

const tip = find("tip");
/** @type {Element | null} */
let explained = null;
/** Whether it is explained because the pointer is there: else the pointer does not end it, over which a page may scroll. */
let isPointed = false;

/** Returns the operation that a line of the tree is part of. @param {Element | null} line */
const operationOf = (line) => {
  while (line && !line.querySelector(".operation")) line = line.previousElementSibling;
  return line?.querySelector(".operation")?.textContent ?? "";
};

/** Returns the explanations of the words in an element, one line each. @param {Element} element @returns {Promise<string[]>} */
const linesOf = async (element) => {
  const own = element.getAttribute("data-explain"), text = element.textContent ?? "";
  if (own) return [own];
  const names = [element, ...element.querySelectorAll(".name")].filter((each) => each.matches("#tree .name"));
  const words = [...names.map((each) => [each.textContent?.trim(), operationOf(each.closest("#tree > *"))]), ...new Set(text.match(ENCODING))];
  const parts = [element, ...element.querySelectorAll(".aside")];
  const isOffset = parts.some((each) => each.matches(".aside, #findings *") && OFFSET.test(each.textContent ?? ""));
  const said = await Promise.all(words.map((word) => home().ask("explain", ...[word].flat())));
  return [...(isOffset ? [OFFSET_TEXT] : []), ...said.filter(Boolean)];
};

const place = () => {
  if (!explained) return;
  const { left, top, bottom } = explained.getBoundingClientRect(), { width, height } = tip.getBoundingClientRect();
  tip.style.left = `${Math.max(GAP, Math.min(left, document.documentElement.clientWidth - width - GAP))}px`;
  tip.style.top = `${bottom + GAP + height > innerHeight ? top - GAP - height : bottom + GAP}px`;
};

const hide = () => {
  explained?.removeAttribute("aria-describedby");
  explained = null;
  isPointed = false;
  tip.hidden = true;
};

/** Explains an element, or nothing. @param {Element | null | undefined} element */
const explain = async (element) => {
  if (element === explained) return;
  hide();
  if (!element) return;
  explained = element;
  const lines = await linesOf(element);
  if (element !== explained || !lines.length) return;
  tip.replaceChildren(...lines.map((line) => make("p", line)));
  tip.hidden = false;
  element.setAttribute("aria-describedby", "tip");
  place();
};

/** Returns what can be explained at an event: an element with words of its own, or a piece of a line. @param {Event} event */
const pieceAt = ({ target }) => {
  if (!(target instanceof Element)) return null;
  const isPiece = target.closest(PLACES) && !target.matches(`${PLACES}, [role=treeitem], .finding, .excerpt`);
  return target.closest("[data-explain]") ?? (isPiece ? target : null);
};

document.addEventListener("pointerover", (event) => {
  const piece = pieceAt(event);
  if (event.pointerType === "touch" || (event.target instanceof Node && tip.contains(event.target)) || !(piece || isPointed)) return;
  explain(piece);
  isPointed = piece !== null;
});
document.addEventListener("click", (event) => {
  const { target } = event;
  explain(pieceAt(event) ?? (target instanceof Element ? target.closest("#tree [role=treeitem], #byte, .finding") : null));
});
document.addEventListener("focusin", ({ target }) => { if (target instanceof Element && target.matches("[data-explain], .finding")) explain(target); });
document.addEventListener("focusout", hide);
document.addEventListener("keydown", ({ key, target }) => {
  if (key === "Escape") hide();
  const line = key.startsWith("Arrow") && target instanceof Element && target.matches("#tree") ? target.getAttribute("aria-activedescendant") : null;
  if (line) explain(document.getElementById(line));
});
document.addEventListener("scroll", place, true);
