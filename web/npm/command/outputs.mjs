// Files that the command writes, complete or not at all and never over others unasked, and the standard streams.
import fs from "node:fs";
import path from "node:path";
import { reason } from "./inputs.mjs";

// Writes all of a text. Whoever has closed the pipe wants no more of it.
function writeAll(descriptor, text) {
  const bytes = Buffer.from(text);
  for (let done = 0; done < bytes.length; ) {
    try {
      done += fs.writeSync(descriptor, bytes, done);
    } catch (error) {
      if (error.code === "EPIPE" || error.code === "EOF") return;
      if (error.code !== "EAGAIN") throw error;
      Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 10);
    }
  }
}

const withoutControls = (text) => text.replace(/[\u0000-\u0008\u000b-\u001f\u007f-\u009f]/g, "\ufffd");

function writeToOutput(text) {
  try {
    writeAll(1, text);
  } catch (error) {
    throw new Error(`could not write to standard output: ${reason(error)}`);
  }
}

// Text for people, and data for programs.
export const writeOutput = (text) => writeToOutput(withoutControls(text));
export const writeResult = (text) => (process.stdout.isTTY ? writeOutput(text) : writeToOutput(text));
export function writeError(text) {
  try {
    writeAll(2, withoutControls(text));
  } catch {
    // Nobody is left to be told.
  }
}

const stateOf = (file) => fs.statSync(file, { throwIfNoEntry: false, bigint: true });
const isSameState = (one, other) => one && other && one.ino !== 0n && one.ino === other.ino && one.dev === other.dev;

// The path without links, even if the file does not exist.
function placeOf(file) {
  try {
    return fs.realpathSync(file);
  } catch {
    const whole = path.resolve(file);
    const folder = path.dirname(whole);
    return folder === whole ? whole : path.join(placeOf(folder), path.basename(whole));
  }
}

const isSameFile = (one, other) => isSameState(stateOf(one), stateOf(other)) || placeOf(one) === placeOf(other);

function streamInto(file) {
  const state = stateOf(file);
  if (!state?.isFile()) return "";
  for (const [descriptor, name] of [[1, "standard output"], [2, "standard error"]]) {
    try {
      if (isSameState(state, fs.fstatSync(descriptor, { bigint: true }))) return name;
    } catch {
      // A stream that is closed leads nowhere.
    }
  }
  return "";
}

const isDevice = (state) => state && !state.isFile() && !state.isDirectory();

// Why a target cannot be written; empty if it can.
function complaint(file, force) {
  const state = stateOf(file);
  if (state?.isDirectory() || /[\\/]$/.test(path.sep === "\\" ? file : file.replaceAll("\\", "")))
    return "is a folder; give the name of a file";
  if (isDevice(state)) return "";
  if (!force && fs.lstatSync(file, { throwIfNoEntry: false }))
    return "already exists; choose another name, or use --force to overwrite it";
  const folder = path.dirname(file);
  if (!stateOf(folder)?.isDirectory()) return `there is no folder ${folder}`;
  try {
    fs.accessSync(folder, fs.constants.W_OK | fs.constants.X_OK);
  } catch (error) {
    return `cannot create a file in ${folder}: ${reason(error)}`;
  }
  return "";
}

// What forbids writing to targets, [{option, file}]; `inputs` are [{kind, file}].
export function judgeTargets(targets, inputs, force) {
  const errors = [];
  targets.forEach(({ option, file }, place) => {
    const say = (what) => errors.push(`${option} ${file}: ${what}`);
    for (const earlier of targets.slice(0, place)) {
      if (file === "-" && earlier.file === "-") say("only one result can go to standard output");
      else if (file !== "-" && earlier.file !== "-" && isSameFile(file, earlier.file))
        say(`is also given for ${earlier.option}; choose another name`);
    }
    if (file === "-") return;
    const input = inputs.find((each) => isSameFile(file, each.file));
    const stream = streamInto(file);
    if (input) say(`is ${input.kind}; choose another name`);
    else if (stream) say(`is where ${stream} is redirected; choose another name`);
    else if (complaint(file, force)) say(complaint(file, force));
  });
  return errors;
}

// Gives the draft the name of the target, without force only if it is free.
function rename(draft, target, force) {
  if (force) return fs.renameSync(draft, target);
  try {
    fs.linkSync(draft, target);
  } catch (error) {
    if (error.code === "EEXIST") throw error;
    fs.copyFileSync(draft, target, fs.constants.COPYFILE_EXCL); // a disk without links
  }
  fs.unlinkSync(draft);
}

function writeDraft(draft, text) {
  const descriptor = fs.openSync(draft, "wx", 0o666);
  try {
    writeAll(descriptor, text);
    fs.fsyncSync(descriptor);
  } finally {
    fs.closeSync(descriptor);
  }
}

// Writes the files, [{file, text}], then the text for people; that goes to standard error if a result goes to standard
// output.
export function publish(results, force, summary) {
  const drafts = [];
  let file;
  try {
    for (const result of results.filter((each) => each.file !== "-")) {
      file = result.file;
      if (isDevice(stateOf(file))) {
        drafts.push({ file, publish: () => fs.writeFileSync(result.file, result.text) });
        continue;
      }
      const target = force ? placeOf(file) : file;
      const draft = path.join(path.dirname(target), `.dashpad-${process.pid}-${drafts.length}.part`);
      drafts.push({ file, draft, publish: () => rename(draft, target, force) });
      writeDraft(draft, result.text);
      if (force && stateOf(target)) fs.chmodSync(draft, fs.statSync(target).mode & 0o7777);
    }
    for (const each of drafts) {
      file = each.file;
      each.publish();
      each.draft = undefined;
    }
  } catch (error) {
    if (error.code !== "EPIPE") throw new Error(`could not write ${file}: ${reason(error)}`);
  } finally {
    for (const { draft } of drafts) if (draft) fs.rmSync(draft, { force: true });
  }
  const output = results.find((each) => each.file === "-");
  if (!output) return writeOutput(summary);
  writeError(summary);
  writeResult(output.text);
}
