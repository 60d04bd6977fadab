// Curves over an axis: time, or the radius of the contact. Each curve may have places of its own.

import uPlot from "uplot";

import { colour } from "../both/colours.js";
import { axes } from "./axes.js";
import { Frame, dashes } from "./frame.js";
import { onMoment, point } from "./moment.js";

// On the chord between two entries; null outside.
function at(xs, ys, x) {
  let low = 0;
  let high = xs.length - 1;
  if (!(x >= xs[low] && x <= xs[high])) return null;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (xs[middle] <= x) low = middle;
    else high = middle;
  }
  const share = xs[high] > xs[low] ? (x - xs[low]) / (xs[high] - xs[low]) : 0;
  return ys[low] === null || ys[high] === null ? null : ys[low] + share * (ys[high] - ys[low]);
}

const largest = (values) => values.reduce((most, value) => Math.max(most, Math.abs(value ?? 0)), 0);

export class CurveChart extends Frame {
  // x, y: label and SI unit; series: label, x, y, colour, dash; rest: the entry shown when nobody points;
  // overTime: whether x is the history's time; bands: from, to, label, colour; lines: y, label, dash.
  constructor(definition) {
    super(definition);
    this.definition = definition;
    this.following = false;
    if (definition.overTime) onMoment((entry, source) => source !== this && this.follow(entry));
  }

  show(units) {
    const { x, y, series, bands = [], lines = [], logarithmic } = this.definition;
    this.clear();
    this.curves = series.map((each) => ({
      x: units.column(each.x, x.unit),
      y: units.column(each.y, each.unit ?? y.unit),
    }));
    this.bands = bands.map((band) => ({ ...band, from: units.value(band.from, x.unit), to: units.value(band.to, x.unit) }));
    this.lines = lines.map((line) => ({ ...line, y: units.value(line.y, y.unit) }));
    this.scales = [0, ...this.curves.map(() => Math.max(...this.curves.map((curve) => largest(curve.y))))];
    this.makeLegend([
      { label: x.label, unit: units.name(x.unit) },
      ...series.map((each) => ({ ...each, unit: units.name(each.unit ?? y.unit) })),
    ]);
    for (const { y: value, label, dash } of this.lines) if (value <= 1.06 * this.scales[1]) this.addToLegend(`text thin ${dash}`, label);
    for (const band of this.bands) this.addToLegend(`block ${band.colour}`, band.label);
    this.plot = new uPlot(this.options(units), this.table(logarithmic), this.canvasPlace);
    this.plot.over.addEventListener("pointermove", (event) => this.touch(event));
    this.rest();
  }

  // One table for all curves. A logarithmic axis has no place for 0.
  table(logarithmic) {
    const ys = (curve) => (logarithmic ? curve.y.map((value) => (value > 0 ? value : null)) : curve.y);
    const shared = this.curves.every((curve) => curve.x === this.curves[0].x || this.definition.overTime);
    if (shared) return [this.curves[0].x, ...this.curves.map(ys)];
    return uPlot.join(this.curves.map((curve) => [curve.x, ys(curve)]));
  }

  options(units) {
    const { x, y, series, logarithmic, overTime } = this.definition;
    const high = units.value(y.high ?? null, y.unit);
    const end = { pad: 0.06, soft: 0, mode: 1 };
    const linear = { min: end, max: high === null ? end : { ...end, hard: 1.06 * high } };
    // Four decades, the last of which holds the highest value.
    const last = Math.ceil(Math.log10(high));
    return {
      ...this.size(),
      padding: [10, 14, 0, 0],
      legend: { show: false },
      scales: { x: { time: false }, y: logarithmic ? { distr: 3, range: [10 ** (last - 4), 10 ** last] } : { range: linear } },
      axes: axes(units.label(x.label, x.unit), units.label(y.label, y.unit), logarithmic),
      series: [
        {},
        ...series.map((each) => ({
          stroke: () => colour(each.colour),
          width: 2,
          dash: dashes[each.dash ?? "solid"],
          pxAlign: 0,
          spanGaps: !overTime,
          points: { show: false },
        })),
      ],
      cursor: { y: false, points: { show: overTime, size: 8 }, drag: { x: true, y: false } },
      hooks: {
        drawClear: [(plot) => this.drawBands(plot)],
        draw: [(plot) => this.drawLines(plot)],
        setCursor: [(plot) => this.pointed(plot)],
      },
    };
  }

  pointed(plot) {
    if (this.following) return;
    const { left, idx } = plot.cursor;
    if (left === undefined || left < 0 || idx === null || idx === undefined) {
      this.showRest();
      if (this.definition.overTime) point(null, this);
      return;
    }
    this.showAt(this.definition.overTime ? plot.data[0][idx] : plot.posToVal(left, "x"));
    if (this.definition.overTime) point(idx, this);
  }

  showAt(x) {
    this.where = x;
    this.showValues([x, ...this.curves.map((curve) => at(curve.x, curve.y, x))], this.scales);
  }

  showRest() {
    const { rest = 0 } = this.definition;
    this.showAt(this.curves[0].x[rest]);
    this.where = null;
  }

  // Goes where the reader points in another plot.
  follow(entry) {
    if (!this.plot) return;
    this.following = true;
    if (entry === null) {
      this.plot.setCursor({ left: -10, top: -10 });
      this.showRest();
    } else {
      const x = this.plot.data[0][entry];
      this.plot.setCursor({ left: this.plot.valToPos(x, "x"), top: 0 });
      this.showAt(x);
    }
    this.following = false;
  }

  rest() {
    this.plot?.setCursor({ left: -10, top: -10 });
  }

  step(count) {
    const xs = this.plot.data[0];
    const from = this.where ?? this.curves[0].x[this.definition.rest ?? 0];
    const entry = Math.min(Math.max(this.plot.valToIdx(from) + count, 0), xs.length - 1);
    this.plot.setCursor({ left: this.plot.valToPos(xs[entry], "x"), top: 0 });
  }

  drawBands(plot) {
    const { ctx, bbox } = plot;
    ctx.save();
    for (const band of this.bands) {
      const left = Math.max(plot.valToPos(band.from, "x", true), bbox.left);
      const right = Math.min(plot.valToPos(band.to, "x", true), bbox.left + bbox.width);
      if (right <= left) continue;
      ctx.fillStyle = colour(band.colour);
      ctx.fillRect(left, bbox.top, right - left, bbox.height);
    }
    ctx.restore();
  }

  drawLines(plot) {
    const { ctx, bbox } = plot;
    const ratio = plot.ctx.canvas.width / plot.width;
    ctx.save();
    ctx.strokeStyle = colour("text");
    ctx.lineWidth = ratio;
    for (const line of this.lines) {
      const y = plot.valToPos(line.y, "y", true);
      if (!(y >= bbox.top && y <= bbox.top + bbox.height)) continue;
      ctx.setLineDash(dashes[line.dash].map((length) => length * ratio));
      ctx.beginPath();
      ctx.moveTo(bbox.left, y);
      ctx.lineTo(bbox.left + bbox.width, y);
      ctx.stroke();
    }
    ctx.restore();
  }
}
