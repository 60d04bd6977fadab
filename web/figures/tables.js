// Tables of cells as they are shown, in a box of their own that scrolls where the page is narrow.

import { element } from "../both/text.js";

// A cell with a number: "12.5", "-3e-4", "< 0.1 %", "4.1 ± 0.2"; and what says that there is no number.
const isNumber = (cell) => /^[<>≤≥≈~±+\-−]?\s*\.?\d[\d.,]*(e[+-]?\d+)?\s*(%|±.*)?$/i.test(cell.trim());
const isNone = (cell) => /^[–-]?$|^none$|^n\/a$/i.test(cell.trim());

function head(columns, rows) {
  const isOfNumbers = (cells) => cells.some(isNumber) && cells.every((cell) => isNumber(cell) || isNone(cell));
  return columns.map((text, column) => {
    const className = column > 0 && isOfNumbers(rows.map((row) => row[column])) ? "number" : "";
    return text ? element("th", { text, className, attributes: { scope: "col" } }) : element("td");
  });
}

function row(cells, columns) {
  const [first, ...others] = cells;
  const isRight = (text) => isNumber(text) || isNone(text);
  return element(
    "tr",
    {},
    element("th", { text: first, attributes: { scope: "row" } }),
    ...others.map((text, i) =>
      element("td", { text, className: isRight(text) ? "number" : "", attributes: { "data-column": columns[i + 1] ?? "" } }),
    ),
  );
}

export function table({ caption, columns, rows }) {
  const made = element("table");
  if (caption) made.append(element("caption", { text: caption }));
  if (columns.some(Boolean)) made.append(element("thead", {}, element("tr", {}, ...head(columns, rows))));
  made.append(element("tbody", {}, ...rows.filter((cells) => cells.length > 0).map((cells) => row(cells, columns))));
  return element("div", { className: "table" }, made);
}
