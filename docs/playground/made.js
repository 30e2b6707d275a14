// The frames in notations of other programs, one tab each. Those of many frames are made when their tab is opened.

import { copy, find } from "./elements.js";
import { derived } from "./notations.js";

const CHOSEN = "notation";
/** @type {Record<string, string>} */
const PANELS = { lesson: "frame", hex: "hex", c: "c", python: "python", javascript: "javascript" };

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
  made = { ...answer.made, ...derived(answer.made.lesson) };
  ask = make;
  find("make").hidden = !answer.made.lesson;
  for (const [tab, panel] of Object.entries(PANELS)) find(panel).textContent = made[tab] ?? "";
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
  if (made === now) find(PANELS[name]).textContent = now[name];
};

/** @param {HTMLElement} tab */
const nameOf = (tab) => tab.dataset.tab ?? "";

/** @param {string} name */
const remember = (name) => { try { localStorage.setItem(CHOSEN, name); } catch { /* storage may be forbidden */ } };
const remembered = () => { try { return localStorage.getItem(CHOSEN); } catch { return null; } };

for (const tab of tabs) {
  tab.onclick = () => {
    remember(nameOf(tab));
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
find("copy").onclick = () => copy(find(PANELS[chosen]).textContent ?? "", "copy");
const before = remembered();
choose(before !== null && before in PANELS ? before : "lesson");
