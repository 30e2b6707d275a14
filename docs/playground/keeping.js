// The input outlives a reload: the browser keeps it for this tab, until the tab is closed or the input is to be forgotten.

import { deflated, inflated } from "./address.js";
import { change } from "./state.js";

/** What is kept is one string: the name of a file, a line feed, and its bytes, deflated; or no name, and the text. */
const KEY = "input";
const KEPT = "This browser keeps the input for this tab: a reload does not lose it.";

/** Counts what was to be kept: packing a file takes a while. */
let turn = 0;

/** Keeps the input in place of what was kept; nothing, if it is empty. @param {string | File} input */
export const keep = async (input) => {
  const mine = ++turn, isText = typeof input === "string", size = isText ? input.length : input.size;
  try {
    sessionStorage.removeItem(KEY);
    const packed = isText ? `\n${input}` : `${input.name.replaceAll("\n", " ")}\n${await deflated(input)}`;
    if (mine !== turn) return;
    if (size) sessionStorage.setItem(KEY, packed);
    change({ kept: size ? KEPT : "" });
  } catch {
    if (mine === turn) change({ kept: `The input is too large to be kept (${(size / 1e6).toFixed(1)} MB): a reload loses it.` });
  }
};

/** Returns what was kept, a text or a file, if the page is loaded again; null for nothing. @returns {Promise<string | File | null>} */
export const kept = async () => {
  try {
    const [{ type }] = /** @type {PerformanceNavigationTiming[]} */ (performance.getEntriesByType("navigation"));
    // Who opens the page anew begins with an empty one.
    if (type === "navigate") sessionStorage.removeItem(KEY);
    const [, name, content] = sessionStorage.getItem(KEY)?.match(/^(.*?)\n(.*)$/s) ?? [];
    return name && content ? new File([await inflated(content, Infinity)], name) : content ?? null;
  } catch {
    return null;
  }
};
