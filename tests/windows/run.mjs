// Unpacks the command for Windows and tries it under wine: node run.mjs PACKAGE.zip DASHPAD ROOT WINEPREFIX
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { differences } from "../wasm/differences.mjs";

const [archive, native, root, prefix] = process.argv.slice(2);
const wine = "/usr/lib/wine/wine64";
const folder = join(mkdtempSync(join(tmpdir(), "dashpad-windows-")), "Prüfstand für Schäume");
mkdirSync(folder);
const env = { ...process.env, LC_ALL: "C.UTF-8", WINEPREFIX: prefix, WINEDEBUG: "-all", WINEDLLOVERRIDES: "mscoree,mshtml=" };
for (const name of ["DISPLAY", "DASHPAD_MATERIALS", "DASHPAD_STANDARDS"]) delete env[name];

let failures = 0;
// A failure unless `holds`.
const check = (holds, text) => {
  if (holds) return;
  console.log(`FAILED: ${text}`);
  failures += 1;
};
const start = (file, words, options = {}) => spawnSync(file, words, { encoding: "utf8", maxBuffer: 1e9, env, cwd: home, ...options });
const server = (option) => start("/usr/lib/wine/wineserver", [option], { stdio: "ignore" });
const ours = (words, options) => start(wine, [join(home, "dashpad.exe"), ...words], options);
const theirs = (words, options) => start(native, words, options);
const shown = ({ status, stdout, stderr }) => `ended with ${status}: ${stdout.slice(0, 300)} ${stderr.slice(0, 500)}`;
const wanted = (words, code, output, options) => {
  const answer = ours(words, options);
  check(answer.status === code && (answer.stdout + answer.stderr).includes(output), `${words.join(" ")}: ${shown(answer)}`);
};

execFileSync("cmake", ["-E", "tar", "xf", archive], { cwd: folder });
const home = join(folder, readdirSync(folder)[0]);
const drop = "examples/dashboard-20mph.toml";
const panel = ["--standard", "fmvss-201-instrument-panel"];

// Numbers: those of the native command to the last bit.
function compareNumbers() {
  const examples = readdirSync(join(home, "examples")).filter((name) => name.endsWith(".toml"));
  const calls = [
    ...examples.map((name) => ["run", `examples\\${name}`]),
    ["assess", drop, ...panel],
    ["assess", "examples/helmet-pad-10fps.toml", "--standard", "en-1078"],
    ["assess", "examples/helmet-struck-by-a-ram.toml", "--standard", "fmvss-201u", "--keep-nose", "--keep-speed"],
    ["solve-for", "pad.thickness", drop, ...panel],
    ["solve-for", "pad.thickness", "examples/disc-on-mat.toml", "--until", "hic15 <= 150", "--vary", "pad.scale=5 %", "--draws", "64"],
    ["fall-height", "examples/drops/mat-50mm.csv", "--calibration", "2 %"],
    ["sensitivity", "examples/disc-on-mat.toml"],
    ["pulse", "examples/pulses/synthetic-helmet-pad.csv", "--filter", "CFC1000"],
    ["compare", drop],
    ["compare", "examples/helmet-pad-10fps.toml", "--pulse", "examples/pulses/synthetic-helmet-pad.csv"],
    ["material-test", "ensolite-aac-9", "--test", "parabolic", "--rate", "1,100"],
    ["spit1984", drop],
  ];
  // solve-for and material-test call functions of the C library, too: there the last digit may differ.
  const isAlike = (text) => {
    const [mine, other] = text.slice(text.indexOf(": ") + 2).split(" and ").map(Number);
    return Math.abs(mine - other) <= 1e-15 * Math.abs(other);
  };
  let equal = 0;
  for (const words of calls) {
    const [mine, other] = [ours([...words, "--json", "-"]), theirs(words.map((word) => word.replace("\\", "/")).concat("--json", "-"))];
    const name = words.join(" ");
    check(mine.status === other.status && mine.stdout !== "", `${name}: ${shown(mine)}, natively ${other.status}`);
    if (!mine.stdout || !other.stdout) continue;
    check(!mine.stdout.includes("\r"), `${name}: line ends of Windows`);
    const found = differences(JSON.parse(mine.stdout.replaceAll("\\\\", "/")), JSON.parse(other.stdout));
    const isExact = ["run", "assess", "sensitivity"].includes(words[0]);
    for (const text of found.filter((text) => isExact || !isAlike(text)).slice(0, 5)) check(false, `${name}: ${text}`);
    if (!isExact && found.length > 0) console.log(`${words[0]}: ${found.length} figures differ in the last digit`);
    if (words[0] === "run" && found.length === 0) equal += 1;
  }
  console.log(`${equal} of ${examples.length} examples equal to the last bit`);
}

