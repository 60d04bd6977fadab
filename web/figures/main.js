// The page of figures: sections of text, tables and figures, and above them what there is.

import "uplot/dist/uPlot.min.css";
import "../both/both.css";
import "./figures.css";
import { element } from "../both/text.js";
import { warning } from "../both/warning.js";
import { figureElement, titleOf } from "./figure.js";
import { ranges } from "./ranges.js";
import { table } from "./tables.js";

const data = JSON.parse(document.getElementById("data").textContent);
const page = document.getElementById("page");

const paragraphs = (texts) => texts.map((text) => element("p", { text }));
const figureId = (section, figure) => `figure-${section + 1}-${figure + 1}`;
const sectionId = (section) => `section-${section + 1}`;

function sectionElement(section, i) {
  const made = element("section", { attributes: { id: sectionId(i) } });
  if (section.heading) made.append(element("h2", { text: section.heading }));
  made.append(...paragraphs(section.paragraphs));
  if (section.ranges.length > 0) made.append(ranges(section.ranges));
  made.append(...section.tables.map(table));
  if (section.figures.length > 0)
    made.append(
      element("div", { className: "plots" }, ...section.figures.map((figure, k) => figureElement(figure, figureId(i, k)))),
    );
  if (section.copy) made.append(element("pre", { text: section.copy, attributes: { tabindex: "0" } }));
  return made;
}

function contents() {
  const link = (text, id) => element("a", { text, attributes: { href: `#${id}` } });
  const list = element("ul");
  data.sections.forEach((section, i) => {
    const figures = section.figures.map((figure, k) =>
      element("li", {}, link(titleOf(figure) || `Figure ${k + 1}`, figureId(i, k))),
    );
    const item = element("li", {}, link(section.heading || `Section ${i + 1}`, sectionId(i)));
    if (figures.length > 0) item.append(element("ul", {}, ...figures));
    list.append(item);
  });
  return element("nav", { attributes: { "aria-label": "Contents" } }, element("h2", { text: "Contents" }), list);
}

function header() {
  const made = element("header", {}, ...paragraphs(data.summary));
  // Above a page that answers its question the answer is the heading.
  if (!document.querySelector(".lead")) made.prepend(element("h1", { text: data.title || "Figures" }));
  if (data.warnings.length > 0) made.append(element("ul", { className: "warnings" }, ...data.warnings.map(warning)));
  return made;
}

const count = data.sections.reduce((sum, { figures }) => sum + figures.length, 0);
page.replaceChildren(header());
if (count > 3) page.append(contents());
if (count > 0)
  page.append(
    element("p", {
      className: "hint",
      text:
        "Point at a curve for its values, or go along it with the arrow keys. Drag to enlarge, double-click to go " +
        "back. The legend switches curves off and on.",
    }),
  );
page.append(
  ...data.sections.map(sectionElement),
  element(
    "footer",
    {},
    element("p", { text: `Written by dashpad ${data.program.version}, commit ${data.program.commit}.` }),
  ),
);
