// One pair of axes. uPlot has the axes, the grid, the cursor and the zoom; its own series want increasing x, so
// they are drawn by painter.js, each with an x of its own.

import uPlot from "uplot";

import { isPrinting } from "../both/colours.js";
import { Surface } from "../both/surface.js";
import { element } from "../both/text.js";
import { axes } from "./axes.js";
import { besides, nearest, stepped } from "./nearest.js";
import { paint } from "./painter.js";
import { ranges, toScale } from "./scale.js";
import { tipTexts } from "./tip.js";

export class Panel extends Surface {
  // panel: title, x, y, series; isOn(series): whether the legend has it switched on.
  constructor(panel, title, isOn) {
    super(panel.title || title, { width: 660, height: 300 });
    this.panel = panel;
    this.isOn = isOn;
    this.series = panel.series.map((each) => this.scaled(each));
    this.ends = ranges(panel, this.series);
    this.marker = element("div", { className: "marker" });
    this.tip = element("div", { className: "tip", attributes: { role: "status" } });
    this.element = element("div", { className: "panel" });
    if (panel.title) this.element.append(element("h4", { text: panel.title }));
    this.element.append(
      element("p", { className: "axis", text: panel.y.label }),
      this.canvasPlace,
      element("p", { className: "axis below", text: panel.x.label }),
    );
    this.makeWhenNear();
  }

  // The places on the axes beside the values as they are.
  scaled(series) {
    const places = { ...series, given: series };
    if (series.x) places.x = series.x.map((value) => toScale(value, this.panel.x));
    for (const name of ["y", "y2"])
      if (series[name]) places[name] = series[name].map((value) => toScale(value, this.panel.y));
    return places;
  }

  // Many large canvases are too much for a phone: they are made when they are about to be seen.
  makeWhenNear() {
    const observer = new IntersectionObserver(
      (entries) => {
        if (entries.some((entry) => entry.isIntersecting)) this.make();
        if (this.plot) observer.disconnect();
      },
      { rootMargin: "600px" },
    );
    observer.observe(this.canvasPlace);
  }

  make() {
    if (this.plot) return;
    this.canvasPlace.style.minHeight = "";
    const { x, y } = this.ends;
    this.plot = new uPlot(this.options(), [x, y], this.canvasPlace);
    this.plot.over.append(this.marker, this.tip);
    this.plot.over.addEventListener("pointermove", (event) => this.touch(event));
    this.mark(null);
  }

  fit(colours = false) {
    if (isPrinting()) this.make();
    if (!this.plot) this.canvasPlace.style.minHeight = `${this.size().height}px`;
    super.fit(colours);
  }

  options() {
    const { x, y } = this.panel;
    return {
      ...this.size(),
      padding: [10, 20, 0, 0],
      legend: { show: false },
      scales: { x: { time: false, range: (plot, low, high) => [low, high] }, y: { auto: false, range: () => this.ends.y } },
      axes: axes(x, y),
      series: [{}, { paths: () => null, points: { show: false } }],
      cursor: {
        x: false,
        y: false,
        points: { show: false },
        drag: { x: true, y: true, uni: 20, dist: 5 },
        bind: { dblclick: () => () => this.reset() },
      },
      hooks: {
        draw: [(plot) => this.draw(plot)],
        setCursor: [(plot) => this.pointed(plot)],
        setScale: [() => this.mark(null)],
        setSize: [() => this.mark(null)],
      },
    };
  }

  shown() {
    return this.series.filter((each) => this.isOn(each.given));
  }

  draw(plot) {
    paint(plot, this.shown());
    if (this.series.length > 0) return;
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.textAlign = "center";
    ctx.fillText("no data", bbox.left + bbox.width / 2, bbox.top + bbox.height / 2);
    ctx.restore();
  }

  // Some series were switched on or off.
  changed() {
    this.mark(null);
    this.plot?.redraw(false, false);
  }

  reset() {
    this.plot.batch(() => {
      for (const name of ["x", "y"]) this.plot.setScale(name, { min: this.ends[name][0], max: this.ends[name][1] });
    });
  }

  pointed(plot) {
    const { left, top } = plot.cursor;
    if (left === undefined || this.plot !== plot) return;
    this.mark(left < 0 ? null : nearest(plot, this.shown(), left, top));
  }

  mark(stop) {
    this.stop = stop;
    this.marker.hidden = this.tip.hidden = !stop;
    if (!stop || !this.plot) return;
    this.marker.style.left = `${stop.x}px`;
    this.marker.style.top = `${stop.y}px`;
    const [label, ...values] = tipTexts(stop, this.panel);
    this.tip.replaceChildren(...values.map((text) => element("div", { text })));
    if (label) this.tip.prepend(element("strong", { text: label }));
    const { clientWidth: width, clientHeight: height } = this.plot.over;
    const { offsetWidth, offsetHeight } = this.tip;
    const above = stop.y - offsetHeight - 12;
    this.tip.style.left = `${Math.min(Math.max(stop.x - offsetWidth / 2, 0), width - offsetWidth)}px`;
    this.tip.style.top = `${above >= 0 ? above : Math.min(stop.y + 12, height - offsetHeight)}px`;
  }

  rest() {
    this.plot?.setCursor({ left: -10, top: -10 });
    this.mark(null);
  }

  step(count) {
    this.mark(stepped(this.plot, this.shown(), this.stop, count));
  }

  key(event) {
    this.make();
    const turns = { ArrowUp: -1, ArrowDown: 1 };
    if (!(event.key in turns) || event.ctrlKey || event.altKey || event.metaKey) return super.key(event);
    event.preventDefault();
    this.mark(besides(this.plot, this.shown(), this.stop, turns[event.key]));
  }
}
