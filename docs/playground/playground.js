// The page: the input, and Python's answers about it. Every text is set as text, never as markup.

import { showBrick } from "./brick.js";

const MOST_LINK = 4000;
const MOST_FILE = 32 << 20;

const find = (id) => document.getElementById(id);
const make = (tag, text = "", className = "") => {
  const element = document.createElement(tag);
  element.textContent = text;
  element.className = className;
  return element;
};
const input = find("input");

// Python, in a worker

const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
const waiting = new Map();
let calls = 0;
const ask = (call, ...given) => new Promise((resolve, reject) => {
  waiting.set(++calls, { resolve, reject });
  worker.postMessage({ number: calls, call, given });
});
worker.onerror = (event) => { fail(event.message || "worker.js cannot be loaded"); };
worker.onmessage = ({ data }) => {
  if (data.status) find("status").textContent = data.status;
  else if (data.brick) brick.take(data.brick);
  else if (data.failed) fail(data.failed);
  else if (data.ready) begin();
  else {
    const { resolve, reject } = waiting.get(data.number);
    waiting.delete(data.number);
    if (data.error === undefined) resolve(data.answer); else reject(new Error(data.error));
  }
};
const fail = (text) => { find("status").textContent = `Python cannot be loaded: ${text}`; };

const brick = showBrick(find("brick"), async (action) => {
  const said = await ask("act", JSON.stringify(action));
  if (said) brick.take(said);
});

// Only the newest question waits while Python works on an older one

let wanted = null, isAtWork = false, shown = { lines: [], frames: [], made: {} };
const look = (call, ...given) => {
  wanted = [call, ...given];
  if (!isAtWork) work();
};
const work = async () => {
  isAtWork = true;
  while (wanted) {
    const question = wanted;
    wanted = null;
    const late = setTimeout(() => { find("status").textContent = "Reading …"; }, 300);
    try {
      show(await ask(...question));
      find("status").textContent = "";
    } catch (error) {
      find("error").textContent = `ev3proto has a bug, please report it: ${error.message}`;
    }
    clearTimeout(late);
  }
  isAtWork = false;
};

const show = (answer) => {
  shown = answer;
  find("error").textContent = answer.error;
  showTree();
  showFindings(answer.findings);
  showMade(answer.made);
  showDialogues(answer.dialogues);
};

// The tree beside the bytes

let line = -1, byte = -1;

const showTree = () => {
  line = byte = -1;
  find("bytes").replaceChildren();
  find("tree").replaceChildren(...shown.lines.map(([text, frame], number) => {
    const element = make("span", `${text}\n`);
    if (frame >= 0) {
      element.role = "option";
      element.id = `line-${number}`;
      element.onclick = () => choose(number);
    }
    return element;
  }));
  const first = shown.lines.findIndex(([, frame]) => frame >= 0);
  if (first >= 0) choose(first);
};

/** Chooses a line, and marks its bytes. */
const choose = (number, at = -1) => {
  const before = shown.lines[line]?.[1];
  mark(find("tree"), line, number);
  line = number;
  const [, frame, offset, length] = shown.lines[line];
  byte = at < 0 ? offset : at;
  if (frame !== before) {
    const bytes = shown.frames[frame].match(/../g) ?? [];
    find("bytes").replaceChildren(...bytes.map((text, index) => {
      const element = make("span", text.toUpperCase());
      element.role = "option";
      element.id = `byte-${index}`;
      element.onclick = () => chooseByte(index);
      return element;
    }));
  }
  [...find("bytes").children].forEach((element, index) => {
    const isIn = index >= offset && index < offset + length;
    element.classList.toggle("chosen", isIn);
    element.setAttribute("aria-selected", isIn);
  });
  find("bytes").setAttribute("aria-activedescendant", `byte-${byte}`);
};

/** Chooses a byte, and the shortest line that is about it. */
const chooseByte = (index) => {
  const frame = shown.lines[line][1];
  let best = -1;
  shown.lines.forEach(([, of, offset, length], number) => {
    if (of !== frame || index < offset || index >= offset + length) return;
    if (best < 0 || length <= shown.lines[best][3]) best = number;
  });
  if (best >= 0) choose(best, index);
  find("tree").children[line]?.scrollIntoView({ block: "nearest" });
};

const mark = (list, before, now) => {
  const elements = list.children;
  for (const [number, isChosen] of [[before, false], [now, true]]) {
    elements[number]?.classList.toggle("chosen", isChosen);
    elements[number]?.setAttribute("aria-selected", isChosen);
  }
  list.setAttribute("aria-activedescendant", elements[now]?.id ?? "");
};

