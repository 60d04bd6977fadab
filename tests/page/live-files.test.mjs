// Files that are dropped on the live page, and links of strangers.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import test from "node:test";

import { example, open, picture, report, scratch, write } from "./browser.mjs";
import { answered, changed, command, linkOf, livePage, openLive, shown, shownByCommand, source, stateOf, type } from "./live.mjs";

test("a link of a stranger is data, or nothing", async () => {
  const file = livePage(example("dashboard-20mph"));
  const own = await shown(await openLive(file));
  const nothing = ["#x", "#%", `#${"A".repeat(70000)}`, linkOf([]), linkOf({}), linkOf(stateOf({}, { pads: [] })), linkOf(stateOf({}, { active: 7 })), linkOf(stateOf({}, { pads: [null] })), linkOf(stateOf({}, { units: "furlong" })), linkOf(stateOf({}, { user: { do: 1 } })), linkOf(stateOf(JSON.parse(`${'{"a":'.repeat(3000)}1${"}".repeat(3000)}`)))];
  for (const link of nothing) {
    const page = await open(file);
    await page.goto("about:blank");
    await page.goto(`file://${file}${link}`);
    await answered(page);
    assert.deepEqual(await shown(page), own, link.slice(0, 40));
    assert.deepEqual(page.seen.complaints, []);
  }
  const attack = "</script><img src=x onerror=window.pwned=1>";
  const hostile = [
    stateOf({ thickness: "20 mm", material: attack }),
    stateOf({ thickness: "20 mm", material: "vn600" }, { case: { title: attack, impactor: { mass: "5 kg", radius: "80 mm", speed: "3 m/s" }, support: { type: "rigid" }, [attack]: attack } }),
    stateOf({ thickness: { deep: [[[[1]]]] } }),
    stateOf({ thickness: "20 mm", material: "../../../etc/passwd" }),
    stateOf({ thickness: "20 mm", material: "vn600" }, { standard: attack }),
    stateOf({ thickness: "20 mm", material: "vn600" }, { user: { mass: -1, speed: 1e300 }, standard: "en-1078" }),
    stateOf({ thickness: "20 mm", material: "vn600", ["__proto__x"]: attack }),
    stateOf({ layers: Array.from({ length: 300 }, () => ({ thickness: "20 mm", material: "vn600" })) }),
  ];
  for (const state of hostile) {
    const page = await open(file);
    await page.goto("about:blank");
    await page.goto(`file://${file}${linkOf(state)}`);
    await page.locator("#faults").waitFor();
    assert.equal(await page.evaluate(() => window.pwned), undefined);
    assert.deepEqual(page.seen.complaints, []);
    // It is still a page: a case of one's own is answered.
    await page.selectOption("#standard", "");
    await changed(page, () => page.setInputFiles("#open", example("helmet-pad-10fps")));
  }
});

test("what is dropped is read as the command reads it", async () => {
  const page = await openLive(livePage(example("dashboard-20mph")));
  const drop = (name, text) => page.setInputFiles("#open", { name, mimeType: "text/plain", buffer: Buffer.from(text) });
  await drop("broken.toml", '[impactor]\nmass = "5 kpg"\n[pad\n');
  await page.locator("#faults").waitFor();
  assert.match(await page.locator("#faults").textContent(), /broken|the case/);
  await drop("noise.toml", Buffer.from(Array.from({ length: 3000 }, (_, i) => (i * 7919) % 256)));
  await page.locator("#faults").waitFor();
  await changed(page, () => page.setInputFiles("#open", example("helmet-pad-10fps")));
  assert.deepEqual(await shown(page), await shownByCommand(report(example("helmet-pad-10fps"))));
  const card = 'title = "My foam"\nsource = "a test"\nlaw = "elastic"\n[parameters]\nmodulus = "300 kPa"\n';
  await changed(page, () => drop("my-foam.toml", card));
  assert.equal(await page.getByLabel("Foam", { exact: true }).inputValue(), "my-foam");
});

