// Pages that answer: the verdict, the picture and the figures on the first screen, with and without a script, on a
// phone and on paper.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { statSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";

import { example, open, picture, scratch, words } from "./browser.mjs";

const { DASHPAD_COMMAND: command, DASHPAD_SOURCE_DIR: source } = process.env;
const quiet = { complaints: [], requests: [] };

function written(name, ...words) {
  const file = join(scratch, `${name}.html`);
  try {
    execFileSync(command, [...words, "--report", file], { stdio: "pipe" });
  } catch (error) {
    if (![3, 4].includes(error.status)) throw error;  // a verdict
  }
  return file;
}

const cards = ["--materials", join(source, "materials")];
const assess = (name, ...more) => written(`assess-${name}`, "assess", example(name), ...cards, ...more);
const pages = {
  passes: assess("helmet-pad-10fps", "--standard", "fmvss-208-hic15", "--speed", "2.5 m/s"),
  narrow: assess("dashboard-20mph", "--standard", "fmvss-201-instrument-panel"),
  fails: assess("rigid-floor-bottoming", "--standard", "en-1177", "--drop-height", "2 m"),
  pulse: written("pulse", "pulse", join(source, "examples/pulses/synthetic-helmet-pad.csv")),
  run: written("run", "run", example("package-on-block"), ...cards),
};

test("the verdict is the heading, in its colour and with a sign", async () => {
  const passes = await open(pages.passes);
  assert.match(await words(passes.locator("h1.good")), /^✓ Passes: HIC15 has \d+ to spare$/);
  const narrow = await open(pages.narrow);
  assert.match(await words(narrow.locator("h1.doubtful")), /^\? Undecided: 3 ms clip could be anywhere from [\d.]+ to [\d.]+ g, but must be at most 80 g$/);
  assert.match(await narrow.locator(".reservation").innerText(), /^EXTRAPOLATED STRAIN: the strain reaches/);
  assert.match((await narrow.locator(".subject").allInnerTexts()).join("\n"), /Case: Dashboard[\s\S]*Replaced in the case: .*speed/);
  const fails = await open(pages.fails);
  assert.match(await words(fails.locator("h1.bad")), /^✕ Fails: the pad bottoms out with the impactor still moving at \d\.\d+ m\/s$/);
  assert.match(await passes.title(), /^Passes: /);
});

test("verdict, curve and figures are on the first screen", async () => {
  const page = await open(pages.narrow, { viewport: { width: 1300, height: 1000 } });
  for (const part of ["h1", ".pictures svg >> nth=0", ".key-figures b >> nth=0"]) {
    const box = await page.locator(part).boundingBox();
    assert.ok(box.width > 0 && box.y + box.height < 1000, `${part} ends at ${box.y + box.height}`);
  }
  const bar = page.locator(".key-figures .limit").first();
  assert.match(await bar.getAttribute("aria-label"), /^95 % of the limit, \d+ to \d+ % including uncertainty$/);
  await page.screenshot({ path: picture("answer.png") });
});

for (const [name, file] of Object.entries(pages))
  test(`${name}: nothing is missing without a script, nothing is cut off on a phone`, async () => {
    assert.ok(statSync(file).size < 260_000, `${statSync(file).size} bytes`);
    for (const javaScriptEnabled of [true, false]) {
      const page = await open(file, { viewport: { width: 390, height: 900 }, isMobile: true, javaScriptEnabled });
      const what = javaScriptEnabled ? "with" : "without";
      assert.equal(await page.locator("h1").count(), 1);
      assert.ok((await page.locator(".key-figures li").count()) >= 4);
      assert.ok((await page.locator(".pictures svg path").count()) >= 1);
      assert.ok((await page.locator("main table").count()) >= 1);
      if (!javaScriptEnabled) assert.ok((await page.locator("figure svg.dp-plot").count()) >= 1);
      const width = await page.locator("html").evaluate((html) => html.scrollWidth);
      assert.ok(width <= 390, `${what} a script ${width} px wide`);
      assert.deepEqual(page.seen, quiet);
      await page.screenshot({ path: picture(`answer-${name}-${what}-script.png`), fullPage: true });
      await page.context().close();
    }
  });

test("on paper the answer is a sheet of its own", async () => {
  const page = await open(pages.narrow);
  const pdf = await page.pdf({ path: picture("answer.pdf"), format: "A4" });
  const sheets = pdf.toString("latin1").match(/\/Type\s*\/Page\b/g).length;
  assert.ok(sheets >= 2 && sheets <= 5, `${sheets} sheets`);
});
