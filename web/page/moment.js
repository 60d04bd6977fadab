// The moment that the reader points at: an entry of the history, the same in all plots that know time.

const listeners = [];

export function onMoment(listener) {
  listeners.push(listener);
}

// `entry` is null when the reader points at nothing.
export function point(entry, source) {
  for (const listener of listeners) listener(entry, source);
}
