// The answers on top of the pages of material tests, studies and fits, and the foam's curve below an assessment.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import test from "node:test";

import { example, open, picture, scratch, settled, words, write } from "./browser.mjs";

const { DASHPAD_COMMAND: command, DASHPAD_SOURCE_DIR: source } = process.env;
const quiet = { complaints: [], requests: [] };
const cards = ["--materials", join(source, "materials")];

function dashpad(...words) {
  try {
    execFileSync(command, words, { stdio: "pipe" });
  } catch (error) {
    if (words[0] !== "assess" || ![3, 4].includes(error.status)) throw error;  // a verdict
  }
}

function written(name, ...words) {
  const file = join(scratch, `${name}.html`);
  dashpad(...words, "--report", file);
  return file;
}

function study(name, factors, ...questions) {
  const text = `title = "${name}"\ncase = "${example("dashboard-20mph")}"\nresponses = ["peak_acceleration", "hic15"]\n`;
  const store = join(scratch, `${name}.db`);
  dashpad("study", write(`${name}.toml`, text + factors), "--out", store, "--quiet", ...cards);
  return written(name, "study", "summary", store, ...questions);
}

const sampled = `sampling = "sobol"\nseed = 1\nindices = true\nsamples = 64
[factors."impactor.speed"]\ndistribution = "uniform"\nlow = "19 mph"\nhigh = "21 mph"
[factors."pad.thickness"]\ndistribution = "uniform"\nlow = "0.9 in"\nhigh = "1.1 in"\n`;
const grid = `[factors."impactor.speed"]\nvalues = ["5 m/s", "7 m/s"]\n`;

const pages = {
  test: written("test", "material-test", "vn600", ...cards),
  limit: written("limit", "material-test", "vn600", "--stress-limit", "300 kPa", "--rate", "10", ...cards),
  creep: written("creep", "material-test", "ensolite-aac-9", "--test", "creep", "--stress", "50 kPa", ...cards),
  indices: study("indices", sampled),
  probability: study("probability", sampled, "--limit", "peak_acceleration > 130 g"),
  grid: study("grid", grid),
  fit: written("fit", "fit", join(source, "examples/fits/vn600.toml")),
  validation: process.env.VALIDATION_PAGE,
};

const answers = {
  test: /^\? Best used up to 324 kPa, having absorbed 122 kJ\/m³ \(at 100 per second\)$/,
  limit: /^Absorbs 1\d\d kJ\/m³ before its stress reaches 300 kPa \(at 10 per second\)$/,
  creep: /^Creeps from a strain of 0\.169 to 0\.311 in 1000 ms under 50 kPa/,
  indices: /^Peak acceleration depends most on the impact speed, which explains \d\d\.?\d? % of its variance$/,
  probability: /^Peak acceleration exceeds 130 g in [\d.]+ % of the draws \(95 % interval [\d.]+ % to [\d.]+ %\)$/,
  grid: /^Peak acceleration ranges from [\d.]+ to [\d.]+ g$/,
  fit: /^The data determine 4 of 5 unknowns and do not determine 1; the model deviates from the tests by 1\.2 % of their largest stress \(root mean square\)$/,
  validation: /^✕ The report's foam law does not meet all the rules for the 1986 tests: it meets 2 of 6, and a foam fitted with the predicted test left out meets 3 of 5$/,
};

for (const [name, file] of Object.entries(pages))
  test(`${name}: the answer, its curve and its figures come first, on a phone and without a script too`, async () => {
    for (const [javaScriptEnabled, widths] of [[true, [1300, 390]], [false, [390]]]) {
      const page = await open(file, { viewport: { width: widths[0], height: 1000 }, javaScriptEnabled });
      for (const width of widths) {
        await page.setViewportSize({ width, height: 1000 });
        if (javaScriptEnabled) await settled(page);
        assert.match(await words(page.locator("h1")), answers[name]);
        assert.equal(await page.locator(".lead .pictures figure:has(svg path)").count(), 1);
        const figures = await page.locator(".key-figures li").count();
        assert.ok(figures >= 3 && figures <= 6, `${figures} figures`);
        const headings = await page.locator("main figure h3").allTextContents();
        assert.ok(headings.every((text) => text.trim()), `a figure without a heading: ${headings}`);
        const scrolled = await page.locator("html").evaluate((html) => html.scrollWidth);
        assert.ok(scrolled <= width, `${scrolled} px wide`);
        assert.deepEqual(page.seen, quiet);
        await page.locator(".lead").screenshot({ path: picture(`lead-${name}-${width}.png`) });
      }
      await page.context().close();
    }
  });

test("a material test says what it rests on, and how far the foam was tested", async () => {
  const page = await open(pages.test);
  const reached = page.locator(".key-figures li", { hasText: "Strain reached" });
  assert.match(await reached.innerText(), /tested up to 0\.55/);
  assert.equal(await reached.getAttribute("class"), "doubtful");
  const basis = page.locator("section", { has: page.locator("h2", { hasText: "Basis" }) });
  assert.match(await basis.innerText(), /tested up to a strain of 0\.55[^]*Landauer/);
});

test("a study's quantiles are bars towards its limit", async () => {
  const page = await open(pages.probability);
  const bars = page.locator(".key-figures li", { hasText: "limit 130 g" });
  assert.equal(await bars.locator("svg.limit").count(), 2);
});

test("an assessment shows how much of the foam it used", async () => {
  const file = written("assess", "assess", example("dashboard-20mph"), "--standard", "fmvss-201-instrument-panel", ...cards);
  const page = await open(file);
  const basis = page.locator("section", { has: page.locator("h2", { hasText: "Basis" }) });
  assert.match(await basis.locator("figure h3").innerText(), /^The foam reaches a strain of 0\.979; it was fitted up to 0\.95$/);
  assert.match(await basis.locator("figure").innerText(), /first loading at 1 per second/);
});

test("who switches a curve off switches its arrow off", async () => {
  const page = await open(pages.test);
  const plot = page.locator("main svg.dp-plot", { has: page.locator(".dp-arrow") }).first();
  const label = await plot.locator(".dp-arrow").first().getAttribute("data-of");
  const arrows = plot.locator(`.dp-arrow[data-of="${label}"]`);
  assert.ok(await arrows.first().isVisible());
  await plot.locator(`[aria-pressed][data-label="${label}"]`).first().click();
  assert.ok(!(await arrows.first().isVisible()));
});

test("over materials the answer is their names, and each has its bar", async () => {
  const file = study("materials", `[factors."pad.material"]\nvalues = ["ensolite-aac-9", "ensolite-aac-21", "team-wendy-hard-pu"]\n`, "--limit", "hic15=1600");
  const page = await open(file);
  assert.match(await words(page.locator("h1")), /^HIC15 exceeds 1600 with all but team-wendy-hard-pu$/);
  const ends = await page.locator(".lead .dp-end").allTextContents();
  for (const name of ["ensolite-aac-9", "ensolite-aac-21", "team-wendy-hard-pu"]) assert.ok(ends.some((text) => text.includes(name)), `${name}: ${ends}`);
});
