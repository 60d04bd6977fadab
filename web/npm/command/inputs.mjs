// Brings what a case names from the disk into the engine.
import fs from "node:fs";
import path from "node:path";
import { diskPath, engineFolder, enginePath } from "./paths.mjs";

// More than the engine takes of a file; it says so itself.
const longest = 16 * 1024 * 1024 + 1;

const words = {
  EACCES: "Permission denied",
  EPERM: "Operation not permitted",
  ENOENT: "No such file or directory",
  ENOTDIR: "Not a directory",
  ENOSPC: "No space left on device",
  EROFS: "Read-only file system",
  EFBIG: "File too large",
  EIO: "Input/output error",
};
export const reason = (error) => words[error.code] ?? error.code ?? error.message;

function contentOf(descriptor) {
  const pieces = [];
  for (let length = 0; length < longest; ) {
    const piece = Buffer.alloc(1 << 16);
    let count;
    try {
      count = fs.readSync(descriptor, piece);
    } catch (error) {
      if (error.code === "EOF") break; // the end of standard input on Windows
      if (error.code !== "EAGAIN") throw error;
      Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 10);
      continue;
    }
    if (count === 0) break;
    pieces.push(piece.subarray(0, count));
    length += count;
  }
  return Buffer.concat(pieces);
}

// Streams are read only if the command line names them: a name in a file must not make the program wait.
function addFile(engine, name, disk, mayBeStream) {
  let descriptor;
  try {
    const state = fs.statSync(disk, { throwIfNoEntry: false });
    if (!state) return;
    if (state.isDirectory()) return engine.refuseFile(name, "is a folder; a file is needed");
    if (!state.isFile() && !(mayBeStream && state.isFIFO())) return engine.refuseFile(name, "is not a regular file");
    descriptor = fs.openSync(disk, "r");
    engine.addFile(name, contentOf(descriptor));
  } catch (error) {
    if (error.code !== "ENOENT" && error.code !== "ENOTDIR") engine.refuseFile(name, `cannot be read: ${reason(error)}`);
  } finally {
    if (descriptor !== undefined) fs.closeSync(descriptor);
  }
}

// A file of the command line; - is standard input. Its name in the engine.
export function addGiven(engine, given) {
  const name = enginePath(given, path);
  if (given === "-") {
    try {
      engine.addFile(name, contentOf(0));
    } catch (error) {
      engine.refuseFile(name, `cannot be read: ${reason(error)}`);
    }
  } else {
    addFile(engine, name, given, true);
  }
  return name;
}

// The .toml files of a folder, which is `kind` of "materials" or "standards". Its name in the engine.
export function addFolder(engine, given, kind) {
  const folder = engineFolder(given, path);
  try {
    for (const file of fs.readdirSync(given).sort())
      if (file.endsWith(".toml")) addFile(engine, `${folder}/${file}`.replace("//", "/"), path.join(given, file), false);
  } catch (error) {
    engine.refuseFile(folder, `is not a readable folder of ${kind}: ${reason(error)}`);
  }
  return folder;
}

// The answer to a request, after what it has looked for was added if the disk has it.
export function askWithFiles(engine, request) {
  const tried = new Set();
  for (;;) {
    const answer = engine.ask(request);
    const names = engine.missingFiles().filter((name) => !tried.has(name));
    if (names.length === 0) return answer;
    for (const name of names) {
      tried.add(name);
      addFile(engine, name, diskPath(name, path), false);
    }
  }
}
