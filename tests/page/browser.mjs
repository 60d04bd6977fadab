// Pages that the command writes, opened in a browser without a window.

import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, afterEach } from "node:test";
import { pathToFileURL } from "node:url";

const { DASHPAD_COMMAND: command, DASHPAD_SOURCE_DIR: source, PAGE_FOLDER: folder } = process.env;
const { chromium } = createRequire(join(folder, "tests/package.json"))("playwright-core");

export const pictures = join(folder, "pictures");
mkdirSync(pictures, { recursive: true });
export const picture = (name) => join(pictures, name);

export const scratch = mkdtempSync(join(tmpdir(), "dashpad-page-"));
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium" });
after(async () => {
  await browser.close();
  rmSync(scratch, { recursive: true });
});
// Pages that stay open take their share of the machine.
afterEach(() => Promise.all(browser.contexts().map((context) => context.close())));

export const example = (name) => join(source, "examples", `${name}.toml`);

export function write(name, text) {
  writeFileSync(join(scratch, name), text);
  return join(scratch, name);
}

let count = 0;
// The page of a case file. Exit code 3 is a result, too.
export function report(caseFile, ...more) {
  const file = join(scratch, `${++count}.html`);
  const options = ["run", caseFile, "--report", file, "--materials", join(source, "materials"), ...more];
  try {
    execFileSync(command, options, { stdio: "pipe" });
  } catch (error) {
    if (error.status !== 3) throw error;
  }
  return file;
}

// A page with all that it said on the console, and all that it asked of the network.
export async function open(file, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1200, height: 900 }, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(300_000);  // a guard against hanging: the machine may be slow
  const seen = { complaints: [], requests: [] };
  page.on("console", (message) => seen.complaints.push(`${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => seen.complaints.push(String(error)));
  await context.route("**/*", (route) => {
    const url = route.request().url();
    if (url === pathToFileURL(file).href) return route.continue();
    seen.requests.push(url);
    return route.abort();
  });
  await page.goto(pathToFileURL(file).href);
  // Without scripts nothing is drawn after the page is there.
  if (options.javaScriptEnabled !== false) await settled(page);
  return Object.assign(page, { seen });
}

// Two frames: what was asked for has been drawn.
export const settled = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 50)))));

// Of each plot below the answer its heading, and how many px its curves are wide and high together.
export const drawn = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll("main figure")].map((figure) => ({
      name: figure.querySelector("h3").textContent,
      size: [...figure.querySelectorAll(".dp-series path")].reduce((sum, path) => {
        const { width, height } = path.getBoundingClientRect();
        return sum + width + height;
      }, 0),
    })),
  );

export const figure = (page, heading) => page.locator("main figure", { has: page.getByRole("heading", { name: heading, exact: true }) });

// A place in a panel: shares of its width and height, from the upper left corner.
export async function place(of, x, y, index = 0) {
  const floor = of.locator(".dp-floor").nth(index);
  await floor.scrollIntoViewIfNeeded();
  const box = await floor.boundingBox();
  return [box.x + x * box.width, box.y + y * box.height];
}

// The same of two numbers on its axes, which are linear.
export async function placeOf(of, x, y, index = 0) {
  const data = await of.locator(".dp-panel").nth(index).evaluate(({ dataset }) => ({ ...dataset }));
  const share = (value, low, high) => (value - low) / (high - low);
  return place(of, share(x, data.xLow, data.xHigh), 1 - share(y, data.yLow, data.yHigh), index);
}

// What it says, with ordinary blanks also between numbers and their units.
export const words = async (of) => (await of.innerText()).replaceAll("\u00a0", " ");

export const tip = async (page) => {
  await settled(page);
  return page.locator(".tip:visible").allInnerTexts();
};

// The numbers on the axes of a panel, and all its other texts.
export const texts = (of, index = 0) => of.locator(".dp-panel").nth(index).locator("text").allTextContents();
