// The frames in notations of other programs, one tab each. Those of many frames are made when their tab is opened.

import { put } from "./editor.js";
import { copy, find, inside, remember, remembered } from "./elements.js";
import { home } from "./reading.js";

const CHOSEN = "notation";
/** @type {Record<string, string>} */
const PANELS = { lesson: "frame", hex: "hex", c: "c", python: "python", javascript: "javascript", operations: "operations" };

const operations = inside(find("operations"), "textarea", HTMLTextAreaElement);
const complaint = inside(find("operations"), "p", HTMLParagraphElement);

const tabs = /** @type {HTMLElement[]} */ ([...document.querySelectorAll("[data-tab]")]);
/** @type {Record<string, string>} */
let made = {};
/** @type {(form: string) => Promise<string>} */
let ask = async () => "";
let chosen = "lesson";

/**
 * Shows the frames of an answer.
 *
 * @param {import("./answer.js").Answer} answer
 * @param {(form: string) => Promise<string>} make  makes a notation that is not in the answer
 */
export const showMade = (answer, make) => {
  ask = make;
  if (made.lesson === answer.made.lesson && Object.keys(answer.made).every((form) => made[form] !== undefined)) return;
  made = { ...answer.made };
  find("make").hidden = !answer.made.lesson;
  for (const tab of Object.keys(PANELS)) showIn(tab);
  choose(chosen);
};

/** @param {string} name */
const choose = async (name) => {
  chosen = name;
  for (const tab of tabs) {
    const isChosen = tab.dataset.tab === name;
    tab.setAttribute("aria-selected", String(isChosen));
    tab.tabIndex = isChosen ? 0 : -1;
    find(PANELS[nameOf(tab)]).hidden = !isChosen;
  }
  find("copy").setAttribute("aria-label", `Copy as ${tabs.find((tab) => nameOf(tab) === name)?.textContent}`);
  if (made[name] !== undefined || !made.lesson) return;
  const now = made;
  now[name] = await ask(name);
  if (made === now) showIn(name);
};

/** Shows a notation in its panel; operations that are being edited stay as they are. @param {string} name */
const showIn = (name) => {
  if (name !== "operations") find(PANELS[name]).textContent = made[name] ?? "";
  else if (document.activeElement !== operations) operations.value = made[name] ?? "";
};

/** @param {HTMLElement} tab */
const nameOf = (tab) => tab.dataset.tab ?? "";

for (const tab of tabs) {
  tab.onclick = () => {
    remember(CHOSEN, nameOf(tab));
    choose(nameOf(tab));
  };
}
find("tabs").onkeydown = (event) => {
  const step = { ArrowRight: 1, ArrowLeft: -1 }[/** @type {"ArrowRight"} */ (event.key)];
  if (!step) return;
  event.preventDefault();
  const next = tabs[(tabs.findIndex((tab) => tab.dataset.tab === chosen) + step + tabs.length) % tabs.length];
  next.focus();
  next.click();
};
operations.oninput = async () => {
  const text = operations.value;
  /** @type {{text: string, error: string}} */
  const found = await home().ask("frames_of", text);
  if (text !== operations.value) return;
  complaint.textContent = found.error;
  if (found.text && !found.error) put(found.text);
};
find("copy").onclick = () => copy(made[chosen] ?? "", "copy");
const before = remembered(CHOSEN);
choose(before !== null && before in PANELS ? before : "lesson");
