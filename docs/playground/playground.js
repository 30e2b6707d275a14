// The page: the input, who reads it, and where it goes. Every text is set as text, never as markup.

import { fragmentOf, linkTo, textOf } from "./address.js";
import { showBrick } from "./brick.js";
import { edit, offerCompletions, replace } from "./editor.js";
import { copy, find, flash, make } from "./elements.js";
import { showMade } from "./made.js";
import { Python } from "./python.js";
import { realBrick } from "./real_brick.js";
import { onLine, view } from "./view.js";

/** Characters or bytes that the Python of the brick reads itself, at once. */
const LITTLE = 4000;
const MOST_FILE = 32 << 20;
const MOST_EDITED = 100_000;
const PAUSE = 400, SOON = 300, LATE = 1000;
const EXAMPLES = [
  ["A frame that plays a tone", "0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|"],
  ["A log with a mistake in it", `# What a program sent and received
09:12:31.011558 Sent 0x|0B:00|2A:00|00|04:00|81:01:60:81:12:64|
09:12:31.014092 Recv 0x|07:00|2A:00|02|66:66:F6:40|
09:12:31.520417 Sent 0x|08:00|2B:00|80|00:00|81:01:60|
`],
  ["A program that blinks", `vmthread MAIN
{
  DATA32 Timer
  DATA8 Round
  MOVE8_8(0, Round)
Again:
  UI_WRITE(LED, LED_ORANGE)
  TIMER_WAIT(500, Timer)
  TIMER_READY(Timer)
  UI_WRITE(LED, LED_GREEN)
  TIMER_WAIT(500, Timer)
  TIMER_READY(Timer)
  ADD8(Round, 1, Round)
  JR_LT8(Round, 20, Again)
}
`],
];

const input = find("input");
const status = (text) => { find("status").textContent = text; };
const note = (text) => { find("note").textContent = text; };

// Python: one that has the bricks, and a second one for what takes long, which starts when it is first needed

let home = null, reader = null;

const hear = (said) => {
  if (said.status) status(said.status);
  else if (said.failed) status(`Python cannot be loaded: ${said.failed}`);
  else if (said.brick) {
    brick.take(said.brick);
    if (said.brick.talks) real.takeVirtual(said.brick.talks);
  }
  else if (said.real) real.take(said.real);
  else if (said.carry) real.carry(said.carry);
  else if (said.ready) begin();
};
const start = () => new Python("brick", hear);

const brick = showBrick(find("brick"), async (action) => {
  const said = await home.ask("act", JSON.stringify(action));
  if (said) brick.take(said);
});
const real = realBrick(() => home);

// Reading: only the newest question counts

let turn = 0, source = null, busy = null, atHome = Promise.resolve(), current = Promise.resolve(), isFile = false;

/** Has Python read something, and shows what it says as it comes. */
const look = (size, isTyped, call, ...given) => {
  const mine = ++turn, isLong = size > LITTLE;
  if (busy && busy === reader) stopReader();
  const reading = (async () => {
    if (isLong && isTyped) await new Promise((resolve) => { setTimeout(resolve, PAUSE); });
    else if (!isLong) await atHome;
    if (mine === turn) await readBy(isLong ? theReader() : home, mine, call, given);
  })();
  if (!isLong) atHome = reading;
  current = reading;
};

const theReader = () => (reader ??= new Python("reader", (said) => { if (said.failed) hear(said); }));

const readBy = async (python, mine, call, given) => {
  const isNow = () => mine === turn;
  const soon = setTimeout(() => { if (isNow()) status("Reading …"); }, SOON);
  const late = setTimeout(() => { if (isNow()) showProgress({ part: 0, count: 0 }); }, LATE);
  const hearPart = ({ answer, ...progress }) => {
    if (!isNow()) return;
    source = python;
    if (answer) show(answer);
    else if (!find("progress").hidden) showProgress(progress);
  };
  busy = python;
  try {
    const answer = await python.follow(hearPart, call, ...given);
    if (isNow()) {
      source = python;
      show(answer);
    }
  } catch (error) {
    find("error").textContent = `ev3proto has a bug, please report it: ${error.message}`;
  }
  clearTimeout(soon);
  clearTimeout(late);
  if (isNow()) endReading();
};

