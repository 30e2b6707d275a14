// A real brick: connecting it, its answers, what is asked for every second, the recording, and the comparison.

import { brickFiles } from "./brick_files.js";
import { openBluetooth, openUsb, Refused } from "./carriers.js";
import { filled, find, inside, make, remember, remembered, saveAs } from "./elements.js";
import { bytesOf } from "./rows.js";
import { change, follow, state } from "./state.js";

/** What connects, by the button: what it needs of the browser. */
const CONNECT = Object.entries({
  "connect-usb": { carrier: navigator.hid, lack: "This browser has no WebHID, which USB needs." },
  "connect-bluetooth": { carrier: navigator.serial, lack: "This browser has no Web Serial, which Bluetooth needs." },
});
const LACKS = CONNECT.filter(([, { carrier }]) => !carrier).map(([, { lack }]) => ` ${lack}`);
const NONE = `Not connected to a real brick: what you send goes to the virtual one.${LACKS.join("")}`;
const MOST_TALKS = 20;
const ELSEWHERE = "This browser cannot reach a real brick: it has neither WebHID nor Web Serial, which Chrome, Edge and Opera on a computer or a"
  + " Chromebook have on pages with https or from localhost.";
const SNAP = " If no brick is listed on Linux: Chromium as a snap cannot reach USB.";
const CAPTURE = "./conformance.pcapng";
const LEAVING = 1000;
const SILENT = "The brick does not answer. Is it asleep, switched off, or in use by another program? On Bluetooth: is this the port of a brick?";
/** Where it is kept that nothing is to be asked every second. */
const QUIET = "quiet";

// Another page may have the right to reach bricks given to it, and could lead clicks to this one.
const IS_FRAMED = window.top !== window.self;
const FRAMED = "This page is in a frame of another page, so it does not connect to a real brick. Open it in a tab of its own.";

/** @typedef {import("./carriers.js").Wire} Wire */
/** @typedef {import("./elements.js").Piece} Piece */
/** @typedef {{isSent: boolean, error: string}} Outcome  of sending; neither sent nor wrong is cancelled */
/** @typedef {{result: string, differences: {command: string, answer: string, difference: string}[]}} Comparison */
/** @typedef {{name?: string, firmware?: string, battery?: string, ports?: string[][], silence?: string}} Facts */
/**
 * @typedef {object} News  from the session
 * @property {Piece[][][]} [answers]
 * @property {boolean} [isWaiting]
 * @property {Facts} [facts]
 * @property {{done: number, count: number}} [comparing]
 * @property {Comparison} [comparison]
 * @property {boolean} [hasLeft]  nothing is open on the brick any more
 * @property {import("./brick_files.js").FileNews} [files]
 */
/**
 * @typedef {object} Real
 * @property {(news: News) => void} take
 * @property {(found: {number: number, text: string}[]) => void} takeVirtual
 * @property {(hex: string) => void} carry
 * @property {(given: unknown) => Promise<Outcome>} send
 * @property {() => void} forget
 * @property {() => void} drop
 */

/** Returns why this page cannot reach a real brick; empty if it may. */
const whyNone = () => {
  if (IS_FRAMED) return FRAMED;
  return navigator.hid || navigator.serial ? "" : ELSEWHERE;
};

/** Returns why a connection was not made. @param {unknown} error @param {boolean} isUsb */
const refusal = (error, isUsb) => {
  if (error instanceof Refused) return `${error.message}.${isUsb ? SNAP : ""}`.replace("?.", "?");
  return `Not connected: ${error instanceof Error ? error.message : error}`;
};

/**
 * Controls what belongs to a real brick.
 *
 * @param {() => import("./python.js").Python} python  the Python that has the session
 * @returns {Real}
 */
