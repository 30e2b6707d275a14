// The worker that runs Python, which reads and lets the time of the bricks pass.

import { isPrepared, start } from "./boot.js";
import { Lack } from "./loads.js";

/** Milliseconds between two steps of the bricks' clock, while something happens on them. */
const PERIOD = 50;

/** @param {unknown} message */
const say = (message) => postMessage(message);

/** @type {Promise<import("./boot.js").Started>} */
let started;

/** @param {boolean} saveData */
const begin = async (saveData) => {
  let isOver = false;
  started = start(new URL(".", import.meta.url), saveData, (progress) => { if (!isOver) say({ progress }); });
  try {
    const python = await started;
    isOver = true;
    say({ ready: python.started });
    beat(python, performance.now());
    await python.packages;
  } catch (error) {
    isOver = true;
    say({ failed: error instanceof Error ? error.message : String(error) });
  }
};

/** @type {ReturnType<typeof setTimeout>} */
let timer;
let before = 0;

/** Lets the time pass, again and again until nothing happens any more. @param {import("./boot.js").Started} python */
const beat = (python, now = performance.now()) => {
  const { bridge } = python, news = bridge.tick((now - before) / 1000);
  before = now;
  if (news) say({ brick: JSON.parse(news) });
  bridge.turn();
  clearTimeout(timer);
  if (!bridge.rests()) timer = setTimeout(() => beat(python), PERIOD);
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
/** @param {MessageEvent<Question & {saveData?: boolean}>} event */
onmessage = async ({ data: { saveData, number, call, given, isFollowed } }) => {
  if (saveData !== undefined) {
    begin(saveData);
    return;
  }
  const python = await started, { bridge, packages } = python;
  const more = call === "connect" ? [carry, hear] : [];
  try {
    if (!isPrepared(call)) await packages;
    beat(python);
    say({ number, answer: isFollowed ? await followed(python, number, call, given) : JSON.parse(bridge[call](...given, ...more)) });
    beat(python);
  } catch (error) {
    const said = error instanceof Error ? error.message : String(error);
    say({ number, error: error instanceof Lack ? said : `ev3proto has a bug, please report it: ${said}` });
  }
};
