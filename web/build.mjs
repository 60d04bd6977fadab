// Makes the page: one HTML file with its script and style inside, cut in two where the data go.
//   node build.mjs PACKAGES OUTPUT   PACKAGES: a folder with node_modules, OUTPUT: a C++ source

import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const here = fileURLToPath(new URL(".", import.meta.url));
const [packages, output] = process.argv.slice(2);
const { buildSync } = createRequire(resolve(packages, "package.json"))("esbuild");

// Whoever passes a page on passes on a copy of uPlot, and with it this notice.
const license = readFileSync(resolve(packages, "node_modules/uplot/LICENSE"), "utf8").trim();

const bundle = buildSync({
  entryPoints: [join(here, "page/main.js")],
  nodePaths: [resolve(packages, "node_modules")],
  outdir: "unused",
  write: false,
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2020",
  charset: "ascii",
  // Twice as many pixels as a plain screen has, so that canvases are sharp on paper.
  define: { devicePixelRatio: "canvasPixelRatio" },
  banner: { js: `/*! uPlot, https://github.com/leeoniya/uPlot\n${license} */\nconst canvasPixelRatio=Math.max(2,window.devicePixelRatio||1);` },
});

function text(ending) {
  const found = bundle.outputFiles.find((file) => file.path.endsWith(ending)).text.trim();
  if (/<\/(script|style)|<!--/i.test(found)) throw new Error(`the bundle's ${ending} would end its own element`);
  return found;
}

const script = text(".js");
const style = text(".css");
const hash = (of) => `'sha256-${createHash("sha256").update(of).digest("base64")}'`;
const policy = [
  "default-src 'none'",
  `script-src ${hash(script)}`,
  `style-src ${hash(style)}`,
  "img-src data:",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");

const html = readFileSync(join(here, "page/page.html"), "utf8")
  .replace("@POLICY@", () => policy)
  .replace("@STYLE@", () => style)
  .replace("@SCRIPT@", () => script);
const parts = html.split("@DATA@");
if (parts.length !== 2) throw new Error("the page needs one place for its data");

const literal = (of) => {
  if (of.includes(')page"')) throw new Error("the text would end its own literal");
  return `R"page(${of})page"`;
};
writeFileSync(
  output,
  `// Made by web/build.mjs.
#include "report/page_template.hpp"

namespace dashpad {

const std::string_view page_before_data = ${literal(parts[0])};
const std::string_view page_after_data = ${literal(parts[1])};

}  // namespace dashpad
`,
);