export const realBrick = (python) => {
  /** @type {Wire | null} */
  let wire = null;
  /** @type {Comparison | null} */
  let result = null;
  let isNew = false;
  let connected = "";
  const watch = find("watch", HTMLInputElement), virtual = find("virtual", HTMLDetailsElement);
  watch.checked = remembered(QUIET) === null;
  /** @param {string} text */
  const status = (text) => { find("brick-status").textContent = text; };

  follow(({ connection, isConnecting }) => {
    document.body.dataset.connection = connection;
    for (const [id, { carrier }] of CONNECT) {
      find(id).hidden = connection !== "none" || !carrier;
      find(id, HTMLButtonElement).disabled = isConnecting;
    }
    for (const id of ["disconnect", "talk"]) find(id).hidden = connection === "none";
  });
  const showState = () => {
    find("facts").hidden = true;
    find("facts").replaceChildren();
    // A real brick has the place of the virtual one.
    virtual.open = wire === null;
    find("brick-files", HTMLDetailsElement).open = false;
    change({ connection: wire?.kind ?? "none", isComparing: false });
  };

  /** @type {import("./carriers.js").To} */
  const to = {
    heard: (bytes, at) => { python().ask("real", "heard", bytes, at); },
    gone: (reason) => {
      wire = null;
      showState();
      status(`The connection ended: ${reason}.`);
      python().ask("real", "gone", reason);
    },
  };

  /** @param {typeof openUsb} open */
  const connect = async (open) => {
    const obstacle = whyNone();
    if (obstacle) {
      status(obstacle);
      return;
    }
    change({ isConnecting: true });
    status("Connecting …");
    try {
      wire = await open(isNew, to);
      isNew = false;
      for (const id of ["comparison", "results", "differences"]) find(id).hidden = true;
      talks.clear();
      showAnswer([]);
      await python().ask("connect", wire.kind);
      showState();
      find("recorded").hidden = false;
      connected = `Connected by ${wire.kind === "usb" ? "USB" : "Bluetooth"} to ${wire.label}. What you send goes to it.`;
      status(connected);
      if (watch.checked) await python().ask("real", "watch", true);
    } catch (error) {
      wire = null;
      showState();
      status(refusal(error, open === openUsb));
    } finally {
      change({ isConnecting: false });
    }
  };
  find("connect-usb").onclick = () => connect(openUsb);
  find("connect-bluetooth").onclick = () => connect(openBluetooth);
  /** @type {() => void} */
  let left = () => {};
  /** @param {boolean} leaves  whether what was opened on the brick is closed first */
  const disconnect = async (leaves) => {
    if (leaves && await python().ask("real", "leave")) {
      await new Promise((resolve) => {
        left = () => resolve(null);
        setTimeout(left, LEAVING);
      });
    }
    const closing = wire;
    wire = null;
    // Who disconnects may want another one.
    isNew = true;
    showState();
    status(NONE);
    python().ask("real", "gone", "you disconnected");
    await closing?.close();
  };
  find("disconnect").onclick = () => disconnect(true);

  find("stop-motors").onclick = () => python().ask("stop_motors");
  virtual.ontoggle = () => { find("more").hidden = !virtual.open; };

  // Answers

  /** @type {Map<number, string>} */
  const talks = new Map();
  /** @param {HTMLElement[]} lines */
  const showAnswer = (lines) => {
    const box = find("answer");
    box.hidden = !lines.length;
    box.replaceChildren(...lines);
    box.scrollTop = box.scrollHeight;
  };

  /** Shows what the virtual brick was told and answered since the last `forget`. @type {Real["takeVirtual"]} */
  const takeVirtual = (found) => {
    for (const { number, text } of found) talks.set(number, text);
    if (wire === null) showAnswer([...talks.values()].slice(-MOST_TALKS).map((text) => make("span", `${text}\n`)));
  };

  /** @type {Real["take"]} */
  const take = ({ answers, isWaiting, facts, comparing, comparison, hasLeft, files: moved }) => {
    if (moved) files.take(moved);
    if (answers) {
      const lines = answers.flatMap((answer) => answer.map((pieces) => {
        const line = filled(make("span"), pieces);
        line.append("\n");
        return line;
      }));
      showAnswer([...lines, ...(isWaiting ? [make("span", "waiting for the answer …\n", "aside")] : [])]);
    }
    if (facts) showFacts(facts);
    if (comparing) {
      find("comparison").hidden = false;
      find("comparison").textContent = `Comparing: ${comparing.done} of ${comparing.count} …`;
    }
    if (comparison) showComparison(comparison);
    if (hasLeft) left();
  };

  /** @param {Facts} facts */
  const showFacts = ({ name, firmware, battery, ports = [], silence }) => {
    if (!wire) return;
    const said = silence ? SILENT : connected;
    if (find("brick-status").textContent !== said) status(said);
    if (!watch.checked) return;
    /** @type {(string | undefined)[][]} */
    const rows = [["Name", name], ["Firmware", firmware], ["Battery", battery]];
    rows.push(...ports.map(([port, type, value]) => [`Port ${port}`, `${type}: ${value}`]));
    find("facts").hidden = false;
    find("facts").replaceChildren(...rows.filter(([, value]) => value).flatMap(([key, value]) => [make("dt", key), make("dd", value)]));
  };
  watch.onchange = () => {
    find("facts").hidden = !watch.checked;
    remember(QUIET, watch.checked ? null : "yes");
    if (wire) python().ask("real", "watch", watch.checked);
  };

  // The recording

  find("record").onclick = async () => {
    const text = await python().ask("real", "record");
    const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
    saveAs("ev3.pcapng", new Blob([bytes], { type: "application/x-pcapng" }));
  };

  // The comparison

  find("compare").onclick = async () => {
    if (state().isComparing) {
      await python().ask("real", "end_comparison");
      return;
    }
    change({ isComparing: true });
    find("results").hidden = find("differences").hidden = true;
    find("comparison").hidden = false;
    find("comparison").textContent = "Comparing …";
    const found = await fetch(new URL(CAPTURE, import.meta.url));
    await python().ask("real", "compare", new Uint8Array(await found.arrayBuffer()), find("computes", HTMLInputElement).checked);
  };
  /** @param {Comparison} found */
  const showComparison = (found) => {
    change({ isComparing: false });
    result = found;
    find("comparison").hidden = find("results").hidden = false;
    find("comparison").textContent = `${found.result}.`;
    find("differences").hidden = !found.differences.length;
    find("differences").replaceChildren(...found.differences.map(({ command, answer, difference }) => {
      const item = make("li");
      item.append(make("code", command), make("div", answer), make("div", difference, "aside"));
      return item;
    }));
  };
  find("save-comparison").onclick = () => {
    saveAs("ev3proto-comparison.json", new Blob([JSON.stringify(result, null, 1)], { type: "application/json" }));
  };

  // Sending

  const dialog = find("ask", HTMLDialogElement), cancel = find("cancel", HTMLButtonElement), cancelPlace = cancel.parentElement;
  dialog.onclose = () => cancelPlace?.append(cancel);

  /**
   * Asks whether to send what is not on the list of reading operations.
   *
   * @param {string[]} reasons
   * @returns {Promise<boolean>}
   */
  const isAllowed = (reasons) => new Promise((resolve) => {
    inside(dialog, "ul", HTMLUListElement).replaceChildren(...reasons.map((reason) => make("li", reason)));
    dialog.returnValue = "";
    // The one button that cancels is where it can be reached, and what Enter chooses.
    find("allow").after(cancel);
    cancel.autofocus = true;
    dialog.addEventListener("close", () => resolve(dialog.returnValue === "allow"), { once: true });
    dialog.showModal();
  });

  const files = brickFiles(python, isAllowed);

  /** @type {Real["send"]} */
  const send = async (given) => {
    let said = await python().ask("real", "talk", JSON.stringify(given), false);
    if (said.ask) {
      if (!await isAllowed(said.ask)) return { isSent: false, error: "" };
      said = await python().ask("real", "talk", JSON.stringify(given), true);
    }
    return { isSent: !said.error, error: said.error ?? "" };
  };

  /** @type {Real["carry"]} */
  const carry = (hex) => {
    if (!wire || IS_FRAMED) return;
    python().ask("real", "sent", performance.now());
    wire.send(Uint8Array.from(bytesOf(hex)));
  };

  showState();
  status(whyNone() || NONE);
  return {
    take, takeVirtual, carry, send,
    forget: () => talks.clear(),
    /** The session is gone with its Python. */
    drop: () => { if (wire) disconnect(false); },
  };
};
