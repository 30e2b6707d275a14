export * from "./ev3-texts.js";
