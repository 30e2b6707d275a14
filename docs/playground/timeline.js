// Draws a timeline, a chart of Vega-Lite. This module is loaded when the first one is drawn.

import "./vega/vega.min.js";
import "./vega/vega-lite.min.js";
import { expressionInterpreter } from "./vega/vega-interpreter.js";

/** The share of a narrow page that names get, and its limits, in pixels. */
const NAMES = 0.36, LEAST_NAMES = 110, LEAST_ROOM = 120, NARROW = 700, SCROLLBAR = 40;

/** The colours of charts that are those of the page, which are dark in the dark. @type {Record<string, string>} */
const OWN = { "#444444": "--aside", "#777777": "--aside", "#222222": "--text", "#000000": "--text", black: "--text" };
/** Where a colour is in a chart: at a name such as `subtitleColor`, or in a list. */
const COLOUR = /color$|^\d+$/i;

/** Draws a chart into a box, as wide as a place, in its colours. @param {string} text @param {HTMLElement} box @param {HTMLElement} place */
export const drawTimeline = async (text, box, place) => {
  const { vega, vegaLite } = /** @type {any} */ (globalThis);
  const style = getComputedStyle(place);
  const chart = JSON.parse(text, (key, value) => (COLOUR.test(key) && Object.hasOwn(OWN, value) ? style.getPropertyValue(OWN[value]).trim() : value));
  /** @param {string} name */
  const parameter = (name) => chart.params.find((/** @type {{name: string}} */ each) => each.name === name);
  const width = place.clientWidth - SCROLLBAR;
  parameter("margin").value = Math.min(parameter("margin").value, Math.max(LEAST_NAMES, NAMES * width));
  if (width < NARROW) parameter("kinds").value = 0;
  parameter("room").value = Math.max(LEAST_ROOM, width - parameter("margin").value);
  for (const each of chart.vconcat) each.width = parameter("room").value;
  const { spec } = vegaLite.compile({ ...chart, background: "transparent", config: { ...chart.config, ...colours(place) } });
  const flow = vega.parse(spec, null, { ast: true });
  await new vega.View(flow, { renderer: "canvas", container: box, hover: true, expr: expressionInterpreter }).runAsync();
};

/** Returns the colours of the page for a chart, which are dark in the dark. @param {HTMLElement} place */
const colours = (place) => {
  const style = getComputedStyle(place);
  const [text, aside, line] = ["--text", "--aside", "--line"].map((name) => style.getPropertyValue(name).trim());
  const axis = { labelColor: aside, titleColor: text, gridColor: line, domainColor: line, tickColor: line };
  return { axis, legend: { labelColor: aside, titleColor: text }, title: { color: text }, text: { color: text }, view: { stroke: line } };
};
