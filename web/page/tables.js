// The figures as tables: figure, value with unit, estimated error; of repeated blows a row each.

import { element } from "../both/text.js";

function row({ label, value, unit, error, remark }) {
  const name = element("th", { text: label, attributes: { scope: "row" } });
  if (remark) name.append(element("small", { text: remark }));
  return element(
    "tr",
    {},
    name,
    element("td", { className: "number", text: value }),
    element("td", { className: "unit", text: unit }),
    element("td", { className: "error", text: error ? `± ${error}` : "" }),
  );
}

export function blowTable({ words, columns, rows }) {
  const head = element("tr", {}, ...columns.map((text) => element("th", { text, attributes: { scope: "col" } })));
  const cells = ([blow, ...values]) =>
    element(
      "tr",
      {},
      element("th", { text: blow, attributes: { scope: "row" } }),
      ...values.map((text) => element("td", { className: "number", text })),
    );
  return element(
    "table",
    { className: "blows" },
    element("caption", { text: words }),
    element("thead", {}, head),
    element("tbody", {}, ...rows.map(cells)),
  );
}

export function table(caption, rows) {
  const head = element("tr", {});
  for (const text of ["Figure", "Value", "", "Estimated error"])
    head.append(text ? element("th", { text, attributes: { scope: "col" } }) : element("td"));
  return element(
    "table",
    {},
    element("caption", { text: caption }),
    element("thead", {}, head),
    element("tbody", {}, ...rows.map(row)),
  );
}
