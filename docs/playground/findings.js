// What a check found, as elements: the bytes of an excerpt and their marks scroll together, Enter opens a finding.

import { filled, find, make } from "./elements.js";

/** @typedef {(code: string) => Promise<string>} Explain  tells what a code means */

/** Shows findings. @param {import("./answer.js").Block[]} blocks @param {Explain} explain */
export const showFindings = (blocks, explain) => {
  find("check").hidden = !blocks.length;
  find("findings").replaceChildren(...blocks.map((block, number) => blockBox(block, number, explain)));
};

/** @param {import("./answer.js").Block} block @param {number} number @param {Explain} explain */
const blockBox = ({ lines, severity, codes, frame }, number, explain) => {
  const box = make("div", "", `finding ${severity}`);
  // It may scroll sideways.
  box.tabIndex = 0;
  box.setAttribute("role", "group");
  box.setAttribute("aria-label", textOf(lines[0] ?? []));
  if (frame >= 0) box.dataset.block = String(number);
  /** @type {HTMLElement | null} */
  let excerpt = null;
  for (const pieces of lines) {
    const text = textOf(pieces);
    const line = filled(make("div", "", text ? "" : "gap"), pieces);
    line.append("\n");
    if (pieces[0]?.[1] === "gutter") {
      if (!excerpt) {
        excerpt = make("div", "", "excerpt");
        box.append(excerpt);
      }
      excerpt.append(line);
    } else {
      excerpt = null;
      box.append(line);
    }
  }
  box.append(...codes.map((code) => explanation(code, explain)));
  return box;
};

/** @param {import("./elements.js").Piece[]} pieces */
const textOf = (pieces) => pieces.map(([text]) => text).join("");

/** @param {string} code @param {Explain} explain */
const explanation = (code, explain) => {
  const more = make("details"), body = make("pre");
  more.append(make("summary", `What ${code} means`), body);
  more.ontoggle = async () => { if (!body.textContent) body.textContent = await explain(code); };
  return more;
};
