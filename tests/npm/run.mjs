// Installs the package into an empty folder and tries it: node run.mjs PACKAGE.tgz DASHPAD ROOT
import { execFileSync, spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readdirSync, rmSync, symlinkSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { tryCommand } from "./command.mjs";
import { tryModule } from "./module.mjs";
import { tryPaths } from "./paths.mjs";

const [archive, native, root] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "dashpad-npm-"));
const home = join(folder, "node_modules/dashpad");

// By npm if it is there, which is no part of node everywhere; else as npm does it.
function install() {
  const words = ["install", "--offline", "--ignore-scripts", "--no-audit", "--no-fund", archive];
  if (spawnSync("npm", words, { cwd: folder, env: { ...process.env, npm_config_cache: join(folder, "cache") } }).status === 0) return;
  mkdirSync(join(folder, "node_modules/.bin"), { recursive: true });
  mkdirSync(home);
  execFileSync("tar", ["xzf", archive, "--strip-components=1", "-C", home]);
  symlinkSync("../dashpad/bin/dashpad.mjs", join(folder, "node_modules/.bin/dashpad"));
}

let failures = 0;
// A failure unless `holds`.
const check = (holds, text) => {
  if (holds) return;
  console.log(`FAILED: ${text}`);
  failures += 1;
};

try {
  install();
  const program = join(folder, "node_modules/.bin/dashpad");
  const here = { check, folder, home, native, program, root, examples: readdirSync(join(root, "examples")).filter((name) => name.endsWith(".toml")) };
  await tryPaths(here);
  await tryModule(here);
  await tryCommand(here);
} finally {
  rmSync(folder, { recursive: true });
}
console.log(failures === 0 ? "The package does what it says." : `${failures} failures`);
process.exitCode = failures === 0 ? 0 : 1;
