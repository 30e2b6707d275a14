export * from "./ev3.js";
