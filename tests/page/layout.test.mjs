// On a phone, in the dark, on paper. Pictures of all of them are kept.

import assert from "node:assert/strict";
import test from "node:test";

import { drawn, example, figure, open, picture, report, settled } from "./browser.mjs";

const file = report(example("dashboard-20mph"));
const paper = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);

// Contrast of two colours as WCAG defines it.
function contrast(...colours) {
  const light = colours.map((colour) => {
    const parts = /rgb\((\d+), (\d+), (\d+)\)/.exec(colour).slice(1).map((part) => part / 255);
    const [red, green, blue] = parts.map((c) => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  });
  return (Math.max(...light) + 0.05) / (Math.min(...light) + 0.05);
}

// Every colour of text against the colour behind it.
const pairs = (page) =>
  page.evaluate(() => {
    const behind = (element) => {
      for (let each = element; each; each = each.parentElement) {
        const colour = getComputedStyle(each).backgroundColor;
        if (!colour.endsWith(", 0)")) return colour;
      }
      return "rgb(255, 255, 255)";
    };
    return [...document.querySelectorAll(".lead :not(svg *), main :not(svg *)")]
      .filter((each) => [...each.childNodes].some((node) => node.nodeType === 3 && node.data.trim()))
      .map((each) => [each.className || each.localName, getComputedStyle(each).color, behind(each)]);
  });

test("a phone shows all without scrolling sideways", async () => {
  const page = await open(file, { viewport: { width: 360, height: 740 }, isMobile: true, hasTouch: true, deviceScaleFactor: 2 });
  for (const units of ["SI", "US", "Engineering metric"]) {
    await page.getByRole("radio", { name: units }).check();
    await settled(page);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360, units);
    const cut = await page.evaluate(() =>
      [...document.querySelectorAll("main *, .lead *")].filter((each) => each.getBoundingClientRect().right > 360.5).map((each) => each.outerHTML.slice(0, 80)),
    );
    assert.deepEqual(cut, [], units);
  }
  await page.screenshot({ path: picture("phone.png"), fullPage: true });
});

// The smallest text in each kind of picture, px as they are seen.
const sizes = (page) =>
  page.evaluate(() => {
    const least = { drawing: Infinity, plots: Infinity };
    for (const text of document.querySelectorAll("svg.dp-plot text, .drawing > svg:first-child text")) {
      const svg = text.ownerSVGElement.closest(".dp-plot, .drawing > svg");
      const kind = svg.matches(".dp-plot") ? "plots" : "drawing";
      const halves = kind === "drawing" ? [...document.querySelectorAll(".drawing > .half")].filter((half) => half.getBoundingClientRect().width > 0) : [];
      const group = text.closest("[id$=-half]");
      const shown = halves.find((half) => `#${group?.id}` === half.querySelector("use").getAttribute("href")) ?? svg;
      const scale = shown.getBoundingClientRect().width / shown.viewBox.baseVal.width;
      least[kind] = Math.min(least[kind], Number.parseFloat(getComputedStyle(text).fontSize) * scale);
    }
    return least;
  });

test("texts of pictures can be read at every width", async () => {
  const page = await open(report(example("knee-on-bolster")));
  for (const width of [360, 390, 480, 560, 720, 970, 1024, 1200, 1280, 1600]) {
    await page.setViewportSize({ width, height: 800 });
    await settled(page);
    const { drawing, plots } = await sizes(page);
    const least = width < 400 ? 10.8 : 11.8;
    assert.ok(drawing >= least && plots >= least, `${width} px: drawing ${drawing}, plots ${plots}`);
  }
});

test("light and dark follow the system and can be read", async () => {
  for (const [scheme, background] of [["light", "rgb(255, 255, 255)"], ["dark", "rgb(20, 24, 29)"]]) {
    const page = await open(file, { colorScheme: scheme });
    assert.equal(await paper(page), background);
    for (const [what, text, behind] of await pairs(page))
      assert.ok(contrast(text, behind) >= 4.5, `${scheme}: ${what} ${text} on ${behind}`);
    for (const { name, size } of await drawn(page)) assert.ok(size > 300, name);
    await page.screenshot({ path: picture(`${scheme}.png`), fullPage: true });
  }
});

test("a change of the system's scheme changes the plots", async () => {
  const page = await open(file, { colorScheme: "light" });
  const colour = () => figure(page, "Force over time").locator(".dp-series").evaluate((curve) => getComputedStyle(curve).color);
  const light = await colour();
  await page.emulateMedia({ colorScheme: "dark" });
  assert.notEqual(await colour(), light);
});

test("paper is light, two plots wide, and the screen is as before", async () => {
  const page = await open(file, { colorScheme: "dark" });
  const width = () => figure(page, "Force over time").locator("svg.dp-plot").evaluate((svg) => svg.getBoundingClientRect().width);
  const before = await width();
  await page.emulateMedia({ media: "print", colorScheme: "dark" });
  await page.setViewportSize({ width: 720, height: 1000 });
  await settled(page);
  assert.equal(await paper(page), "rgb(255, 255, 255)");
  assert.ok((await width()) > 300 && (await width()) < 360, `${await width()} px`);
  for (const { name, size } of await drawn(page)) assert.ok(size > 300, name);
  assert.ok(!(await page.locator(".units").isVisible()));
  await page.screenshot({ path: picture("print.png"), fullPage: true });
  await page.emulateMedia({ media: "screen", colorScheme: "dark" });
  await page.setViewportSize({ width: 1200, height: 900 });
  await settled(page);
  assert.equal(await width(), before);
  await page.emulateMedia({ media: null, colorScheme: "dark" });
  const document = await page.pdf({ path: picture("print.pdf"), format: "A4" });
  const pages = document.toString("latin1").match(/\/Type\s*\/Page\b/g).length;
  assert.ok(pages >= 2 && pages <= 5, `${pages} pages`);
  assert.deepEqual(page.seen, { complaints: [], requests: [] });
});
