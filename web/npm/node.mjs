// The package in node: the engine lies beside this file.
import { readFile } from "node:fs/promises";
import { engineFrom } from "./dashpad.mjs";

export { DashpadFaults, Engine } from "./dashpad.mjs";

export async function loadEngine({ wasm, files } = {}) {
  return engineFrom(wasm ?? (await readFile(new URL("engine.wasm.gz", import.meta.url))), files);
}
