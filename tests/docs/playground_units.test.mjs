// What the playground's modules do without a browser: addresses, places, the dump's colours, buttons' texts.

import assert from "node:assert/strict";
import test from "node:test";
import { pathToFileURL } from "node:url";

/** The elements of the page, as far as modules look for them when they are loaded. */
globalThis.location = new URL("https://example.org/playground/index.html");
const module = (name) => import(pathToFileURL(`${process.env.PLAYGROUND}/${name}`).href);

const { fragmentOf, linkTo, textOf, MOST_TEXT } = await module("address.js");
const { overlap, partOf, rowAt, rowsByFrame, targetOf } = await module("places.js");
const { buttonTexts, change, state } = await module("state.js");

test("a short text is in the address as it is, a long one deflated", async () => {
  assert.equal(await fragmentOf(""), "");
  assert.equal(await fragmentOf("0x|08:00|"), "#text=0x%7C08%3A00%7C");
  const long = "0e002a0080000094010182b80182e803\n".repeat(200);
  assert.ok(long.length > MOST_TEXT);
  const fragment = await fragmentOf(long);
  assert.match(fragment, /^#z=[\w-]+$/);
  assert.ok(fragment.length < 200);
  assert.equal(await textOf(fragment), long);
});

test("a link is the shortest one, and there is none to a text without order", async () => {
  assert.equal(await linkTo("UI_WRITE(LED, 1)"), "https://example.org/playground/index.html#text=UI_WRITE(LED%2C%201)");
  assert.match(await linkTo("0e002a00".repeat(100)), /#z=/);
  const noise = Array.from({ length: 20_000 }, (_, at) => String.fromCharCode(33 + (at * at * 7919) % 94 + (at % 7))).join("");
  assert.ok(await linkTo(noise) === null || (await linkTo(noise)).length <= 8192);
});

test("a fragment without a text is none, a damaged one a sentence", async () => {
  assert.equal(await textOf("#elsewhere"), null);
  assert.equal(await textOf("#text=100%"), "100%");
  await assert.rejects(textOf("#z=____"), /The link is damaged/);
  await assert.rejects(textOf("#z=*"), /The link is damaged/);
});

/** A heading over 16 bytes, an operation, two arguments, a line about nothing, another frame. */
const LINES = [[[], 0, 0, 16], [[], 0, 7, 9], [[], 0, 9, 1], [[], 0, 10, 3], [[], -1, 0, 0], [[], 1, 0, 10]];

test("a byte belongs to the smallest line around it", () => {
  const rows = rowsByFrame(LINES);
  assert.deepEqual([...rows], [[0, [0, 1, 2, 3]], [1, [5]]]);
  const found = [0, 7, 8, 9, 11, 13, 15, 16].map((at) => rowAt(LINES, rows.get(0), at));
  assert.deepEqual(found, [0, 1, 1, 2, 3, 1, 1, -1]);
  assert.deepEqual(targetOf(LINES, 3), { frame: 0, offset: 10, length: 3, row: 3 });
});

test("of a long program the part around a byte is in the page", () => {
  assert.equal(partOf(4096, 4000), 0);
  assert.equal(partOf(10_000, 100), 0);
  assert.equal(partOf(10_000, 5000), 2944);
  assert.ok(overlap({ offset: 4, length: 1 }, { offset: 0, length: 5 }));
  assert.ok(!overlap({ offset: 5, length: 1 }, { offset: 0, length: 5 }));
});

test("the text of a button follows from what the page knows", () => {
  const textOfSend = () => Object.fromEntries(buttonTexts(state())).send;
  assert.equal(textOfSend(), "Send to the brick");
  change({ connection: "usb" });
  assert.equal(textOfSend(), "Send to the real brick");
  change({ flashes: { send: "Sent" } });
  assert.equal(textOfSend(), "Sent");
  change({ connection: "none", flashes: {} });
  assert.equal(textOfSend(), "Send to the brick");
});
