// Python in a worker: questions to it, the parts of an answer as they come, and what it says by itself.

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

  /**
   * @param {string} name  "brick" for the one that has the bricks, "reader" for one that only reads
   * @param {(said: Said) => void} hear  takes what it says by itself
   */
  constructor(name, hear) {
    this.#worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module", name });
    const { downlink, rtt, saveData } = Reflect.get(navigator, "connection") ?? {};
    this.#worker.postMessage({ line: { downlink, rtt, saveData } });
    this.#worker.onerror = (event) => hear({ failed: event.message || "worker.js cannot be loaded" });
    this.#worker.onmessage = ({ data }) => {
      const asked = this.#waiting.get(data.number);
      if (!asked) hear(data);
      else if (data.part !== undefined) asked.hear?.(data.part);
      else {
        this.#waiting.delete(data.number);
        if (data.error === undefined) asked.resolve(data.answer); else asked.reject(new Error(data.error));
      }
    };
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
    this.#worker.terminate();
    this.#waiting.clear();
  }
}
