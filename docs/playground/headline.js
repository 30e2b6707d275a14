// The headline: what the input is, what is wrong with it, and a button for each change that was probably meant.

import { replace } from "./editor.js";
import { find, make } from "./elements.js";
import { home } from "./reading.js";
import { follow, state } from "./state.js";

/** @typedef {{sentence: string, verdict: string, kind: "none" | "takes" | "refuses", severity: "" | "error" | "warning"}} Headline  see bridge/headline.py */

const input = find("input", HTMLTextAreaElement), row = find("remedies");

/** Sets a text that differs: screen readers read out what is set. @param {string} id @param {string} text */
export const setText = (id, text) => { if (find(id).textContent !== text) find(id).textContent = text; };

follow(({ headline: { sentence, verdict, kind, severity }, error }) => {
  setText("sentence", sentence);
  setText("verdict", verdict);
  setText("error", error);
  Object.assign(find("verdict").dataset, { kind, severity });
  find("say").hidden = !sentence && !verdict && !error;
});

/** Takes the buttons away: they belong to an older input. */
export const clearRemedies = () => row.replaceChildren();

/** Offers what was probably meant by what was read last. */
export const offerRemedies = async () => {
  const text = input.value;
  /** @type {{label: string, text: string}[]} */
  const found = state().file ? [] : await home().ask("remedies");
  if (text !== input.value) return;
  row.replaceChildren(...found.map((remedy) => {
    const button = make("button", remedy.label);
    button.title = remedy.text.length > 200 ? "" : remedy.text;
    button.onclick = () => replace(remedy.text);
    return button;
  }));
};
