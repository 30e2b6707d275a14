// The input: what is typed, pasted, dropped, opened, chosen or linked to, and the address that says what it is.

import { fragmentOf, linkTo, textOf } from "./address.js";
import { edit, replace } from "./editor.js";
import { copy, find, make } from "./elements.js";
import { EXAMPLES } from "./examples.js";
import { keep, kept } from "./keeping.js";
import { current, home, look } from "./reading.js";
import { firstAnswer } from "./first.js";
import { change, state } from "./state.js";
import { onLine, view } from "./view.js";

const MOST_FILE = 32e6;
/** Characters of a text that can be edited: browsers need 6 kB for each line of it. A longer one is read as a file. */
const MOST_EDITED = 500_000;
/** Milliseconds after which the first frame is painted, if ever. */
const PAINTED = 100;

const input = find("input", HTMLTextAreaElement), filter = find("filter", HTMLInputElement), file = find("file", HTMLInputElement), lesson = find("lesson", HTMLSelectElement);

// What is typed

/** A link to this page, here or elsewhere. */
const OWN_LINK = /^\s*https?:\S+\/(?:index\.html)?(#(?:text|z)=\S+)\s*$/;

const changed = () => {
  const text = input.value;
  if (text.length > MOST_EDITED) {
    input.value = "";
    open(new File([text], "text.log"), `The text is too long to be edited here (${(text.length / 1e6).toFixed(1)} MB): it is read as a file.`);
    return;
  }
  const link = text.match(OWN_LINK);
  if (link) {
    location.hash = link[1];
    return;
  }
  file.value = "";
  input.placeholder = "";
  change({ file: "", note: "", filter: "", canFilter: false });
  filter.value = "";
  find("start").hidden = text !== "";
  setAddress(text);
  keep(text);
  look(text.length, true, "look", text, "");
  preview(text);
};
input.addEventListener("input", changed);

/** @param {string} text */
const setAddress = async (text) => {
  const fragment = fragmentOf(text), isThere = typeof fragment === "string";
  put(isThere ? fragment : "");
  const found = await fragment;
  if (!isThere && found && input.value === text && !state().file) put(found);
};
/** @param {string} fragment */
const put = (fragment) => {
  try { history.replaceState(null, "", fragment || location.pathname + location.search); } catch { /* too often for Safari */ }
};

// Files

/** @param {File | undefined} opened @param {string} [note]  what is said about it */
const open = async (opened, note = "") => {
  if (!opened) return;
  if (!opened.size) {
    refuse(`${opened.name} is empty.`);
    return;
  }
  if (opened.size > MOST_FILE) {
    refuse(`${opened.name} has ${(opened.size / 1e6).toFixed(1)} MB, and this page reads at most ${MOST_FILE / 1e6} MB: use ev3proto on the command line.`);
    return;
  }
  if (opened.size <= MOST_EDITED) {
    const text = await opened.text();
    if (!/[\0-\x08\ufffd]/.test(text)) {
      replace(text.replaceAll("\r\n", "\n"));
      return;
    }
  }
  if (input.value) replace("");
  latest = opened;
  file.value = "";
  change({ file: opened.name, note, filter: "", canFilter: false });
  filter.value = "";
  input.placeholder = opened.name;
  find("start").hidden = true;
  put("");
  await readFile("");
};

/** Empties the input, so that nothing is shown of it, and says why. @param {string} why */
const refuse = async (why) => {
  if (input.value) replace(""); else changed();
  await current();
  if (!input.value && !state().file) change({ error: why });
};
find("forget").onclick = () => { if (input.value) replace(""); else changed(); };

/** The file that is read in place of the input. @type {File | null} */
let latest = null;

/** Reads the file. @param {string} expression  the filter */
const readFile = async (expression) => {
  const opened = latest;
  if (!opened) return;
  try {
    const bytes = new Uint8Array(await opened.arrayBuffer());
    if (opened !== latest || !state().file) return;
    if (!expression) keep(opened);
    look(bytes.length, false, "open_file", opened.name, bytes, expression);
  } catch (error) {
    refuse(`${opened.name} cannot be read: ${error instanceof Error ? error.message : error}`);
  }
};
file.onchange = () => open(file.files?.[0]);

// What is dropped or pasted anywhere

document.ondragover = (event) => { event.preventDefault(); document.body.classList.add("dropping"); };
document.ondragleave = (event) => { if (!event.relatedTarget) document.body.classList.remove("dropping"); };
document.ondrop = (event) => {
  document.body.classList.remove("dropping");
  const dropped = event.dataTransfer;
  const isText = !dropped?.files.length && dropped?.types.includes("text/plain");
  // A text that is dropped into the input goes where it is dropped.
  if (isText && event.target === input) return;
  event.preventDefault();
  if (isText) replace(dropped?.getData("text/plain") ?? "");
  else open(dropped?.files[0]);
};
document.addEventListener("paste", (event) => {
  const text = event.clipboardData?.getData("text/plain") ?? "";
  // The browser itself would take seconds for a long one.
  const isField = event.target instanceof Element && event.target.closest("input, textarea, select, dialog") && !(event.target === input && text.length > MOST_EDITED);
  if (isField || !text) return;
  event.preventDefault();
  replace(text);
});

// The filter: the same is read again, and only some frames are shown

filter.onchange = () => {
  change({ filter: filter.value, note: "" });
  if (state().file) readFile(filter.value);
  else look(input.value.length, false, "look", input.value, filter.value);
};

// Examples

find("start").querySelector(".row")?.append(...EXAMPLES.map(([title, text]) => {
  const button = make("button", title);
  button.onclick = () => edit(text);
  return button;
}));
fetch(new URL("./lesson.json", import.meta.url)).then((found) => found.json(), () => []).then((/** @type {{title: string, frame: string}[]} */ found) => {
  for (const { title, frame } of found) {
    const option = make("option", title);
    option.value = frame;
    lesson.append(option);
  }
});
lesson.onchange = async () => {
  const frame = lesson.value;
  lesson.value = "";
  if (frame) replace((await home().ask("as_assembly", frame)).trim());
};

// The lines of findings

onLine((line) => {
  if (state().file) return;
  const lines = input.value.split("\n");
  const begin = lines.slice(0, line - 1).reduce((sum, each) => sum + each.length + 1, 0);
  const top = (input.scrollHeight / lines.length) * (line - 1);
  if (!matchMedia("(pointer: coarse)").matches) input.focus({ preventScroll: true });
  input.setSelectionRange(begin, begin + lines[line - 1].length);
  if (top < input.scrollTop || top > input.scrollTop + input.clientHeight - 20) input.scrollTop = top - input.clientHeight / 2;
});

// Links

find("link").onclick = async () => {
  if (state().file) change({ note: "A file is not part of a link. Upload it where you ask, and name it there." });
  else if (!input.value) change({ note: "There is nothing to link to yet." });
  else {
    const link = await linkTo(input.value);
    if (link) copy(link, "link");
    else change({ note: `The text is too long for a link: ${input.value.length.toLocaleString("en")} characters. Attach it as a file where you ask.` });
  }
};

/** Opens what the address has. Returns whether it has something. */
const openLink = async (isFirst = false) => {
  try {
    const text = await textOf(location.hash);
    if (text === null) return false;
    if (isFirst || text !== input.value) {
      input.value = text;
      change({ file: "" });
      find("start").hidden = text !== "";
      keep(text);
      look(text.length, false, "look", text, "");
      if (!isFirst) preview(text);
    }
  } catch (error) {
    const said = error instanceof Error ? error.message : String(error), address = location.href;
    change({ error: said });
    // An answer that was on its way would take its place.
    current().then(() => { if (location.href === address) change({ error: said }); });
  }
  return true;
};
window.onhashchange = () => openLink();

// Who comes to paste something need not click first; on a phone this would show the keyboard.
if (document.activeElement === document.body && !matchMedia("(pointer: coarse)").matches) input.focus({ preventScroll: true });

/** Shows a frame until Python has read it. @param {string} text */
const preview = (text) => {
  const answer = state().isReady ? null : firstAnswer(text);
  document.body.classList.toggle("early", answer !== null && answer.lines.length > 0);
  document.body.classList.toggle("brief", answer?.lines.length === 0);
  if (!answer) return;
  view(answer, false);
  change({ isStale: false });
};

/** Shows the frame of the link, of what was kept, or an example at once. Returns when it can be seen. */
export const showFirst = async () => {
  const text = await textOf(location.hash).catch(() => "") ?? await kept();
  if (text === null) {
    const [[, example]] = EXAMPLES;
    input.value = example;
    preview(example);
    // What is typed or pasted takes its place.
    input.select();
    input.addEventListener("focus", () => { if (input.value === example) input.select(); }, { once: true });
  }
  if (text instanceof File) {
    latest = text;
    input.placeholder = text.name;
    find("start").hidden = true;
  }
  if (typeof text === "string") {
    keep(text);
    input.value = text;
    find("start").hidden = text !== "";
    preview(text);
  }
  // A page in the background is not painted, but Python starts all the same.
  await new Promise((resolve) => { requestAnimationFrame(() => setTimeout(resolve)); setTimeout(resolve, PAINTED); });
};

/** Reads what is there when Python is ready: the link, what was typed meanwhile, or what was kept. */
export const readFirst = async () => {
  if (await openLink(true)) return;
  if (latest && !input.value) await open(latest);
  else look(input.value.length, false, "look", input.value, "");
};
