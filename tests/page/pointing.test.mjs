// Values where the reader points, by mouse, key or finger.

import assert from "node:assert/strict";
import test from "node:test";

import { example, legend, open, report, settled } from "./browser.mjs";

const file = report(example("dashboard-20mph"));

async function at(page, name, x, y = 0.5) {
  await page.locator(`#${name}`).scrollIntoViewIfNeeded();
  const box = await page.locator(`#${name} .u-over`).boundingBox();
  return [box.x + x * box.width, box.y + y * box.height];
}

const time = (text) => Number(/Time\s+([\d.]+)/.exec(text)[1]);

test("the mouse over a curve shows its values there, and in the other plots", async () => {
  const page = await open(file);
  const rest = time(await legend(page, "force"));  // the step of the largest force
  assert.ok(Math.abs(rest - 13.033) < 0.3, rest);
  await page.mouse.move(...(await at(page, "force", 0.25)));
  await settled(page);
  const quarter = time(await legend(page, "force"));
  assert.ok(Math.abs(quarter - 6.07) < 0.3, quarter);
  for (const name of ["acceleration", "motion", "energy", "force-motion"])
    assert.equal(time(await legend(page, name)), quarter, name);
  assert.ok(await page.locator("#force-motion .marker").isVisible());
  await page.mouse.move(2, 2);
  await settled(page);
  assert.equal(time(await legend(page, "energy")), rest);
  assert.ok(!(await page.locator("#force-motion .marker").isVisible()));
});

test("the mouse over a loop finds the branch that is nearest", async () => {
  const page = await open(file);
  await page.mouse.move(...(await at(page, "force-penetration", 0.5, 0.9)));
  await settled(page);
  const loading = time(await legend(page, "force-penetration"));
  await page.mouse.move(...(await at(page, "force-penetration", 0.85, 0.9)));
  await settled(page);
  const unloading = time(await legend(page, "force-penetration"));
  assert.ok(loading < 13 && unloading > 13, `${loading}, ${unloading}`);
  assert.equal(time(await legend(page, "force")), unloading);
});

test("the mouse over the contact shows the stress at that radius", async () => {
  const page = await open(file);
  const axis = await legend(page, "stress");
  await page.mouse.move(...(await at(page, "stress", 0.5)));
  await settled(page);
  assert.notEqual(await legend(page, "stress"), axis);
  assert.match(await legend(page, "stress"), /Radius\s+2\d(\.\d+)? mm/);
});

test("arrow keys move along a curve", async () => {
  const page = await open(file);
  for (const name of ["energy", "force-motion"]) {
    const rest = time(await legend(page, name));
    await page.locator(`#${name} .plot`).focus();
    await page.keyboard.press("ArrowRight");
    const next = time(await legend(page, name));
    assert.ok(next > rest, `${name} ${next}`);
    await page.keyboard.press("End");
    assert.ok(Math.abs(time(await legend(page, name)) - 24.284) < 0.002);
    await page.keyboard.press("Escape");
    assert.equal(time(await legend(page, name)), rest);
  }
});

test("a finger shows values, too", async () => {
  const page = await open(file, { viewport: { width: 360, height: 740 }, isMobile: true, hasTouch: true });
  await page.touchscreen.tap(...(await at(page, "force", 0.3)));
  await settled(page);
  assert.ok(Math.abs(time(await legend(page, "force")) - 7.3) < 0.4);
});
