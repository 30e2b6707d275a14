// Notations that need no knowledge of the protocol, made of the lesson's.

/**
 * Returns the frames in other notations. What is not a frame stays a line of its own.
 *
 * @param {string} lesson  lines as "0x|0E:00|2A:00|..."
 * @returns {{hex: string, javascript: string}}
 */
export const derived = (lesson) => {
  const lines = lesson.split("\n");
  const frames = lines.filter((each) => each.startsWith("0x|")).map((each) => each.slice(3).match(/[0-9A-F]{2}/g) ?? []);
  const rest = lines.filter((each) => each && !each.startsWith("0x|"));
  /** @param {number} index */
  const name = (index) => (frames.length > 1 ? `frame${index + 1}` : "frame");
  return {
    hex: [...frames.map((bytes) => bytes.join(" ")), ...rest].join("\n"),
    javascript: [
      ...frames.map((bytes, index) => `const ${name(index)} = new Uint8Array([${bytes.map((each) => `0x${each.toLowerCase()}`).join(", ")}]);`),
      ...rest.map((each) => `/* ${each} */`),
    ].join("\n"),
  };
};
