export * from "./ev3-decode.js";
