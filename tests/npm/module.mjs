// The module: results, faults as data, files, and the loader of browsers.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

export async function tryModule({ check, home, root }) {
  const { DashpadFaults, loadEngine } = await import(pathToFileURL(join(home, "node.mjs")));
  const engine = await loadEngine();
  const text = readFileSync(join(root, "examples/dashboard-20mph.toml"), "utf8");
  const faultsOf = (ask) => {
    try {
      ask();
    } catch (error) {
      check(error instanceof DashpadFaults, `no faults: ${error}`);
      return error.faults ?? [];
    }
    check(false, `not refused: ${ask}`);
    return [];
  };

  const result = engine.solve(text);
  check(result.status === "released" && Math.abs(result.peak_acceleration_g - 129.4) < 0.1, `another result: ${result.peak_acceleration_g}`);
  check(result.intervals !== null && engine.solve(text, { intervals: false }).intervals == null, "the option intervals does nothing");
  const thicker = engine.solve(text, { settings: { "pad.thickness": "2 in" } });
  check(thicker.peak_acceleration_g < result.peak_acceleration_g, "a setting does nothing");
  const same = engine.solve(text, { settings: ["pad.thickness=2 in"] });
  check(thicker.peak_force_N === same.peak_force_N, "settings as a list differ from those as an object");
  check(engine.solve(text.replaceAll("\n", "\r\n")).peak_force_N === result.peak_force_N, "CRLF changes the result");
  const tables = { impactor: { mass: "5 kg", radius: "80 mm", speed: "5 m/s" }, pad: { thickness: "30 mm", material: "vn600" }, support: { type: "rigid" } };
  const of_tables = engine.solve(tables);
  check(of_tables.peak_force_N > 0, "tables have no result");
  check(engine.solve(tables, { settings: ["pad.thickness=30 mm"] }).peak_force_N === of_tables.peak_force_N, "tables with settings differ");
  check(engine.assess(text, { standard: "en-1177" }).verdict === "fail", "another verdict");
  check(engine.assess(text, { standard: "en-1177", dropHeight: "1.5 m" }).verdict === "pass", "another verdict from 1.5 m");
  const turns = engine.solveFor("pad.thickness", text, { standard: "fmvss-201-instrument-panel" }).turns;
  check(turns.length === 1 && Math.abs(turns[0].value - 0.01563) < 1e-4, `turns elsewhere: ${JSON.stringify(turns)}`);
  const slower = engine.solveFor("pad.thickness", text, { standard: "fmvss-201-instrument-panel", speed: "6.5 m/s" }).turns;
  check(slower[0]?.value < turns[0].value, `a lower speed needs no thinner pad: ${JSON.stringify(slower)}`);
  for (const mistake of [{ setings: [] }, { dropheight: "1 m" }, { units: "metric" }]) {
    try {
      engine.solve(text, mistake);
      check(false, `${JSON.stringify(mistake)} is taken`);
    } catch (error) {
      check(error instanceof TypeError, `another error: ${error}`);
    }
  }
  check(engine.check(text).case !== undefined, "check shows no case");
  check(/^<!doctype html>/i.test(engine.page(text)), "the page is none");
  check(engine.text(text, { units: "us" }).includes("lbf"), "the text has other units");
  check(engine.materials().some(({ name }) => name === "vn600") && engine.standards().some(({ name }) => name === "en-1177"), "lists are empty");

  const [fault] = faultsOf(() => engine.solve(text.replace("thickness", "thicknes"), { file: "pads/drop.toml" }));
  check(fault?.file === "pads/drop.toml" && fault.line > 0 && fault.key.includes("thicknes") && fault.rule && fault.text, `another fault: ${JSON.stringify(fault)}`);
  faultsOf(() => engine.solve(tables, { standard: "no-such" }));
  faultsOf(() => engine.solve({ pad: { thickness: "1 kg" } }));
  faultsOf(() => engine.solveFor("pad.thicknes", text, { standard: "en-1177" }));

  const card = readFileSync(join(root, "materials/vn600.toml"));
  const named = { ...tables, pad: { thickness: "30 mm", material: "mine.toml" } };
  faultsOf(() => engine.solve(named));
  check(engine.solve(named, { files: { "mine.toml": card } }).peak_force_N === of_tables.peak_force_N, "a card of the host differs");
  engine.addFile("materials/mine.toml", card);
  check(engine.materials().some(({ name }) => name === "mine"), "an added card is not listed");

  const browser = await import(pathToFileURL(join(home, "browser.mjs")));
  const packed = readFileSync(join(home, "engine.wasm.gz"));
  const own = globalThis.fetch;
  globalThis.fetch = async () => new Response(packed);
  const in_browser = await browser.loadEngine();
  globalThis.fetch = own;
  check(in_browser.solve(text).peak_force_N === result.peak_force_N, "the loader of browsers gives another result");
  for (const name of ["browser.mjs", "dashpad.mjs", "engine.mjs"])
    check(!/["']node:/.test(readFileSync(join(home, name), "utf8")), `${name} needs node`);
}
