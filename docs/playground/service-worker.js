// Keeps the page for use without a network. The build names the files with their digests; one version of all is kept at a time.

const VERSION = "@FILES_VERSION@";
/** SHA-256 of each file, in hex. @type {Record<string, string>} */
const FILES = JSON.parse(`@FILES@`);

const PREFIX = "ev3proto-playground-";
const CACHE = `${PREFIX}${VERSION}`;

const worker = /** @type {ServiceWorkerGlobalScope} */ (/** @type {unknown} */ (self));

/** Returns whether this browser uses a file: it takes one of two snapshots, as boot.js does. @param {string} file */
const isUsed = (file) => {
  try {
    return file !== "snapshot.bin" || !new DecompressionStream(/** @type {any} */ ("brotli"));
  } catch {
    return file !== "snapshot_brotli.bin";
  }
};

/** Where a file may be found, the nearest place first. @type {((url: URL) => Promise<Response | undefined>)[]} */
const PLACES = [
  (url) => caches.match(url),
  // The page has just loaded most of them. What is older than this version is told by its digest.
  (url) => fetch(url, { cache: "force-cache" }),
  (url) => fetch(url, { cache: "reload" }),
];

/** @param {Response} answer */
const digestOf = async (answer) => {
  const digest = await crypto.subtle.digest("SHA-256", await answer.arrayBuffer());
  return [...new Uint8Array(digest)].map((each) => each.toString(16).padStart(2, "0")).join("");
};

/** @param {Cache} cache @param {string} file */
const keep = async (cache, file) => {
  const url = new URL(file, worker.registration.scope);
  for (const place of PLACES) {
    const found = await place(url);
    if (found?.ok && await digestOf(found.clone()) === FILES[file]) {
      await cache.put(url, found);
      return;
    }
  }
  throw new Error(`${file} is not that of this version`);
};

worker.addEventListener("install", (event) => {
  const keepAll = async () => {
    const cache = await caches.open(CACHE);
    for (const file of Object.keys(FILES).filter(isUsed)) await keep(cache, file);
  };
  event.waitUntil(keepAll());
});

worker.addEventListener("activate", (event) => {
  const drop = async () => {
    const names = await caches.keys();
    await Promise.all(names.filter((name) => name.startsWith(PREFIX) && name !== CACHE).map((name) => caches.delete(name)));
  };
  event.waitUntil(drop());
});

worker.addEventListener("fetch", (event) => {
  const url = new URL(event.request.url), scope = new URL(worker.registration.scope);
  if (event.request.method !== "GET" || url.origin !== scope.origin || !url.pathname.startsWith(scope.pathname)) return;
  const file = url.pathname.slice(scope.pathname.length) || "index.html";
  if (!(file in FILES)) return;
  const answer = async () => {
    const cache = await caches.open(CACHE);
    return await cache.match(new URL(file, scope)) ?? fetch(event.request);
  };
  event.respondWith(answer());
});
