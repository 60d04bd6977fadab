// The page of one impact: what happened in words and figures, plots, and the case to run again.

import "uplot/dist/uPlot.min.css";
import "../both/both.css";
import "./page.css";
import { element } from "../both/text.js";
import { warning } from "../both/warning.js";
import { plots } from "./plots.js";
import { blowTable, table } from "./tables.js";
import { Units } from "./units.js";

const data = JSON.parse(document.getElementById("data").textContent);
const page = document.getElementById("page");

const words = element("p", { className: "words" });
const warnings = element("ul", { className: "warnings" });
const tables = element("div", { className: "tables" });
const blows = element("div", {});

function unitSwitch(choose) {
  const choices = element("fieldset", { className: "units" }, element("legend", { text: "Units" }));
  for (const system of data.systems) {
    const choice = element("input", { attributes: { type: "radio", name: "units", value: system.name } });
    choice.checked = system.name === data.shown;
    choice.addEventListener("change", () => choose(system));
    choices.append(element("label", {}, choice, element("span", { text: system.title })));
  }
  return choices;
}

function about() {
  const { version, commit } = data.program;
  return element(
    "footer",
    {},
    element("p", { text: data.numbers }),
    element("p", { text: `Written by dashpad ${version}, commit ${commit}.` }),
  );
}

function caseToRepeat() {
  return element(
    "section",
    { className: "case" },
    element("h2", { text: "The case" }),
    element("p", { text: "In SI, as it was computed. Kept as a file, it is a case that dashpad run repeats." }),
    element("pre", { text: data.case, attributes: { tabindex: "0" } }),
  );
}

const charts = plots(data);

function show(system) {
  words.textContent = system.words;
  warnings.replaceChildren(...system.warnings.map(warning));
  blows.replaceChildren();
  if (system.blows)
    blows.append(blowTable(system.blows), ...system.blows.reservations.map((text) => element("p", { text })));
  tables.replaceChildren(table(system.blows ? "The last blow" : "The impact", system.figures));
  if (system.injury.length > 0) tables.append(table("Injury figures of this pulse", system.injury));
  const units = new Units(system);
  for (const chart of charts) chart.show(units);
}

// The answer stands above, and the title with it.
page.replaceChildren(
  element("header", {}, words, warnings),
  unitSwitch(show),
  element("section", {}, element("h2", { text: "Figures" }), blows, tables),
  element(
    "section",
    {},
    element("h2", { text: "Plots" }),
    element("p", {
      className: "hint",
      text: "Legends give the values at the largest force, or on the axis; point at a curve for others. Drag to zoom, double-click to go back.",
    }),
    element("div", { className: "plots" }, ...charts.map((chart) => chart.figure)),
  ),
  caseToRepeat(),
  about(),
);
show(data.systems.find((system) => system.name === data.shown) ?? data.systems[0]);
