// The page of figures that write_figures.cpp makes: everything is drawn, can be pointed at, enlarged and switched
// off, on any screen.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { statSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";

import { open, picture, scratch, settled } from "./browser.mjs";

const attack = "</script><script>window.pwned=1</script><!-- <img src=x onerror=window.pwned=1>";
const file = join(scratch, "figures.html");
execFileSync(process.env.PAGE_FIGURES, [file]);

// High enough for all plots to be made.
const tall = { viewport: { width: 1200, height: 6000 } };
const phone = { viewport: { width: 360, height: 9000 }, isMobile: true, hasTouch: true, deviceScaleFactor: 2 };
const quiet = { complaints: [], requests: [] };

// Of each panel how many pixels are neither empty nor grey.
const inked = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll(".panel canvas")].map((canvas) => {
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      let pixels = 0;
      for (let i = 0; i < data.length; i += 4)
        if (data[i + 3] > 40 && Math.max(...data.slice(i, i + 3)) - Math.min(...data.slice(i, i + 3)) > 60) ++pixels;
      return pixels;
    }),
  );

const panel = (page, figure, index = 0) => page.locator(`#${figure} .panel`).nth(index);
// Of its pixels, short enough for a message.
async function image(page, figure, index = 0) {
  const url = await panel(page, figure, index).locator("canvas").evaluate((canvas) => canvas.toDataURL());
  return createHash("sha256").update(url).digest("hex");
}

async function place(page, figure, x, y, index = 0) {
  const box = await panel(page, figure, index).locator(".u-over").boundingBox();
  return [box.x + x * box.width, box.y + y * box.height];
}

const tip = async (page) => {
  await settled(page);
  return page.locator(".tip:visible").allInnerTexts();
};

