// The text in the address: #text= as it is, or #z= deflated, for links to what the page shows.

export const MOST_TEXT = 4000;
const MOST_LINK = 8192;
const MOST_INFLATED = 1 << 20;

const DEFLATE = "deflate-raw";

/** @param {Uint8Array} bytes */
const base64url = (bytes) => {
  let text = "";
  for (let at = 0; at < bytes.length; at += 4096) text += String.fromCharCode(...bytes.subarray(at, at + 4096));
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
};

/** @param {string} text */
const bytesOf = (text) => Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (it) => it.charCodeAt(0));

/** @param {string} text */
const plain = (text) => `#text=${encodeURIComponent(text)}`;

/** Returns something deflated, in base64url. @param {BlobPart} content */
export const deflated = async (content) => {
  const stream = new Blob([content]).stream().pipeThrough(new CompressionStream(DEFLATE));
  return base64url(new Uint8Array(await new Response(stream).arrayBuffer()));
};

/** @param {string} text */
const packed = async (text) => `#z=${await deflated(text)}`;

/** @param {string} fragment */
const isShort = (fragment) => location.href.split("#")[0].length + fragment.length <= MOST_LINK;

/** The fragment for the address bar, of a short text at once; empty for a text that is too long. @param {string} text @returns {string | Promise<string>} */
export const fragmentOf = (text) => {
  if (text.length <= MOST_TEXT) return text && plain(text);
  return packed(text).then((found) => (isShort(found) ? found : ""));
};

/** The shortest link to a text; null if there is none. @param {string} text */
export const linkTo = async (text) => {
  const [shortest = ""] = [plain(text), await packed(text)].sort((one, other) => one.length - other.length);
  return isShort(shortest) ? location.href.split("#")[0] + shortest : null;
};

/** The text of a fragment; null if it has none. Throws an Error with a sentence if it cannot be read. @param {string} fragment */
export const textOf = async (fragment) => {
  const [, kind, given] = fragment.match(/^#(text|z)=(.*)$/s) ?? [];
  if (kind === undefined) return null;
  if (kind === "text") {
    try { return decodeURIComponent(given); } catch { return given; }
  }
  return (await inflated(given, MOST_INFLATED)).text();
};

/** Returns what was deflated. @param {string} given  in base64url @param {number} most  bytes */
export const inflated = async (given, most) => {
  const parts = [];
  let size = 0;
  try {
    const stream = new Blob([bytesOf(given)]).stream().pipeThrough(new DecompressionStream(DEFLATE));
    for (const reader = stream.getReader(); ;) {
      const { done, value } = await reader.read();
      if (done) break;
      size += value.length;
      if (size > most) {
        reader.cancel().catch(() => {});
        break;
      }
      parts.push(value);
    }
  } catch {
    throw new Error("The link is damaged: the text in it cannot be unpacked. Was it copied as a whole?");
  }
  if (size > most) throw new Error("The link unpacks to more than 1 MiB, which this page does not read.");
  return new Blob(parts);
};