find("tree").onkeydown = (event) => {
  const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  if (!step) return;
  event.preventDefault();
  let next = line + step;
  while (shown.lines[next] && shown.lines[next][1] < 0) next += step;
  if (!shown.lines[next]) return;
  choose(next);
  find("tree").children[next].scrollIntoView({ block: "nearest" });
};
find("bytes").onkeydown = (event) => {
  const next = byte + ({ ArrowRight: 1, ArrowLeft: -1 }[event.key] ?? 0);
  if (next === byte || !find("bytes").children[next]) return;
  event.preventDefault();
  chooseByte(next);
};

// Findings

const showFindings = (findings) => {
  find("fix").hidden = !findings.some(({ code }) => code) || !shown.frames.length;
  find("findings").replaceChildren(...findings.flatMap(({ text, code }) => {
    if (!code) return [make("pre", text)];
    const more = make("details"), body = make("pre");
    more.append(make("summary", `What ${code} means`), body);
    more.ontoggle = async () => { if (!body.textContent) body.textContent = await ask("explain", code); };
    return [make("pre", text), more];
  }));
};
find("fix").onclick = async () => type(await ask("fix"));

// The frame in several notations

const showMade = ({ hex = "", c = "", python = "" }) => {
  const frames = hex.split("\n").filter((each) => each.startsWith("0x|")).map((each) => each.slice(3).match(/[0-9A-F]{2}/g));
  find("frame").textContent = hex.trimEnd();
  find("hex").textContent = frames.map((bytes) => bytes.join(" ")).join("\n");
  find("c").textContent = c.trimEnd();
  find("python").textContent = python.trimEnd();
  find("javascript").textContent = frames.map((bytes, index) => {
    const name = frames.length > 1 ? `frame${index + 1}` : "frame";
    return `const ${name} = new Uint8Array([${bytes.map((each) => `0x${each.toLowerCase()}`).join(", ")}]);`;
  }).join("\n");
};
for (const button of document.querySelectorAll("[data-copy]")) {
  button.setAttribute("aria-label", `Copy as ${button.parentElement.firstChild.textContent.trim()}`);
  button.onclick = () => copy(find(button.dataset.copy).textContent, button);
}
const copy = async (text, button) => {
  const before = button.textContent;
  try {
    await navigator.clipboard.writeText(text);
    button.textContent = "Copied";
  } catch {
    button.textContent = "The browser did not allow it";
  }
  setTimeout(() => { button.textContent = before; }, 1500);
};
find("link").onclick = () => copy(location.href, find("link"));

// Dialogues

const showDialogues = (dialogues) => {
  find("dialogues").hidden = find("timeline").hidden = !dialogues.length;
  showTimeline();
  find("dialogues").querySelector("tbody").replaceChildren(...dialogues.map(({ text, latency }) => {
    const row = make("tr");
    const [, time = "", rest] = text.match(/^(\d+\.\d+)?\s*(.*?)(?:\s+[\d.]+ m?s)?$/);
    const [said, reply = ""] = rest.split(" -> ", 2);
    const waited = latency == null ? "" : `${(latency * 1000).toFixed(3)} ms`;
    row.append(...[time, said, reply, waited].map((each) => make("td", each)));
    return row;
  }));
};

// The timeline, drawn on request. Vega interprets its expressions: the page's policy forbids eval.

const showTimeline = async () => {
  const place = find("timeline").querySelector("div");
  place.replaceChildren();
  if (!find("timeline").open) return;
  await import("./vega/vega.min.js");
  await import("./vega/vega-lite.min.js");
  const { expressionInterpreter } = await import("./vega/vega-interpreter.js");
  const chart = await ask("timeline");
  if (!chart) {
    place.textContent = "Nothing to draw.";
    return;
  }
  // As wide as the page: names get a smaller share of a narrow one.
  const parameter = (name) => chart.params.find((each) => each.name === name);
  const width = place.clientWidth - 40;
  parameter("margin").value = Math.min(parameter("margin").value, Math.max(110, 0.36 * width));
  if (width < 700) parameter("kinds").value = 0;
  parameter("room").value = Math.max(120, width - parameter("margin").value);
  for (const view of chart.vconcat) view.width = parameter("room").value;
  const { spec } = globalThis.vegaLite.compile(chart);
  const flow = globalThis.vega.parse(spec, null, { ast: true });
  const view = new globalThis.vega.View(flow, { renderer: "canvas", container: place, hover: true, expr: expressionInterpreter });
  await view.runAsync();
};
find("timeline").ontoggle = showTimeline;

