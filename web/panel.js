// One pair of axes: what stands under the pointer, enlarging, and the same with keys.

function svgElement(name, attributes = {}) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

const textElement = (name, text) => Object.assign(document.createElement(name), { textContent: text });

class Panel {
  // group: g.dp-panel; tip: where the values are said.
  constructor(group, tip) {
    this.group = group;
    this.tip = tip;
    this.inside = group.querySelector(".dp-inside");
    [this.width, this.height] = ["width", "height"].map((name) => Number(group.dataset[name]));
    this.x = new Axis(group.dataset, "x", this.width);
    this.y = new Axis(group.dataset, "y", this.height);
    this.curves = [...this.inside.querySelectorAll(".dp-series")].map((each) => new Curve(each, this.width, this.height));
    this.stop = null;
    this.onMoment = null;
    this.addLayers();
    this.listen();
  }

  get shown() {
    return this.curves.filter((curve) => curve.isOn && curve.path && !curve.isCasing);
  }

  // A floor that takes the pointer, a frame that cuts curves off once they are enlarged, and marks above all.
  addLayers() {
    const size = { width: this.width, height: this.height };
    this.inside.prepend(svgElement("rect", { ...size, class: "dp-floor" }));
    this.frame = svgElement("svg", { ...size, overflow: "visible" });
    this.curves[0]?.group.before(this.frame);
    this.frame.append(...this.curves.map((curve) => curve.group));
    this.marks = svgElement("g", { class: "dp-pointer" });
    this.inside.append(this.marks);
    this.inside.setAttribute("tabindex", "0");
    // Names of curves in it are buttons, which an image could not have.
    this.inside.setAttribute("role", "group");
    const what = [this.y.quantity, this.x.quantity].filter(Boolean).join(" over ") || "Plot";
    this.inside.setAttribute("aria-label", `${what}. Arrow keys go along the curves, plus and minus enlarge.`);
  }

  listen() {
    this.inside.addEventListener("pointermove", (event) => this.move(event));
    this.inside.addEventListener("pointerdown", (event) => this.press(event));
    this.inside.addEventListener("pointerup", (event) => this.release(event));
    this.inside.addEventListener("pointercancel", () => this.drop());
    this.inside.addEventListener("pointerleave", (event) => this.leave(event));
    this.inside.addEventListener("dblclick", () => this.whole());
    this.inside.addEventListener("keydown", (event) => this.key(event));
    this.inside.addEventListener("blur", () => this.rest());
  }

