// The live page: its numbers are those of the command, whatever is changed.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readdirSync, statSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";

import { example, open, picture, report, scratch, settled, write } from "./browser.mjs";
import { answered, changed, command, linkOf, livePage, openLive, shown, shownByCommand, source, stateOf, type } from "./live.mjs";

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
  assert.equal(await page.locator("#why-not").textContent(), "Thinnest pad: choose a standard first. At most four pads.");
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

test("what pads differ by stands above them", async () => {
  const page = await openLive(livePage(example("helmet-pad-10fps"), "--standard", "en-1078"));
  await changed(page, () => page.getByRole("button", { name: "Compare with another pad" }).click());
  await changed(page, () => page.getByLabel("Foam", { exact: true }).selectOption("ensolite-aac-21"));
  await page.getByText("Lowest peak acceleration: pad A, 38 % below pad B.").waitFor();
  const row = page.locator(".differences tr", { hasText: "Peak acceleration" });
  assert.match(await row.textContent(), /^Peak acceleration94\.65\sg\s✓151\.6\sg\s✓ \(\+60\s%\)$/);
});

test("pads whose intervals overlap are not told apart, and a copy is called one", async () => {
  const page = await openLive(livePage(example("dashboard-20mph")), { viewport: { width: 390, height: 844 } });
  await changed(page, () => page.getByRole("button", { name: "Compare with another pad" }).click());
  assert.ok(await page.getByText("Pad B is a copy of pad A: choose another foam or thickness.").isVisible());
  assert.ok(await page.locator("#pads").evaluate((pads) => pads.getBoundingClientRect().top < innerHeight / 2));
  assert.match((await shown(page))[0], /^B: Peak/);
  await type(page, "Thickness", "25.6 mm");
  for (const figure of ["peak acceleration", "HIC15", "3 ms clip"])
    await page.getByText(`Lowest ${figure}: pad B; within their uncertainty it cannot be told apart from pad A.`).waitFor();
  assert.equal(await page.getByText("is a copy").count(), 0);
});

test("with a fault no verdict of another standard stands", async () => {
  const page = await openLive(livePage(example("helmet-pad-10fps"), "--standard", "en-1078"));
  const field = page.getByRole("textbox", { name: "Thickness", exact: true });
  await field.fill("2,5 cm");
  await field.press("Enter");
  await page.locator(".slider:has([aria-invalid]) + #faults").waitFor();
  await page.getByLabel("Standard", { exact: true }).selectOption({ label: "FMVSS 201U, free-motion headform on upper interior" });
  await page.getByRole("heading", { name: "No answer: mend the marked field" }).waitFor();
  assert.equal(await page.locator("#found").textContent(), "");
  await type(page, "Thickness", "45 mm");
  assert.match((await shown(page)).join(), /HIC\(d\)/);
  await changed(page, () => page.getByLabel("Standard", { exact: true }).selectOption({ label: "EN 1078: headform A, 500 mm in circumference" }));
  assert.match(await page.locator("#found").textContent(), /are now those of the standard/);
});

test("a search tells how long it lasts, and is cancelled by its button or a change", async () => {
  const page = await openLive(livePage(example("helmet-pad-10fps"), "--standard", "en-1078"));
  await changed(page, () => page.getByLabel("Foam", { exact: true }).selectOption("ensolite-aac-21"));
  const button = page.locator("#thinnest");
  await button.click();
  await page.waitForFunction(() => /^Cancel the search \([1-9]\d* s\)$/.test(document.getElementById("thinnest").textContent));
  await button.click();
  await page.getByText("The search is cancelled.").waitFor();
  await button.click();
  await type(page, "Thickness", "60 mm");
  assert.equal(await button.textContent(), "Thinnest pad that passes");
  assert.equal(await page.locator("#found").textContent(), "");
});

test("the speed of the case is used by a button where it changes the verdict", async () => {
  const page = await openLive(livePage(example("dashboard-20mph"), "--standard", "fmvss-201-instrument-panel"));
  assert.doesNotMatch(await page.locator("body").innerText(), /--keep/);
  await changed(page, () => page.getByRole("button", { name: "Use the case's speed, 8.941 m/s (then: fail)" }).click());
  assert.match((await shown(page))[0], /Fails: 3\sms clip/);
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
