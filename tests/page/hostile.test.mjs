// Text of a user is text, whatever it looks like.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";

import { drawn, open, report, write } from "./browser.mjs";

const attacks = [
  "</script><script>window.pwned=1</script>",
  "<img src=x onerror=window.pwned=1>",
  `"'\`--><!--<svg onload=window.pwned=1>`,
  "\\u003c/script> &lt;b&gt; ${window.pwned=1} {{7*7}} \u2028 \u202e ]]>",
];

// What a terminal or page would obey instead of showing it is shown as a space.
const shown = (text) => text.replace(/[\u2028\u202e]/g, " ");

const card = (text) => `title = ${JSON.stringify(text)}
source = ${JSON.stringify(text)}
law = "elastic"
[parameters]
modulus = "300 kPa"
`;

const impact = (title, material) => `title = ${JSON.stringify(title)}
[impactor]
mass = "5 kg"
radius = "80 mm"
speed = "3 m/s"
[pad]
thickness = "50 mm"
material = ${JSON.stringify(material)}
[support]
type = "linear"
stiffness = "100 N/mm"
`;

for (const [i, attack] of attacks.entries())
  test(`attack ${i + 1} is shown as it is`, async () => {
    const name = attack.replaceAll("/", "");
    write(`${name}.toml`, card(attack));
    const file = report(write(`hostile-${i}.toml`, impact(attack, `${name}.toml`)));
    const page = await open(file);
    assert.equal(await page.evaluate(() => window.pwned), undefined);
    assert.equal(await page.locator(".subject").first().textContent(), shown(attack));
    assert.ok((await page.locator("main").textContent()).includes(shown(name)));
    assert.ok((await page.locator("pre").textContent()).includes(JSON.stringify(shown(attack))));
    assert.equal(await page.locator("img, iframe").count(), 0);
    const listeners = () => [...document.querySelectorAll("*")].flatMap((each) => each.getAttributeNames().filter((name) => name.startsWith("on")));
    assert.deepEqual(await page.evaluate(listeners), []);
    assert.equal(await page.locator("script").count(), 1);
    assert.deepEqual(page.seen, { complaints: [], requests: [] });
    for (const { name: plot, size } of await drawn(page)) assert.ok(size > 300, plot);
  });

test("a script that is not the page's own does not run", async () => {
  const honest = readFileSync(report(write("honest.toml", impact("Honest", write("plain.toml", card("Plain"))))), "utf8");
  const page = await open(write("changed.html", honest.replace("<main", "<script>window.pwned=1</script><img src=x onerror=window.pwned=1><main")));
  assert.equal(await page.evaluate(() => window.pwned), undefined);
  assert.ok(page.seen.complaints.some((line) => /Content Security Policy/.test(line)));
});
