// A real brick: connecting it, its answers, what is asked for every second, the recording, and the comparison.

import { openBluetooth, openUsb, Refused } from "./carriers.js";
import { filled, find, make, saveAs } from "./elements.js";

const NONE = "Not connected to a real brick: what you send goes to the virtual one below.";
const MOST_TALKS = 20;
const ELSEWHERE = "This browser reaches no real brick: it has neither WebHID nor Web Serial. Chrome, Edge and Opera on a computer or a"
  + " Chromebook have both, on pages with https or from localhost. Chromium as a snap cannot reach USB: install Chrome, or Chromium as a package.";
const SNAP = " If no brick is listed on Linux: Chromium as a snap cannot reach USB.";
const CAPTURE = "./conformance.pcapng";

/**
 * Controls what belongs to a real brick.
 *
 * @param {() => import("./python.js").Python} python  the Python that has the session
 */
export const realBrick = (python) => {
  let wire = null, isNew = false, result = null;
  const status = (text) => { find("brick-status").textContent = text; };

  const showState = () => {
    document.body.dataset.connection = wire?.kind ?? "none";
    find("connect-usb").hidden = find("connect-bluetooth").hidden = wire !== null;
    find("disconnect").hidden = find("talk").hidden = wire === null;
    find("facts").hidden = true;
    find("facts").replaceChildren();
    find("watch").checked = false;
    find("compare").textContent = "Compare with the virtual brick";
    find("send").textContent = wire ? "Send to the real brick" : "Send to the brick";
  };

  const to = {
    heard: (bytes, at) => { python().ask("heard", bytes, at); },
    gone: (reason) => {
      wire = null;
      showState();
      status(`The connection ended: ${reason}.`);
      python().ask("gone", reason);
    },
  };

  const connect = async (open) => {
    if (!navigator.hid && !navigator.serial) {
      status(ELSEWHERE);
      return;
    }
    for (const each of [find("connect-usb"), find("connect-bluetooth")]) each.disabled = true;
    status("Connecting …");
    try {
      wire = await open(isNew, to);
      isNew = false;
      for (const id of ["comparison", "results", "differences"]) find(id).hidden = true;
      talks.clear();
      showAnswer([]);
      await python().ask("connect", wire.kind, wire.label);
      showState();
      find("recorded").hidden = false;
      status(`Connected by ${wire.kind === "usb" ? "USB" : "Bluetooth"} to ${wire.label}. What you send goes to it.`);
    } catch (error) {
      wire = null;
      showState();
      status(error instanceof Refused ? `${error.message}.${open === openUsb ? SNAP : ""}`.replace("?.", "?") : `Not connected: ${error.message}`);
    } finally {
      for (const each of [find("connect-usb"), find("connect-bluetooth")]) each.disabled = false;
    }
  };
  find("connect-usb").onclick = () => connect(openUsb);
  find("connect-bluetooth").onclick = () => connect(openBluetooth);
  find("disconnect").onclick = async () => {
    const closing = wire;
    wire = null;
    // Who disconnects may want another one.
    isNew = true;
    showState();
    status(NONE);
    python().ask("gone", "you disconnected");
    await closing?.close();
  };

  // Answers

  const talks = new Map();
  const showAnswer = (lines) => {
    const box = find("answer");
    box.hidden = !lines.length;
    box.replaceChildren(...lines);
    box.scrollTop = box.scrollHeight;
  };

  /** Shows what the virtual brick was told and answered since the last `forget`. */
  const takeVirtual = (found) => {
    for (const { number, text } of found) talks.set(number, text);
    if (wire === null) showAnswer([...talks.values()].slice(-MOST_TALKS).map((text) => make("span", `${text}\n`)));
  };

  const take = ({ answers, isWaiting, facts, comparing, comparison }) => {
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
  };

  const showFacts = ({ name, firmware, battery, ports = [], silence }) => {
    if (!find("watch").checked) return;
    const rows = [["Name", name], ["Firmware", firmware], ["Battery", battery]];
    rows.push(...ports.map(([port, type, value]) => [`Port ${port}`, `${type}: ${value}`]));
    if (silence) rows.push(["", silence]);
    find("facts").hidden = false;
    find("facts").replaceChildren(...rows.filter(([, value]) => value).flatMap(([key, value]) => [make("dt", key), make("dd", value)]));
  };
  find("watch").onchange = ({ target }) => {
    find("facts").hidden = !target.checked;
    python().ask("watch", target.checked);
  };

  // The recording

  find("record").onclick = async () => {
    const text = await python().ask("record");
    const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
    saveAs("ev3.pcapng", new Blob([bytes], { type: "application/x-pcapng" }));
  };

  // The comparison

  let isComparing = false;
  find("compare").onclick = async ({ target }) => {
    if (isComparing) {
      await python().ask("end_comparison");
      return;
    }
    isComparing = true;
    target.textContent = "Stop comparing";
    find("results").hidden = find("differences").hidden = true;
    find("comparison").hidden = false;
    find("comparison").textContent = "Comparing …";
    const found = await fetch(new URL(CAPTURE, import.meta.url));
    await python().ask("compare", new Uint8Array(await found.arrayBuffer()), find("computes").checked);
  };
  const showComparison = (found) => {
    isComparing = false;
    result = found;
    find("compare").textContent = "Compare with the virtual brick";
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

  const dialog = find("ask"), cancel = find("cancel"), cancelPlace = cancel.parentElement;
  dialog.onclose = () => cancelPlace.append(cancel);

  /** Asks whether to send what is not on the list of reading operations. */
  const isAllowed = (reasons) => new Promise((resolve) => {
    dialog.querySelector("ul").replaceChildren(...reasons.map((reason) => make("li", reason)));
    dialog.returnValue = "";
    // The one button that cancels is where it can be reached, and what Enter chooses.
    find("allow").after(cancel);
    cancel.autofocus = true;
    dialog.addEventListener("close", () => resolve(dialog.returnValue === "allow"), { once: true });
    dialog.showModal();
  });

  const send = async (given) => {
    let said = await python().ask("talk", JSON.stringify(given), false);
    if (said.ask && await isAllowed(said.ask)) said = await python().ask("talk", JSON.stringify(given), true);
    return said.error ?? "";
  };

  const carry = (hex) => {
    if (!wire) return;
    python().ask("sent", performance.now());
    wire.send(Uint8Array.from(hex.match(/../g), (each) => parseInt(each, 16)));
  };

  showState();
  status(navigator.hid || navigator.serial ? NONE : ELSEWHERE);
  return {
    take, takeVirtual, carry, send,
    forget: () => talks.clear(),
    get isConnected() { return wire !== null; },
    /** The session is gone with its Python. */
    drop: () => { if (wire) find("disconnect").click(); },
  };
};
