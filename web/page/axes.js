// Axes in the colours of the page.

import { colour } from "./colours.js";
import { axisFont } from "./frame.js";
import { decadeTicks, decades, ticks } from "./text.js";

const widest = (values) => Math.max(0, ...(values ?? []).map((text) => text.length));

function axis(label, logarithmic = false) {
  const filter = logarithmic ? { filter: decades } : {};
  return {
    ...filter,
    label,
    font: axisFont,
    labelFont: axisFont,
    labelSize: 20,
    labelGap: 2,
    stroke: () => colour("text"),
    grid: { stroke: () => colour("grid"), width: 1, ...filter },
    ticks: { stroke: () => colour("grid"), width: 1, size: 5, ...filter },
    values: logarithmic ? decadeTicks : ticks,
  };
}

export function axes(xLabel, yLabel, logarithmic) {
  return [
    { ...axis(xLabel), size: 32, space: 56 },
    {
      ...axis(yLabel, logarithmic),
      size: (plot, values) => 16 + 7.2 * widest(values),
      ...(logarithmic ? {} : { space: 36 }),
    },
  ];
}
