// The part of a line from one point to another that lies in a box; null if none does (Liang and Barsky).
export function clipped(from, to, { left, right, low, high }) {
  const [x, y] = from;
  const [toX, toY] = to;
  let begin = 0;
  let end = 1;
  for (const [move, room] of [
    [x - toX, x - left],
    [toX - x, right - x],
    [y - toY, y - low],
    [toY - y, high - y],
  ]) {
    if (move === 0) {
      if (room < 0) return null;
    } else if (move < 0) begin = Math.max(begin, room / move);
    else end = Math.min(end, room / move);
  }
  if (begin > end) return null;
  // An end that is not cut is the same array as before.
  const at = (part) => [x + part * (toX - x), y + part * (toY - y)];
  return [begin === 0 ? from : at(begin), end === 1 ? to : at(end)];
}
