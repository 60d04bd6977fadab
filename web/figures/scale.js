// Places on an axis: the value, or its logarithm to base 10. Axes that stretch as their data need.

import { clipped } from "./clip.js";

export const toScale = (value, axis) => (value === null || !axis.logarithmic ? value : Math.log10(value));

const isMarker = ({ style }) => style === "vertical" || style === "horizontal";

function limits({ x, y }) {
  const limit = (value, axis, otherwise) => (value === null ? otherwise : toScale(value, axis));
  return {
    left: limit(x.low, x, -Infinity),
    right: limit(x.high, x, Infinity),
    low: limit(y.low, y, -Infinity),
    high: limit(y.high, y, Infinity),
  };
}

// The ends of both axes: of all that lies within the limits of the other axis, lines across included.
export function ranges(panel, series) {
  const box = limits(panel);
  const x = [Infinity, -Infinity];
  const y = [Infinity, -Infinity];
  const include = (range, value) => {
    range[0] = Math.min(range[0], value);
    range[1] = Math.max(range[1], value);
  };
  for (const each of series) {
    if (isMarker(each)) {
      for (const place of each.x ?? []) include(x, place);
      for (const place of each.y ?? []) include(y, place);
      continue;
    }
    for (const ys of each.y2 ? [each.y, each.y2] : [each.y])
      for (const [from, to] of segments(each.x, ys, each.style === "points")) {
        const part = clipped(from, to, box);
        for (const [px, py] of part ?? []) {
          include(x, px);
          include(y, py);
        }
      }
  }
  return {
    x: withEnds(x, panel.x, box.left, box.right),
    y: withEnds(y, panel.y, box.low, box.high),
  };
}

// From point to point; a point that has a gap on its left, or is not on a line, from itself to itself.
function* segments(xs, ys, single) {
  for (let i = 0; i < xs.length; ++i) {
    if (xs[i] === null) continue;
    const joined = !single && i > 0 && xs[i - 1] !== null;
    yield [joined ? [xs[i - 1], ys[i - 1]] : [xs[i], ys[i]], [xs[i], ys[i]]];
  }
}

// An end that nobody has fixed lies at a round number, or on a logarithmic axis a little beyond the data.
function withEnds([low, high], { logarithmic }, begin, end) {
  const [fixedLow, fixedHigh] = [begin, end].map(Number.isFinite);
  if (low > high) [low, high] = [0, 1];
  if (fixedLow) low = begin;
  if (fixedHigh) high = end;
  if (high <= low) {
    const more = logarithmic ? 0.5 : Math.abs(low) / 10 || 1;
    [low, high] = [fixedLow ? low : high - more, fixedHigh ? high : low + more];
  }
  const step = niceStep((high - low) / 6);
  const margin = 0.03 * (high - low);
  const down = logarithmic ? low - margin : step * Math.floor(low / step + 1e-9);
  const up = logarithmic ? high + margin : step * Math.ceil(high / step - 1e-9);
  return [fixedLow ? low : down, fixedHigh ? high : up];
}

// 1, 2 or 5 times a power of ten, and not below `least`.
export function niceStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * [1, 2, 5, 10].find((times) => times * power >= least * (1 - 1e-9));
}
