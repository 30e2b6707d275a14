// Makes the snapshot of Python's memory: `node make_snapshot.mjs PYODIDE MODULES SNAPSHOT CAPTURE...`, in the build.
// PYODIDE is the folder of the npm package, MODULES the archive that packing.py makes; each CAPTURE is read once, so that
// the modules are there that read others.

import { readFileSync, writeFileSync } from "node:fs";
import { basename, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";
import { LOCK, WARM_UP } from "./boot.js";

const [folder, modules, snapshot, ...captures] = process.argv.slice(2).map((each) => resolve(each));
const { loadPyodide } = await import(pathToFileURL(`${folder}/pyodide.mjs`).href);
// The same modules give nearly the same snapshot; the columns of code in tracebacks would be a tenth of it.
const env = { HOME: "/home/pyodide", PYTHONHASHSEED: "0", PYTHONNODEBUGRANGES: "1" };
const python = await loadPyodide({
  indexURL: `${folder}/`, packageBaseUrl: `${folder}/`, lockFileContents: LOCK, stdLibURL: modules, env, _makeSnapshot: true,
});
const bridge = python.pyimport("bridge");
for (const [call, ...given] of WARM_UP) bridge[call](...given);
for (const capture of captures) {
  python.FS.writeFile(JSON.parse(bridge.place(basename(capture))), new Uint8Array(readFileSync(capture)));
  const job = Number(bridge.start("open_file", basename(capture)));
  while (JSON.parse(bridge.go_on(job)).part !== undefined);
}
bridge.look("");
bridge.destroy();
python.runPython("import gc, linecache; linecache.clearcache(); gc.collect()");
writeFileSync(snapshot, gzipSync(python.makeMemorySnapshot(), { level: 9 }));
