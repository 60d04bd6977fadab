// Writes the formulas of finished pages as HTML and MathML, so that a reader needs no script.
//
//     node formulas.mjs PAGE...     exit code 1, and a line each, for formulas that KaTeX does not read

import { createRequire } from "node:module";
import { readFileSync, writeFileSync } from "node:fs";

const katex = createRequire(import.meta.url)("/usr/share/nodejs/katex/dist/katex.js");
const entities = { amp: "&", lt: "<", gt: ">", quot: '"', "#39": "'" };
const plain = (text) => text.replace(/&(amp|lt|gt|quot|#39);/g, (_, name) => entities[name]);
const formula = /<(span|div) class="arithmatex">\\([([])([\s\S]*?)\\[)\]]<\/\1>([,.;:)]*)/g;

const faults = [];
let count = 0;
for (const file of process.argv.slice(2)) {
  const written = readFileSync(file, "utf8").replace(formula, (all, element, bracket, tex, mark) => {
    count += 1;
    try {
      const html = katex.renderToString(plain(tex).trim(), { displayMode: bracket === "[", throwOnError: true });
      // No line begins with the comma behind a formula.
      if (bracket === "(" && mark && tex.length <= 40) return `<span style="white-space:nowrap">${html}${mark}</span>`;
      return `<${element} class="formula">${html}</${element}>${mark}`;
    } catch (error) {
      faults.push(`${file}: ${error.message}`);
      return all;
    }
  });
  writeFileSync(file, written);
}
console.log(faults.length ? faults.join("\n") : `${count} formulas`);
process.exitCode = faults.length ? 1 : 0;
