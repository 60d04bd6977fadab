// What all plots have: a title, a place for the canvas, and below it the legend with the values at one place.

import { isPrinting, onChange } from "./colours.js";
import { element, number } from "./text.js";

const printed = { width: 336, height: 196 };

export class Frame {
  constructor({ name, title, note }) {
    this.canvasPlace = element("div", {
      className: "plot",
      attributes: { tabindex: "0", role: "img", "aria-label": `${title}. Arrow keys move along the curve.` },
    });
    this.legend = element("ul", { className: "legend" });
    this.figure = element(
      "figure",
      { attributes: { id: name } },
      element("figcaption", {}, element("h3", { text: title })),
      this.canvasPlace,
      this.legend,
    );
    if (note) this.figure.append(element("p", { className: "note", text: note }));
    this.plot = null;
    new ResizeObserver(() => this.fit()).observe(this.canvasPlace);
    onChange(() => this.fit(true));
    this.canvasPlace.addEventListener("keydown", (event) => this.key(event));
    this.canvasPlace.addEventListener("blur", () => this.rest());
  }

  size() {
    if (isPrinting()) return printed;
    const width = Math.max(Math.floor(this.canvasPlace.clientWidth), 200);
    return { width, height: Math.round(Math.min(Math.max(0.62 * width, 230), 340)) };
  }

  // Drawn anew after the colours have changed, resized only if the size has.
  fit(colours = false) {
    if (!this.plot) return;
    const { width, height } = this.size();
    if (width !== this.plot.width || height !== this.plot.height) this.plot.setSize({ width, height });
    if (colours) this.plot.redraw(false, true);
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
    const steps = { ArrowRight: 1, ArrowLeft: -1, PageDown: 10, PageUp: -10, Home: -Infinity, End: Infinity };
    if (event.key === "Escape") return this.rest();
    if (!(event.key in steps) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    this.legend.setAttribute("aria-live", "polite");
    this.step(steps[event.key]);
  }
}

export const dashes = { solid: [], dashed: [8, 5], dotted: [3, 3] };
export const axisFont = '12px system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';
