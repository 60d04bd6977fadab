// One moment in all plots: by mouse, key or finger.

import assert from "node:assert/strict";
import test from "node:test";

import { example, figure, open, place, report, settled, tip } from "./browser.mjs";

const file = report(example("dashboard-20mph"));
const time = (text) => Number(/Time \(ms\): ([\d.]+)/.exec(text)[1]);
const value = (text) => Number(/: ([\d.]+)$/.exec(text)[1]);

// Where the mark of a panel stands, as shares of its width and height.
const marked = (of) =>
  of.locator(".dp-panel").evaluate((panel) => {
    const mark = panel.querySelector(".dp-pointer circle");
    return mark && [mark.getAttribute("cx") / panel.dataset.width, mark.getAttribute("cy") / panel.dataset.height];
  });

test("the mouse over a curve shows its values there, and the moment in the other plots", async () => {
  const page = await open(file);
  const force = figure(page, "Force over time");
  await page.mouse.move(...(await place(force, 0.25, 0.5)));
  const [words] = await tip(page);
  assert.ok(Math.abs(time(words) - 6.5) < 0.5, words);
  for (const heading of ["Deceleration over time", "Penetration and displacement over time", "Energy over time"]) {
    const [x] = await marked(figure(page, heading));
    assert.ok(Math.abs(25 * x - time(words)) < 0.02, `${heading} ${25 * x}`);
    assert.equal(await figure(page, heading).locator(".dp-hairline").count(), 1);
  }
  const loop = figure(page, "Force against displacement");
  const high = Number(await loop.locator(".dp-panel").getAttribute("data-y-high"));
  const [, y] = await marked(loop);
  assert.ok(Math.abs(high * (1 - y) - value(words)) < 15, `${high * (1 - y)} ${words}`);
  assert.notEqual(await marked(page.locator(".lead figure").last()), null);
  await page.mouse.move(2, 2);
  await settled(page);
  assert.equal(await page.locator(".dp-pointer > *").count(), 0);
});

test("the mouse over a loop finds the branch that is nearest", async () => {
  const page = await open(file);
  const loop = figure(page, "Force against penetration");
  const force = figure(page, "Force over time");
  await page.mouse.move(...(await place(loop, 0.5, 0.9)));
  await settled(page);
  const [loading] = await marked(force);
  await page.mouse.move(...(await place(loop, 0.75, 0.9)));
  await settled(page);
  const [unloading] = await marked(force);
  assert.ok(25 * loading < 13 && 25 * unloading > 13, `${loading}, ${unloading}`);
});

test("the mouse over the contact shows the stress at that radius", async () => {
  const page = await open(file);
  await page.mouse.move(...(await place(figure(page, "Stress across the contact"), 0.5, 0.4)));
  assert.match((await tip(page))[0], /ms, .*\nRadius \(mm\): [23]\d(\.\d+)?\nStress \(kPa\): /);
});

test("arrow keys move along a curve, plus and minus enlarge", async () => {
  const page = await open(file);
  const force = figure(page, "Force over time");
  await force.locator(".dp-inside").focus();
  await page.keyboard.press("ArrowRight");
  const first = time((await tip(page))[0]);
  await page.keyboard.press("ArrowRight");
  assert.ok(time((await tip(page))[0]) > first);
  await page.keyboard.press("End");
  assert.ok(Math.abs(time((await tip(page))[0]) - 24.28) < 0.03);
  await page.keyboard.press("Escape");
  assert.deepEqual(await tip(page), []);
  await page.keyboard.press("+");
  assert.equal(await force.locator(".dp-enlarged").count(), 1);
  await page.keyboard.press("0");
  assert.equal(await force.locator(".dp-enlarged").count(), 0);
});

test("an enlarged plot goes where the keys go, and nothing is marked outside of it", async () => {
  const page = await open(file);
  const force = figure(page, "Force over time");
  const height = () => page.evaluate(() => document.documentElement.scrollHeight);
  const before = await height();
  await force.locator(".dp-inside").focus();
  for (const key of ["ArrowRight", "ArrowRight", "+", "+", "+", "+", "+", "+", "End"]) await page.keyboard.press(key);
  const [x, y] = await marked(force);
  assert.ok(x >= -0.01 && x <= 1.01 && y >= -0.01 && y <= 1.01, `${x} ${y}`);
  assert.match((await tip(page))[0], /Time \(ms\): 24/);
  await page.mouse.move(...(await place(figure(page, "Energy over time"), 0.3, 0.5)));
  await settled(page);
  assert.equal(await force.locator(".dp-pointer > *").count(), 0, "the moment is not in view");
  assert.ok(Math.abs((await height()) - before) < 60);
  for (let i = 0; i < 7; ++i) {
    await force.locator(".dp-inside").focus();
    await page.keyboard.press("-");
  }
  assert.equal(await force.locator(".dp-enlarged").count(), 0, "whole again");
});

test("a click leaves the mark where it is", async () => {
  const page = await open(file);
  const force = figure(page, "Force over time");
  await page.mouse.move(...(await place(force, 0.25, 0.5)));
  const mark = await marked(force);
  await page.mouse.down();
  await page.mouse.up();
  (await marked(force)).forEach((share, i) => assert.ok(Math.abs(share - mark[i]) < 0.005));
  assert.equal((await tip(page)).length, 1);
});

test("keys begin with the curve, not with the bracket of the HIC", async () => {
  const page = await open(file);
  const deceleration = figure(page, "Deceleration over time");
  await deceleration.locator(".dp-inside").focus();
  await page.keyboard.press("ArrowRight");
  assert.doesNotMatch((await tip(page))[0], /HIC/);
});

test("a finger shows values, too", async () => {
  const page = await open(file, { viewport: { width: 360, height: 740 }, isMobile: true, hasTouch: true });
  await page.touchscreen.tap(...(await place(figure(page, "Force over time"), 0.3, 0.4)));
  assert.ok(Math.abs(time((await tip(page))[0]) - 7.3) < 0.6);
});
