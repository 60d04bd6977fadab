// What all plots have: a title, a place for the canvas, and below it the legend with the values at one place.

import { Surface } from "../both/surface.js";
import { element, number } from "../both/text.js";

export class Frame extends Surface {
  constructor({ name, title, note }) {
    super(title, { width: 336, height: 196 });
    this.legend = element("ul", { className: "legend" });
    this.figure = element(
      "figure",
      { attributes: { id: name } },
      element("figcaption", {}, element("h3", { text: title })),
      this.canvasPlace,
      this.legend,
    );
    if (note) this.figure.append(element("p", { className: "note", text: note }));
  }

  // Items: label, unit, and of lines colour and dash. The first says where.
  makeLegend(items) {
    this.values = items.map((item) => {
      const value = element("span", { className: "value" });
      const parts = [element("span", { className: "name", text: item.label }), value];
      if (item.colour) parts.unshift(element("span", { className: `swatch ${item.colour} ${item.dash ?? "solid"}` }));
      this.legend.append(element("li", { className: item.colour ? "" : "where" }, ...parts));
      return { value, unit: item.unit };
    });
  }

  clear() {
    this.plot?.destroy();
    this.plot = null;
    this.legend.replaceChildren();
  }

  // What is drawn beside the curves.
  addToLegend(className, text) {
    this.legend.append(
      element("li", {}, element("span", { className: `swatch ${className}` }), element("span", { text })),
    );
  }

  showValues(numbers, scales = []) {
    this.values.forEach(({ value, unit }, i) => {
      const shown = number(numbers[i], scales[i]);
      value.textContent = shown === "–" || !unit ? shown : `${shown} ${unit}`;
    });
  }

  key(event) {
    this.legend.setAttribute("aria-live", "polite");
    super.key(event);
  }
}

export const dashes = { solid: [], dashed: [8, 5], dotted: [3, 3] };