test("compression tests become a foam, which the link takes along", async () => {
  const tests = ["slow", "fast"].map((name) => join(source, "examples/tutorial", `epp-${name}.csv`));
  const page = await openLive(livePage(example("dashboard-20mph")));
  await page.setInputFiles("#tests", tests);
  await page.locator("#test-faults").waitFor();
  assert.match(await page.locator("#test-faults").textContent(), /displacement_mm: is a displacement; for a strain, give the specimen thickness\n/);
  // What they lack is asked for, and then they are fitted by themselves.
  assert.equal(await page.evaluate(() => document.activeElement.id), "test-thickness");
  await page.keyboard.type("25 mm");
  await page.getByLabel("Specimen area").fill("25 cm2");
  await changed(page, () => page.keyboard.press("Enter"));
  assert.ok(await page.locator("#test-faults").isHidden());
  assert.match(await page.locator("#fit-found").textContent(), /^Proposed: law foam with the measured curve as its base/);
  assert.equal(await page.getByLabel("Foam", { exact: true }).inputValue(), "epp-slow");
  await page.locator("#fitted summary").click();
  await page.locator("#fitted").getByText("What these tests do not determine").waitFor();
  // The case as text has the foam itself.
  const whole = write("with-foam.toml", await page.locator("#case").textContent());
  assert.deepEqual((await shown(page)).slice(0, 1), (await shownByCommand(report(whole))).slice(0, 1));
  await page.screenshot({ path: picture("live-fit.png") });

  const card = join(scratch, "epp-slow.toml");
  execFileSync(command, ["fit", "--auto", ...tests, "--thickness", "25 mm", "--area", "25 cm2", "--output", card], { stdio: "pipe" });
  const setting = ["--set", `pad.material=${card}`];
  const figures = await shown(page);
  assert.deepEqual(figures.slice(0, 1), (await shownByCommand(report(example("dashboard-20mph"), ...setting))).slice(0, 1));
  const file = livePage(example("helmet-pad-10fps"));
  const colleague = await open(file);
  await colleague.goto("about:blank");
  await colleague.goto(`file://${file}${new URL(page.url()).hash}`);
  await answered(colleague);
  assert.deepEqual(await shown(colleague), figures);
  assert.deepEqual(page.seen, { complaints: [], requests: [] });
});

test("a measured pulse is shown beside the computed one", async () => {
  const page = await openLive(livePage(example("helmet-pad-10fps"), "--standard", "en-1078"));
  await page.setInputFiles("#open", join(source, "examples/pulses/synthetic-helmet-pad.csv"));
  const summary = page.locator("#fitted summary");
  await summary.getByText("The pulse in synthetic-helmet-pad.csv: Within the limits").waitFor();
  const compared = await page.locator("#fitted h2").first().textContent();
  assert.match(compared, /The computed peak is /);
  await page.screenshot({ path: picture("live-pulse.png"), fullPage: true });
  // It follows the case.
  await type(page, "Thickness", "50 mm");
  await page.waitForFunction((before) => document.querySelector("#fitted h2").textContent !== before, compared);
  await page.setInputFiles("#open", { name: "acc.csv", mimeType: "text/csv", buffer: Buffer.from("time_ms,acc_g\n0,0\n1,x\n") });
  await page.locator("#faults").getByText(/acc.csv/).waitFor();
  assert.deepEqual(page.seen, { complaints: [], requests: [] });
});

test("tables that are no compression tests are refused in the words of the command", async () => {
  const page = await openLive(livePage(example("dashboard-20mph")));
  const figures = await shown(page);
  for (const [text, words] of [["", /is empty/], ["a,b\n1,2\n", /no column for the strain/], ["strain,stress_kPa\n0,0\n0.1,nan\n", /tests.csv:3/], ["<img src=x onerror=alert(1)>\n", /is XML or HTML/], ["\0\x01", /is not text/]]) {
    await page.setInputFiles("#tests", { name: "tests.csv", mimeType: "text/csv", buffer: Buffer.from(text) });
    await page.waitForFunction((words) => document.getElementById("fit-found").textContent === "" && new RegExp(words).test(document.getElementById("test-faults").textContent), words.source);
    await page.evaluate(() => document.getElementById("test-faults").replaceChildren());
  }
  await page.setInputFiles("#tests", { name: "tests.csv", mimeType: "text/csv", buffer: Buffer.alloc(2 ** 20 + 1, 49) });
  await page.locator("#faults").getByText("larger than 1 MiB").waitFor();
  assert.deepEqual(await shown(page), figures);
});