// Words, complaints and codes are those of the native command.
function compareTexts() {
  const data = { env: { ...env, DASHPAD_MATERIALS: "materials", DASHPAD_STANDARDS: "standards" } };
  for (const words of [["run", drop, "--units", "us"], ["standards"], ["materials"], ["materials", "vn600"], ["check", drop],
    ["assess", drop, ...panel], ["standards", "en-1078"], ["run"], ["run", drop, "--set", "pad.thicknes=3"], ["run", "no-such.toml"], ["run", "examples"],
    ["material-test", "vn600"], ["post-impact", drop, "--other-mass", "1500 kg"], ["fall-height", "examples/drops/mat-50mm.csv"], ["run", ""],
    ["run", drop, "--report", "no/such.html"], ["pulse", "examples/pulses/synthetic-helmet-pad.csv"], ["spit1984", drop], ["run", drop, "--csv", "-"],
    ["export", drop, "--format", "ls-dyna", "--out", "-"], ["export", drop, "--format", "radioss", "--out", "-"], ["pulse", "no-such.csv"]]) {
    const [mine, other] = [ours(words, data), theirs(words, data)];
    check(mine.status === other.status && mine.stdout === other.stdout && mine.stderr === other.stderr,
      `${words.join(" ")}: ${mine.status} and ${other.status}\n${mine.stderr}${mine.stdout}\nand\n${other.stderr}${other.stdout}`);
  }
  wanted(["--version"], 0, "Windows x86_64");
  wanted(["--help"], 0, "Exit codes");
}

// What is missing says so in a sentence.
function tryWhatIsMissing() {
  wanted(["study", "a.toml", "--out", "a.db"], 2, "not in dashpad for Windows");
  wanted(["study", "export", "a.db", "--csv", "-"], 2, "not in dashpad for Windows");
  wanted(["run", drop, "--png", "a.png"], 2, "not in dashpad for Windows");
  wanted(["run", drop, "--drawing", "a.PDF"], 2, "not in dashpad for Windows");
  wanted(["export", drop, "--format", "iso-mme", "--out", "a.zip"], 2, "not in dashpad for Windows");
  writeFileSync(join(folder, "test.zip"), "PK\x03\x04 and so on");
  wanted(["pulse", "..\\test.zip"], 2, "unpack it");
  check(!existsSync(join(home, "a.png")) && !existsSync(join(home, "a.zip")), "writes what it refuses");
}

// Line ends and byte order marks of Windows; names with blanks, umlauts and backslashes.
function tryFilesOfWindows() {
  const pads = join(folder, "my päds");
  mkdirSync(join(pads, "cards"), { recursive: true });
  const windows = (text) => `\ufeff${text.replaceAll("\n", "\r\n")}`;
  const shipped = (name) => readFileSync(join(root, name), "utf8");
  const put = (name, text) => writeFileSync(join(pads, name), text);
  put("drop.toml", windows(shipped(drop)));
  put("cards/Schaum ä.toml", windows(shipped("materials/vn600.toml")));
  put("cards/schaum.toml", windows(shipped("materials/vn600.toml")));
  put("nose.csv", windows("depth_mm,radius_mm\n0,0\n10,30\n40,60\n80,70\n"));
  put("own.toml", windows('[impactor]\nmass = "5 kg"\nspeed = "3 m/s"\nnose = "profile"\nfile = "nose.csv"\n\n[pad]\nthickness = "40 mm"\n' +
    "material = 'cards\\Schaum ä.toml'\n\n[support]\ntype = \"rigid\"\n"));
  put("pulse.csv", windows(shipped("examples/pulses/synthetic-helmet-pad.csv")));
  const same = (name, file) => check(ours(["run", file]).stdout === ours(["run", drop]).stdout, `${name}: another answer`);
  same("CRLF", "..\\my päds\\drop.toml");
  same("a drive letter", `Z:${join(pads, "drop.toml").replaceAll("/", "\\")}`);
  wanted(["check", "own.toml"], 0, "OK", { cwd: pads });
  wanted(["check", "own.toml", "--set", "pad.material=schaum", "--materials", "cards\\"], 0, "OK", { cwd: pads });
  wanted(["materials"], 0, "Materials in cards", { cwd: pads, env: { ...env, DASHPAD_MATERIALS: "cards" } });
  wanted(["materials"], 2, "päds", { cwd: pads, env: { ...env, DASHPAD_MATERIALS: "no päds" } });
  wanted(["pulse", "pulse.csv"], 0, "32.04 g", { cwd: pads });
  wanted(["run", "-"], 0, "Peak", { input: windows(shipped(drop)) });
  put("bad.toml", windows('[pad]\nthickness = "1 kg"\n'));
  wanted(["check", "bad.toml"], 2, "bad.toml:2: pad.thickness", { cwd: pads });
  put("utf-16.toml", Buffer.from("\ufeff[pad]\r\n", "utf16le"));
  wanted(["check", "utf-16.toml"], 2, "UTF-16", { cwd: pads });
  put("drücke.jsonl", `{"id": 1, "case": "drop.toml"}\r\n`);
  wanted(["batch", "drücke.jsonl"], 0, "peak_force_N", { cwd: pads });
}

