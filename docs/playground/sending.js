// The Send button: what is in the input goes to the real brick, or to the virtual one if none is connected.

import { showEffect } from "./effect.js";
import { find, saveAs } from "./elements.js";
import { current, home } from "./reading.js";
import { bytesOf } from "./rows.js";
import { change, flash, state } from "./state.js";

/**
 * Has the button send.
 *
 * @param {import("./real_brick.js").Real} real
 */
export const sending = (real) => {
  find("send").onclick = async () => {
    await current();
    const given = await home().ask("to_send");
    real.forget();
    const isReal = state().connection !== "none";
    const { isSent, error } = isReal ? await real.send(given) : outcome(await home().ask("play", JSON.stringify(given)));
    const note = isSent ? `Sent to the ${isReal ? "real" : "virtual"} brick${state().isProgram ? ", which runs it" : ""}.` : "";
    change({ error, note });
    if (!isSent) return;
    flash("send", "Sent");
    showEffect();
  };
};

find("download").onclick = async () => {
  await current();
  /** @type {{program: string | null}} */
  const { program } = await home().ask("to_send");
  saveAs("program.rbf", new Blob([Uint8Array.from(bytesOf(program ?? ""))]));
};

/** @param {string} error */
const outcome = (error) => ({ isSent: !error, error });
