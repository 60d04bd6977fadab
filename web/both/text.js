// Elements with text, and numbers as text. Text of a user only ever becomes text.

export function element(name, { text, className, attributes = {} } = {}, ...children) {
  const made = document.createElement(name);
  if (className) made.className = className;
  if (text !== undefined) made.textContent = text;
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

// Five digits; what is nothing but rounding beside `scale` is 0.
export function number(value, scale = 0) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (Math.abs(value) <= 1e-7 * scale) return "0";
  if (Math.abs(value) >= 1e4 && Math.abs(value) < 1e7) return value.toFixed(0);
  return Math.abs(value) >= 1e7 ? value.toExponential(4) : String(Number(value.toPrecision(5)));
}

// Ticks of an axis: as many decimals as their distance needs, in every language alike.
export function ticks(plot, splits, axis, space, distance) {
  const isWhole = (value) => Math.abs(value - Math.round(value)) < 1e-6;
  const shown = splits.filter((split) => split !== null);
  if (distance < 1e-4 || shown.some((split) => Math.abs(split) >= 1e7))
    return splits.map((split) => (split === null ? "" : exponential(split, distance)));
  let decimals = 0;
  while (decimals < 9 && !isWhole(distance * 10 ** decimals)) ++decimals;
  return splits.map((split) => (split === null ? "" : split.toFixed(decimals)));
}

// What is nothing but rounding beside the distance of two ticks is 0.
function exponential(split, distance) {
  if (Math.abs(split) < 1e-6 * distance) return "0";
  return Number(split.toPrecision(10)).toExponential().replace("e+", "e");
}

export function percent(fraction) {
  return fraction === null ? "unknown" : `${Number((100 * fraction).toPrecision(2))} %`;
}