// Files: the bytes of other systems, all or none, never over others.
function tryOutput() {
  const out = join(folder, "out");
  const drive = join(prefix, "drive_c", "dashpad test");
  rmSync(drive, { recursive: true, force: true });
  mkdirSync(out);
  mkdirSync(drive);
  const written = (...words) => ours(["run", join(home, drop), ...words], { cwd: out });
  const text = (file) => readFileSync(file, "utf8");
  check(written("--json", "a.json", "--report", "C:\\dashpad test\\ä.html", "--markdown", "a.md", "--csv", "a.csv").status === 0, "files are not written");
  check(JSON.parse(text(join(out, "a.json"))).status === "released", "the JSON is another");
  check(text(join(drive, "ä.html")).includes("</html>"), "the page is another");
  theirs(["run", join(home, drop), "--csv", join(out, "native.csv")]);
  check(text(join(out, "a.csv")) === text(join(out, "native.csv")), "the CSV has other bytes");
  for (const name of ["a.json", "a.md"]) check(!text(join(out, name)).includes("\r"), `${name}: line ends of Windows`);

  writeFileSync(join(out, "b.json"), "mine");
  const refused = written("--json", "b.json", "--report", "b.html");
  check(refused.status === 2 && refused.stderr.includes("already exists"), `overwrites: ${shown(refused)}`);
  check(text(join(out, "b.json")) === "mine" && !existsSync(join(out, "b.html")), "writes although it refuses");
  check(written("--json", "b.json", "--force").status === 0 && text(join(out, "b.json")) !== "mine", "--force does nothing");
  check(written("--json", "NUL").status === 0 && !existsSync(join(out, "NUL")), "NUL is a file");
  check(written("--json", "no\\such.json").stderr.includes("there is no folder no"), "a missing folder is not named");

  // By cmd, whose handles wine knows by their files.
  const there = `..\\${basename(home)}`;
  const redirected = (words) => start(wine, ["cmd", "/c", `${there}\\dashpad.exe run ${there}\\examples\\dashboard-20mph.toml ${words}`], { cwd: out });
  const overItself = redirected("--json stdout.txt --force > stdout.txt");
  check(overItself.status === 2 && overItself.stderr.includes("redirected"), `over its own output: ${shown(overItself)}`);
  redirected("> stdout.txt");
  check(text(join(out, "stdout.txt")) === ours(["run", drop]).stdout.replace(drop, `${there}\\examples\\dashboard-20mph.toml`), "redirected text is another");
  check(readdirSync(out).length === 6, `leaves files: ${readdirSync(out)}`);
  rmSync(drive, { recursive: true });
}

try {
  // Wine's server holds the pipes of the program that starts it: one without pipes comes first, and it stays.
  server("-p");
  ours(["--version"], { stdio: "ignore" });
  const begin = Date.now();
  ours(["--version"]);
  console.log(`A start under wine takes ${Date.now() - begin} ms`);
  compareNumbers();
  compareTexts();
  tryWhatIsMissing();
  tryFilesOfWindows();
  tryOutput();
} finally {
  server("-k");
  rmSync(join(folder, ".."), { recursive: true });
}
console.log(failures === 0 ? "The command for Windows does as it should." : `${failures} failures`);
process.exitCode = failures === 0 ? 0 : 1;
