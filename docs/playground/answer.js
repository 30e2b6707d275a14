// Shows an answer of Python: errors, findings, bytes, the tree, notations, dialogues.

import { showDialogues } from "./dialogues.js";
import { showMade } from "./made.js";
import { NOTHING } from "./places.js";
import { home } from "./reading.js";
import { clearRemedies, offerRemedies } from "./headline.js";
import { change, state } from "./state.js";
import { view } from "./view.js";

/** @typedef {import("./elements.js").Piece} Piece */
/** @typedef {[pieces: Piece[], frame: number, offset: number, length: number]} Row  a line, and the bytes that it is about; frame -1 for none */
/**
 * @typedef {object} Block  a finding
 * @property {Piece[][]} lines
 * @property {string} severity
 * @property {string[]} codes
 * @property {number} frame  -1 for none
 * @property {number} line  of the input, 0 for none
 * @property {number} offset
 * @property {number} length
 */
/**
 * @typedef {object} Page  some frames of an input, see Pages.page in bridge/pages.py
 * @property {Row[]} lines
 * @property {Record<number, string>} frames
 * @property {string[][]} rows  dialogues
 * @property {{first: number, next: number, begin: number, end: number}} page
 */
/**
 * @typedef {object} Whole  see Input.answer in bridge/reading.py
 * @property {import("./headline.js").Headline} headline
 * @property {string} error
 * @property {number} count
 * @property {boolean} isProgram
 * @property {Block[]} findings
 * @property {Record<number, string>} found
 * @property {Record<string, string>} made
 * @property {number} dialogues
 */
/** @typedef {Whole & Page & {about?: import("./view.js").About}} Answer  with the first page, and what is known of its frame without Python */

/** Shows an answer, or what there is of it so far. @type {import("./reading.js").Show} */
export const show = (answer, isMore, isWhole) => {
  change({ error: answer.error, isProgram: answer.isProgram, canFilter: state().canFilter || answer.count > 1, isStale: false });
  view(answer, isMore);
  showMade(answer, (form) => home().ask("made", form));
  showDialogues(answer.dialogues, isWhole);
  if (isWhole && answer.headline.sentence) offerRemedies(); else clearRemedies();
};

/** Takes away what belongs to an older input. */
export const clear = () => show(NOTHING, false, true);
