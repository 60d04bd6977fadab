// The page of figures that write_figures.cpp makes: everything is drawn, can be pointed at, enlarged and switched
// off, on any screen.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { statSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";

import { open, picture, place, placeOf, scratch, settled, texts, tip } from "./browser.mjs";

const attack = "</script><script>window.pwned=1</script><!-- <img src=x onerror=window.pwned=1>";
const file = join(scratch, "figures.html");
execFileSync(process.env.PAGE_FIGURES, [file]);

const tall = { viewport: { width: 1200, height: 6000 } };
const phone = { viewport: { width: 360, height: 9000 }, isMobile: true, hasTouch: true, deviceScaleFactor: 2 };
const quiet = { complaints: [], requests: [] };
const paths = (of, index = 0) => of.locator(".dp-panel").nth(index).locator(".dp-series:not(.dp-off) path").evaluateAll((all) => all.map((path) => path.getAttribute("d")));

test("all that is given is there, and nothing else is asked for", async () => {
  const page = await open(file, tall);
  assert.ok(statSync(file).size < 200_000, `${statSync(file).size} bytes`);
  assert.equal(await page.title(), "Figures of an example - Dashpad");
  assert.equal(await page.locator("figure").count(), 5);
  assert.equal(await page.locator(".dp-panel").count(), 8);
  for (const [i, panel] of (await page.locator(".dp-panel").all()).entries())
    assert.equal((await panel.locator(".dp-series path").count()) > 0, i < 7, `panel ${i}`);
  assert.equal(await page.getByText("no data").count(), 1);
  assert.deepEqual(await page.locator("h2").allInnerTexts(), ["Forces", "Materials", attack]);
  const first = page.locator("#figure-1-1");
  assert.equal(await first.locator("h3").innerText(), "Figure 1: Every style");
  assert.equal(await first.locator(".source").innerText(), "dashpad, an example; the tests are made up");
  assert.equal(await first.locator(".note").innerText(), "A note below it.");
  assert.match(await page.locator(".warnings").innerText(), /^EXTRAPOLATED: beyond/);
  for (const label of ["Force (kN)", "Time (ms)"]) assert.ok((await texts(first)).includes(label), label);
  assert.deepEqual(page.seen, quiet);
  await page.screenshot({ path: picture("figures.png"), fullPage: true });
});

test("tables have heads, and numbers on the right", async () => {
  const page = await open(file, tall);
  assert.equal(await page.locator("caption").first().innerText(), "Peaks of force");
  const first = page.getByRole("row", { name: /^first/ });
  assert.equal(await first.getByRole("rowheader").innerText(), "first");
  const sides = await first.locator("td").evaluateAll((cells) => cells.map((cell) => getComputedStyle(cell).textAlign));
  assert.deepEqual(sides, ["right", "right", "left"]);
});

test("no text becomes anything but text", async () => {
  const page = await open(file, tall);
  assert.equal(await page.evaluate(() => window.pwned), undefined);
  assert.equal(await page.locator("script").count(), 1);
  assert.equal(await page.locator("img, iframe").count(), 0);
  const figure = page.locator("#figure-3-1");
  assert.equal(await figure.locator("h3").textContent(), `${attack}: ${attack}`);
  for (const part of [".source", ".note"]) assert.equal(await figure.locator(part).textContent(), attack, part);
  await page.mouse.move(...(await place(figure, 0.5, 0.1)));
  assert.match((await tip(page))[0].replaceAll(attack, "A"), /^A: 0\.9\d*\nA: 0\.9\d*$/);
  assert.deepEqual(page.seen, quiet);
});

test("pointing shows the nearest place with its values", async () => {
  const page = await open(file, tall);
  const every = page.locator("#figure-1-1");
  assert.deepEqual(await tip(page), []);
  // The second test's point at 13 ms and 5 kN, on axes to 30 ms and 6 kN.
  const at = await placeOf(every, 13, 5);
  await page.mouse.move(...at);
  assert.deepEqual(await tip(page), ["test 2\nTime (ms): 13\nForce (kN): 5"]);
  const marker = await every.locator(".dp-marker").first().boundingBox();
  assert.ok(Math.hypot(marker.x + marker.width / 2 - at[0], marker.y + marker.height / 2 - at[1]) < 1.5, JSON.stringify(marker));
  await page.screenshot({ path: picture("figures-pointing.png"), clip: { x: 0, y: 600, width: 1200, height: 700 } });
  await page.mouse.move(...(await placeOf(every, 24, 3)));
  assert.deepEqual(await tip(page), ["contact ends\nTime (ms): 24"]);
  await page.mouse.move(...(await placeOf(every, 3, 5.4)));
  assert.deepEqual(await tip(page), ["limit\nForce (kN): 5.4"]);
  await page.mouse.move(2, 2);
  assert.deepEqual(await tip(page), []);
});

test("a loop is drawn and found there and back", async () => {
  const page = await open(file, tall);
  const force = async (down) => {
    await page.mouse.move(...(await placeOf(page.locator("#figure-1-2"), 15, down)));
    return Number(/Force \(N\): (\d+)/.exec((await tip(page))[0])[1]);
  };
  const [there, back] = [await force(900), await force(360)];
  assert.ok(Math.abs(there - 900) < 60, there);
  assert.ok(Math.abs(back - 360) < 40, back);
});

