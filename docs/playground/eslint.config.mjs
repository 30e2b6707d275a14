// How the JavaScript of the playground and of the virtual brick's page is linted. Undefined names are found with the types.

import js from "@eslint/js";

export default [
  js.configs.recommended,
  // What ev3proto makes of its tables.
  { ignores: ["ev3-*.mjs"] },
  {
    rules: {
      "no-undef": "off",
      "no-unused-vars": ["error", { varsIgnorePattern: "^_", argsIgnorePattern: "^_" }],
      "no-control-regex": "off",
      "prefer-const": ["error", { destructuring: "all" }],
      "no-var": "error",
      eqeqeq: "error",
      "no-implicit-coercion": "error",
      "object-shorthand": "error",
      "arrow-body-style": "error",
      complexity: ["error", 10],
    },
  },
];
