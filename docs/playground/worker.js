// A worker that runs Python: the one that is named "brick" also lets the time of the bricks pass.

import { isPrepared, start } from "./boot.js";
import { loadPyodide } from "./pyodide/pyodide.mjs";

/** Milliseconds between two steps of the bricks' clock. */
const PERIOD = 50;

/** @param {unknown} message */
const say = (message) => postMessage(message);

/** @param {number} missing */
const tell = (missing) => say({ status: `Loading Python: ${(missing / 1e6).toFixed(1)} MB to come …` });
/** @type {Promise<import("./boot.js").Started>} */
let started;

/** @param {import("./boot.js").Line} line */
const begin = (line) => {
  started = start(loadPyodide, new URL(".", import.meta.url), line, tell);
  started.then(live, (error) => say({ failed: error instanceof Error ? error.message : String(error) }));
};

/** @param {string} frame */
const carry = (frame) => say({ carry: frame });
/** @param {string} news */
const hear = (news) => say({ real: JSON.parse(news) });

/**
 * Does what takes long, step by step; other questions are answered between them. Returns the answer, null if it was given up.
 *
 * A file is written first: the bytes behind its name.
 *
 * @param {import("./boot.js").Started} python
 * @param {number} number
 * @param {string} call
 * @param {unknown[]} given
 */
const followed = async ({ bridge, write }, number, call, given) => {
  const [name, bytes, ...rest] = given;
  if (bytes instanceof Uint8Array) write(JSON.parse(bridge.place(name)), bytes);
  const job = bytes instanceof Uint8Array ? bridge.start(call, name, ...rest) : bridge.start(call, ...given);
  for (;;) {
    const step = JSON.parse(bridge.go_on(Number(job)));
    if (step === null || step.part === undefined) return step?.answer ?? null;
    say({ number, part: step });
    await new Promise((resolve) => { setTimeout(resolve); });
  }
};

/** @typedef {{number: number, call: string, given: unknown[], isFollowed: boolean}} Question */
/** @param {MessageEvent<Question & {line?: import("./boot.js").Line}>} event */
onmessage = async ({ data: { line, number, call, given, isFollowed } }) => {
  if (line) {
    begin(line);
    return;
  }
  const python = await started, { bridge, packages } = python;
  const more = call === "connect" ? [carry, hear] : [];
  try {
    if (!isPrepared(call)) await packages;
    say({ number, answer: isFollowed ? await followed(python, number, call, given) : JSON.parse(bridge[call](...given, ...more)) });
  } catch (error) {
    say({ number, error: error instanceof Error ? error.message : String(error) });
  }
};

/** @param {import("./boot.js").Started} start */
const live = ({ bridge, started: how }) => {
  say({ ready: how });
  if (self.name !== "brick") return;
  let before = performance.now();
  setInterval(() => {
    const now = performance.now();
    const news = bridge.tick((now - before) / 1000);
    before = now;
    if (news) say({ brick: JSON.parse(news) });
    bridge.turn();
  }, PERIOD);
};
