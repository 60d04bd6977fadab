// The command: its words, files and exit codes are those of the native one.
import { readFileSync } from "node:fs";
import path from "node:path";
import { gunzipSync } from "node:zlib";
import { Engine } from "../dashpad.mjs";
import { help, helpOf } from "./help.mjs";
import { addFolder, addGiven, askWithFiles } from "./inputs.mjs";
import { commands, Misread, native_commands, parsed } from "./options.mjs";
import { judgeTargets, publish, writeError, writeOutput, writeResult } from "./outputs.mjs";
import { diskPath } from "./paths.mjs";

const exit_done = 0, exit_failed = 1, exit_refused = 2;

// Thrown for input or a command line that is refused; `count` is more than there are lines if these are abridged.
class Refused extends Error {
  constructor(lines, count = lines.length) {
    super("refused");
    Object.assign(this, { lines, count });
  }
}

const beside = (name) => readFileSync(new URL(`../${name}`, import.meta.url));

// The compiler of node makes better code while the engine runs already; to wait for it takes longer than most cases.
const startedEngine = () => new Engine(new WebAssembly.Module(gunzipSync(beside("engine.wasm.gz"))));

function misread(text) {
  writeError(`${text}\nRun with --help for more information.\n`);
  return exit_refused;
}

function advice(word) {
  const names = Object.keys(commands);
  if (word === undefined) return `no command given; available: ${names.join(", ")}`;
  if (native_commands.includes(word)) return `${word}: is not in this package, which has ${names.join(", ")}; the native command has it`;
  if (word.endsWith(".toml")) return `${word}: is not a command; to solve this case: dashpad run ${word}`;
  if (word.startsWith("-")) return `${word}: is not accepted before a command; the commands are ${names.join(", ")}`;
  return `${word}: no such command${startedEngine().meant(word, names)}`;
}

function version() {
  const { version: number } = JSON.parse(beside("package.json"));
  return `dashpad ${number}\n  engine      WebAssembly, node ${process.versions.node}\n  system      ${process.platform} ${process.arch}\n`;
}

const targetsOf = (given) =>
  ["--json", "--report", "--markdown"].filter((option) => typeof given[option] === "string").map((option) => ({ option, file: given[option] }));
const format_of = { "--json": "json", "--report": "page", "--markdown": "markdown" };

// What the options of all commands say to the engine. Its folders are those of the options or of the environment.
function requestOf(what, given, engine) {
  const request = { do: what, units: given["--units"] ?? "si" };
  for (const kind of ["materials", "standards"]) {
    const folder = given[`--${kind}`] ?? process.env[`DASHPAD_${kind.toUpperCase()}`];
    if (folder) request[kind] = addFolder(engine, folder, kind);
  }
  return request;
}

function caseRequest(what, given, engine) {
  const request = requestOf(what, given, engine);
  request.file = addGiven(engine, given.CASE);
  request.set = given["--set"] ?? [];
  request.intervals = !given["--no-intervals"];
  request.others = true;
  request.standard = given["--standard"]?.[0] ?? "";
  for (const option of ["--mass", "--radius", "--speed", "--drop-height"])
    if (given[option] !== undefined) request[option.slice(2).replace("-", "_")] = given[option];
  request.keep_nose = given["--keep-nose"] ?? false;
  request.keep_speed = given["--keep-speed"] ?? false;
  request.tolerance = given["--tolerance"];
  request.until = given["--until"];
  return request;
}

// Faults of the command line that the engine does not see.
function complaintsOf(name, given) {
  const errors = [];
  if (given["--speed"] && given["--drop-height"]) errors.push("--drop-height: give either --speed or --drop-height, not both");
  if (given["--keep-nose"] && given["--radius"]) errors.push("--keep-nose: give either --keep-nose or --radius, not both");
  if (given["--keep-speed"] && (given["--speed"] || given["--drop-height"]))
    errors.push(`--keep-speed: give either --keep-speed or ${given["--speed"] ? "--speed" : "--drop-height"}, not both`);
  if (given["--standard"]?.length > 1) errors.push("--standard: this package takes one standard; the native command takes several, as a test plan");
  if (name === "solve-for" && !given["--standard"] && !given["--until"]) errors.push("no limit: give --standard or --until");
  return errors;
}

function refuseIf(errors, answer = {}) {
  const lines = [...errors, ...(answer.lines ?? [])];
  if (lines.length > 0) throw new Refused(lines, errors.length + (answer.faults?.length ?? 0));
}

