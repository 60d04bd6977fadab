// The engine as objects and exceptions; without access to files, so that browsers run it, too.
import { needArgument, needOptions } from "./arguments.mjs";
import { startEngine } from "./engine.mjs";

// Input that cannot be computed. `faults` has each as data, `lines` as the command shows them.
export class DashpadFaults extends Error {
  constructor({ faults, lines }) {
    super(lines.join("\n"));
    this.name = "DashpadFaults";
    this.faults = faults;
    this.lines = lines;
  }
}

// A module from its bytes, packed by gzip or not: some servers unpack it on the way.
async function compiled(source) {
  if (source instanceof WebAssembly.Module) return source;
  if (!(source instanceof ArrayBuffer) && !ArrayBuffer.isView(source)) throw new TypeError("wasm must be a compiled module or its bytes");
  let bytes = new Uint8Array(source);
  if (bytes[0] === 0x1f && bytes[1] === 0x8b) {
    const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    bytes = await new Response(unpacked).arrayBuffer();
  }
  return WebAssembly.compile(bytes);
}

export async function engineFrom(source, files) {
  return new Engine(await compiled(source), files);
}

function settingsOf(settings = []) {
  return Array.isArray(settings) ? settings : Object.entries(settings).map(([key, value]) => `${key}=${value}`);
}

// Options that are numbers: their names in requests, and the units of numbers without one.
const quantities = {
  tolerance: ["tolerance", ""],
  mass: ["mass", "kg"],
  radius: ["radius", "m"],
  speed: ["speed", "m/s"],
  dropHeight: ["drop_height", "m"],
};

export class Engine {
  #module;
  #core;
  #added = []; // calls that an engine which is started anew needs again

  constructor(module, files = {}) {
    this.#module = module;
    needArgument("files", "files", files);
    for (const [name, content] of Object.entries(files)) this.addFile(name, content);
  }

  #do(what, ...words) {
    this.#core ??= this.#started();
    return this.#core[what](...words);
  }

  #started() {
    const core = startEngine(this.#module);
    for (const [what, ...words] of this.#added) core[what](...words);
    return core;
  }

  #add(what, name, text) {
    this.#do(what, name, text);
    this.#added = [...this.#added.filter(([, known]) => known !== name), [what, name, text]];
  }

  // A file that a case may name, or a card ("materials/NAME.toml") or standard ("standards/NAME.toml"): text or bytes.
  addFile(name, content) {
    needArgument("the name of a file", "name", name);
    needArgument(`the file "${name}"`, "content", content);
    this.#add("addFile", name, content);
  }

  // A file or folder that is there and cannot be read, and why.
  refuseFile(name, why) {
    this.#add("refuseFile", name, why);
  }

  // The files that answers have looked for in vain since the last call.
  missingFiles() {
    return this.#do("missingFiles");
  }

  // A request of src/live/command.hpp. After an answer that ended the engine, the next one has a new engine.
  ask(request) {
    try {
      return this.#do("ask", request);
    } catch (error) {
      this.#core = undefined;
      throw error;
    }
  }

  #answer(request) {
    const answer = this.ask(request);
    if (answer.faults) throw new DashpadFaults(answer);
    return answer;
  }

  // Which of some words one that is unknown may mean, in the words of the native command.
  meant(word, words) {
    return this.#answer({ do: "spell", word, words }).text;
  }

  // What requests about a case have in common. A text is a case file, called `file`; an object has its tables.
  #request(what, given, options = {}) {
    needArgument("the case", "case", given);
    needOptions(what, options, (word, words) => this.meant(word, words));
    const request = {
      do: what,
      set: settingsOf(options.settings),
      units: options.units ?? "si",
      intervals: options.intervals ?? true,
      others: true,
      standard: options.standard ?? "",
      keep_nose: options.keepNose ?? false,
      keep_speed: options.keepSpeed ?? false,
    };
    // As texts they are judged as those of the command; the engine takes one that is empty for none.
    for (const [key, [name, unit]] of Object.entries(quantities)) {
      const value = options[key];
      if (value !== undefined) request[name] = typeof value === "number" ? `${value} ${unit}`.trim() : value || " ";
    }
    for (const [name, content] of Object.entries(options.files ?? {})) this.addFile(name, content);
    if (typeof given !== "string") return { ...request, case: given };
    const file = options.file ?? "case.toml";
    this.addFile(file, given);
    return { ...request, file };
  }

  #written(what, name, given, options, more = {}) {
    return this.#answer({ ...this.#request(what, given, options), ...more, write: [name] }).written[name];
  }

  // As `dashpad run --json`, or with a standard as `dashpad assess --json`.
  solve(given, options) {
    return JSON.parse(this.#written("solve", "json", given, options));
  }

  assess(given, options) {
    if (!options?.standard) throw new TypeError("assess needs a standard");
    return this.solve(given, options);
  }

  // As `dashpad solve-for --json`.
  solveFor(key, given, options) {
    needArgument("the key", "text", key);
    const until = [options?.until ?? []].flat();
    if (!options?.standard && until.length === 0) throw new TypeError("solveFor needs a standard or until");
    return JSON.parse(this.#written("solve-for", "json", given, options, { key, until }));
  }

  // How the case is read: as `dashpad check --json`.
  check(given, options) {
    return JSON.parse(this.#written("check", "json", given, options));
  }

  // The page of the answer as one HTML file, or its text as on a terminal.
  page(given, options) {
    return this.#written("solve", "page", given, options);
  }
  text(given, options) {
    return this.#written("solve", options?.all ? "all" : "text", given, options);
  }

  materials() {
    return this.#answer({ do: "list" }).foams;
  }

  standards() {
    return this.#answer({ do: "list" }).standards;
  }
}
