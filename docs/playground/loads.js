// What the start loads: the bytes of each file are counted, and a file that cannot be loaded is named.

/** @typedef {{missing: number, file: string}} Progress  bytes that are left, and a file that is pending; empty for none */
/** @typedef {{answer: Response, whole: Promise<void>}} Load  `whole` is rejected if the end of the file is missing */

const plainFetch = globalThis.fetch;

/** A file that cannot be loaded. */
export class Lack extends Error {
  /** @param {string} file @param {Response | null} [answer] */
  constructor(file, answer = null) {
    super(`${file} is missing${answer ? ` (${answer.status} ${answer.statusText})` : ""}`);
  }
}

export class Loads {
  /** The bytes of each file that are left. @type {Map<string, number>} */
  #left = new Map();
  #site;
  #sizes;
  #tell;

  /**
   * @param {URL} site  the folder of the page
   * @param {Readonly<Record<string, number>>} sizes  the number of bytes of each file
   * @param {(progress: Progress) => void} tell
   */
  constructor(site, sizes, tell) {
    this.#site = site;
    this.#sizes = sizes;
    this.#tell = tell;
  }

  /** Expects files, and no others any more. @param {string[]} files */
  expect(...files) {
    this.#left = new Map(files.map((file) => [file, this.#sizes[file] ?? 0]));
    this.#take("", 0);
  }

  /** Imports a module, which counts as a whole. @param {string} file @returns {Promise<any>} */
  async import(file) {
    const found = await import(new URL(file, this.#site).href).catch(() => { throw new Lack(file); });
    this.#take(file, Infinity);
    return found;
  }

  /** Fetches a file. @param {string} file @returns {Promise<Load>} */
  async fetch(file) {
    const answer = await plainFetch(new URL(file, this.#site)).catch(() => null);
    if (!answer?.ok) throw new Lack(file, answer);
    return { answer, whole: this.#count(file, answer.clone()) };
  }

  /** @param {string} file @param {Response} copy */
  async #count(file, { body }) {
    const reader = /** @type {ReadableStream<Uint8Array>} */ (body).getReader();
    for (let isDone = false; !isDone;) {
      const { done, value } = await reader.read().catch(() => { throw new Lack(file); });
      this.#take(file, value?.length ?? Infinity);
      isDone = done;
    }
  }

  /** @param {string} file @param {number} count */
  #take(file, count) {
    const left = (this.#left.get(file) ?? 0) - count;
    if (left > 0) this.#left.set(file, left); else this.#left.delete(file);
    const [waiting = ""] = this.#left.keys();
    this.#tell({ missing: [...this.#left.values()].reduce((sum, each) => sum + each, 0), file: waiting });
  }
}
