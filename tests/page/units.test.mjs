// The reader chooses the units: tables, sentences, legends and axes follow.

import assert from "node:assert/strict";
import test from "node:test";

import { example, legend, open, report, settled } from "./browser.mjs";

const written = async (page) => {
  await settled(page);
  return page.evaluate(() => window.written.splice(0));
};

test("units change by mouse and by keys", async () => {
  const page = await open(report(example("dashboard-20mph")));
  assert.ok((await written(page)).includes("Force (N)"));
  assert.match(await legend(page, "force"), /575[56]\.\d N/);

  await page.getByRole("radio", { name: "US" }).check();
  const us = await written(page);
  for (const label of ["Force (lbf)", "Distance (in)", "Stress (psi)", "Energy (in·lbf)", "Time (ms)", "Deceleration (g)"])
    assert.ok(us.includes(label), label);
  assert.ok(!us.includes("Force (N)"));
  assert.match(await page.getByRole("row", { name: /^Peak force/ }).innerText(), /1294\.\d\s+lbf/);
  assert.match(await page.locator(".words").innerText(), /10\.000? lb|10 lb/);
  assert.match(await legend(page, "force"), /129[34]\.\d lbf/);

  await page.getByRole("radio", { name: "US" }).focus();
  await page.keyboard.press("ArrowRight");
  assert.ok((await written(page)).includes("Force (kN)"));
  assert.match(await page.getByRole("row", { name: /^Rebound speed/ }).innerText(), /30\.96[78]\s+km\/h/);
  await page.keyboard.press("Tab");
  assert.deepEqual(page.seen, { complaints: [], requests: [] });
});

test("the units of the command come first", async () => {
  const page = await open(report(example("dashboard-20mph"), "--units", "us"));
  assert.ok(await page.getByRole("radio", { name: "US" }).isChecked());
  assert.ok((await written(page)).includes("Force (lbf)"));
});
