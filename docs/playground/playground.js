// The page: its modules, and what they tell each other. Every text is set as text, never as markup.

import { clear, show } from "./answer.js";
import { showBrick } from "./brick.js";
import { offerCompletions } from "./editor.js";
import { find, inside } from "./elements.js";
import "./explaining.js";
import { setText } from "./headline.js";
import { readFirst, showFirst } from "./input.js";
import { begin, cancel, counted, home } from "./reading.js";
import { realBrick } from "./real_brick.js";
import { sending } from "./sending.js";
import { buttonTexts, change, follow } from "./state.js";

/** Characters of a sentence, in place of a word or two about what is loaded. */
const LONG = 60;

follow((known) => {
  for (const id of /** @type {const} */ (["status", "note", "about", "byte"])) setText(id, known[id]);
  for (const [id, text] of buttonTexts(known)) setText(id, text);
  find("send", HTMLButtonElement).disabled = !known.isReady;
  find("download").hidden = !known.isProgram || known.file !== "";
  document.body.classList.toggle("stale", known.isStale);
  find("status").classList.toggle("long", known.status.length > LONG);
  find("filter").hidden = !known.canFilter;
  find("kept").hidden = !known.kept;
  inside(find("kept"), "small", HTMLElement).textContent = known.kept;
  find("progress").hidden = known.progress === null;
  if (!known.progress) return;
  inside(find("progress"), "progress", HTMLProgressElement).value = known.progress.part;
  inside(find("progress"), "span", HTMLElement).textContent = known.progress.count ? counted(known.progress.count) : "Reading …";
});

const brick = showBrick(find("brick"), find("more"), async (action) => {
  const said = await home().ask("act", JSON.stringify(action));
  if (said) brick.take(said);
});
const real = realBrick(home);

find("cancel").addEventListener("click", cancel);
sending(real);
offerCompletions((before) => home().ask("complete", before));

// What has the focus may be hidden, as a button that has done its work: the focus stays near it

/** @type {Element | null} */
let focused = null;
document.addEventListener("focusin", ({ target }) => { focused = target instanceof Element ? target : null; });
/** @param {Element} element */
const isShown = (element) => element.getClientRects().length > 0;
follow(() => {
  if (!focused || (isShown(focused) && focused.isConnected) || ![document.body, focused].includes(document.activeElement ?? document.body)) return;
  const near = [...document.querySelectorAll(`#${focused.closest("section[id]")?.id ?? "write"} :is(button, textarea)`)];
  const next = near.find((each) => isShown(each) && !each.matches(":disabled")) ?? find("input");
  if (next instanceof HTMLElement) next.focus({ preventScroll: true });
});

/** Takes what Python says by itself. @param {import("./python.js").Said} said */
const hear = (said) => {
  if (said.status) change({ status: said.status });
  else if (said.failed) change({ status: `Python cannot be loaded: ${said.failed}. ${document.body.dataset.advice}` });
  else if (said.brick) {
    brick.take(said.brick);
    if (said.brick.talks) real.takeVirtual(said.brick.talks);
  }
  else if (said.real) real.take(said.real);
  else if (said.carry) real.carry(said.carry);
  else if (said.ready) ready(said.ready);
};

/** @param {"snapshot" | "plain"} started */
const ready = async (started) => {
  document.body.dataset.started = started;
  change({ isReady: true, status: "" });
  if (document.body.dataset.ready) return;
  await readFirst();
  document.body.dataset.ready = "true";
  navigator.serviceWorker?.register(new URL("./service-worker.js", import.meta.url)).catch(() => {});
};

document.body.dataset.begun = "true";
// Python is large: what can be shown without it comes first.
await showFirst();
begin({ hear, show, clear, restarted: real.drop });
