// The live page: its numbers are those of the command, whatever is changed, linked or dropped.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readdirSync, statSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";

import { example, open, picture, report, scratch, settled, write } from "./browser.mjs";

const { DASHPAD_COMMAND: command, DASHPAD_SOURCE_DIR: source } = process.env;

let count = 0;
function livePage(caseFile, ...more) {
  const file = join(scratch, `live-${++count}.html`);
  execFileSync(command, ["explore", caseFile, "--out", file, ...more], { cwd: source, stdio: "pipe" });
  return file;
}

// Everything is computed that was asked for, and is in the link.
const answered = (page) =>
  page.waitForFunction(() => {
    const { answer, complete } = document.getElementById("result").dataset;
    return document.querySelector("#sliders input") && document.querySelector("main footer") && !document.body.classList.contains("pending") && complete === answer;
  });

async function openLive(file, options) {
  const page = await open(file, options);
  page.setDefaultTimeout(60_000);
  await answered(page);
  return page;
}

// Heading and key figures, as people read them.
const shown = (page) =>
  page.evaluate(() => [document.querySelector("h1"), ...document.querySelectorAll("#result .key-figures li, body > .lead .key-figures li")].map((each) => each.textContent.trim()));

async function shownByCommand(file) {
  const page = await open(file);
  return shown(page);
}

// After a change that `make` makes.
async function changed(page, make) {
  const before = await page.evaluate(() => document.getElementById("result").dataset.answer);
  await make();
  await page.waitForFunction((before) => document.getElementById("result").dataset.answer !== before, before);
  await answered(page);
}

const type = (page, label, text) => changed(page, async () => {
  await page.getByRole("textbox", { name: label, exact: true }).fill(text);
  await page.getByRole("textbox", { name: label, exact: true }).press("Enter");
});

for (const name of readdirSync(join(source, "examples")).filter((name) => name.endsWith(".toml")))
  test(`${name} has the figures of the command`, async () => {
    const page = await openLive(livePage(join(source, "examples", name)));
    assert.deepEqual(await shown(page), await shownByCommand(report(join(source, "examples", name))));
    assert.deepEqual(page.seen, { complaints: [], requests: [] });
  });

test("the file is small enough, and ready soon", async () => {
  const file = livePage(example("dashboard-20mph"));
  assert.ok(statSync(file).size < 1.2e6, `${statSync(file).size} bytes`);
});

test("what is changed is solved as the command solves it", async () => {
  const page = await openLive(livePage(example("dashboard-20mph")));
  await type(page, "Thickness", "30 mm");
  await type(page, "Speed", "15 mph");
  await changed(page, () => page.getByLabel("Foam", { exact: true }).selectOption("vn600"));
  await changed(page, () => page.getByLabel("Support", { exact: true }).selectOption("rigid"));
  const rigid = write("rigid.toml", `title = "Dashboard at 20 mph (report, section 2.3)"
[impactor]
radius = "3 in"
weight = "10 lbf"
speed = "15 mph"
[pad]
thickness = "30 mm"
material = "vn600"
[support]
type = "rigid"
`);
  assert.deepEqual(await shown(page), await shownByCommand(report(rigid)));
  // The case that it shows is that case.
  const copied = write("copied.toml", await page.locator("#case").textContent());
  assert.deepEqual(await shown(page), await shownByCommand(report(copied)));
});

test("a slider moves the answer, and the keyboard moves the slider", async () => {
  const page = await openLive(livePage(example("dashboard-20mph")));
  const before = await shown(page);
  await page.getByRole("slider", { name: "Thickness, slider" }).focus();
  await changed(page, async () => {
    for (let i = 0; i < 5; ++i) await page.keyboard.press("PageUp");
  });
  assert.notDeepEqual(await shown(page), before);
});

test("a slider that is dragged to its end stays within its range", async () => {
  const page = await openLive(livePage(example("dashboard-20mph")));
  const slider = page.getByRole("slider", { name: "Thickness, slider" });
  const box = await slider.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  for (let i = 1; i <= 20; ++i) {
    await page.mouse.move(box.x + box.width / 2 + (i / 20) * box.width, box.y + box.height / 2);
    await settled(page);
  }
  await page.mouse.up();
  assert.match(await page.getByRole("textbox", { name: "Thickness", exact: true }).inputValue(), /^10[12] mm$/);
});

test("a verdict stands only where its interval is known", async () => {
  const page = await openLive(livePage(example("dashboard-20mph"), "--standard", "fmvss-201-instrument-panel"));
  assert.match((await shown(page))[0], /Undecided/);
  const headings = await page.evaluate(async () => {
    const range = document.querySelector("#sliders input[type=range]");
    const seen = [];
    const watcher = new MutationObserver(() => seen.push([document.querySelector("h1").textContent, document.body.classList.contains("pending")]));
    watcher.observe(document.getElementById("result"), { childList: true });
    for (let i = 0; i < 10 || (i < 200 && seen.length <= 3); ++i) {
      range.value = Number(range.value) + 0.02;
      range.dispatchEvent(new Event("input"));
      await new Promise((resolve) => setTimeout(resolve, 30));
    }
    watcher.disconnect();
    return seen;
  });
  assert.ok(headings.length > 3);
  for (const [heading, isPending] of headings) if (isPending) assert.match(heading, /^3 ms clip/);
});

