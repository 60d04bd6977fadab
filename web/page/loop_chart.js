// Force over a distance that goes forth and back: one curve in the order of time. uPlot wants increasing x,
// so it has the axes and the cursor, and the curve is drawn here.

import uPlot from "uplot";

import { colour } from "../both/colours.js";
import { element } from "../both/text.js";
import { axes } from "./axes.js";
import { Frame, dashes } from "./frame.js";
import { onMoment, point } from "./moment.js";

const finite = (values) => values.filter((value) => value !== null);

export class LoopChart extends Frame {
  // time: column; x, y: label, unit, values; turn: the entry at which the curve turns back; closed: whether
  // its area is filled; rest: the entry shown when nobody points.
  constructor(definition) {
    super(definition);
    this.definition = definition;
    this.marker = element("div", { className: "marker" });
    onMoment((entry, source) => source !== this && this.mark(entry));
  }

  show(units) {
    const { time, x, y, turn } = this.definition;
    this.clear();
    this.time = units.column(time, "s");
    this.x = units.column(x.values, x.unit);
    this.y = units.column(y.values, y.unit);
    this.makeLegend([
      { label: "Time", unit: units.name("s") },
      { label: x.label, unit: units.name(x.unit) },
      { label: y.label, unit: units.name(y.unit) },
    ]);
    this.addToLegend("line-0 solid", "loading");
    if (turn < time.length - 1) this.addToLegend("line-1 dashed", "unloading");
    const high = Math.max(...finite(this.x));
    const top = units.value(y.high, y.unit);
    const low = Math.min(...finite(this.x), 0);
    this.plot = new uPlot(this.options(units), [[low, high + 0.04 * (high - low)], [0, top]], this.canvasPlace);
    this.plot.over.append(this.marker);
    this.plot.over.addEventListener("pointermove", (event) => this.touch(event));
    this.mark(null);
  }

  options(units) {
    const { x, y } = this.definition;
    return {
      ...this.size(),
      padding: [10, 14, 0, 0],
      legend: { show: false },
      scales: { x: { time: false }, y: { range: { min: { pad: 0, soft: 0, mode: 1 }, max: { pad: 0.06 } } } },
      axes: axes(units.label(x.label, x.unit), units.label(y.label, y.unit)),
      series: [{}, { paths: () => null, points: { show: false } }],
      cursor: { x: false, y: false, points: { show: false }, drag: { x: false, y: false, setScale: false } },
      hooks: { draw: [(plot) => this.draw(plot)], setCursor: [(plot) => this.pointed(plot)], setSize: [() => this.place()] },
    };
  }

  draw(plot) {
    const { ctx, bbox } = plot;
    const { turn, closed } = this.definition;
    const ratio = ctx.canvas.width / plot.width;
    const path = (from, to) => {
      ctx.beginPath();
      for (let i = from; i <= to; ++i)
        if (this.x[i] !== null && this.y[i] !== null)
          ctx.lineTo(plot.valToPos(this.x[i], "x", true), plot.valToPos(this.y[i], "y", true));
    };
    const last = this.x.length - 1;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    if (closed) {
      path(0, last);
      ctx.fillStyle = colour("band");
      ctx.fill("evenodd");
    }
    ctx.lineWidth = 2 * ratio;
    ctx.lineJoin = "round";
    for (const [from, to, line, dash] of [[0, turn, "line-0", "solid"], [turn, last, "line-1", "dashed"]]) {
      ctx.strokeStyle = colour(line);
      ctx.setLineDash(dashes[dash].map((length) => length * ratio));
      path(from, to);
      ctx.stroke();
    }
    ctx.restore();
  }

  // The entry that is drawn nearest to the cursor.
  nearest(left, top) {
    let best = null;
    let least = Infinity;
    for (let i = 0; i < this.x.length; ++i) {
      if (this.x[i] === null || this.y[i] === null) continue;
      const distance = Math.hypot(
        this.plot.valToPos(this.x[i], "x") - left,
        this.plot.valToPos(this.y[i], "y") - top,
      );
      if (distance < least) [best, least] = [i, distance];
    }
    return best;
  }

  pointed(plot) {
    const { left, top } = plot.cursor;
    if (left === undefined || this.plot !== plot) return;
    const entry = left < 0 ? null : this.nearest(left, top);
    this.mark(entry);
    point(entry, this);
  }

  mark(entry) {
    if (!this.plot) return;
    this.entry = entry;
    const shown = entry ?? this.definition.rest;
    this.showValues([this.time[shown], this.x[shown], this.y[shown]], [0, this.x.at(-1), Math.max(...finite(this.y))]);
    this.place();
  }

  place() {
    this.marker.hidden = this.entry === null || this.entry === undefined;
    if (this.marker.hidden || !this.plot) return;
    this.marker.style.left = `${this.plot.valToPos(this.x[this.entry], "x")}px`;
    this.marker.style.top = `${this.plot.valToPos(this.y[this.entry], "y")}px`;
  }

  rest() {
    this.plot?.setCursor({ left: -10, top: -10 });
  }

  step(count) {
    const from = this.entry ?? this.definition.rest;
    const entry = Math.min(Math.max(from + count, 0), this.x.length - 1);
    this.mark(entry);
    point(entry, this);
  }
}
