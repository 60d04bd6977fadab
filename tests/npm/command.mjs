// The command: as the native one over all examples, and what it does with files and mistakes.
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { differences } from "../wasm/differences.mjs";

export async function tryCommand({ check, examples, folder, native, program, root }) {
  const env = { ...process.env };
  delete env.DASHPAD_MATERIALS;
  delete env.DASHPAD_STANDARDS;
  const started = (file, words, options) => spawnSync(file, words, { cwd: root, encoding: "utf8", env, ...options });
  const ours = (words, options) => started(program, words, options);
  const theirs = (words, options) => started(native, words, { env: { ...env, DASHPAD_MATERIALS: "materials", DASHPAD_STANDARDS: "standards" }, ...options });
  const wanted = (words, code, output, options) => {
    const { status, stdout, stderr } = ours(words, options);
    check(status === code && (stdout + stderr).includes(output), `${words.join(" ")}: ended with ${status}: ${stdout.slice(0, 200)} ${stderr.slice(0, 300)}`);
  };
  const same_json = (words) => {
    const [mine, other] = [ours([...words, "--json", "-"]), theirs([...words, "--json", "-"])];
    check(mine.status === other.status, `${words.join(" ")}: ended with ${mine.status} and ${other.status}: ${mine.stderr}`);
    if (!mine.stdout || !other.stdout) return check(mine.stdout === other.stdout, `${words.join(" ")}: only one has a result: ${mine.stderr}`);
    const found = differences(JSON.parse(mine.stdout), JSON.parse(other.stdout));
    for (const text of found.slice(0, 5)) check(false, `${words.join(" ")}: ${text}`);
  };
  const same_text = (words) => {
    const [mine, other] = [ours(words), theirs(words)];
    check(mine.status === other.status && mine.stdout === other.stdout && mine.stderr === other.stderr,
      `${words.join(" ")}: ${mine.status} and ${other.status}\n${mine.stderr}${mine.stdout}\nand\n${other.stderr}${other.stdout}`);
  };

  for (const name of examples) same_json(["run", `examples/${name}`]);
  const drop = "examples/dashboard-20mph.toml";
  const panel = ["--standard", "fmvss-201-instrument-panel"];
  same_json(["assess", drop, ...panel]);
  same_json(["assess", "examples/helmet-struck-by-a-ram.toml", "--standard", "fmvss-201u", "--keep-nose", "--keep-speed"]);
  same_json(["assess", drop, "--standard", "en-1177", "--drop-height", "1.5 m"]);
  same_json(["solve-for", "pad.thickness", drop, ...panel]);
  same_json(["solve-for", "pad.thickness", drop, "--until", "peak_acceleration <= 100 g", "--until", "peak_penetration <= 40 mm", "--no-intervals"]);
  same_json(["solve-for", "pad.thickness", drop, ...panel, "--until", "hic15 <= 600"]);
  same_json(["solve-for", "impactor.drop_height", drop, "--until", "hic15 = 700", "--tolerance", "1e-3"]);
  same_json(["solve-for", "pad.thickness", drop, "--until", "peak_acceleration <= 5 g", "--no-intervals"]);

  // Words, complaints and codes.
  for (const words of [["standards"], ["materials"], ["materials", "vn600", "--units", "us"], ["standards", "en-1078:kerbstone"], ["run", drop],
    ["run", drop, "--units", "us", "--set", "pad.thickness=2 in"], ["run"], ["run", drop, "a", "--foo"], ["run", drop, "--units", "bogus"],
    ["run", drop, "--json"], ["run", drop, "--set", "pad.thicknes=3"], ["run", "no-such.toml"], ["run", "examples"], ["run", drop, "--tolerance", "1"],
    ["run", drop, "--json", "-", "--report", "-"], ["run", drop, "--json", drop, "--force"], ["run", drop, "--report", "no/such.html", "--json", "examples"],
    ["assess", drop], ["assess", drop, "--standard", "en-1177", "--speed", "3"], ["assess", drop, "--standard", "en-1078:no-such"],
    ["run", drop, "--materials", "no-such"], ["solve-for", "pad.thicknes", drop, "--standard", "en-1177"], ["check", drop, "--set", "pad.material=./no.toml"],
    ["check", drop, "--json", "--set", "pad.x=1"], ["run", ""], [drop],
    // Own limits, and what is wrong with them.
    ...[["hic16 <= 3"], ["Peak acceleration <= 3"], ["hic15 ~ 3"], ["hic15 << 3"], ["hic15 <="], ["hic15 <= 3 kg"],
      ["peak_acceleration <= 80 q"], ["hic15 <= 0"], ["hic15 <= -7"], [""], ["hic15 = 700", "peak_acceleration <= 100 g"], ["hic16 <= 3", "hic15 <= 1 m"]]
      .map((limits) => ["solve-for", "pad.thickness", drop, "--no-intervals", ...limits.flatMap((limit) => ["--until", limit])]),
    ["solve-for", "pad.thickness", drop], ["solve-for", "Pad.Thickness", drop, "--until", "hic15 <= 700"], ["solve-for", "pad.material", drop, "--until", "hic15 <= 7"],
    ["solve-for", "pad.thickness", drop, "--until", "hic15 = 700", ...panel], ["run", drop, "--tolerance", "1e-5x"], ["run", drop, "--tolerance", "nan"],
    // Names that differ in capitals, blanks or a letter.
    ["runn"], ["Solve For"], ["materials", "VN600"], ["materials", "ENSOLITE AAC 9"], ["materials", "vn-600"], ["standards", "EN 1078"], ["standards", "FMVSS 208 HIC15"],
    ["assess", drop, "--standard", "Fmvss_201u"], ["run", drop, "--set", "pad.material=Team Wendy Hard PU"], ["run", drop, "--set", "Pad.Thickness=3 mm"]])
    same_text(words);
  wanted([], 2, "no command given");
  wanted(["RUN"], 2, 'did you mean "run"?');
  wanted(["materials", "ENSOLITE AAC 9"], 2, 'did you mean "ensolite-aac-9"?');
  wanted(["standards", "FMVSS 208 HIC15"], 2, 'did you mean "fmvss-208-hic15"?');
  wanted(["qqqq"], 2, "available: run, check");
  wanted(["study", "a.toml"], 2, "the native command has it");
  wanted(["run", drop, "--png", "a.png"], 2, "the native command has it");
  wanted(["assess", drop, "--standard", "en-1177", "--standard", "en-1078"], 2, "test plan");
  wanted(["assess", drop, "--standard", "en-1177"], 4, "");
  wanted(["assess", drop, ...panel], 3, "Undecided");
  wanted(["--help"], 0, "Exit codes");
  wanted(["run", "--help"], 0, "--set KEY=VALUE");
  wanted(["--version"], 0, "WebAssembly");
  wanted(["run", "-"], 0, "Peak", { input: readFileSync(join(root, drop)) });
  wanted(["run", "-"], 2, "UTF-16", { input: Buffer.from([0xff, 0xfe, 0x41, 0]) });

  // Line ends of Windows; cards and noses that a case names, with spaces and from another folder.
  const pads = join(folder, "my pads");
  mkdirSync(join(pads, "cards"), { recursive: true });
  const windows = (text) => `\ufeff${text.replaceAll("\n", "\r\n")}`;
  const put = (name, text) => writeFileSync(join(pads, name), text);
  put("drop.toml", windows(readFileSync(join(root, drop), "utf8")));
  put("cards/foam.toml", windows(readFileSync(join(root, "materials/vn600.toml"), "utf8")));
  put("nose.csv", windows("depth_mm,radius_mm\n0,0\n10,30\n40,60\n80,70\n"));
  put("own.toml", windows('[impactor]\nmass = "5 kg"\nspeed = "3 m/s"\nnose = "profile"\nfile = "nose.csv"\n\n[pad]\nthickness = "40 mm"\nmaterial = "cards/foam.toml"\n\n[support]\ntype = "rigid"\n'));
  check(ours(["run", join(pads, "drop.toml")]).stdout === ours(["run", drop]).stdout, "CRLF changes the answer");
  same_json(["run", join(pads, "own.toml")]);
  wanted(["check", "own.toml"], 0, "OK", { cwd: pads });
  wanted(["check", "own.toml", "--set", "pad.material=foam", "--materials", "cards/"], 0, "OK", { cwd: pads });
  wanted(["materials", "cards/foam.toml"], 0, "VN600", { cwd: pads });
  wanted(["materials"], 0, "Materials in cards", { cwd: pads, env: { ...env, DASHPAD_MATERIALS: "cards" } });
  put("bad.toml", windows("[pad]\nthickness = \"1 kg\"\n"));
  wanted(["check", "bad.toml"], 2, "bad.toml:2: pad.thickness", { cwd: pads });

  // Files: all or none, never over others.
  const out = join(folder, "out");
  mkdirSync(out);
  const written = (...words) => ours(["run", join(root, drop), ...words], { cwd: out });
  check(written("--json", "a.json", "--report", "a b.html", "--markdown", "a.md").status === 0, "files are not written");
  check(JSON.parse(readFileSync(join(out, "a.json"), "utf8")).status === "released", "the JSON is another");
  check(readFileSync(join(out, "a b.html"), "utf8").includes("</html>"), "the page is another");
  writeFileSync(join(out, "b.json"), "mine");
  const refused = written("--json", "b.json", "--report", "b.html");
  check(refused.status === 2 && refused.stderr.includes("already exists"), `overwrites: ${refused.stderr}`);
  check(readFileSync(join(out, "b.json"), "utf8") === "mine" && !existsSync(join(out, "b.html")), "writes although it refuses");
  check(written("--json", "b.json", "--force").status === 0 && readFileSync(join(out, "b.json"), "utf8") !== "mine", "--force does nothing");
  check(readdirSync(out).length === 4, `leaves files: ${readdirSync(out)}`);
  if (existsSync("/dev/full")) {
    check(written("--json", "/dev/full").status === 1, "a full disk is no failure");
    const full = started("sh", ["-c", '"$0" run "$1" >/dev/full', program, drop]);
    check(full.status === 1 && full.stderr.includes("No space left"), `standard output on a full disk: ${full.stderr}`);
    const closed = started("bash", ["-c", '"$0" run "$1" --report - 2>/dev/null | true; echo "${PIPESTATUS[0]}"', program, drop]);
    check(closed.stdout.trim() === "0", `a closed pipe: ${closed.stdout}`);
    const piped = started("bash", ["-c", '"$0" run "$1" --report - 2>/dev/null | (sleep 0.2; wc -c)', program, drop]);
    check(Number(piped.stdout) > 70000, `a slow pipe gets ${piped.stdout} bytes`);
  }
}
