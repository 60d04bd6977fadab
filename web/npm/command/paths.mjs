// Names of files as the engine and the system know them. The engine has slashes alone and takes only names that begin with
// one for absolute. `path` is node's own, or in tests path.win32.

const isWindows = (path) => path.sep === "\\";

export function enginePath(name, path) {
  return isWindows(path) ? name.replaceAll("\\", "/") : name;
}

// What the engine looks for: to a name in a case it has joined the folder of that case, also to D:\pads\foam.toml or
// \\server\pads\foam.toml.
export function diskPath(name, path) {
  if (!isWindows(path)) return name;
  const whole = /^.*[\\/]([A-Za-z]:[\\/].*)$/s.exec(name) ?? /^.+?[\\/](\\\\[^\\/].*)$/s.exec(name);
  return path.normalize(whole ? whole[1] : name);
}

// A folder without the slashes at its end, so that names of files follow with one.
export function engineFolder(name, path) {
  const folder = enginePath(name, path);
  return folder.replace(/(?<=[^/:])\/+$/, "");
}
