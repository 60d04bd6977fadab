// A fit as a page: the answer first, the model over the test, bars with open ends, nothing wider than a phone.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import test from "node:test";

import { drawn, open, picture, scratch, words } from "./browser.mjs";

const { DASHPAD_COMMAND: command, DASHPAD_SOURCE_DIR: source } = process.env;
const file = join(scratch, "fit.html");
execFileSync(command, ["fit", join(source, "examples/fits/vn600.toml"), "--report", file], { stdio: "pipe" });

test("the answer is the heading, what is not determined stands below it", async () => {
  const page = await open(file, { viewport: { width: 1300, height: 2700 } });
  assert.deepEqual(page.seen, { complaints: [], requests: [] });
  assert.match(await words(page.locator("h1")), /^The data determine 4 of 5 unknowns and do not determine 1; the model deviates from the tests by 1\.2 %/);
  assert.match(await page.locator(".reservation").innerText(), /NOT DETERMINED: the data do not determine the modulus of the foam/);
  assert.equal(await page.locator("main .dp-panel").count(), 2);
  for (const { size } of await drawn(page)) assert.ok(size > 300);
  assert.equal(await page.locator(".ranges > li").count(), 5);
  const open_end = page.locator(".ranges > li", { hasText: "Modulus of the foam" });
  const fading = await open_end.locator(".interval").evaluateAll((all) => all.map((each) => Number(each.getAttribute("opacity"))));
  assert.ok(fading.at(-1) < 0.1 && fading[0] > 0.5, String(fading));
  assert.match(await open_end.innerText(), /from 45\d\.?\d* kPa, with no upper bound; the bar is logarithmic/);
  await page.screenshot({ path: picture("fit.png") });
  await page.context().close();
});

test("on a phone nothing is wider than the screen", async () => {
  const page = await open(file, { viewport: { width: 390, height: 3600 }, isMobile: true });
  assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390);
  await page.screenshot({ path: picture("fit-phone.png") });
  await page.context().close();
});
