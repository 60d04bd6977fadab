// The two axes of a plot of one impact, with their labels.

import { axis, axisFont, widthOfNumbers } from "../both/axes.js";
import { decadeTicks, decades } from "./decades.js";

function labelled(label, logarithmic = false) {
  const looks = { ...axis(), label, labelFont: axisFont, labelSize: 20, labelGap: 2 };
  if (!logarithmic) return looks;
  const filter = decades;
  return {
    ...looks,
    filter,
    grid: { ...looks.grid, filter },
    ticks: { ...looks.ticks, filter },
    values: decadeTicks,
  };
}

export function axes(xLabel, yLabel, logarithmic) {
  return [
    { ...labelled(xLabel), size: 32, space: 56 },
    { ...labelled(yLabel, logarithmic), size: widthOfNumbers, ...(logarithmic ? {} : { space: 36 }) },
  ];
}
