// The drawing moves with the slider of time, and stands as it was written when nobody moves it.

import assert from "node:assert/strict";
import test from "node:test";

import { example, figure, open, place, report, settled } from "./browser.mjs";

const cases = ["dashboard-20mph", "playground-mat-in-layers", "helmet-struck-by-a-ram", "head-on-door-panel"];
const files = Object.fromEntries(cases.map((name) => [name, report(example(name))]));

// Where things of the right picture are drawn, in its own px.
const seen = (page) =>
  page.locator(".drawing [data-penetration]").evaluate((group) => {
    const box = (name) => {
      const each = group.querySelector(name);
      const { y, height } = each.getBBox();
      const by = Number(/translate\(0[ ,](\S+)\)/.exec(each.getAttribute("transform"))?.[1] ?? 0);
      return { top: y + by, bottom: y + height + by };
    };
    const widest = [...group.querySelectorAll("[data-strain]")].map((layer) => Math.max(...[...layer.querySelectorAll("rect")].slice(1).map((rect) => Number(rect.getAttribute("width")))));
    return { nose: box(".dd-nose").bottom, pad: box(".dd-pad"), widest, data: { ...group.dataset }, heading: group.parentNode.querySelector(".dd-heading").textContent };
  });
const stand = (page, share) =>
  page.locator(".time input").evaluate((slider, part) => {
    slider.value = part * slider.max;
    slider.dispatchEvent(new Event("input"));
  }, share);
const values = async (page) => {
  const words = await page.locator(".time output").innerText();
  return { words, penetration: Number(/penetration ([\d.]+) mm/.exec(words)?.[1]), time: Number(/At ([\d.]+) ms/.exec(words)?.[1]) };
};

for (const name of cases)
  test(`${name}: the nose is as deep in the pad as the curve says`, async () => {
    const page = await open(files[name]);
    const written = await seen(page);
    assert.match(written.heading, /^Greatest penetration/);
    const { scale, penetration } = written.data;
    await stand(page, 0);
    const first = await seen(page);
    assert.ok(Math.abs(first.nose - first.pad.top) < 0.3, `at first contact ${first.nose} ${first.pad.top}`);
    assert.deepEqual(new Set(first.widest), new Set([0]), "no strain yet");
    for (const share of [0.1, 0.25, 0.6]) {
      await stand(page, share);
      const now = await seen(page);
      const { penetration: deep, time } = await values(page);
      assert.ok(Math.abs(now.nose - now.pad.top - (deep / 1000) * scale) < 0.003 * penetration * scale + 0.2, `${name} at ${time} ms`);
      assert.match(now.heading, /^At [\d.]+ ms$/);
    }
    assert.ok(Math.max(...(await seen(page)).widest) > 0);
    await stand(page, 1);
    assert.match(await page.locator(".time output").innerText(), /^At [\d.]+ ms: force .*penetration/, "at its end");
    assert.deepEqual(page.seen, { complaints: [], requests: [] });
  });

test("a sheet follows the nose, and a free body stays in the picture", async () => {
  const page = await open(report(example("rubber-top-on-a-mat")));
  const sheetAndNose = () =>
    page.locator(".drawing [data-penetration]").evaluate((group) => [".dd-sheet-bent", ".dd-nose"].map((name) => group.querySelector(name).getBoundingClientRect().bottom));
  for (const share of [0, 0.2, 0.5, 1]) {
    await stand(page, share);
    const [sheet, nose] = await sheetAndNose();
    assert.ok(Math.abs(sheet - nose) < 0.3, `at ${share}: ${sheet} and ${nose}`);
  }
  const struck = await open(files["helmet-struck-by-a-ram"]);
  await stand(struck, 1);
  const [body, frame] = await struck.locator(".drawing svg").first().evaluate((svg) => [svg.querySelector("[data-penetration] .dd-body"), svg].map((each) => each.getBoundingClientRect().bottom));
  assert.ok(body < frame, `${body} and ${frame}`);
});

test("who points at a curve moves the drawing, and it goes back", async () => {
  const page = await open(files["dashboard-20mph"]);
  const written = await seen(page);
  await page.mouse.move(...(await place(figure(page, "Force over time"), 0.2, 0.6)));
  await settled(page);
  assert.ok((await seen(page)).pad.top < written.pad.top - 5);
  assert.ok(!(await page.locator(".drawing .dd-dimension[data-of=deflection]").first().isVisible()));
  await page.mouse.move(2, 2);
  await settled(page);
  assert.deepEqual(await seen(page), written);
  assert.match(await page.locator(".time output").innerText(), /^The whole impact/);
});

test("it plays, and stands still where less motion is asked for", async () => {
  const page = await open(files["dashboard-20mph"]);
  await page.getByRole("button", { name: "Play" }).click();
  await page.waitForTimeout(400);
  await page.getByRole("button", { name: "Pause" }).click();
  const { time } = await values(page);
  assert.ok(time > 0.5 && time < 20, `${time} ms`);
  await settled(page);
  assert.equal((await values(page)).time, time);
  const still = await open(files["dashboard-20mph"], { reducedMotion: "reduce" });
  assert.equal(await still.getByRole("button", { name: "Play" }).count(), 0);
  assert.equal(await still.locator(".time input").count(), 1);
});

test("other units keep the moment", async () => {
  const page = await open(files["dashboard-20mph"]);
  await stand(page, 0.3);
  const before = await seen(page);
  const marks = await page.locator(".dp-pointer > *").count();
  assert.ok(marks > 5);
  await page.getByRole("radio", { name: "US" }).check();
  await settled(page);
  const after = await seen(page);
  assert.equal(await page.locator(".dp-pointer > *").count(), marks);
  assert.ok(Math.abs(after.nose - before.nose) < 0.05 && after.heading === before.heading);
  assert.match(await page.locator(".time output").innerText(), /penetration 0\.9\d+ in/);
});
