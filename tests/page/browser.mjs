// Pages that the command writes, opened in a browser without a window.

import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after } from "node:test";
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

// A page with all that it said on the console, all that it asked of the network, and all that it wrote on
// canvases.
export async function open(file, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1200, height: 900 }, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(10_000);
  const seen = { complaints: [], requests: [] };
  page.on("console", (message) => seen.complaints.push(`${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => seen.complaints.push(String(error)));
  await context.route("**/*", (route) => {
    const url = route.request().url();
    if (url === pathToFileURL(file).href) return route.continue();
    seen.requests.push(url);
    return route.abort();
  });
  if (options.javaScriptEnabled !== false) await page.addInitScript(() => {
    window.written = [];
    const fillText = CanvasRenderingContext2D.prototype.fillText;
    CanvasRenderingContext2D.prototype.fillText = function (text, ...more) {
      window.written.push(text);
      return fillText.call(this, text, ...more);
    };
  });
  await page.goto(pathToFileURL(file).href);
  // Without scripts nothing is drawn after the page is there.
  if (options.javaScriptEnabled !== false) await settled(page);
  return Object.assign(page, { seen });
}

// Two frames: what was asked for has been drawn.
export const settled = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 50)))));

// Of each plot its name and how many pixels of its canvas are a line in colour.
export const inked = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll("main figure")].map((figure) => {
      const canvas = figure.querySelector("canvas");
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      let pixels = 0;
      for (let i = 0; i < data.length; i += 4) {
        const [red, green, blue, alpha] = data.slice(i, i + 4);
        if (alpha > 128 && Math.max(red, green, blue) - Math.min(red, green, blue) > 60) ++pixels;
      }
      return { name: figure.id, pixels };
    }),
  );

export const legend = (page, name) => page.locator(`#${name} .legend`).innerText();