test("numbers beside a standard are read by the engine", async () => {
  const page = await openLive(livePage(example("dashboard-20mph"), "--standard", "fmvss-201-instrument-panel"));
  const field = page.getByRole("textbox", { name: "Speed", exact: true });
  for (const text of ["1,5 m/s", "2/3 m/s", "8 0 m/s", "15 MPH", "3 kg"]) {
    await field.fill(text);
    await field.press("Enter");
    await page.waitForFunction(() => document.querySelector('[id="field impactor.speed"][aria-invalid="true"]'), null, { timeout: 20_000 });
  }
  await type(page, "Speed", "300 in/s");
  assert.match(await page.locator(".subject").allTextContents().then((all) => all.join(" ")), /7\.62\sm\/s given by you/);
});

test("quick hands break nothing", async () => {
  const page = await openLive(livePage(example("dashboard-20mph")));
  await page.getByRole("button", { name: "Compare with another pad" }).click();
  await page.waitForFunction(() => document.querySelectorAll(".pad").length === 2);
  await page.getByRole("button", { name: "Remove pad B" }).dblclick();
  await answered(page);
  await type(page, "Thickness", "40 mm");
  assert.match((await shown(page))[0], /^Peak/);
  assert.deepEqual(page.seen.complaints, []);
});

test("a fault stands at its field, and the answer stays", async () => {
  const page = await openLive(livePage(example("dashboard-20mph")));
  const before = await shown(page);
  const field = page.getByRole("textbox", { name: "Thickness", exact: true });
  for (const text of ["-3 mm", "0", "3 kg", "1e400 mm", "NaN", "<img src=x onerror=window.pwned=1>", "x".repeat(5000)]) {
    await field.fill(text);
    await field.press("Enter");
    await page.locator("#faults").waitFor();
    await page.waitForFunction(() => document.querySelector('[aria-invalid="true"]'));
    assert.deepEqual((await shown(page)).slice(0, 1), before.slice(0, 1), text);
  }
  assert.equal(await page.evaluate(() => window.pwned), undefined);
  await type(page, "Thickness", "1 in");
  assert.deepEqual(await shown(page), before);
  assert.deepEqual(page.seen, { complaints: [], requests: [] });
});

test("a standard gives the verdict of assess, and the thinnest pad is found", async () => {
  const page = await openLive(livePage(example("dashboard-20mph"), "--standard", "fmvss-201-instrument-panel"));
  const file = join(scratch, "assessed.html");
  try {
    execFileSync(command, ["assess", example("dashboard-20mph"), "--standard", "fmvss-201-instrument-panel", "--report", file], { stdio: "pipe" });
  } catch {
    // A verdict has an exit code.
  }
  assert.deepEqual(await shown(page), await shownByCommand(file));
  await page.getByRole("button", { name: "Thinnest pad that passes" }).click();
  await page.waitForFunction(() => /^(Passes|Fails|Nothing)/.test(document.getElementById("found").textContent));
  await answered(page);
});

test("up to four pads stand side by side, and the browser goes back", async () => {
  const page = await openLive(livePage(example("dashboard-20mph")));
  const add = page.getByRole("button", { name: "Compare with another pad" });
  for (const foam of ["vn600", "eps-29", "team-wendy-hard-pu"]) {
    await changed(page, () => add.click());
    await changed(page, () => page.getByLabel("Foam", { exact: true }).selectOption(foam));
  }
  await page.waitForFunction(() => document.querySelectorAll(".pad").length === 4);
  assert.ok(await add.isDisabled());
  await settled(page);
  await page.screenshot({ path: picture("live-four-pads.png") });
  const link = await page.evaluate(() => location.href);
  await page.goBack();
  await page.waitForFunction(() => document.querySelector(".pad.active h2").textContent.includes("polystyrene"));
  // A link that is put into the address is followed.
  await page.evaluate((link) => (location.hash = new URL(link).hash), link);
  await page.waitForFunction(() => document.querySelector(".pad.active h2").textContent.includes("Team Wendy"));
  // It shows the same elsewhere.
  const again = await page.context().newPage();
  await again.goto(link);
  await again.waitForFunction(() => document.querySelectorAll(".pad").length === 4);
});

