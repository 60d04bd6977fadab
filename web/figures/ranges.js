// Values with their intervals as bars between two bounds. An end that is open fades, and its words say so.

import { element } from "../both/text.js";

const percent = (share) => `${(100 * share).toFixed(2)}%`;

function track({ place, from, to, open_below, open_above, words }) {
  const bar = element("div", { className: `bar${open_below ? " open-below" : ""}${open_above ? " open-above" : ""}` });
  bar.style.left = percent(from);
  bar.style.width = percent(to - from);
  const mark = element("div", { className: "at" });
  mark.style.left = percent(place);
  return element("div", { className: "track", attributes: { role: "img", "aria-label": words } }, bar, mark);
}

function row(range) {
  return element(
    "li",
    {},
    element("p", { className: "name" }, element("span", { text: range.label }), element("b", { text: range.value })),
    track(range),
    element(
      "p",
      { className: "ends" },
      element("span", { text: range.lowest }),
      element("span", { className: "words", text: range.words }),
      element("span", { text: range.highest }),
    ),
  );
}

export const ranges = (list) => element("ul", { className: "ranges" }, ...list.map(row));
