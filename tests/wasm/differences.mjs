// How results of the engine may differ from those of the command.

// Both solve by the same operations, but round them differently, and a step that one of them divides the other may take
// whole: figures then differ by some hundredths of their numerical error, and ends of intervals, which are solved to 1e-3,
// by more. Errors, and energies that are differences of others, are not compared.
function allowed(path) {
  if (/error|residual|wall_time|seconds|steps|program|energy|_fraction/.test(path)) return Infinity;
  return /intervals|flags/.test(path) ? 1e-3 : 1e-5;
}

// Figures that differ by more than they may, and the largest difference of the others.
export function differences(ours, theirs, path = "", found = { texts: [], largest: 0 }) {
  if (typeof ours === "number" && typeof theirs === "number") {
    const difference = ours === theirs ? 0 : Math.abs(ours - theirs) / Math.max(Math.abs(ours), Math.abs(theirs));
    if (difference > allowed(path)) found.texts.push(`${path}: ${ours} and ${theirs}`);
    if (!/intervals|flags/.test(path) && allowed(path) < 1) found.largest = Math.max(found.largest, difference);
  } else if (ours && theirs && typeof ours === "object" && typeof theirs === "object") {
    for (const key of new Set([...Object.keys(ours), ...Object.keys(theirs)]))
      differences(ours[key], theirs[key], `${path}.${key}`, found);
  } else if (ours !== theirs && allowed(path) < 1 && !/text$/.test(path)) {
    found.texts.push(`${path}: ${ours} and ${theirs}`);
  }
  return found;
}
