// The point that is drawn nearest to a place, and the way from point to point. A stop is { series, entry, x, y },
// with x and y in pixels of the axes; of lines across the panel it is where they are nearest.

const sizeOf = ({ over }) => ({ width: over.clientWidth, height: over.clientHeight });

function distanceTo(segment, left, top) {
  const [x, y, toX, toY] = segment;
  const [dx, dy] = [toX - x, toY - y];
  const length = dx * dx + dy * dy;
  const part = length > 0 ? Math.min(Math.max(((left - x) * dx + (top - y) * dy) / length, 0), 1) : 0;
  return Math.hypot(x + part * dx - left, y + part * dy - top);
}

// The points of a series, null where there is a gap: where each is drawn, and the row that it comes from.
function stops(plot, series, top) {
  const { style, x, y, y2 } = series;
  const { width, height } = sizeOf(plot);
  if (style === "vertical")
    return x.map((place, entry) => ({ series, entry, x: plot.valToPos(place, "x"), y: top ?? height / 2 }));
  if (style === "horizontal")
    return y.map((place, entry) => ({ series, entry, x: width / 2, y: plot.valToPos(place, "y") }));
  const edge = (ys) =>
    x.map((value, entry) =>
      value === null ? null : { series, entry, x: plot.valToPos(value, "x"), y: plot.valToPos(ys[entry], "y") },
    );
  return y2 ? [...edge(y), null, ...edge(y2)] : edge(y);
}

const isIn = ({ x, y }, { width, height }) => x >= -1 && x <= width + 1 && y >= -1 && y <= height + 1;

// A point counts as near as the line that it is on.
export function nearest(plot, shown, left, top) {
  let best = null;
  let least = Infinity;
  const size = sizeOf(plot);
  for (const series of shown) {
    const isLine = series.style !== "points";
    const list = stops(plot, series, top).map((stop) => (series.style === "horizontal" ? { ...stop, x: left } : stop));
    list.forEach((stop, i) => {
      if (!stop || !isIn(stop, size)) return;
      const point = Math.hypot(stop.x - left, stop.y - top);
      let distance = point;
      for (const next of isLine ? [list[i - 1], list[i + 1]] : [])
        if (next) distance = Math.min(distance, distanceTo([stop.x, stop.y, next.x, next.y], left, top));
      // Of the two ends of the same line, the nearer one.
      distance += 1e-6 * point;
      if (distance < least) [best, least] = [stop, distance];
    });
  }
  return best;
}

// From a stop, or from the first, `count` points on along its series.
export function stepped(plot, shown, from, count) {
  const series = shown.includes(from?.series) ? from.series : shown[0];
  if (!series) return null;
  const size = sizeOf(plot);
  // Of a band along one edge only.
  const list = stops(plot, series)
    .slice(0, (series.x ?? series.y).length)
    .filter((stop) => stop && isIn(stop, size));
  if (list.length === 0) return null;
  const now = list.findIndex((stop) => stop.entry === from?.entry && series === from.series);
  return list[now < 0 ? 0 : Math.min(Math.max(now + count, 0), list.length - 1)];
}

// The point of the next or last series that is nearest to a stop.
export function besides(plot, shown, from, count) {
  const now = shown.indexOf(from?.series);
  const series = shown[(now + count + shown.length) % shown.length];
  if (!from || !series) return stepped(plot, shown, null, 0);
  return nearest(plot, [series], from.x, from.y);
}
