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
  const own = engine.solveFor("pad.thickness", text, { until: "peak_acceleration <= 120 g", intervals: false }).turns;
  const both = engine.solveFor("pad.thickness", text, { until: ["peak_acceleration <= 120 g", "peak_penetration <= 1 m"], intervals: false }).turns;
  check(own.length === 1 && own[0].value > turns[0].value && own[0].value === both[0]?.value, `turns of own limits: ${JSON.stringify([own, both])}`);
  const stricter = engine.solveFor("pad.thickness", text, { until: "hic15 <= 1000", standard: "fmvss-201-instrument-panel", intervals: false }).turns;
  check(stricter[0]?.value > turns[0].value, `a limit beside a standard does nothing: ${JSON.stringify(stricter)}`);
  check(engine.solve(text, { tolerance: 1e-3 }).peak_force_N !== result.peak_force_N, "the option tolerance does nothing");
  const [of_number, of_text] = [1.5, "1.5 m"].map((dropHeight) => engine.assess(text, { standard: "en-1177", dropHeight }).result.peak_force_N);
  check(of_number > 0 && of_number === of_text, `a number is another height than its text: ${of_number}, ${of_text}`);

  // Mistakes of the program.
  const isTypeError = async (ask, words) => {
    try {
      await ask();
      check(false, `not refused: ${ask}`);
    } catch (error) {
      check(error instanceof TypeError && error.message.includes(words), `another error than "${words}" of ${ask}: ${error}`);
    }
  };
  for (const given of [12, null, undefined, true, [], Buffer.from(text), Promise.resolve(text), new Map()])
    for (const call of ["solve", "check", "page", "text"]) await isTypeError(() => engine[call](given), "the case must be the text of a case file or an object");
  for (const [mistake, words] of [[{ setings: [] }, 'did you mean "settings"?'], [{ dropheight: "1 m" }, 'did you mean "dropHeight"?'], [{ zz: 1 }, "available: all, dropHeight"],
    [{ units: "metric" }, "units must be"], [{ toString: 1 }, "unknown option"], [{ until: "hic15 <= 700" }, "unknown option"], [{ settings: "pad.thickness=2 in" }, "settings must be"],
    [{ settings: [1] }, "settings must be"], [{ settings: { "pad.thickness": null } }, "settings must be"], [{ tolerance: "1e-3" }, "tolerance must be a number"],
    [{ intervals: "no" }, "intervals must be true or false"], [{ standard: 1078 }, "standard must be a text"], [{ mass: true }, "mass must be a number in SI or a text"],
    [{ speed: null }, "speed must be"], [{ keepNose: 1 }, "keepNose must be"], [{ file: "" }, "file must be a text that is not empty"], [{ files: { "a.toml": 3 } }, "files must be"],
    [[], "the options must be an object"], [null, "the options must be an object"], ["us", "the options must be an object"]])
    await isTypeError(() => engine.solve(text, mistake), words);
  await isTypeError(() => engine.assess(text), "needs a standard");
  await isTypeError(() => engine.solveFor("pad.thickness", text, { until: [] }), "needs a standard or until");
  await isTypeError(() => engine.solveFor("pad.thickness", text, { until: [80] }), "until must be a text or a list of texts");
  await isTypeError(() => engine.solveFor(3, text, { standard: "en-1177" }), "the key must be a text");
  await isTypeError(() => engine.addFile("a.toml", 12), "must be a text or a Uint8Array");
  await isTypeError(() => engine.addFile(12, ""), "the name of a file must be");
  await isTypeError(() => loadEngine({ wasm: 12 }), "wasm must be");
  await isTypeError(() => loadEngine({ files: [] }), "files must be");
  check(engine.check(text).case !== undefined, "check shows no case");
  check(/^<!doctype html>/i.test(engine.page(text)), "the page is none");
  check(engine.text(text, { units: "us" }).includes("lbf"), "the text has other units");
  check(engine.materials().some(({ name }) => name === "vn600") && engine.standards().some(({ name }) => name === "en-1177"), "lists are empty");

  const [fault] = faultsOf(() => engine.solve(text.replace("thickness", "thicknes"), { file: "pads/drop.toml" }));
  check(fault?.file === "pads/drop.toml" && fault.line > 0 && fault.key.includes("thicknes") && fault.rule && fault.text, `another fault: ${JSON.stringify(fault)}`);
  faultsOf(() => engine.solve(tables, { standard: "no-such" }));
  faultsOf(() => engine.solve({ pad: { thickness: "1 kg" } }));
  faultsOf(() => engine.solveFor("pad.thicknes", text, { standard: "en-1177" }));
  const rule_is = (words, ask) => check(faultsOf(ask)[0]?.text.includes(words), `no fault "${words}" of ${ask}: ${JSON.stringify(faultsOf(ask))}`);
  for (const tolerance of [1, 0, -1, NaN, Infinity]) rule_is(`--tolerance ${tolerance}: must be a number from`, () => engine.solve(text, { tolerance }));
  for (const mass of [0, -1, NaN, Infinity, "5", "", "5 m", "heavy"]) rule_is("--mass ", () => engine.assess(text, { standard: "fmvss-201u", mass }));
  rule_is('did you mean "en-1078"', () => engine.assess(text, { standard: "EN 1078" }));
  rule_is('did you mean "vn600"', () => engine.solve({ ...tables, pad: { ...tables.pad, material: "VN 600" } }));
  rule_is('did you mean "hic15"', () => engine.solveFor("pad.thickness", text, { until: "HIC15 <= 700" }));
  rule_is("--until: = asks", () => engine.solveFor("pad.thickness", text, { until: "hic15 = 700", standard: "en-1177" }));
  for (const tables_of_faults of [{}, { pad: null }, { pad: 3 }, { ...tables, pad: { ...tables.pad, thickness: NaN } }, { ...tables, pad: { ...tables.pad, thickness: [3] } }])
    faultsOf(() => engine.solve(tables_of_faults));

  const card = readFileSync(join(root, "materials/vn600.toml"));
  const named = { ...tables, pad: { thickness: "30 mm", material: "mine.toml" } };
  faultsOf(() => engine.solve(named));
  check(engine.solve(named, { files: { "mine.toml": card } }).peak_force_N === of_tables.peak_force_N, "a card of the host differs");
  engine.addFile("materials/mine.toml", card);
  check(engine.materials().some(({ name }) => name === "mine"), "an added card is not listed");

  const browser = await import(pathToFileURL(join(home, "browser.mjs")));
  const packed = readFileSync(join(home, "engine.wasm.gz"));
  const fetch = globalThis.fetch;
  globalThis.fetch = async () => new Response(packed);
  const in_browser = await browser.loadEngine();
  globalThis.fetch = fetch;
  check(in_browser.solve(text).peak_force_N === result.peak_force_N, "the loader of browsers gives another result");
  for (const name of ["arguments.mjs", "browser.mjs", "dashpad.mjs", "engine.mjs"])
    check(!/["']node:/.test(readFileSync(join(home, name), "utf8")), `${name} needs node`);
}
