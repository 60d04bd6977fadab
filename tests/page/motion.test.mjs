// The drawing moves with the slider of time, and stands as it was written when nobody moves it.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";

import { example, figure, open, place, report, settled, write } from "./browser.mjs";

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

// The numbers of all that moves in the right picture, as they are drawn.
const shapes = (page) =>
  page.locator(".drawing [data-penetration]").evaluate((group) => {
    const ends = [...group.querySelectorAll("[data-behind]")].map((each) => each.getAttribute("d").match(/-?[\d.]+/g).map(Number));
    const rects = [...group.querySelectorAll("[data-strain] rect")].map((each) => ["x", "width"].map((name) => Number(each.getAttribute(name))));
    const boxes = [".dd-nose", ".dd-pad", ".dd-springs", ".dd-panel"].map((name) => group.querySelector(name)).filter(Boolean);
    const places = boxes.map((each) => {
      const { top, bottom } = each.getBoundingClientRect();
      return [top, bottom];
    });
    return { ends, rects, places };
  });
// Outlines are the same where they are drawn through other places, but for a part of a px.
const reach = (places) => [Math.min(...places), Math.max(...places)];

const edited = (name, to, ...edits) => {
  const text = readFileSync(example(name), "utf8");
  return write(to, edits.reduce((now, [old, fresh]) => {
    assert.ok(now.includes(old), `${old} in ${name}`);
    return now.replace(old, fresh);
  }, text));
};
const disc = report(edited("playground-mat-in-layers", "disc.toml", ['nose = "sphere"', 'nose = "flat-disc"']));

for (const [name, file] of [...Object.entries(files), ["a disc on layers", disc]])
  test(`${name}: before it moves it is as the library has drawn it`, async () => {
    const [plain, moving] = [await open(file, { javaScriptEnabled: false }), await open(file)];
    const [drawn, now] = [await shapes(plain), await shapes(moving)];
    const isClose = (a, b) => a.length === b.length && a.every((each, i) => Math.abs(each - b[i]) < 0.3);
    assert.equal(now.ends.length, drawn.ends.length);
    for (const [i, end] of drawn.ends.entries()) assert.ok(isClose(reach(end), reach(now.ends[i])), `${end}\n${now.ends[i]}`);
    for (const [i, rect] of drawn.rects.entries()) assert.ok(isClose(rect, now.rects[i]), `${rect} and ${now.rects[i]}`);
    const heights = ({ places }) => places.map(([top, bottom]) => [bottom - places[0][0], top - places[0][0]]).flat();
    assert.ok(isClose(heights(drawn), heights(now)), `${heights(drawn)}\n${heights(now)}`);
  });

test("the back of a layer below a disc is a step", async () => {
  const page = await open(disc);
  for (const moment of [null, 0.2, 0.5]) {
    if (moment !== null) await stand(page, moment);
    for (const places of (await shapes(page)).ends) {
      // Straight down at the edge of the disc: the same place across, another one down, inside of the pad.
      const isStep = (_, i) => i % 2 === 0 && i >= 2 && Math.abs(places[i] - places[i - 2]) < 0.01 && Math.abs(places[i + 1] - places[i - 1]) > 1;
      const steps = places.filter(isStep).filter((x) => x > reach(places.filter((_, i) => i % 2 === 0))[0] + 1);
      assert.ok(steps.length >= 1, `${moment}: ${places}`);
    }
  }
});

test("a support that gives way further stays in the picture", async () => {
  const page = await open(report(edited("head-on-door-panel", "heavy.toml", ['mass = "1.2 kg"', 'mass = "15 kg"'], ['stiffness = "100 N/mm"', 'stiffness = "15 N/mm"'])));
  for (const share of [0.3, 0.5, 0.7, 0.9, 1]) {
    await stand(page, share);
    const [panel, ground, stretch] = await page.locator(".drawing [data-penetration]").evaluate((group) => [
      group.querySelector(".dd-panel").getBoundingClientRect().bottom,
      group.querySelector(".dd-ground").getBoundingClientRect().top,
      Number(/matrix\(1 0 0 (\S+)/.exec(group.querySelector(".dd-springs").getAttribute("transform"))[1]),
    ]);
    assert.ok(panel < ground && stretch > 0, `at ${share}: panel ${panel}, ground ${ground}, springs ${stretch}`);
  }
});

test("the mark of a pad struck through is that of the greatest penetration", async () => {
  const page = await open(report(example("rigid-floor-bottoming")));
  // A line has no height to be visible by.
  const visibility = () => page.locator(".drawing .dd-struck-edge").first().evaluate((mark) => getComputedStyle(mark).visibility);
  assert.equal(await visibility(), "visible");
  await stand(page, 0);
  assert.equal(await visibility(), "hidden");
});

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
  // Stopped in the frame in which it has moved, or at its end where frames are that slow.
  await page.evaluate(() => new Promise((done) => {
    const button = [...document.querySelectorAll("button")].find(({ textContent }) => /^(Play|Pause)$/.test(textContent));
    const look = () => {
      const time = Number(/At ([\d.]+) ms/.exec(document.querySelector(".time output").innerText)?.[1]);
      if (!(time > 0.5)) return requestAnimationFrame(look);
      if (button.textContent === "Pause") button.click();
      done();
    };
    look();
  }));
  const { time } = await values(page);
  assert.ok(time > 0.5, `${time} ms`);
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
