// Makes the pages: each is one HTML file with its script and style inside, cut in two where the data go.
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

const banner = `/*! uPlot, https://github.com/leeoniya/uPlot\n${license} */
const canvasPixelRatio=Math.max(2,window.devicePixelRatio||1);`;

function bundled(script) {
  const bundle = buildSync({
    entryPoints: [join(here, script)],
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
    banner: { js: banner },
  });
  return (ending) => {
    const found = bundle.outputFiles.find((file) => file.path.endsWith(ending)).text.trim();
    if (/<\/(script|style)|<!--/i.test(found)) throw new Error(`the ${ending} of ${script} would end its own element`);
    return found;
  };
}

function policy(script, style) {
  const hash = (of) => `'sha256-${createHash("sha256").update(of).digest("base64")}'`;
  return [
    "default-src 'none'",
    `script-src ${hash(script)}`,
    // C++ adds the hashes of the styles that SVGs bring.
    `style-src ${hash(style)}@STYLES@`,
    "img-src data:",
    "base-uri 'none'",
    "form-action 'none'",
  ].join("; ");
}

// What stands before, between and after what C++ fills in.
function cut(main) {
  const text = bundled(main);
  const [script, style] = [text(".js"), text(".css")];
  const parts = readFileSync(join(here, "both/page.html"), "utf8")
    .replace("@POLICY@", () => policy(script, style))
    .replace("@STYLE@", () => style)
    .replace("@SCRIPT@", () => script)
    .split(/@(?:STYLES|TITLE|LEAD|BODY|DATA)@/);
  if (parts.length !== 6) throw new Error("the page needs one place each for its title, lead, body and data");
  return parts;
}

const literal = (of) => {
  if (of.includes(')page"')) throw new Error("the text would end its own literal");
  return `R"page(${of})page"`;
};

const texts = (name, main) => `const PageParts ${name}_parts{${cut(main).map(literal).join(",\n")}};\n`;

writeFileSync(
  output,
  `// Made by web/build.mjs.
#include "output/page/page_template.hpp"

namespace dashpad::output {

${texts("page", "page/main.js")}
${texts("figures_page", "figures/main.js")}
}  // namespace dashpad::output
`,
);
