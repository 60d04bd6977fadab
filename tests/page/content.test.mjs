// What is on the page, and that it asks nothing of anyone.

import assert from "node:assert/strict";
import { statSync } from "node:fs";
import test from "node:test";

import { drawn, example, figure, open, picture, report, words, write } from "./browser.mjs";

const all = [
  "Force over time",
  "Deceleration over time",
  "Force against penetration",
  "Force against displacement",
  "Penetration and displacement over time",
  "Energy over time",
  "Stress across the contact",
  "Strain across the contact",
];
const onRigid = all
  .filter((name) => name !== "Force against displacement")
  .map((name) => name.replace("Penetration and displacement", "Penetration"));
const caseOf = (law, parameters, more = "") => `
[impactor]
mass = "4 kg"
radius = "80 mm"
speed = "3 m/s"
[pad]
thickness = "30 mm"
law = "${law}"
parameters = { ${parameters} }
[support]
type = "linear"
stiffness = "100 N/mm"
${more}`;

async function check(file, plots = all) {
  assert.ok(statSync(file).size < 200_000, `${statSync(file).size} bytes`);
  const page = await open(file);
  assert.deepEqual(page.seen, { complaints: [], requests: [] });
  const seen = await drawn(page);
  const [foam, ...others] = seen.map(({ name }) => name);
  assert.match(foam, /^The foam reaches a strain of [01]\b/);
  assert.deepEqual(others, plots);
  for (const { name, size } of seen) assert.ok(size > 300, `${name} is ${size} px of curve`);
  return page;
}

test("the example of the report", async () => {
  const page = await check(report(example("dashboard-20mph")));
  assert.equal(await page.title(), "Peak 129 g, HIC15 1662 - Dashpad");
  assert.match(await words(page.locator("h1")), /^Peak 129 g, HIC15 1/);
  assert.deepEqual(await page.locator(".subject").allInnerTexts(), [
    "Dashboard at 20 mph (report, section 2.3)",
    "The impactor rebounded and left the pad.",
  ]);
  assert.match(await page.locator("main").innerText(), /a sphere of mass 4\.5359 kg/);
  const warnings = await page.locator(".warnings li").allInnerTexts();
  assert.equal(warnings.length, 1, "the other stands with the answer");
  assert.match(await page.locator(".reservation").innerText(), /^EXTRAPOLATED STRAIN: the strain reaches 0\.987/);
  assert.match(warnings[0], /^EXTRAPOLATED RATE: the strain rate/);
  const peak = await page.getByRole("row", { name: /^Peak force/ }).innerText();
  assert.match(peak, /5756\.[78]\s+N\s+\d+ to \d+ N\s+± 0\.0\d* %/);
  assert.match(await page.locator("table").nth(1).innerText(), /HIC15[\s\S]*HIC36[\s\S]*3 ms clip[\s\S]*Cumulative 3 ms clip/);
  assert.match((await figure(page, "Deceleration over time").locator("text").allTextContents()).join("\n"), /3 ms clip 126\.\d g/);
  assert.match(await figure(page, "Stress across the contact").locator(".note").innerText(), /differs from the force by at most 0\.\d+ %/);
  assert.match(await page.locator("pre").innerText(), /\[impactor\]\nmass = "4\.5359237 kg"/);
  assert.match(await page.locator("footer").innerText(), /dashpad \d+\.\d+\.\d+, commit \w+/);
  await page.screenshot({ path: picture("desktop.png"), fullPage: true });
});

test("a row for each of repeated blows", async () => {
  const page = await check(report(example("playground-three-drops")), onRigid);
  const table = page.locator("#section-1 table").first();
  assert.match(await words(page.locator("h1")), /^Blow 3 peaks at [\d.]+ g, \d+ % higher than blow 1; its HIC15 is \d+, \d+ % higher$/);
  assert.equal(await table.locator("tbody tr").count(), 3);
  assert.match(await table.locator("thead").innerText(), /Peak acceleration, g[\s\S]*HIC15[\s\S]*Peak force, N/);
});

test("every law, every example", async () => {
  await check(report(example("dashboard-20mph-21-parameter")));
  await check(report(example("load-cell-drop")));
  await check(report(write("elastic.toml", caseOf("elastic", 'modulus = "300 kPa"'))));
  await check(report(write("viscous.toml", caseOf("linear-viscoelastic",
    'asymptotic_modulus = "140 kPa", initial_modulus = "420 kPa", relaxation_time = "5 ms"'))));
  const page = await check(report(write("rigid.toml", caseOf("rigid-foam",
    'crush_stress = "200 kPa", crush_strain = 0.6, second_stress = "400 kPa", second_strain = 0.8'))));
  assert.match(await figure(page, "Stress across the contact").locator(".note").innerText(), /rigid foam is at rest/);
});

test("a pad that bottoms out has no peak force and no injury figures", async () => {
  const page = await check(report(example("rigid-floor-bottoming")), onRigid);
  assert.match(await page.locator(".reservation").innerText(), /BOTTOMED at 5\.9/);
  assert.match(await page.getByRole("row", { name: /^Peak force/ }).innerText(), /none/);
  assert.equal(await page.locator("#section-1 table").count(), 1);
  assert.match(await figure(page, "Force over time").locator(".note").innerText(), /runs off the plot/);
});

test("time limit and missed tolerance are in plain sight", async () => {
  const elastic = caseOf("elastic", 'modulus = "300 kPa"', '[solver]\ntime_limit = "5 ms"\n');
  const short = await check(report(write("short.toml", elastic)));
  assert.match(await words(short.locator("h1.doubtful")), /^\? Peak at least [\d.]+ g/);
  assert.match(await short.locator(".reservation").innerText(), /TIME LIMIT/);
  assert.match(await words(short.locator(".key-figures")), /≥ \d/);
  const missed = await open(report(example("dashboard-20mph-21-parameter"), "--tolerance", "1e-8"));
  assert.match(await missed.locator(".reservation").innerText(), /TOLERANCE NOT MET/);
  assert.deepEqual(missed.seen, { complaints: [], requests: [] });
});
