// How results of the engine differ from those of the command, which does the same operations and rounds them alike.

/** Where two results are not the same, beside the seconds they took. */
export function differences(ours, theirs, path = "") {
  if (ours && theirs && typeof ours === "object" && typeof theirs === "object") {
    const keys = new Set([...Object.keys(ours), ...Object.keys(theirs)]);
    return [...keys].flatMap((key) => differences(ours[key], theirs[key], `${path}.${key}`));
  }
  return ours === theirs || /wall_time|seconds|program/.test(path) ? [] : [`${path}: ${ours} and ${theirs}`];
}
