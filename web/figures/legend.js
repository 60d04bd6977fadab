// One legend for all panels of a figure. Its entries are buttons that switch series off and on.

import { onChange } from "../both/colours.js";
import { element } from "../both/text.js";
import { drawPoints, fillArea, fillBand, setStroke } from "./looks.js";

const width = 40;
const height = 14;

// Series that look alike and have the same label are one entry.
const keyOf = ({ label, style, turn, colour }) => JSON.stringify([label, style, turn, colour]);

function sample(series) {
  const canvas = element("canvas", { className: "sample" });
  const ratio = devicePixelRatio;
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  const context = canvas.getContext("2d");
  const draw = () => {
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.beginPath();
    if (series.style === "points") return drawPoints(context, [[canvas.width / 2, canvas.height / 2]], series, ratio);
    if (series.style === "area" || series.style === "band") {
      context.rect(0, 0, canvas.width, canvas.height);
      if (series.style === "area") return fillArea(context, series, ratio);
      return fillBand(context, series);
    }
    context.moveTo(0, canvas.height / 2);
    context.lineTo(canvas.width, canvas.height / 2);
    setStroke(context, series, ratio);
    return context.stroke();
  };
  draw();
  onChange(draw);
  return canvas;
}

export class Legend {
  constructor(changed) {
    this.off = new Set();
    this.changed = changed;
    this.element = element("ul", { className: "legend" });
  }

  // Whether the series is switched on. Without a label it always is.
  isOn(series) {
    return !this.off.has(keyOf(series));
  }

  add(list) {
    const entries = new Map(list.filter(({ label }) => label).map((series) => [keyOf(series), series]));
    for (const [key, series] of entries) this.element.append(element("li", {}, this.button(key, series)));
  }

  button(key, series) {
    const button = element(
      "button",
      { attributes: { type: "button", "aria-pressed": "true" } },
      sample(series),
      element("span", { text: series.label }),
    );
    button.addEventListener("click", () => {
      if (!this.off.delete(key)) this.off.add(key);
      button.setAttribute("aria-pressed", String(!this.off.has(key)));
      this.changed();
    });
    return button;
  }
}
