// How Python starts: from a snapshot of its memory, which the build made, or plain, by importing the same modules.
// Pyodide's snapshots are experimental: where one cannot be loaded, the plain start follows.

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
const MODULES = "python.zip", NO_MODULES = "none.zip", SNAPSHOT = "snapshot.bin", WASM = "pyodide/pyodide.asm.wasm", ASM = "pyodide/pyodide.asm.js";
/** Where Pyodide has its standard library. */
const LIBRARY = "/lib/python313.zip";

/** @typedef {{downlink?: number, rtt?: number, saveData?: boolean}} Line  what the browser says about the line: megabits per second, milliseconds */
/** Megabits per second below which the plain start comes first, which has fewer bytes. */
const SLOW = 8;
/** Round trips, in milliseconds, that Chromium guesses, together with a slow line, until it has measured one. */
const GUESSED = { least: 75, most: 125 };

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
  ["tick", 0.05],
  ["turn"],
];
const PREPARED = new Set(WARM_UP.map(([call]) => call));

/** Returns whether a call of bridge needs no more than a snapshot has. @param {string} call */
export const isPrepared = (call) => PREPARED.has(call);

/**
 * Starts Python.
 *
 * @param {Load} load
 * @param {URL} site  the folder of the page
 * @param {Line} line
 * @param {(missing: number) => void} tell  takes the number of bytes that are still to come
 * @returns {Promise<Started>}
 */
export const start = async (load, site, line, tell) => {
  if (await isSlow(line, site) && !await globalThis.caches?.match(new URL(SNAPSHOT, site))) return startPlain(load, site, tell);
  try {
    return await startSnapshot(load, site, tell);
  } catch (error) {
    console.warn(`The snapshot cannot be loaded: ${error}`);
    return startPlain(load, site, tell);
  }
};

/** Returns whether fewer bytes are better than a quick start. @param {Line} line @param {URL} site */
const isSlow = async ({ saveData = false, downlink = SLOW, rtt = 0 }, site) => {
  if (saveData) return true;
  if (downlink >= SLOW) return false;
  return rtt < GUESSED.least || rtt > GUESSED.most || await measured(site) < SLOW;
};

/** Returns the megabits per second at which a file comes that is needed anyway. @param {URL} site */
const measured = async (site) => {
  const begun = performance.now();
  const bytes = await (await fetched(ASM, site)).arrayBuffer();
  return (bytes.byteLength * 8) / 1000 / (performance.now() - begun);
};

/** @typedef {(load: Load, site: URL, tell: (missing: number) => void) => Promise<Started>} Start */

/** @type {Start} */
const startPlain = async (load, site, tell) => {
  tell(size(MODULES, WASM, ASM));
  const python = await load({ ...settings(site), stdLibURL: new URL(MODULES, site).href });
  return { bridge: python.pyimport("bridge"), started: "plain", write: writer(python), packages: Promise.resolve() };
};

/** @type {Start} */
const startSnapshot = async (load, site, tell) => {
  const others = size(WASM, ASM);
  tell(others + size(SNAPSHOT));
  const snapshot = inflated(await fetched(SNAPSHOT, site), (missing) => tell(others + missing));
  const python = await load({ ...settings(site), stdLibURL: new URL(NO_MODULES, site).href, _loadSnapshot: snapshot });
  // It would be kept as long as the page, and is as large as Python's memory.
  Reflect.deleteProperty(/** @type {any} */ (python)._api.config, "_loadSnapshot");
  const bridge = python.pyimport("bridge");
  const packages = fetched(MODULES, site).then(async (found) => {
    python.FS.writeFile(LIBRARY, new Uint8Array(await found.arrayBuffer()));
    python.runPython("import importlib; importlib.invalidate_caches()");
  });
  bridge.begin();
  return { bridge, started: "snapshot", write: writer(python), packages };
};

/** @param {Awaited<ReturnType<Load>>} python @returns {Started["write"]} */
const writer = (python) => (path, bytes) => python.FS.writeFile(path, bytes, { canOwn: true });

/** @param {URL} site */
const settings = (site) => ({ indexURL: new URL("pyodide/", site).href, packageBaseUrl: site.href, lockFileContents: LOCK });

/** @param {string} name @param {URL} site */
const fetched = async (name, site) => {
  const answer = await fetch(new URL(name, site));
  if (!answer.ok || !answer.body) throw new Error(`${name}: ${answer.status} ${answer.statusText}`);
  return answer;
};

/** The number of bytes of each large file, which the build knows. @type {Record<string, number>} */
const SIZES = /* @SIZES@ */ {};
/** @param {string[]} names */
const size = (...names) => names.reduce((sum, name) => sum + SIZES[name], 0);

/** Returns the unpacked snapshot. @param {Response} answer @param {(missing: number) => void} tell */
const inflated = async ({ body }, tell) => {
  let missing = size(SNAPSHOT);
  const counting = new TransformStream({
    /** @param {Uint8Array} chunk @param {TransformStreamDefaultController} to */
    transform: (chunk, to) => {
      missing -= chunk.length;
      tell(missing);
      to.enqueue(chunk);
    },
  });
  const stream = /** @type {ReadableStream} */ (body).pipeThrough(counting).pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
};
