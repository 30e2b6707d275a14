// Keeps the page for use without a network. The build names the files; one version of all of them is kept at a time.

const VERSION = "@FILES_VERSION@";
const FILES = @FILES@;

const CACHE = `ev3proto-playground-${VERSION}`;

addEventListener("install", (event) => {
  // The answers of an older version may still be in the browser's own cache.
  event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(FILES.map((file) => new Request(file, { cache: "no-cache" })))));
});

addEventListener("activate", (event) => {
  const drop = async () => {
    const names = await caches.keys();
    await Promise.all(names.filter((name) => name.startsWith("ev3proto-playground-") && name !== CACHE).map((name) => caches.delete(name)));
  };
  event.waitUntil(drop());
});

addEventListener("fetch", (event) => {
  const url = new URL(event.request.url), scope = new URL(registration.scope);
  if (event.request.method !== "GET" || url.origin !== scope.origin || !url.pathname.startsWith(scope.pathname)) return;
  const file = url.pathname.slice(scope.pathname.length) || "index.html";
  if (!FILES.includes(file)) return;
  const answer = async () => {
    const cache = await caches.open(CACHE);
    return await cache.match(new URL(file, scope)) ?? fetch(event.request);
  };
  event.respondWith(answer());
});
