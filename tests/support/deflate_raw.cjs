// Gives Node 18 what browsers have and it lacks: streams that deflate without a header.
const { Duplex } = require("node:stream");
const zlib = require("node:zlib");

for (const [name, make] of [["CompressionStream", zlib.createDeflateRaw], ["DecompressionStream", zlib.createInflateRaw]]) {
  globalThis[name] = function () {
    return Duplex.toWeb(make());
  };
}
