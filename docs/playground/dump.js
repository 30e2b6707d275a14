// The bytes of a frame as a dump: each byte has the colour of its field, and is a button of its own.

import { make } from "./elements.js";

/** @typedef {{name: string, offset: number, length: number}} Field  of a header: it has a colour of its own */

/**
 * Returns the class of each byte: its field of the header, or a tint that changes from part to part.
 *
 * @param {number} size
 * @param {Field[]} fields
 * @param {{offset: number, length: number}[]} parts  of the rest
 * @returns {string[]}
 */
export const classesOf = (size, fields, parts) => {
  const cuts = new Set(parts.flatMap(({ offset, length }) => [offset, offset + length]));
  let isTinted = false;
  /** @type {string[]} */
  const classes = Array.from({ length: size }, (_, at) => {
    if (cuts.has(at)) isTinted = !isTinted;
    return isTinted ? "tint" : "";
  });
  for (const { name, offset, length } of fields) classes.fill(`field-${name}`, offset, Math.min(size, offset + length));
  return classes;
};

/**
 * Draws a part of a frame.
 *
 * @param {HTMLElement} box
 * @param {{hex: string, start: number, end: number, columns: number, classes: string[]}} what
 */
export const drawDump = (box, { hex, start, end, columns, classes }) => {
  const size = hex.length / 2;
  const rows = [];
  for (let row = start; row < end; row += columns) {
    const line = make("div"), letters = make("code");
    line.append(make("i", row.toString(16).toUpperCase().padStart(4, "0")));
    for (let index = row; index < row + columns; index++) {
      if (index >= end) {
        line.append(make("u"));
        continue;
      }
      const text = hex.slice(2 * index, 2 * index + 2).toUpperCase();
      line.append(byteBox(index, text, classes[index]));
      letters.append(letterBox(index, parseInt(text, 16)));
    }
    line.append(letters);
    rows.push(line);
  }
  const isCut = start > 0 || end < size;
  box.replaceChildren(...rows, ...(isCut ? [make("div", `bytes ${start} to ${end - 1} of ${size}`, "aside")] : []));
};

/** @param {number} index @param {string} text @param {string} kind */
const byteBox = (index, text, kind) => {
  const byte = make("span", text, kind);
  byte.setAttribute("role", "option");
  byte.id = `byte-${index}`;
  byte.dataset.at = String(index);
  byte.setAttribute("aria-selected", "false");
  return byte;
};

/** @param {number} index @param {number} number */
const letterBox = (index, number) => {
  const letter = make("samp", number > 31 && number < 127 ? String.fromCharCode(number) : "·");
  letter.dataset.letter = String(index);
  return letter;
};
