// The frames in notations of other programs, one tab each. Those of many frames are made when their tab is opened.

import { copy, find } from "./elements.js";

const CHOSEN = "notation";
const PANELS = { lesson: "frame", hex: "hex", c: "c", python: "python", javascript: "javascript" };

const tabs = [...document.querySelectorAll("[data-tab]")];
let made = {}, ask = null, chosen = "lesson";

/**
 * Shows the frames of an answer.
 *
 * @param {object} answer  see Reading.answer
 * @param {(form: string) => Promise<string>} make  makes a notation that is not in the answer
 */
export const showMade = (answer, make) => {
  made = { ...answer.made, ...derived(answer.made.lesson) };
  ask = make;
  find("make").hidden = !answer.made.lesson;
  for (const [tab, panel] of Object.entries(PANELS)) find(panel).textContent = made[tab] ?? "";
  choose(chosen);
};

/** The notations that need no knowledge of the protocol. */
const derived = (lesson) => {
  const frames = lesson.split("\n").filter((each) => each.startsWith("0x|")).map((each) => each.slice(3).match(/[0-9A-F]{2}/g));
  const rest = lesson.split("\n").filter((each) => each && !each.startsWith("0x|"));
  return {
    hex: [...frames.map((bytes) => bytes.join(" ")), ...rest].join("\n"),
    javascript: [...frames.map((bytes, index) => {
      const name = frames.length > 1 ? `frame${index + 1}` : "frame";
      return `const ${name} = new Uint8Array([${bytes.map((each) => `0x${each.toLowerCase()}`).join(", ")}]);`;
    }), ...rest.map((each) => `/* ${each} */`)].join("\n"),
  };
};

const choose = async (name) => {
  chosen = name;
  for (const tab of tabs) {
    const isChosen = tab.dataset.tab === name;
    tab.setAttribute("aria-selected", isChosen);
    tab.tabIndex = isChosen ? 0 : -1;
    find(PANELS[tab.dataset.tab]).hidden = !isChosen;
  }
  find("copy").setAttribute("aria-label", `Copy as ${tabs.find((tab) => tab.dataset.tab === name).textContent}`);
  if (made[name] !== undefined || !made.lesson) return;
  const now = made;
  now[name] = await ask(name);
  if (made === now) find(PANELS[name]).textContent = now[name];
};

const remember = (name) => { try { localStorage.setItem(CHOSEN, name); } catch { /* storage may be forbidden */ } };
const remembered = () => { try { return localStorage.getItem(CHOSEN); } catch { return null; } };

for (const tab of tabs) {
  tab.onclick = () => {
    remember(tab.dataset.tab);
    choose(tab.dataset.tab);
  };
}
find("tabs").onkeydown = (event) => {
  const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
  if (!step) return;
  event.preventDefault();
  const next = tabs[(tabs.findIndex((tab) => tab.dataset.tab === chosen) + step + tabs.length) % tabs.length];
  next.focus();
  next.click();
};
find("copy").onclick = () => copy(find(PANELS[chosen]).textContent, find("copy"));
choose(remembered() in PANELS ? remembered() : "lesson");
