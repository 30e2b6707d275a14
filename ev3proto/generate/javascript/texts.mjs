const { areas, ...others } = found, operations = {};
for (const [area, entries] of Object.entries(areas)) {
  for (const [name, [text, given, each]] of Object.entries(entries)) {
    const parameters = given.map((it) => (Array.isArray(it) ? it[0] : it)), special = given.map((it) => (Array.isArray(it) ? it[1] : {}));
    operations[name] = { area, text, parameters, special, each };
  }
}
export const texts = { ...others, operations };
