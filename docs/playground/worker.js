// A worker that runs Python: the one that is named "brick" also lets the time of the bricks pass.

import { loadPyodide } from "./pyodide/pyodide.mjs";

const PERIOD = 50;

const say = (message) => postMessage(message);

const start = async () => {
  say({ status: "Loading Python …" });
  const fetched = fetch(new URL("./packages.zip", import.meta.url));
  const python = await loadPyodide({ indexURL: new URL("./pyodide/", import.meta.url).href });
  say({ status: "Loading ev3proto …" });
  const packages = await fetched;
  if (!packages.ok) throw new Error(`packages.zip: ${packages.status} ${packages.statusText}`);
  python.unpackArchive(await packages.arrayBuffer(), "zip", { extractDir: "/packages" });
  python.runPython("import sys; sys.path.insert(0, '/packages')");
  return python.pyimport("bridge");
};

const started = start();

const carry = (frame) => say({ carry: frame });
const tell = (news) => say({ real: JSON.parse(news) });

onmessage = async ({ data: { number, call, given, isFollowed } }) => {
  const bridge = await started;
  const publish = (part) => say({ number, part: JSON.parse(part) });
  const more = call === "connect" ? [carry, tell] : isFollowed ? [publish] : [];
  try {
    say({ number, answer: JSON.parse(bridge[call](...given, ...more)) });
  } catch (error) {
    say({ number, error: String(error.message ?? error) });
  }
};

started.then((bridge) => {
  say({ ready: "plain" });
  if (self.name !== "brick") return;
  let before = performance.now();
  setInterval(() => {
    const now = performance.now();
    const news = bridge.tick((now - before) / 1000);
    before = now;
    if (news) say({ brick: JSON.parse(news) });
    bridge.turn();
  }, PERIOD);
}, (error) => say({ failed: String(error.message ?? error) }));
