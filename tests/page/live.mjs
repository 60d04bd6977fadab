// Live pages, opened and changed as by a reader.

import { execFileSync } from "node:child_process";
import { join } from "node:path";

import { open, scratch } from "./browser.mjs";

export const { DASHPAD_COMMAND: command, DASHPAD_SOURCE_DIR: source } = process.env;

let count = 0;
export function livePage(caseFile, ...more) {
  const file = join(scratch, `live-${++count}.html`);
  execFileSync(command, ["explore", caseFile, "--out", file, ...more], { cwd: source, stdio: "pipe" });
  return file;
}

// Everything is computed that was asked for, and is in the link.
export const answered = (page) =>
  page.waitForFunction(() => {
    const { answer, complete } = document.getElementById("result").dataset;
    return document.querySelector("#sliders input") && document.querySelector("main footer") && !document.body.classList.contains("pending") && complete === answer;
  });

export async function openLive(file, options) {
  const page = await open(file, options);
  page.setDefaultTimeout(60_000);
  await answered(page);
  return page;
}

// Heading and key figures, as people read them.
export const shown = (page) =>
  page.evaluate(() => [document.querySelector("h1"), ...document.querySelectorAll("#result .key-figures li, body > .lead .key-figures li")].map((each) => each.textContent.trim()));

export async function shownByCommand(file) {
  const page = await open(file);
  return shown(page);
}

// After a change that `make` makes.
export async function changed(page, make) {
  const before = await page.evaluate(() => document.getElementById("result").dataset.answer);
  await make();
  await page.waitForFunction((before) => document.getElementById("result").dataset.answer !== before, before);
  await answered(page);
}

export const type = (page, label, text) => changed(page, async () => {
  await page.getByRole("textbox", { name: label, exact: true }).fill(text);
  await page.getByRole("textbox", { name: label, exact: true }).press("Enter");
});

export const linkOf = (state) => `#${Buffer.from(JSON.stringify(state)).toString("base64url")}`;
export const stateOf = (pad, more = {}) => ({ case: { impactor: { mass: "5 kg", radius: "80 mm", speed: "3 m/s" }, support: { type: "rigid" } }, pads: [pad], active: 0, standard: "", units: "si", user: {}, ...more });
