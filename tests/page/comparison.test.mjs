// A measured pulse over the computed one: the answer first, one chart with both curves, and the table.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import test from "node:test";

import { example, open, picture, scratch, words } from "./browser.mjs";

const { DASHPAD_COMMAND: command, DASHPAD_SOURCE_DIR: source } = process.env;
const file = join(scratch, "comparison.html");
const pulse = join(source, "examples/pulses/synthetic-helmet-pad.csv");
const cards = join(source, "materials");
execFileSync(command, ["compare", example("helmet-pad-10fps"), "--pulse", pulse, "--report", file, "--materials", cards], {
  stdio: "pipe",
});

test("the answer is the heading, and both curves are in one chart", async () => {
  const page = await open(file, { viewport: { width: 1300, height: 2000 } });
  assert.match(await words(page.locator("h1")), /^The computed peak is \d+ % higher than the measured one/);
  assert.equal(await page.locator(".dp-panel").count(), 1);
  assert.deepEqual(await page.locator(".dp-series").evaluateAll((all) => all.map(({ dataset }) => dataset.label)), ["computed", "measured"]);
  assert.deepEqual(page.seen, { complaints: [], requests: [] });
  assert.equal(await page.locator("table").first().locator("tbody tr").count(), 6);
  await page.screenshot({ path: picture("comparison.png") });
  await page.context().close();
});

test("on a phone nothing is wider than the screen", async () => {
  const page = await open(file, { viewport: { width: 390, height: 2400 }, isMobile: true });
  assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390);
  await page.screenshot({ path: picture("comparison-phone.png") });
  await page.context().close();
});
