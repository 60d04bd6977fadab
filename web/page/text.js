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
  let decimals = 0;
  while (decimals < 9 && !isWhole(distance * 10 ** decimals)) ++decimals;
  return splits.map((split) => (split === null ? "" : split.toFixed(decimals)));
}

// Of a logarithmic axis only the decades have a tick.
export function decades(plot, splits) {
  return splits.map((split) => (Math.abs(Math.log10(split) - Math.round(Math.log10(split))) < 1e-9 ? split : null));
}

export function decadeTicks(plot, splits) {
  return splits.map((split) => (split === null ? "" : String(Number(split.toPrecision(1)))));
}

export function percent(fraction) {
  return fraction === null ? "unknown" : `${Number((100 * fraction).toPrecision(2))} %`;
}