// The input

const type = (text) => {
  input.value = text;
  find("file").value = "";
  changed();
};
const changed = () => {
  const text = input.value;
  // Longer links do not work in forums.
  history.replaceState(null, "", text && text.length <= MOST_LINK ? `#text=${encodeURIComponent(text)}` : location.pathname);
  look("look", text);
};
input.oninput = () => { find("file").value = ""; changed(); suggest(); };

const open = async (file) => {
  if (!file) return;
  if (file.size > MOST_FILE) {
    find("error").textContent = `${file.name} is larger than ${MOST_FILE >> 20} MiB; use ev3proto on the command line.`;
    return;
  }
  const bytes = new Uint8Array(await file.arrayBuffer());
  const text = new TextDecoder().decode(bytes);
  if (bytes.length <= 100_000 && !/[\0-\x08\ufffd]/.test(text)) {
    type(text);
    return;
  }
  input.value = "";
  input.placeholder = file.name;
  history.replaceState(null, "", location.pathname);
  look("open_file", file.name, bytes);
};
find("file").onchange = () => open(find("file").files[0]);
document.ondragover = (event) => { event.preventDefault(); document.body.classList.add("dropping"); };
document.ondragleave = () => document.body.classList.remove("dropping");
document.ondrop = (event) => {
  event.preventDefault();
  document.body.classList.remove("dropping");
  open(event.dataTransfer.files[0]);
};

find("send").onclick = async () => {
  const said = await ask("send");
  if (said) find("error").textContent = said;
};

// Completion

let words = [], chosen = -1, word = "";
const suggest = async () => {
  const before = input.value.slice(0, input.selectionStart);
  const at = before.lastIndexOf("\n") + 1;
  const answer = await ask("complete", before.slice(at));
  if (input.value.slice(0, input.selectionStart) !== before) return;
  word = answer.word;
  words = answer.words;
  chosen = -1;
  const hint = answer.hint ? [make("li", answer.hint)] : [];
  const items = words.map(([, label], number) => {
    const item = make("li", label);
    item.role = "option";
    item.id = `word-${number}`;
    item.onpointerdown = (event) => { event.preventDefault(); insert(number); };
    return item;
  });
  find("words").replaceChildren(...items, ...hint);
  find("words").hidden = !items.length && !hint.length;
};
const insert = (number) => {
  const [name] = words[number];
  const [head, cmd] = name.split(".");
  const isCall = !/\([^()]*$/.test(input.value.slice(0, input.selectionStart - word.length).split("\n").pop());
  const text = isCall ? (cmd ? `${head}(${cmd}, ` : `${head}(`) : name;
  input.setRangeText(text, input.selectionStart - word.length, input.selectionStart, "end");
  find("words").hidden = true;
  changed();
  suggest();
};
input.onkeydown = (event) => {
  if (find("words").hidden || !words.length) return;
  const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  if (step) {
    const next = Math.max(0, Math.min(words.length - 1, chosen + step));
    mark(find("words"), chosen, next);
    chosen = next;
    input.setAttribute("aria-activedescendant", `word-${next}`);
    find("words").children[next].scrollIntoView({ block: "nearest" });
  } else if ((event.key === "Enter" || event.key === "Tab") && chosen >= 0) insert(chosen);
  else if (event.key === "Escape") find("words").hidden = true;
  else return;
  event.preventDefault();
};
input.onblur = () => { find("words").hidden = true; };

// The lesson

fetch(new URL("./lesson.json", import.meta.url)).then((found) => found.json()).then((lesson) => {
  for (const { title, frame } of lesson) {
    const option = make("option", title);
    option.value = frame;
    find("lesson").append(option);
  }
});
find("lesson").onchange = async () => {
  const frame = find("lesson").value;
  if (frame) type((await ask("as_assembly", frame)).trim());
};

// The start

const given = () => {
  const [, text] = location.hash.match(/^#text=(.*)$/) ?? [];
  if (text === undefined) return null;
  try { return decodeURIComponent(text); } catch { return text; }
};
const begin = () => {
  find("status").textContent = "";
  find("send").disabled = false;
  const text = given();
  if (text !== null) input.value = text;
  look("look", input.value);
  document.body.dataset.ready = "true";
};
window.onhashchange = () => { const text = given(); if (text !== null && text !== input.value) type(text); };