const showProgress = ({ part, count }) => {
  find("progress").hidden = false;
  find("progress").querySelector("progress").value = part;
  find("progress").querySelector("span").textContent = count ? `${count.toLocaleString("en")} frames` : "Reading …";
};
const endReading = () => {
  busy = null;
  status("");
  find("progress").hidden = true;
};
const stopReader = () => {
  reader.end();
  reader = busy = null;
};
find("cancel").addEventListener("click", () => {
  if (!busy) return;
  turn++;
  if (busy === reader) {
    note(`Cancelled after ${find("progress").querySelector("span").textContent}.`);
    stopReader();
  } else {
    note("Cancelled. The virtual brick was switched off and on.");
    real.drop();
    home.end();
    home = start();
  }
  atHome = current = Promise.resolve();
  endReading();
});

const show = (answer) => {
  find("error").textContent = answer.error;
  find("fix").hidden = !answer.isFixable || isFile;
  view(answer, (code) => source.ask("explain", code));
  showMade(answer, (form) => source.ask("made", form));
  showDialogues(answer.dialogues);
};

find("fix").onclick = async () => {
  const before = input.value;
  const fixed = await source.ask("fix");
  if (input.value !== before) return;
  if (fixed === before) note("The way in which this is written cannot be edited; the help says what to change.");
  else replace(fixed);
};

onLine((line) => {
  if (isFile) return;
  const lines = input.value.split("\n");
  const begin = lines.slice(0, line - 1).reduce((sum, each) => sum + each.length + 1, 0);
  const top = (input.scrollHeight / lines.length) * (line - 1);
  if (!matchMedia("(pointer: coarse)").matches) input.focus({ preventScroll: true });
  input.setSelectionRange(begin, begin + lines[line - 1].length);
  if (top < input.scrollTop || top > input.scrollTop + input.clientHeight - 20) input.scrollTop = top - input.clientHeight / 2;
});

// Dialogues

const showDialogues = ({ count, rows }) => {
  find("dialogues").hidden = find("timeline").hidden = !count;
  find("dialogues").querySelector("summary").textContent = `Dialogues (${count.toLocaleString("en")})`;
  const fill = (found) => find("dialogues").querySelector("tbody").replaceChildren(...found.map((cells) => {
    const row = make("tr");
    row.append(...cells.map((each) => make("td", each)));
    return row;
  }));
  fill(rows);
  const fillAll = async () => {
    if (find("dialogues").open && rows.length < count) fill(await source.ask("all_dialogues"));
  };
  find("dialogues").ontoggle = fillAll;
  fillAll();
  showTimeline();
};

// The timeline, drawn on request. Vega interprets its expressions: the page's policy forbids eval.

const showTimeline = async () => {
  const place = find("timeline").querySelector("div");
  place.replaceChildren();
  if (!find("timeline").open || find("timeline").hidden) return;
  await import("./vega/vega.min.js");
  await import("./vega/vega-lite.min.js");
  const { expressionInterpreter } = await import("./vega/vega-interpreter.js");
  const chart = await source.ask("timeline");
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
  for (const each of chart.vconcat) each.width = parameter("room").value;
  const { spec } = globalThis.vegaLite.compile(chart);
  const flow = globalThis.vega.parse(spec, null, { ast: true });
  const drawn = new globalThis.vega.View(flow, { renderer: "canvas", container: place, hover: true, expr: expressionInterpreter });
  await drawn.runAsync();
};
find("timeline").ontoggle = showTimeline;

// The input

const changed = () => {
  const text = input.value;
  isFile = false;
  find("file").value = "";
  input.placeholder = "";
  note("");
  find("start").hidden = text !== "";
  setAddress(text);
  look(text.length, true, "look", text);
};
input.addEventListener("input", changed);