test("the name of a series switches it off and on in all panels", async () => {
  const page = await open(file, tall);
  const every = page.locator("#figure-1-1");
  const button = every.getByRole("button", { name: "model of 1984" }).first();
  assert.equal(await every.getByRole("button", { name: "model of 1984" }).count(), 2, "at its end in both panels");
  const before = [await paths(every, 0), await paths(every, 1)];
  await button.focus();
  await page.keyboard.press("Enter");
  assert.equal(await button.getAttribute("aria-pressed"), "false");
  for (const i of [0, 1]) assert.equal((await paths(every, i)).length, before[i].length - 1);
  await page.mouse.move(...(await place(every, 0.5, 0.2, 1)));
  assert.match((await tip(page))[0], /^computed/);
  await page.mouse.move(2, 2);
  await button.locator("text").first().click();
  assert.equal(await button.getAttribute("aria-pressed"), "true");
  for (const i of [0, 1]) assert.deepEqual(await paths(every, i), before[i]);
  assert.deepEqual(page.seen, quiet);
});

test("dragging enlarges both axes, and a double click goes back", async () => {
  const page = await open(file, tall);
  for (const id of ["#figure-1-1", "#figure-2-1"]) {
    const of = page.locator(id);
    const ends = async () => (await paths(of)).map((path) => path.split("M").length);
    const before = await paths(of);
    await page.mouse.move(...(await place(of, 0.2, 0.2)));
    await page.mouse.down();
    await page.mouse.move(...(await place(of, 0.5, 0.6)), { steps: 5 });
    await page.mouse.up();
    const ticks = (await of.locator(".dp-panel").first().locator(".dp-tick").allTextContents()).map(Number).filter(Number.isFinite);
    assert.ok(ticks.length >= 4, `ticks: ${ticks}`);
    if (id === "#figure-1-1") assert.ok(Math.max(...ticks) <= 15 && Math.min(...ticks) >= 2.4, `ticks: ${ticks}`);
    assert.notDeepEqual(await paths(of), before);
    assert.equal((await ends()).length, before.length);
    await page.mouse.dblclick(...(await place(of, 0.5, 0.5)));
    const places = (list) => list.flatMap((path) => (path.match(/[\d.]+/g) ?? []).map(Number));
    const [now, then] = [places(await paths(of)), places(before)];
    assert.equal(now.length, then.length);
    assert.ok(now.every((each, i) => Math.abs(each - then[i]) < 0.011), id);
  }
  assert.deepEqual(page.seen, quiet);
});

test("logarithmic axes have numbers at decades, drawn by the page as by the library", async () => {
  const page = await open(file, tall);
  const of = page.locator("#figure-2-1");
  const before = await of.locator(".dp-tick").allTextContents();
  for (const tick of ["10⁻³", "1", "100", "10⁻⁶"]) assert.ok(before.includes(tick), tick);
  await page.mouse.dblclick(...(await place(of, 0.5, 0.5)));
  await page.mouse.dblclick(...(await place(of, 0.5, 0.5, 1)));
  assert.deepEqual((await of.locator(".dp-tick").allTextContents()).sort(), before.sort());
});

test("arrow keys go along a series and to the next", async () => {
  const page = await open(file, tall);
  await page.locator("#figure-1-1 .dp-inside").nth(1).focus();
  await page.keyboard.press("End");
  assert.match((await tip(page))[0], /^computed\nTime \(ms\): 30\n/);
  await page.keyboard.press("ArrowDown");
  assert.match((await tip(page))[0], /^model of 1984\nTime \(ms\): (30|29\.\d+)\n/);
  await page.keyboard.press("Escape");
  assert.deepEqual(await tip(page), []);
});

test("a phone shows all without scrolling sideways, and a finger the values", async () => {
  const page = await open(file, phone);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
  const cut = await page.evaluate(() =>
    [...document.querySelectorAll("main *")]
      .filter((each) => !each.closest(".table") && each.getBoundingClientRect().right > 360.5)
      .map((each) => each.outerHTML.slice(0, 80)),
  );
  assert.deepEqual(cut, []);
  await page.touchscreen.tap(...(await placeOf(page.locator("#figure-1-1"), 13, 5)));
  assert.deepEqual(await tip(page), ["test 2\nTime (ms): 13\nForce (kN): 5"]);
  await page.screenshot({ path: picture("figures-phone.png"), fullPage: true });
});

test("dark and light follow the system, paper is light and has every plot", async () => {
  const page = await open(file, { colorScheme: "dark" });
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.equal(await paper(), "rgb(20, 24, 29)");
  await page.screenshot({ path: picture("figures-dark.png") });
  await page.emulateMedia({ colorScheme: "light" });
  await settled(page);
  assert.equal(await paper(), "rgb(255, 255, 255)");
  await page.emulateMedia({ media: "print", colorScheme: "dark" });
  await page.setViewportSize({ width: 720, height: 1000 });
  await settled(page);
  assert.equal(await paper(), "rgb(255, 255, 255)");
  await page.emulateMedia({ media: null, colorScheme: "dark" });
  const document = await page.pdf({ path: picture("figures.pdf"), format: "A4" });
  const pages = document.toString("latin1").match(/\/Type\s*\/Page\b/g).length;
  assert.ok(pages >= 3 && pages <= 6, `${pages} pages`);
  assert.deepEqual(page.seen, quiet);
});
