// How Python starts: from a snapshot of its memory, which the build made, or plain, by importing the same modules.
// Pyodide's snapshots are experimental: where one cannot be loaded, the plain start follows.

import { Loads } from "./loads.js";

/** @typedef {typeof import("./pyodide/pyodide.mjs").loadPyodide} Load */
/** @typedef {Record<string, (...given: unknown[]) => any>} Bridge */
/**
 * @typedef {object} Started
 * @property {Bridge} bridge
 * @property {"snapshot" | "plain"} started
 * @property {(path: string, bytes: Uint8Array) => void} write  makes a file of bytes, which are not copied
 * @property {Promise<unknown>} packages  when each module can be imported
 */

/** Files of the site. An archive without anything takes the place of Python's modules until they are there. */
const MODULES = "python.zip", NO_MODULES = "none.zip", PYODIDE = "pyodide/pyodide.mjs", WASM = "pyodide/pyodide.asm.wasm", ASM = "pyodide/pyodide.asm.js";
/** The snapshot in each form in which it is packed, the smallest first. @type {[format: string, file: string][]} */
const SNAPSHOTS = [["brotli", "snapshot_brotli.bin"], ["gzip", "snapshot.bin"]];
/** @param {string} format */
const unpacker = (format) => { try { return new DecompressionStream(/** @type {CompressionFormat} */ (format)); } catch { return null; } };
const [FORMAT, SNAPSHOT] = SNAPSHOTS.find(([format]) => unpacker(format)) ?? ["gzip", "snapshot.bin"];
/** The end of an archive, which alone is an archive without anything. */
const EMPTY_ARCHIVE = Uint8Array.from({ length: 22 }, (_, at) => [0x50, 0x4b, 5, 6][at] ?? 0);
/** Where Pyodide has its standard library. */
const LIBRARY = "/lib/python313.zip";
/** Seconds that Python takes to import its modules, which it has in a snapshot. */
const IMPORTING = 6;

/** The list of packages that Pyodide could install: none. */
export const LOCK = {
  info: { abi_version: "2025_0", arch: /** @type {const} */ ("wasm32"), platform: "emscripten_4_0_9", python: "3.13.2", version: "0.28.3" },
  packages: {},
};

const FRAME = "0x|08:00|01:00|00|05:00|81:01:61|";
/**
 * What Python has done before the snapshot is taken, as calls of bridge. For other calls a module may have to be imported,
 * so they wait for the packages.
 *
 * @type {readonly (readonly [call: string, ...given: unknown[]])[]}
 */
export const WARM_UP = [
  ["look", `vmthread MAIN\n{\n  UI_WRITE(LED, LED_RED)\n}\n`],
  ["look", `# A log\n09:12:31.5 Sent ${FRAME}\n09:12:31.6 Recv 0x|07:00|01:00|02|66:66:F6:40|\n`],
  ["page", 0],
  ["look", "SOUND(TONE, 1, 440, 1000)"],
  ["look", FRAME],
  ["about", "0e002a0080000094010182b80182e803"],
  ["remedies"],
  ["made", "c"],
  ["made", "python"],
  ["frames_of", "SOUND(TONE, 1, 440, 1000)"],
  ["explain", "E102"],
  ["as_assembly", FRAME],
  ["complete", "SOUND(TONE, 1"],
  ["complete", "UI_WRTE"],
  ["to_send"],
  ["stop_motors"],
  ["give_up"],
  ["tick", 0.05],
  ["turn"],
];
const PREPARED = new Set(WARM_UP.map(([call]) => call));

/** Returns whether a call of bridge needs no more than a snapshot has. @param {string} call */
export const isPrepared = (call) => PREPARED.has(call);

/**
 * Starts Python. Is rejected with a sentence if a file is missing that it needs.
 *
 * @param {URL} site  the folder of the page
 * @param {boolean} saveData  whether fewer bytes are better than a quick start
 * @param {(progress: import("./loads.js").Progress) => void} tell
 * @returns {Promise<Started>}
 */
