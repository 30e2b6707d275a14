// Says which file of the page itself is missing. A classic script: modules start only when all of them are there.

/** Milliseconds after which a file is said to be late. */
const LATE = 15_000;

/** @param {string} url @param {string} what */
const tellOf = (url, what) => {
  const file = url.slice(new URL(".", location.href).href.length);
  const tell = () => {
    // Of a page that was opened as a file, the browser loads no module: that is said where nothing else is.
    if (document.body.dataset.lacks || location.protocol === "file:") return;
    const sentence = `${file} ${what}. ${document.body.dataset.advice}`;
    for (const id of ["status", "late"]) /** @type {HTMLElement} */ (document.getElementById(id)).textContent = sentence;
    document.body.dataset.lacks = file;
  };
  if (document.readyState === "loading") addEventListener("DOMContentLoaded", tell); else tell();
};

/** The files of the page. @type {() => string[]} */
const files = () => [...document.querySelectorAll("link[href]:not([rel=icon]), script[src]")].map((each) => Reflect.get(each, "href") ?? Reflect.get(each, "src"));

addEventListener("error", ({ target }) => {
  const url = target instanceof HTMLLinkElement ? target.href : target instanceof HTMLScriptElement ? target.src : "";
  if (files().includes(url)) tellOf(url, "is missing");
}, true);
setTimeout(() => {
  const there = new Set(performance.getEntriesByType("resource").map(({ name }) => name)), late = files().find((each) => !there.has(each));
  if (late && !document.body.dataset.begun) tellOf(late, "has not arrived after 15 seconds");
}, LATE);
