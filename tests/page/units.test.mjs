// The reader chooses the units: the answer, tables, sentences, the drawing and axes follow.

import assert from "node:assert/strict";
import test from "node:test";

import { example, figure, open, place, report, settled, texts, tip, words } from "./browser.mjs";

const labels = (page) => page.locator(".dp-axis-title").allTextContents();

test("units change by mouse and by keys, and back", async () => {
  const page = await open(report(example("dashboard-20mph")));
  const force = figure(page, "Force over time");
  assert.ok((await labels(page)).includes("Force (N)"));

  await page.getByRole("radio", { name: "US" }).check();
  for (const label of ["Force (lbf)", "Distance (in)", "Stress (psi)", "Energy (in·lbf)", "Time (ms)", "Deceleration (g)"])
    assert.ok((await labels(page)).includes(label), label);
  assert.ok(!(await labels(page)).includes("Force (N)"));
  assert.ok((await texts(force)).includes("1200"), String(await texts(force)));
  assert.match(await page.getByRole("row", { name: /^Peak force/ }).innerText(), /1294\.\d\s+lbf/);
  assert.match(await page.locator("main").innerText(), /10\.000? lb|10 lb/);
  assert.match(await words(page.locator(".key-figures")), /1294 lbf/);
  assert.match((await page.locator(".drawing > svg").first().locator("text").allTextContents()).join(" "), /1 in .*20 mph|20 mph.* 1 in/);
  await page.mouse.move(...(await place(force, 13.03 / 25, 0.05)));
  assert.match((await tip(page))[0], /Force \(lbf\): 129[345](\.\d)?$/);
  await page.mouse.move(2, 2);

  await page.getByRole("radio", { name: "US" }).focus();
  await page.keyboard.press("ArrowRight");
  assert.ok((await labels(page)).includes("Force (kN)"));
  assert.match(await page.locator("#section-1").getByRole("row", { name: /^Rebound speed/ }).innerText(), /30\.96[78]\s+km\/h/);
  await page.getByRole("radio", { name: "SI" }).check();
  await settled(page);
  const titles = await labels(page);
  assert.ok(titles.includes("Force (N)") && titles.includes("Energy (J)"), String(titles));
  assert.match(await page.getByRole("row", { name: /^Peak force/ }).innerText(), /575[67]\.\d\s+N/);
  assert.deepEqual(page.seen, { complaints: [], requests: [] });
});

test("a drawing that other units draw anew keeps its look, from each system to each", async () => {
  const page = await open(report(example("post-on-bumper")));
  const fill = () => page.locator(".drawing .dd-nose").first().evaluate((nose) => getComputedStyle(nose).fill);
  const written = await fill();
  const expected = { US: "Force (lbf)", "Engineering metric": "Force (kN)", SI: "Force (N)" };
  for (const system of ["US", "Engineering metric", "SI", "Engineering metric", "US", "SI"]) {
    await page.getByRole("radio", { name: system }).check();
    assert.equal(await fill(), written, system);
    assert.ok((await labels(page)).includes(expected[system]), system);
  }
  assert.deepEqual(page.seen, { complaints: [], requests: [] });
});

test("the units of the command come first", async () => {
  const page = await open(report(example("dashboard-20mph"), "--units", "us"));
  assert.ok(await page.getByRole("radio", { name: "US" }).isChecked());
  assert.ok((await labels(page)).includes("Force (lbf)"));
  await page.getByRole("radio", { name: "SI" }).check();
  assert.ok((await labels(page)).includes("Force (N)"));
});
