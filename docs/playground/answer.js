// Shows an answer of Python: errors, findings, bytes, the tree, notations, dialogues.

import { showDialogues } from "./dialogues.js";
import { showMade } from "./made.js";
import { NOTHING } from "./places.js";
import { source } from "./reading.js";
import { offerRemedies } from "./remedies.js";
import { change, state } from "./state.js";
import { view } from "./view.js";

/** @typedef {import("./elements.js").Piece} Piece */
/** @typedef {[pieces: Piece[], frame: number, offset: number, length: number]} Row  a line, and the bytes that it is about; frame -1 for none */
/**
 * @typedef {object} Block  a finding, or the verdict on a frame
 * @property {Piece[][]} lines
 * @property {string} severity
 * @property {string[]} codes
 * @property {number} frame  -1 for none
 * @property {number} line  of the input, 0 for none
 * @property {number} offset
 * @property {number} length
 */
/** @typedef {{kind: "" | "takes" | "but" | "refuses", text: string}} Verdict */
/** @typedef {{summary: string, verdict: Verdict, blocks: Block[], accepted: number, places: string[]}} Findings */
/** @typedef {{count: number, rows: string[][]}} Dialogues */
/**
 * @typedef {object} Answer  see Reading.answer in bridge/reading.py
 * @property {string} error
 * @property {number} count
 * @property {boolean} isProgram
 * @property {Row[]} lines
 * @property {Record<number, string>} frames
 * @property {Findings} findings
 * @property {boolean} isFixable
 * @property {Record<string, string>} made
 * @property {Dialogues} dialogues
 */

/** Shows an answer. @param {Answer} answer */
export const show = (answer) => {
  change({ error: answer.error, canFix: answer.isFixable, canFilter: state().canFilter || answer.count > 1, isStale: false });
  view(answer, (code) => source().ask("explain", code), (frame) => source().ask("about", frame));
  showMade(answer, (form) => source().ask("made", form));
  showDialogues(answer.dialogues);
  offerRemedies();
};

/** Takes away what belongs to an older input. */
export const clear = () => show(NOTHING);
