// Compares the engine of the live page in node with the command: node run.mjs ENGINE.wasm DASHPAD ROOT
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { startEngine } from "../../web/engine/engine.mjs";
import { differences } from "./differences.mjs";

const [wasm, dashpad, root] = process.argv.slice(2);
const module = await WebAssembly.compile(readFileSync(wasm));
const engine = startEngine(module);

let failures = 0;
const fail = (text) => {
  console.log(text);
  failures += 1;
};

// A text that does not depend on the order of keys.
function sorted(value) {
  if (Array.isArray(value)) return `[${value.map(sorted)}]`;
  if (value === null || typeof value !== "object") return JSON.stringify(value);
  return `{${Object.keys(value).sort().map((key) => `${key}:${sorted(value[key])}`)}}`;
}

function command(...words) {
  try {
    return execFileSync(dashpad, words, { cwd: root, encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] });
  } catch (error) {
    return error.stdout;
  }
}

for (const name of readdirSync(join(root, "examples")).filter((name) => name.endsWith(".toml"))) {
  const file = `examples/${name}`;
  const read = engine.ask({ do: "read", text: readFileSync(join(root, file), "utf8") });
  if (!read.case) { fail(`${name}: ${JSON.stringify(read)}`); continue; }
  const solved = engine.ask({ do: "solve", case: read.case, units: "si", intervals: true });
  if (!solved.result) { fail(`${name}: ${JSON.stringify(solved)}`); continue; }
  const theirs = JSON.parse(command("run", file, "--json", "-"));
  for (const each of differences(solved.result, theirs).slice(0, 5)) fail(`${name}: ${each}`);
  const again = engine.ask({ do: "read", text: solved.toml });
  if (sorted(again.case) !== sorted(read.case)) fail(`${name}: the case as TOML reads differently`);
}
const refused = engine.ask({ do: "solve", case: { pad: { thicknes: "1 in" } }, units: "si" });
if (!refused.faults?.length) fail(`not refused: ${JSON.stringify(refused)}`);
console.log(failures === 0 ? "The engine gives the bits of the command on all examples." : `${failures} failures`);
process.exitCode = failures === 0 ? 0 : 1;