test("all that is given is there, and nothing else is asked for", async () => {
  const page = await open(file, tall);
  assert.ok(statSync(file).size < 200_000, `${statSync(file).size} bytes`);
  assert.equal(await page.title(), "Figures of an example - Dashpad");
  assert.equal(await page.locator("figure").count(), 5);
  assert.equal(await page.locator(".panel").count(), 8);
  const ink = await inked(page);
  assert.equal(ink.length, 8);
  for (const [i, pixels] of ink.slice(0, 7).entries()) assert.ok(pixels > 300, `panel ${i} has ${pixels} pixels of ink`);
  assert.equal(ink[7], 0);
  assert.ok((await page.evaluate(() => window.written)).includes("no data"));
  assert.deepEqual(await page.locator("h2").allInnerTexts(), ["Contents", "Forces", "Materials", attack]);
  assert.equal(await page.locator("#figure-1-1 h3").innerText(), "Figure 1: Every style");
  assert.equal(await page.locator("#figure-1-1 .source").innerText(), "dashpad, an example; the tests are made up");
  assert.equal(await page.locator("#figure-1-1 .note").innerText(), "A note below it.");
  assert.match(await page.locator(".warnings").innerText(), /^EXTRAPOLATED: beyond/);
  assert.deepEqual(await panel(page, "figure-1-1").locator(".axis").allInnerTexts(), ["Force (kN)", "Time (ms)"]);
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

test("the contents lead to sections and figures", async () => {
  const page = await open(file);
  const links = page.locator("nav a");
  assert.equal(await links.count(), 3 + 5);
  for (const link of await links.all()) assert.equal(await page.locator(await link.getAttribute("href")).count(), 1);
  await page.getByRole("link", { name: "Figure 4: Many series" }).click();
  await settled(page);
  const box = await page.locator("#figure-2-2 .panel canvas").boundingBox();
  assert.ok(box.y > 0 && box.y < 900, `at ${box.y}`);
});

test("no text becomes anything but text", async () => {
  const page = await open(file, tall);
  assert.equal(await page.evaluate(() => window.pwned), undefined);
  assert.equal(await page.locator("script").count(), 2);
  assert.equal(await page.locator("img, svg, iframe").count(), 0);
  const figure = page.locator("#figure-3-1");
  assert.equal(await figure.locator("h3").textContent(), `${attack}: ${attack}`);
  for (const part of [".source", ".note", "h4 >> nth=0", ".axis >> nth=0", ".axis >> nth=1", ".legend button"])
    assert.equal(await figure.locator(part).textContent(), attack, part);
  await page.mouse.move(...(await place(page, "figure-3-1", 0.5, 0.1)));
  assert.deepEqual(await tip(page), [`${attack}\n${attack}: 1\n${attack}: 1`]);
  assert.deepEqual(page.seen, quiet);
});

test("pointing shows the nearest point with its values", async () => {
  const page = await open(file, tall);
  assert.deepEqual(await tip(page), []);
  // The second test's point at 13 ms and 5 kN, on axes to 30 ms and 6 kN.
  await page.mouse.move(...(await place(page, "figure-1-1", 13 / 30, 1 - 5 / 6)));
  assert.deepEqual(await tip(page), ["test 2\nTime (ms): 13\nForce (kN): 5"]);
  const marker = await panel(page, "figure-1-1").locator(".marker").boundingBox();
  const [x, y] = await place(page, "figure-1-1", 13 / 30, 1 - 5 / 6);
  assert.ok(Math.hypot(marker.x + 5.5 - x, marker.y + 5.5 - y) < 1.5, JSON.stringify(marker));
  await page.screenshot({ path: picture("figures-pointing.png"), clip: { x: 0, y: 600, width: 1200, height: 700 } });
  await page.mouse.move(...(await place(page, "figure-1-1", 24 / 30, 0.5)));
  assert.deepEqual(await tip(page), ["contact ends\nTime (ms): 24"]);
  await page.mouse.move(...(await place(page, "figure-1-1", 0.1, 1 - 5.4 / 6)));
  assert.deepEqual(await tip(page), ["limit\nForce (kN): 5.4"]);
  await page.mouse.move(...(await place(page, "figure-2-1", 0.8, 0.1, 1)));
  assert.match((await tip(page))[0], /^error\nSpeed \(m\/s\): 7\nError \(1\): 8e-7$/);
  await page.mouse.move(2, 2);
  assert.deepEqual(await tip(page), []);
});

test("a loop is drawn and found there and back", async () => {
  const page = await open(file, tall);
  const force = async (down) => {
    await page.mouse.move(...(await place(page, "figure-1-2", 0.6, 1 - down / 2500)));
    return Number(/Force \(N\): (\d+)/.exec((await tip(page))[0])[1]);
  };
  const [there, back] = [await force(900), await force(360)];
  assert.ok(Math.abs(there - 900) < 60, there);
  assert.ok(Math.abs(back - 360) < 40, back);
});

test("the legend switches series off and on in all panels", async () => {
  const page = await open(file, tall);
  const button = page.locator("#figure-1-1").getByRole("button", { name: "model of 1984" });
  assert.equal(await button.count(), 1);
  const before = [await image(page, "figure-1-1", 0), await image(page, "figure-1-1", 1)];
  await button.focus();
  await page.keyboard.press("Enter");
  await settled(page);
  assert.equal(await button.getAttribute("aria-pressed"), "false");
  for (const i of [0, 1]) assert.notEqual(await image(page, "figure-1-1", i), before[i]);
  await page.mouse.move(...(await place(page, "figure-1-1", 0.5, 0.2, 1)));
  assert.match((await tip(page))[0], /^computed/);
  await page.mouse.move(2, 2);
  await button.click();
  await settled(page);
  assert.equal(await button.getAttribute("aria-pressed"), "true");
  for (const i of [0, 1]) assert.equal(await image(page, "figure-1-1", i), before[i]);
  assert.deepEqual(page.seen, quiet);
});

test("each style has its own ink", async () => {
  const page = await open(file, tall);
  const buttons = page.locator("#figure-1-1 .legend button");
  assert.equal(await buttons.count(), 8);
  for (const button of await buttons.all()) {
    const before = await image(page, "figure-1-1");
    await button.click();
    await settled(page);
    assert.notEqual(await image(page, "figure-1-1"), before, await button.innerText());
  }
  await page.mouse.move(2, 2);
  await settled(page);
  assert.equal((await inked(page))[0], 0);
});

test("dragging enlarges both axes, and a double click goes back", async () => {
  const page = await open(file, tall);
  for (const [figure, index] of [["figure-1-1", 0], ["figure-2-1", 0]]) {
    const before = await image(page, figure, index);
    await page.mouse.move(...(await place(page, figure, 0.2, 0.2, index)));
    await page.mouse.down();
    await page.mouse.move(...(await place(page, figure, 0.5, 0.6, index)), { steps: 5 });
    await page.evaluate(() => window.written.splice(0));
    await page.mouse.up();
    await settled(page);
    const ticks = (await page.evaluate(() => window.written)).map(Number).filter(Number.isFinite);
    assert.ok(ticks.length >= 4, `ticks: ${ticks}`);
    if (figure === "figure-1-1") assert.ok(Math.max(...ticks) <= 15 && Math.min(...ticks) >= 2.4, `ticks: ${ticks}`);
    assert.notEqual(await image(page, figure, index), before);
    await page.mouse.dblclick(...(await place(page, figure, 0.5, 0.5, index)));
    await page.mouse.move(2, 2);
    await settled(page);
    assert.equal(await image(page, figure, index), before);
  }
  assert.deepEqual(page.seen, quiet);
});

test("logarithmic axes have numbers at decades", async () => {
  const page = await open(file, tall);
  const written = await page.evaluate(() => window.written);
  for (const tick of ["0.001", "1", "100", "10⁻⁶"]) assert.ok(written.includes(tick), tick);
});

test("arrow keys go along a series and to the next", async () => {
  const page = await open(file, tall);
  await panel(page, "figure-1-1", 1).locator(".plot").focus();
  for (const key of ["ArrowRight", "ArrowRight", "ArrowRight"]) await page.keyboard.press(key);
  assert.match((await tip(page))[0], /^computed\nTime \(ms\): 1\n/);
  await page.keyboard.press("End");
  assert.match((await tip(page))[0], /^computed\nTime \(ms\): 30\n/);
  await page.keyboard.press("ArrowDown");
  assert.match((await tip(page))[0], /^model of 1984\nTime \(ms\): (30|29\.5)\n/);
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
  await page.touchscreen.tap(...(await place(page, "figure-1-1", 13 / 30, 1 - 5 / 6)));
  assert.deepEqual(await tip(page), ["test 2\nTime (ms): 13\nForce (kN): 5"]);
  await page.screenshot({ path: picture("figures-phone.png"), fullPage: true });
});

test("dark and light follow the system, paper is light and has every plot", async () => {
  const page = await open(file, { colorScheme: "dark" });
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.equal(await paper(), "rgb(20, 24, 29)");
  const dark = await image(page, "figure-1-1");
  assert.ok((await page.locator(".panel canvas").count()) < 8, "plots far below are made later");
  await page.screenshot({ path: picture("figures-dark.png") });
  await page.emulateMedia({ colorScheme: "light" });
  await settled(page);
  assert.equal(await paper(), "rgb(255, 255, 255)");
  assert.notEqual(await image(page, "figure-1-1"), dark);
  await page.emulateMedia({ media: "print", colorScheme: "dark" });
  await page.setViewportSize({ width: 720, height: 1000 });
  await settled(page);
  assert.equal(await paper(), "rgb(255, 255, 255)");
  const ink = await inked(page);
  assert.equal(ink.length, 8);
  for (const pixels of ink.slice(0, 7)) assert.ok(pixels > 300, String(pixels));
  await page.emulateMedia({ media: null, colorScheme: "dark" });
  const document = await page.pdf({ path: picture("figures.pdf"), format: "A4" });
  const pages = document.toString("latin1").match(/\/Type\s*\/Page\b/g).length;
  assert.ok(pages >= 3 && pages <= 6, `${pages} pages`);
  assert.deepEqual(page.seen, quiet);
});