const inputsOf = (answer) => (answer.files ?? []).filter(({ file }) => file !== "-").map(({ kind, file }) => ({ kind, file: diskPath(file, path) }));

// Asks what nothing forbids to write, and writes it.
function answered(engine, request, given, heading = () => "", code = (answer) => answer.code ?? exit_done) {
  const targets = targetsOf(given);
  const text = given["--all"] || commands[request.do]?.only_looks ? "all" : "text";
  const answer = askWithFiles(engine, { ...request, write: [text, ...targets.map(({ option }) => format_of[option])] });
  if (answer.faults) {
    if (answer.written) writeOutput(heading(answer) + (answer.written[text] ?? answer.written.text));
    refuseIf([], answer);
  }
  const results = targets.map(({ option, file }) => ({ file, text: answer.written[format_of[option]] }));
  publish(results, given["--force"], heading(answer) + (answer.written[text] ?? answer.written.text));
  return code(answer);
}

function solveCase(name, given, engine) {
  const errors = complaintsOf(name, given);
  const request = caseRequest(name === "solve-for" ? "solve-for" : "solve", given, engine);
  const key = name === "solve-for" ? { key: given.KEY } : {};
  const read = askWithFiles(engine, { ...request, do: "check" });
  const inputs = read.faults ? [{ kind: "the case file", file: given.CASE }] : inputsOf(read);
  const forbidden = judgeTargets(targetsOf(given), inputs, given["--force"]);
  if (errors.length > 0 || read.faults || forbidden.length > 0)
    throw new Refused([...errors, ...(read.lines ?? []), ...forbidden], errors.length + (read.faults?.length ?? 0) + forbidden.length);
  return answered(engine, { ...request, ...key }, given);
}

function check(given, engine) {
  const answer = askWithFiles(engine, caseRequest("check", given, engine));
  if (given["--json"]) writeResult(answer.written.json);
  else if (answer.faults) refuseIf([], answer);
  else writeOutput(answer.written.text);
  return answer.faults ? exit_refused : exit_done;
}

function materials(given, engine) {
  const request = { ...requestOf("materials", given, engine), name: given.NAME ?? "" };
  if (request.name.endsWith(".toml")) request.name = addGiven(engine, request.name);
  const read = askWithFiles(engine, { ...request, write: [] });
  refuseIf(judgeTargets(targetsOf(given), inputsOf(read), given["--force"]));
  return answered(engine, request, given, (answer) => answer.heading ?? "");
}

function standards(given, engine) {
  const request = { ...requestOf("standards", given, engine), standard: given.NAME ?? "" };
  if (!given.NAME && targetsOf(given).length > 0) throw new Refused(["--report, --markdown: apply to a single preset; give its NAME"]);
  const read = askWithFiles(engine, { ...request, write: [] });
  refuseIf(judgeTargets(targetsOf(given), inputsOf(read), given["--force"]));
  return answered(engine, request, given);
}

function perform(name, given) {
  const empty = Object.entries(given).filter(([, values]) => [values].flat().includes(""));
  if (empty.length > 0) throw new Refused(empty.map(([option]) => `${option}: must not be empty`));
  const engine = startedEngine();
  if (name === "check") return check(given, engine);
  if (name === "materials") return materials(given, engine);
  if (name === "standards") return standards(given, engine);
  return solveCase(name, given, engine);
}

export async function main([name, ...words]) {
  try {
    if (name === "--help" || name === "-h") return writeOutput(help()), exit_done;
    if (name === "--version") return writeOutput(version()), exit_done;
    if (!Object.hasOwn(commands, name ?? "")) return misread(advice(name));
    const given = parsed(name, words);
    if (given.help) return writeOutput(helpOf(name)), exit_done;
    return perform(name, given);
  } catch (error) {
    if (error instanceof Misread) return misread(error.message);
    if (error instanceof Refused) {
      const would_run = !commands[name].only_looks;
      writeError(`${error.lines.slice(0, 200).map((line) => `${line}\n`).join("")}${error.lines.length > 200 ? "...\n" : ""}` +
        `${error.count} error${error.count === 1 ? "" : "s"}${would_run ? "; nothing was run" : ""}\n`);
      return exit_refused;
    }
    writeError(`dashpad: ${error.message}\n`);
    return exit_failed;
  }
}
