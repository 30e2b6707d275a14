// Python in a worker: questions to it, the parts of an answer as they come, and what it says by itself.

export class Python {
  #waiting = new Map();
  #count = 0;
  #worker;

  /**
   * @param {string} name  "brick" for the one that has the bricks, "reader" for one that only reads
   * @param {(said: object) => void} hear  takes what it says by itself: `status`, `ready`, `failed`, `brick`, `real`, `carry`
   */
  constructor(name, hear) {
    this.#worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module", name });
    this.#worker.onerror = (event) => hear({ failed: event.message || "worker.js cannot be loaded" });
    this.#worker.onmessage = ({ data }) => {
      const asked = this.#waiting.get(data.number);
      if (!asked) hear(data);
      else if (data.part !== undefined) asked.hear(data.part);
      else {
        this.#waiting.delete(data.number);
        if (data.error === undefined) asked.resolve(data.answer); else asked.reject(new Error(data.error));
      }
    };
  }

  /** Calls a function of bridge. */
  ask(call, ...given) {
    return this.#post(call, given, null);
  }

  /** Calls a function of bridge that publishes parts of its answer. */
  follow(hear, call, ...given) {
    return this.#post(call, given, hear);
  }

  #post(call, given, hear) {
    return new Promise((resolve, reject) => {
      const number = ++this.#count;
      this.#waiting.set(number, { resolve, reject, hear });
      this.#worker.postMessage({ number, call, given, isFollowed: hear !== null });
    });
  }

  /** Ends it, whatever it is doing. Its questions are never answered. */
  end() {
    this.#worker.terminate();
    this.#waiting.clear();
  }
}
