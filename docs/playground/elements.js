// What the modules of the page share: finding, making and filling elements, and saving files. Text is never markup.

import { make, saveAs } from "./brick.js";

export { make, saveAs };

export const find = (id) => document.getElementById(id);

/** The pieces of a line that Python made: text, the role that gives its colour, its place in the reference. */
export const filled = (element, pieces) => {
  for (const [text, role, place] of pieces) {
    if (place) {
      // Blanks before a name are not part of the link.
      const [, blanks, name] = text.match(/^(\s*)(.*)$/s);
      const link = make("a", name, role);
      link.href = `../reference/${place}`;
      link.target = "_blank";
      link.tabIndex = -1;
      element.append(blanks, link);
    } else element.append(role === "plain" ? text : make("span", text, role));
  }
  return element;
};

/** Shows a text in a button for a moment. */
export const flash = (button, text) => {
  button.dataset.text ??= button.textContent;
  button.textContent = text;
  clearTimeout(Number(button.dataset.timer));
  button.dataset.timer = setTimeout(() => { button.textContent = button.dataset.text; }, 1500);
};

/** Copies a text, and says in the button whether that worked. */
export const copy = async (text, button) => {
  try {
    await navigator.clipboard.writeText(text);
    flash(button, "Copied");
  } catch {
    flash(button, "The browser did not allow it");
  }
};
