// What was probably meant by a wrong input: a button for each remedy, which replaces the input.

import { replace } from "./editor.js";
import { find, make } from "./elements.js";
import { LITTLE, source } from "./reading.js";
import { state, verdictOf } from "./state.js";

const input = find("input", HTMLTextAreaElement), row = find("remedies");

/** Offers remedies for what was read last, if it is wrong. */
export const offerRemedies = async () => {
  const text = input.value;
  row.replaceChildren();
  const isWrong = verdictOf(state()).kind !== "takes" && (state().error || state().verdict.kind);
  if (!isWrong || state().file || text.length > LITTLE) return;
  /** @type {{label: string, line: string, text: string}[]} */
  const found = await source().ask("remedies", text);
  if (text !== input.value) return;
  row.replaceChildren(...found.map((remedy) => {
    const button = make("button", remedy.label);
    button.title = remedy.line;
    button.onclick = () => replace(remedy.text);
    return button;
  }));
};
