// What is marked in the dump, the header, the tree, the findings and the input, all at once.

import { find } from "./elements.js";
import { paint } from "./paint.js";
import { overlap } from "./places.js";

/** @typedef {import("./places.js").Target} Target */

/** What can be marked, by its selector. */
const MARKED = "#bytes .chosen, #bytes .named, #header .chosen, #tree .chosen, #findings .chosen";

/** @param {Element | null | undefined} element @param {string} [name] */
const choose = (element, name = "chosen") => {
  element?.classList.add(name);
  if (element?.hasAttribute("aria-selected")) element.setAttribute("aria-selected", "true");
};

/** Returns the byte in the dump, if it is there. @param {number} at */
export const byteAt = (at) => document.getElementById(`byte-${at}`);

/** Returns the line of the header or of the tree about a target. @param {Target} target @returns {HTMLElement | null} */
export const lineOf = ({ row, part }) => document.getElementById(part === undefined ? `line-${row}` : `part-${part}`);

/** Takes all marks away. */
export const unmark = () => {
  for (const element of document.querySelectorAll(MARKED)) {
    element.classList.remove("chosen", "named");
    if (element.hasAttribute("aria-selected")) element.setAttribute("aria-selected", "false");
  }
  paint(null);
};

/**
 * Marks a target.
 *
 * @param {Target} target
 * @param {import("./answer.js").Block[]} blocks  the findings
 * @param {number} size  the bytes of the frame
 */
export const mark = (target, blocks, size) => {
  unmark();
  const { frame, offset, length } = target;
  for (let index = offset; index < offset + length; index++) choose(byteAt(index));
  for (const letter of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("#bytes [data-letter]"))) {
    const index = Number(letter.dataset.letter);
    if (index >= offset && index < offset + length) choose(letter, "named");
  }
  const line = lineOf(target);
  choose(line);
  find("bytes").setAttribute("aria-activedescendant", `byte-${target.at ?? offset}`);
  const box = target.part === undefined ? "tree" : "header";
  find(box).setAttribute("aria-activedescendant", line?.id ?? "");
  paint(target);
  blocks.forEach((block, number) => {
    const isAbout = block.codes.length > 0 && block.frame === frame && overlap(block, target);
    if (isAbout && (length < size || target.block === number)) choose(document.querySelector(`#findings [data-block="${number}"]`));
  });
};
