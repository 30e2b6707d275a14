// What the modules of the page share: finding, making and filling elements, and saving files. Text is never markup.

import { make, saveAs } from "./brick.js";
import { flash } from "./state.js";

export { make, saveAs };

/** @typedef {[text: string, role: string, place?: string]} Piece  text, the role that gives its colour, its place in the reference */

/**
 * Returns the element with an id.
 *
 * @template {Element} [T=HTMLElement]
 * @param {string} id
 * @param {new () => T} [kind]  its class
 * @returns {T}
 */
export const find = (id, kind) => {
  const element = document.getElementById(id);
  if (!element || (kind && !(element instanceof kind))) throw new Error(`#${id} is missing, or of another kind`);
  return /** @type {T} */ (/** @type {unknown} */ (element));
};

/**
 * Returns an element inside another one.
 *
 * @template {Element} T
 * @param {ParentNode} place
 * @param {string} selector
 * @param {new () => T} kind
 * @returns {T}
 */
export const inside = (place, selector, kind) => {
  const element = place.querySelector(selector);
  if (!(element instanceof kind)) throw new Error(`${selector} is missing, or of another kind`);
  return element;
};

/**
 * Fills an element with the pieces of a line that Python made.
 *
 * @template {HTMLElement} T
 * @param {T} element
 * @param {Piece[]} pieces
 * @returns {T}
 */
export const filled = (element, pieces) => {
  for (const [text, role, place] of pieces) {
    if (place) {
      // Blanks before a name are not part of the link.
      const [, blanks, name] = text.match(/^(\s*)(.*)$/s) ?? ["", "", text];
      const link = make("a", name, role);
      link.href = `../reference/${place}`;
      link.target = "_blank";
      link.tabIndex = -1;
      element.append(blanks, link);
    } else element.append(role === "plain" ? text : make("span", text, role));
  }
  return element;
};

/** Keeps a choice for later visits, or forgets it. @param {string} name @param {string | null} value */
export const remember = (name, value) => {
  try {
    if (value === null) localStorage.removeItem(name); else localStorage.setItem(name, value);
  } catch { /* storage may be forbidden */ }
};

/** Returns a choice of an earlier visit; null for none. @param {string} name */
export const remembered = (name) => { try { return localStorage.getItem(name); } catch { return null; } };

/** Copies a text, and says in a button whether that worked. @param {string} text @param {string} id */
export const copy = async (text, id) => {
  try {
    await navigator.clipboard.writeText(text);
    flash(id, "Copied");
  } catch {
    flash(id, "The browser did not allow it");
  }
};
