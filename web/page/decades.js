// Of a logarithmic axis only the decades have a tick.

export function decades(plot, splits) {
  return splits.map((split) => (Math.abs(Math.log10(split) - Math.round(Math.log10(split))) < 1e-9 ? split : null));
}

export function decadeTicks(plot, splits) {
  return splits.map((split) => (split === null ? "" : String(Number(split.toPrecision(1)))));
}