const setAddress = async (text) => {
  const fragment = text.length <= LITTLE ? fragmentOf(text) : null;
  // A short text is in the address at once.
  put(text && text.length <= LITTLE ? `#text=${encodeURIComponent(text)}` : "");
  const found = await (fragment ?? fragmentOf(text));
  if (found && input.value === text && !isFile) put(found);
};
const put = (fragment) => {
  try { history.replaceState(null, "", fragment || location.pathname + location.search); } catch { /* too often for Safari */ }
};

const open = async (file) => {
  if (!file) return;
  if (file.size > MOST_FILE) {
    find("error").textContent = `${file.name} is larger than ${MOST_FILE >> 20} MiB; use ev3proto on the command line.`;
    return;
  }
  const bytes = new Uint8Array(await file.arrayBuffer());
  const text = new TextDecoder().decode(bytes);
  if (bytes.length <= MOST_EDITED && !/[\0-\x08\ufffd]/.test(text)) {
    replace(text.replaceAll("\r\n", "\n"));
    return;
  }
  if (input.value) replace("");
  find("file").value = "";
  isFile = true;
  note("");
  input.placeholder = file.name;
  find("start").hidden = true;
  put("");
  look(bytes.length, false, "open_file", file.name, bytes);
};
find("file").onchange = () => open(find("file").files[0]);
document.ondragover = (event) => { event.preventDefault(); document.body.classList.add("dropping"); };
document.ondragleave = (event) => { if (!event.relatedTarget) document.body.classList.remove("dropping"); };
document.ondrop = (event) => {
  event.preventDefault();
  document.body.classList.remove("dropping");
  open(event.dataTransfer.files[0]);
};

find("link").onclick = async ({ target }) => {
  if (isFile) note("A file is not part of a link. Upload it where you ask, and name it there.");
  else if (!input.value) note("There is nothing to link to yet.");
  else {
    const link = await linkTo(input.value);
    if (link) copy(link, target);
    else note(`The text is too long for a link: ${input.value.length.toLocaleString("en")} characters. Attach it as a file where you ask.`);
  }
};

find("send").onclick = async ({ target }) => {
  await current;
  const given = await source.ask("to_send");
  real.forget();
  const said = real.isConnected ? await real.send(given) : await home.ask("play", JSON.stringify(given));
  find("error").textContent = said;
  if (!said) {
    flash(target, "Sent");
    if (getComputedStyle(find("show-brick")).display !== "none") showBench(true);
  }
};

offerCompletions((before) => home.ask("complete", before));

const examples = EXAMPLES.map(([title, text]) => {
  const button = make("button", title);
  button.onclick = () => edit(text);
  return button;
});
find("start").querySelector(".row").append(...examples);

fetch(new URL("./lesson.json", import.meta.url)).then((found) => found.json()).then((lesson) => {
  for (const { title, frame } of lesson) {
    const option = make("option", title);
    option.value = frame;
    find("lesson").append(option);
  }
});
find("lesson").onchange = async ({ target }) => {
  const frame = target.value;
  target.value = "";
  if (frame) replace((await home.ask("as_assembly", frame)).trim());
};

// The brick on a phone: behind a button

const showBench = (isShown) => {
  document.body.classList.toggle("bench", isShown);
  find("show-brick").setAttribute("aria-expanded", isShown);
  find("show-brick").textContent = isShown ? "Back to the input" : "Show the brick";
};
find("show-brick").onclick = () => showBench(!document.body.classList.contains("bench"));

// The start

/** Opens what the address has. Returns whether it has something. */
const openLink = async () => {
  try {
    const text = await textOf(location.hash);
    if (text === null) return false;
    if (text !== input.value) {
      input.value = text;
      isFile = false;
      find("start").hidden = text !== "";
      look(text.length, false, "look", text);
    }
  } catch (error) {
    find("error").textContent = error.message;
  }
  return true;
};
const begin = async () => {
  status("");
  source = home;
  find("send").disabled = false;
  if (document.body.dataset.ready) return;
  find("start").hidden = input.value !== "";
  if (!await openLink()) look(input.value.length, false, "look", input.value);
  document.body.dataset.ready = "true";
  navigator.serviceWorker?.register(new URL("./service-worker.js", import.meta.url)).catch(() => {});
};
window.onhashchange = openLink;
home = start();
