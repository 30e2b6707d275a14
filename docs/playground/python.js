// Python in a worker: questions to it, the parts of an answer as they come, and what it says by itself.

/** The script of the worker. */
const SCRIPT = "worker.js";
/** Milliseconds without a byte after which the page says what it waits for. */
const PATIENCE = 15_000;

/**
 * @typedef {object} Said  what Python says by itself; one of these
 * @property {string} [status]
 * @property {string} [failed]
 * @property {"snapshot" | "plain"} [ready]  how it started
 * @property {any} [brick]  news of the virtual brick
 * @property {any} [real]  news of the session with a real brick
 * @property {string} [carry]  a frame for the real brick, in hex
 */

export class Python {
  /** @type {Map<number, {resolve: (answer: any) => void, reject: (error: Error) => void, hear: ((part: any) => void) | null}>} */
  #waiting = new Map();
  #count = 0;
  #worker;
  #hear;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {(said: Said) => void} hear  takes what it says by itself */
  constructor(hear) {
    this.#hear = hear;
    this.#worker = new Worker(new URL(SCRIPT, import.meta.url), { type: "module" });
    this.#worker.postMessage({ saveData: Reflect.get(navigator, "connection")?.saveData === true });
    this.#worker.onerror = ({ message }) => {
      clearTimeout(this.#timer);
      hear({ failed: message || `${SCRIPT} is missing` });
    };
    this.#watch({ missing: 0, file: SCRIPT });
    this.#worker.onmessage = ({ data }) => {
      const asked = this.#waiting.get(data.number);
      if (data.progress) this.#watch(data.progress);
      else if (!asked) {
        clearTimeout(this.#timer);
        hear(data);
      }
      else if (data.part !== undefined) asked.hear?.(data.part);
      else {
        this.#waiting.delete(data.number);
        if (data.error === undefined) asked.resolve(data.answer); else asked.reject(new Error(data.error));
      }
    };
  }

  /** Says how far the start is, and after a while without data, which file is pending. @param {import("./loads.js").Progress} progress */
  #watch({ missing, file }) {
    clearTimeout(this.#timer);
    this.#hear({ status: missing ? `Loading Python: ${(missing / 1e6).toFixed(1)} MB left …` : "Starting Python …" });
    const late = `Still waiting for ${file} after 15 seconds without data. Is the network up, and does it let this file through?`;
    if (file) this.#timer = setTimeout(() => this.#hear({ status: late }), PATIENCE);
  }

  /** Calls a function of bridge. @param {string} call @param {unknown[]} given @returns {Promise<any>} */
  ask(call, ...given) {
    return this.#post(call, given, null);
  }

  /**
   * Has bridge do something that takes long. Arrays of bytes are handed over: they are empty afterwards.
   *
   * @param {(part: any) => void} hear  takes reports of progress
   * @param {string} call
   * @param {unknown[]} given
   * @returns {Promise<any>}
   */
  follow(hear, call, ...given) {
    return this.#post(call, given, hear);
  }

  /** @param {string} call @param {unknown[]} given @param {((part: any) => void) | null} hear */
  #post(call, given, hear) {
    return new Promise((resolve, reject) => {
      const number = ++this.#count;
      this.#waiting.set(number, { resolve, reject, hear });
      const bytes = hear ? given.filter((each) => each instanceof Uint8Array) : [];
      this.#worker.postMessage({ number, call, given, isFollowed: hear !== null }, bytes.map(({ buffer }) => buffer));
    });
  }

  /** Ends it, whatever it is doing. Its questions are never answered. */
  end() {
    clearTimeout(this.#timer);
    this.#worker.terminate();
    this.#waiting.clear();
  }
}
