// Makes the snapshot of Python's memory: `node make_snapshot.mjs PYODIDE MODULES GZIP BROTLI CAPTURE...`, in the build.
// PYODIDE is the folder of the npm package, MODULES the archive that packing.py makes; each CAPTURE is read once, so that
// the modules are there that read others.

import { readFileSync, writeFileSync } from "node:fs";
import { basename, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { brotliCompressSync, constants, gzipSync } from "node:zlib";
import { LOCK, WARM_UP } from "./boot.js";

const [folder, modules, gzip, brotli, ...captures] = process.argv.slice(2).map((each) => resolve(each));
const { loadPyodide } = await import(pathToFileURL(`${folder}/pyodide.mjs`).href);
// The same modules give nearly the same snapshot; the columns of code in tracebacks would be a tenth of it, docstrings another one.
const env = { HOME: "/home/pyodide", PYTHONHASHSEED: "0", PYTHONNODEBUGRANGES: "1", PYTHONOPTIMIZE: "2" };
/** Overwrites the memory that is free between what is used. */
const TIDY = `
import gc, linecache
linecache.clearcache()
gc.collect()
def overwrite():
    end = max(map(id, gc.get_objects()))
    kept, size = [], 1 << 20
    while size > 1:
        zeros = bytes(size)
        if id(zeros) < end:
            kept.append(zeros)
        else:
            size = size * 7 // 8
overwrite()
del overwrite
`;
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
python.runPython(TIDY);
const memory = python.makeMemorySnapshot();
writeFileSync(gzip, gzipSync(memory, { level: 9 }));
// A better quality takes minutes.
const params = { [constants.BROTLI_PARAM_QUALITY]: 7, [constants.BROTLI_PARAM_LGWIN]: constants.BROTLI_MAX_WINDOW_BITS };
writeFileSync(brotli, brotliCompressSync(memory, { params }));
