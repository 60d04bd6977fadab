// The package in a browser: the engine is fetched from beside this file, or from where the caller says.
import { engineFrom } from "./dashpad.mjs";

export { DashpadFaults, Engine } from "./dashpad.mjs";

export async function loadEngine({ wasm = new URL("engine.wasm.gz", import.meta.url), files } = {}) {
  if (!(wasm instanceof URL) && typeof wasm !== "string") return engineFrom(wasm, files);
  const response = await fetch(wasm);
  if (!response.ok) throw new Error(`${wasm}: ${response.status} ${response.statusText}`);
  return engineFrom(await response.arrayBuffer(), files);
}
