// How axes look, in the colours of the page.

import { colour } from "./colours.js";
import { ticks } from "./text.js";

export const axisFont = '12px system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';
export const characterWidth = 7.2;

const widest = (values) => Math.max(0, ...(values ?? []).map((text) => text.length));

export const axis = () => ({
  font: axisFont,
  stroke: () => colour("text"),
  grid: { stroke: () => colour("grid"), width: 1 },
  ticks: { stroke: () => colour("grid"), width: 1, size: 5 },
  values: ticks,
});

// Of an axis on the left: as wide as its numbers.
export const widthOfNumbers = (plot, values) => 16 + characterWidth * widest(values);
