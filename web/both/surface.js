// The place of a canvas: as wide as the page allows, drawn anew when colours change, moved along by keys. Who
// extends it has step(count) and rest().

import { isPrinting, onChange } from "./colours.js";
import { element } from "./text.js";

const steps = { ArrowRight: 1, ArrowLeft: -1, PageDown: 10, PageUp: -10, Home: -Infinity, End: Infinity };

export class Surface {
  // printed: width and height on paper.
  constructor(title, printed) {
    this.printed = printed;
    this.canvasPlace = element("div", {
      className: "plot",
      attributes: { tabindex: "0", role: "img", "aria-label": `${title}. Arrow keys move along the curve.` },
    });
    this.plot = null;
    new ResizeObserver(() => this.fit()).observe(this.canvasPlace);
    onChange(() => this.fit(true));
    this.canvasPlace.addEventListener("keydown", (event) => this.key(event));
    this.canvasPlace.addEventListener("blur", () => this.rest());
  }

  size() {
    if (isPrinting()) return this.printed;
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

  key(event) {
    if (event.key === "Escape") return this.rest();
    if (!(event.key in steps) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    this.step(steps[event.key]);
  }

  // Mice are uPlot's own.
  touch(event) {
    if (event.pointerType === "mouse") return;
    const box = this.plot.over.getBoundingClientRect();
    this.plot.setCursor({ left: event.clientX - box.left, top: event.clientY - box.top });
  }
}