export const start = async (site, saveData, tell) => {
  const loads = new Loads(site, SIZES, tell);
  loads.expect(PYODIDE, ASM, WASM, SNAPSHOT);
  /** @type {{loadPyodide: Load}} */
  const { loadPyodide } = await loads.import(PYODIDE);
  await loads.import(ASM);
  const isPlain = (saveData || isSlow(site)) && !await globalThis.caches?.match(new URL(SNAPSHOT, site));
  const begin = async () => {
    if (isPlain) return startPlain(loadPyodide, loads, site);
    try {
      return await startSnapshot(loadPyodide, loads, site);
    } catch (error) {
      console.warn(`The snapshot cannot be loaded: ${error}`);
      return startPlain(loadPyodide, loads, site);
    }
  };
  // Pyodide waits forever for a missing file.
  return Promise.race([lackOf(loads, site), begin()]);
};

/** Has Pyodide load its files so that they are counted. Is rejected if one of them is missing. @param {Loads} loads @param {URL} site @returns {Promise<never>} */
const lackOf = (loads, site) => new Promise((_, reject) => {
  globalThis.fetch = async (/** @type {any} */ url) => {
    const file = String(url).slice(site.href.length);
    if (file === NO_MODULES) return new Response(EMPTY_ARCHIVE);
    try {
      const { answer, whole } = await loads.fetch(file);
      whole.catch(reject);
      return answer;
    } catch (error) {
      reject(error);
      throw error;
    }
  };
});

/** Returns whether the bytes that the snapshot has more take longer than to import the modules. @param {URL} site */
const isSlow = (site) => {
  const [entry] = /** @type {PerformanceResourceTiming[]} */ (performance.getEntriesByName(new URL(ASM, site).href));
  if (!entry) return false;
  // WebKit does not tell what was transferred. Text is packed into a quarter, where a server does that.
  const bytes = entry.encodedBodySize || SIZES[ASM] / 4, seconds = (entry.responseEnd - entry.responseStart) / 1000;
  return ((SIZES[SNAPSHOT] - SIZES[MODULES]) / bytes) * seconds > IMPORTING;
};

/** @typedef {(load: Load, loads: Loads, site: URL) => Promise<Started>} Start */

/** @type {Start} */
const startPlain = async (load, loads, site) => {
  loads.expect(WASM, MODULES);
  const python = await load({ ...settings(site), stdLibURL: new URL(MODULES, site).href });
  return { bridge: python.pyimport("bridge"), started: "plain", write: writer(python), packages: Promise.resolve() };
};

/** @type {Start} */
const startSnapshot = async (load, loads, site) => {
  const snapshot = loads.fetch(SNAPSHOT).then(inflated);
  snapshot.catch(() => {});
  const python = await load({ ...settings(site), stdLibURL: new URL(NO_MODULES, site).href, _loadSnapshot: snapshot });
  // It would be kept as long as the page, and is as large as Python's memory.
  Reflect.deleteProperty(/** @type {any} */ (python)._api.config, "_loadSnapshot");
  const bridge = python.pyimport("bridge");
  const packages = loads.fetch(MODULES).then(async ({ answer, whole }) => {
    await whole;
    python.FS.writeFile(LIBRARY, new Uint8Array(await answer.arrayBuffer()));
    python.runPython("import importlib; importlib.invalidate_caches()");
  });
  bridge.begin();
  return { bridge, started: "snapshot", write: writer(python), packages };
};

/** @param {Awaited<ReturnType<Load>>} python @returns {Started["write"]} */
const writer = (python) => (path, bytes) => python.FS.writeFile(path, bytes, { canOwn: true });

/** @param {URL} site */
const settings = (site) => ({ indexURL: new URL("pyodide/", site).href, packageBaseUrl: site.href, lockFileContents: LOCK });

/** The number of bytes of each large file, which the build knows. @type {Record<string, number>} */
const SIZES = /* @SIZES@ */ {};

/** Returns the unpacked snapshot. @param {import("./loads.js").Load} load */
const inflated = async ({ answer, whole }) => {
  const stream = /** @type {ReadableStream} */ (answer.body).pipeThrough(/** @type {DecompressionStream} */ (unpacker(FORMAT)));
  const [found] = await Promise.all([new Response(stream).arrayBuffer(), whole]);
  return new Uint8Array(found);
};