const linkOf = (state) => `#${Buffer.from(JSON.stringify(state)).toString("base64url")}`;
const stateOf = (pad, more = {}) => ({ case: { impactor: { mass: "5 kg", radius: "80 mm", speed: "3 m/s" }, support: { type: "rigid" } }, pads: [pad], active: 0, standard: "", units: "si", user: {}, ...more });

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
  await page.getByLabel("Specimen thickness").fill("25 mm");
  await page.getByLabel("Specimen area").fill("25 cm2");
  await changed(page, () => page.getByRole("button", { name: "Fit a foam" }).click());
  assert.match(await page.locator("#fit-found").textContent(), /^Proposed: law foam with the measured curve as its base/);
  assert.equal(await page.getByLabel("Foam", { exact: true }).inputValue(), "epp-slow");
  await page.locator("#fitted summary").click();
  await page.locator("#fitted").getByText("What these tests do not determine").waitFor();
  // The case as text has the foam itself.
  const whole = write("with-foam.toml", await page.locator("#case").textContent());
  assert.deepEqual((await shown(page)).slice(0, 1), (await shownByCommand(report(whole))).slice(0, 1));
  await page.screenshot({ path: picture("live-fit.png") });

  const card = join(scratch, "epp-slow.toml");
  execFileSync(process.env.DASHPAD_COMMAND, ["fit", "--auto", ...tests, "--thickness", "25 mm", "--area", "25 cm2", "--output", card], { stdio: "pipe" });
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

test("the thinnest pad is that for the speed of the reader", async () => {
  const page = await openLive(livePage(example("dashboard-20mph"), "--standard", "fmvss-201-instrument-panel"));
  const thinnest = async () => {
    await page.evaluate(() => (document.getElementById("found").textContent = ""));
    await page.getByRole("button", { name: "Thinnest pad that passes" }).click();
    await page.waitForFunction(() => /The thickness is/.test(document.getElementById("found").textContent));
    await answered(page);
    return Number(/([\d.]+) mm/.exec(await page.locator("#found").textContent())[1]);
  };
  const usual = await thinnest();
  await type(page, "Speed", "5 m/s");
  assert.ok((await thinnest()) < usual);
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

test("sizes of the nose and the support are set", async () => {
  const page = await openLive(livePage(example("dashboard-20mph")));
  await type(page, "Radius", "60 mm");
  await type(page, "Stiffness", "50");
  const setting = ["--set", "impactor.radius=60 mm", "--set", "support.stiffness=50 N/mm"];
  assert.deepEqual(await shown(page), await shownByCommand(report(example("dashboard-20mph"), ...setting)));
  await changed(page, () => page.getByLabel("Nose", { exact: true }).selectOption("cylinder"));
  // Back at the sphere, its radius is there again, and the speed that was set meanwhile stays.
  await type(page, "Radius", "90 mm");
  await type(page, "Speed", "5 m/s");
  await changed(page, () => page.getByLabel("Nose", { exact: true }).selectOption("sphere"));
  assert.deepEqual(await shown(page), await shownByCommand(report(example("dashboard-20mph"), ...setting, "--set", "impactor.speed=5 m/s")));
  await changed(page, () => page.getByLabel("Nose", { exact: true }).selectOption("cylinder"));
  await page.getByRole("textbox", { name: "Length", exact: true }).fill("-3 mm");
  await page.keyboard.press("Enter");
  await page.locator("#faults").getByText(/Length.*must be/).waitFor();
});

test("what pads differ by stands below them", async () => {
  const page = await openLive(livePage(example("dashboard-20mph")));
  await changed(page, () => page.getByRole("button", { name: "Compare with another pad" }).click());
  await type(page, "Thickness", "50.8 mm");
  await page.getByText(/^Lowest peak acceleration: pad B, [\d.]+ % below pad A\.$/).waitFor();
  const row = page.locator(".differences tr", { hasText: "Peak acceleration" });
  await page.waitForFunction(() => /\(\u2212\d+ %\)/.test(document.querySelector(".differences").textContent));
  assert.match(await row.textContent(), /^Peak acceleration129\.4\sg[\d.]+\sg \(\u2212[\d.]+ %\)$/);
});

test("a case that does not end leaves the page alive", async () => {
  const endless = stateOf({ layers: [1, 2, 3, 4].map(() => ({ thickness: "20 mm", material: "vn600" })) });
  endless.case.solver = { tolerance: 1e-9 };
  const file = livePage(example("dashboard-20mph"));
  const page = await open(file);
  await page.goto("about:blank");
  await page.goto(`file://${file}${linkOf(endless)}`);
  await page.locator("#faults").waitFor();
  assert.match(await page.locator("#faults").textContent(), /no answer within|tolerance/);
  await changed(page, () => page.setInputFiles("#open", example("helmet-pad-10fps")));
  assert.match((await shown(page))[0], /^Peak 38/);
});

for (const [width, height] of [[390, 844], [768, 1024], [1300, 900]])
  for (const colorScheme of ["light", "dark"])
    test(`nothing is cut off ${width} px wide, ${colorScheme}`, async () => {
      const page = await openLive(livePage(example("helmet-pad-10fps"), "--standard", "en-1078"), { viewport: { width, height }, colorScheme });
      await settled(page);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
      await page.screenshot({ path: picture(`live-${width}-${colorScheme}.png`) });
    });

test("without a script the answer is there", async () => {
  const page = await open(livePage(example("dashboard-20mph")), { javaScriptEnabled: false });
  assert.match(await page.locator("h1").textContent(), /^Peak 129\sg/);
  assert.ok(await page.locator("#controls").isHidden());
});