  // Of an event, in px as drawn, y upwards.
  under(event) {
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.inside.getScreenCTM().inverse());
    return [x, this.height - y];
  }

  // ---- The pointer ----

  move(event) {
    const at = this.under(event);
    if (this.pressed) return this.select(at);
    const isIn = at[0] > -8 && at[0] < this.width + 8 && at[1] > -8 && at[1] < this.height + 8;
    if (!isIn) return this.rest();
    this.mark(this.ground(event, at) ?? this.nearest(this.shown, at));
  }

  // In a filled area it is the place itself.
  ground(event, [x, y]) {
    const curve = this.shown.find((each) => each.style === "area" && each.group.contains(event.target));
    return curve ? { curve, place: [this.x.place(x), this.y.place(y)], way: 0 } : null;
  }

  nearest(curves, at) {
    const stops = curves.map((curve) => curve.nearest(this.x, this.y, at)).filter(Boolean);
    return stops.reduce((best, stop) => (best && best.distance <= stop.distance ? best : stop), null);
  }

  // A finger leaves whenever it is lifted: what it has touched stays.
  leave(event) {
    if (!this.pressed && event.pointerType !== "touch") this.rest();
  }

  press(event) {
    if (event.pointerType === "touch") return this.move(event);
    // The name of a curve is a button.
    if (event.button !== 0 || event.target.closest("[aria-pressed]")) return;
    this.pressed = this.under(event);
    this.inside.setPointerCapture(event.pointerId);
  }

  // What is dragged over; a side that is hardly dragged is whole.
  selection([x, y]) {
    const side = (from, to, length) => {
      const [low, high] = [Math.min(from, to), Math.max(from, to)].map((each) => Math.min(Math.max(each, 0), length));
      return high - low < 15 ? [0, length] : [low, high];
    };
    return [side(this.pressed[0], x, this.width), side(this.pressed[1], y, this.height)];
  }

  select(at) {
    this.mark(null);
    const [[left, right], [low, high]] = this.selection(at);
    const box = { x: left, y: this.height - high, width: right - left, height: high - low, class: "dp-selection" };
    this.marks.replaceChildren(svgElement("rect", box));
  }

  release(event) {
    if (!this.pressed) return;
    const at = this.under(event);
    const isDragged = Math.hypot(at[0] - this.pressed[0], at[1] - this.pressed[1]) > 15;
    const [x, y] = this.selection(at);
    this.pressed = null;
    if (!isDragged) return this.move(event);
    this.look(x.map((each) => this.x.place(each)), y.map((each) => this.y.place(each)));
  }

  drop() {
    this.pressed = null;
    this.rest();
  }

  // ---- What is shown ----

  look(x, y) {
    this.x.look(...x);
    this.y.look(...y);
    this.draw();
  }

  whole() {
    this.x.whole();
    this.y.whole();
    this.draw();
  }

  draw() {
    this.redraw();
    this.rest();
  }

  redraw() {
    const isWhole = this.x.isWhole && this.y.isWhole;
    this.frame.setAttribute("overflow", isWhole ? "visible" : "hidden");
    // What stands beside a curve would not move with it.
    this.inside.classList.toggle("dp-enlarged", !isWhole);
    for (const curve of this.curves) curve.draw(this.x, this.y);
    this.drawAxes();
  }

  drawAxes() {
    this.inside.querySelectorAll(".dp-grid, .dp-minor-grid, .dp-axis, .dp-tick").forEach((each) => each.remove());
    const paths = { "dp-minor-grid": "", "dp-grid": "", "dp-axis": `M0 0V${this.height}H${this.width}` };
    const numbers = [];
    const number = (classes, x, y, text) => {
      const made = svgElement("text", { class: `dp-tick ${classes}`, x, y });
      made.textContent = text;
      numbers.push(made);
    };
    for (const { place, label } of this.x.ticks()) {
      paths[label ? "dp-grid" : "dp-minor-grid"] += `M${place} 0V${this.height}`;
      if (!label) continue;
      paths["dp-axis"] += `M${place} ${this.height}v5`;
      number("dp-centred", place, this.height + 18, label);
    }
    for (const { place, label } of this.y.ticks()) {
      const down = this.height - place;
      paths[label ? "dp-grid" : "dp-minor-grid"] += `M0 ${down}H${this.width}`;
      if (!label) continue;
      paths["dp-axis"] += `M0 ${down}h-5`;
      number("dp-to-end", -8, down + 4.2, label);
    }
    const lines = Object.entries(paths).filter(([, d]) => d).map(([name, d]) => svgElement("path", { class: name, d }));
    this.inside.querySelector(".dp-floor").after(...lines, ...numbers);
  }

  // Both axes in other units: { "m": ["in", 39.37] }, of the SI; without one as they were written.
  setUnits(units) {
    for (const axis of [this.x, this.y]) {
      if (!axis.unit) continue;
      axis.setUnit(...(units[axis.unit] ?? []));
      const lines = this.group.querySelectorAll(`.dp-axis-title[data-axis="${axis === this.x ? "x" : "y"}"]`);
      lines.forEach((line, i) => (line.textContent = i === 0 ? axis.label : ""));
    }
    this.redraw();
    this.mark(null);
  }

  // ---- The mark and its words ----

  dot([x, y], { group } = {}) {
    const made = svgElement("circle", { class: "dp-marker", r: 4.5, cx: this.x.shown(x), cy: this.height - this.y.shown(y) });
    if (group) made.setAttribute("color", getComputedStyle(group).color);
    return made;
  }

  // Marks that another plot or the slider of time asks for, and a line up at a place on the x axis, or null.
  point(places, across) {
    this.stop = null;
    this.tip.hide(this);
    const line = across === null || !this.x.contains(across) ? [] : [svgElement("path", { class: "dp-hairline", d: `M${this.x.shown(across)} 0V${this.height}` })];
    this.marks.replaceChildren(...line, ...places.filter(([place]) => this.isInView(place)).map(([place, curve]) => this.dot(place, curve)));
  }

  isInView([x, y]) {
    return this.x.contains(x) && this.y.contains(y);
  }

  // Where keys go, what is looked at goes too.
  markInView(stop) {
    if (!this.isInView(stop.place)) {
      this.x.follow(stop.place[0]);
      this.y.follow(stop.place[1]);
      this.redraw();
    }
    this.mark(stop);
  }

  mark(stop) {
    this.stop = stop;
    this.marks.replaceChildren(...(stop ? [this.dot(stop.place, stop.curve)] : []));
    if (!stop) return this.tip.hide(this);
    this.tip.show(this, this.words(stop));
    this.onMoment?.(stop);
  }

  words({ curve, place }) {
    if (curve.style === "mark") return [curve.label];
    const named = (axis, text) => (axis.label ? `${axis.label}: ${text}` : text);
    // The name of an axis says it already.
    const isNamed = curve.label !== this.x.quantity && curve.label !== this.y.quantity;
    return [
      isNamed ? curve.label : "",
      ...(curve.style === "horizontal" || !this.x.hasNumbers ? [] : [named(this.x, this.x.text(place[0]))]),
      ...(curve.style === "vertical" || !this.y.hasNumbers ? [] : [named(this.y, this.y.text(place[1]))]),
    ];
  }

  rest() {
    this.mark(null);
    this.onMoment?.(null);
  }

  // ---- Keys ----

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const steps = { ArrowRight: 1, ArrowLeft: -1, PageDown: 10, PageUp: -10, Home: -Infinity, End: Infinity };
    const turns = { ArrowUp: -1, ArrowDown: 1 };
    const zooms = { "+": 0.5, "=": 0.5, "-": 2 };
    if (event.key === "Escape") this.rest();
    else if (event.key in steps) this.step(steps[event.key]);
    else if (event.key in turns) this.turn(turns[event.key]);
    else if (event.key in zooms) this.zoom(zooms[event.key]);
    else if (event.key === "0") this.whole();
    else return;
    event.preventDefault();
  }

  // A hundredth of the curve, or to the next point.
  step(count) {
    const curve = this.shown.includes(this.stop?.curve) ? this.stop.curve : this.firstCurve();
    if (!curve) return;
    const length = curve.length;
    const begin = this.stop?.curve === curve ? this.stop.way : curve.isPoints ? -1 : 0;
    const way = Math.min(Math.max(begin + count * (curve.isPoints ? 1 : length / 100), 0), length);
    this.markInView({ curve, way, place: curve.along(way) });
  }

  firstCurve() {
    return this.shown.find((curve) => !curve.isMark) ?? this.shown[0];
  }

  // To the next curve, where it is nearest.
  turn(count) {
    const list = this.shown;
    const now = list.indexOf(this.stop?.curve);
    if (now < 0) return this.step(0);
    const [x, y] = this.stop.place;
    const next = list[(now + count + list.length) % list.length];
    this.markInView(this.nearest([next], [this.x.shown(x), this.y.shown(y)]) ?? { curve: next, way: 0, place: next.along(0) });
  }

  zoom(factor) {
    const stop = this.stop;
    const curve = this.firstCurve();
    const around = (axis, middle) => [middle - (factor * (axis.to - axis.from)) / 2, middle + (factor * (axis.to - axis.from)) / 2];
    // Without a mark the middle of the first curve is as good a place as any, if it is in view.
    const half = curve?.along(curve.length / 2);
    const middle = half && this.isInView(half) ? half : [(this.x.from + this.x.to) / 2, (this.y.from + this.y.to) / 2];
    const [x, y] = stop?.place ?? middle;
    this.look(around(this.x, x), around(this.y, y));
    if (stop) this.mark(stop);
  }
}
