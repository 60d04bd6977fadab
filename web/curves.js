// The series of a panel, read from their paths. Places are in px on the axes, x to the right and y upwards.

const numbersOf = (text) => (text.match(/-?[\d.]+(e[-+]?\d+)?/g) ?? []).map(Number);

const pairs = (numbers) => numbers.flatMap((x, i) => (i % 2 === 0 ? [[x, numbers[i + 1]]] : []));

class Curve {
  constructor(group, width, height) {
    this.group = group;
    this.path = group.querySelector("path");
    this.label = group.dataset.label;
    this.style = group.dataset.style;
    this.isPoints = this.style === "points" || this.style === "dots";
    this.isAcross = this.style === "vertical" || this.style === "horizontal";
    // A bracket that names a window, or a line across: what it marks is elsewhere.
    this.isMark = this.style === "mark" || this.isAcross;
    this.isCasing = group.classList.contains("dp-casing");
    this.isClosed = this.style === "area" || this.style === "band";
    [this.width, this.height] = [width, height];
    this.runs = this.read(this.path?.getAttribute("d") ?? "");
  }

  get isOn() {
    return !this.group.classList.contains("dp-off");
  }

  // Runs of places with gaps between them; of points one run.
  read(text) {
    const parts = text.split("M").slice(1);
    const upwards = (list) => list.map(([x, y]) => [x, this.height - y]);
    if (this.style === "vertical") return parts.map((part) => [[numbersOf(part)[0], 0], [numbersOf(part)[0], this.height]]);
    if (this.style === "horizontal") return parts.map((part) => upwards([[0, numbersOf(part)[1]], [this.width, numbersOf(part)[1]]]));
    if (!this.isPoints) return parts.map((part) => upwards(pairs(numbersOf(part))));
    // What follows the place is the shape, in steps from there.
    this.shape = /^[-\d.e]+ [-\d.e]+(.*)$/.exec(parts[0] ?? "")?.[1] ?? "";
    return [parts.map((part) => upwards(pairs(numbersOf(part).slice(0, 2)))[0])];
  }

  // The path anew, where both axes say.
  draw(x, y) {
    const place = ([px, py]) => `${x.shown(px).toFixed(2)} ${(this.height - y.shown(py)).toFixed(2)}`;
    const text = this.runs.map((run) => {
      if (this.isPoints) return run.map((each) => `M${place(each)}${this.shape}`).join("");
      if (this.style === "vertical") return `M${x.shown(run[0][0])} 0V${this.height}`;
      if (this.style === "horizontal") return `M0 ${this.height - y.shown(run[0][1])}H${this.width}`;
      return `M${run.map(place).join(" ")}${this.isClosed ? "z" : ""}`;
    });
    this.path?.setAttribute("d", text.join(""));
  }

  // Calls use(from, to, way) for each piece: `way` is how far along the curve it begins. Of points every piece is
  // one of them, and the way their number.
  pieces(use) {
    let way = 0;
    for (const run of this.runs)
      run.forEach((to, i) => {
        if (this.isPoints) return use(to, to, i);
        const from = run[Math.max(i - 1, 0)];
        if (i > 0 || run.length === 1) use(from, to, way);
        way += Math.hypot(to[0] - from[0], to[1] - from[1]);
      });
  }

  get length() {
    let length = 0;
    this.pieces((from, to, way) => (length = way + Math.hypot(to[0] - from[0], to[1] - from[1])));
    return length;
  }

  // The place that far along it.
  along(way) {
    let place = null;
    this.pieces((from, to, begin) => {
      const size = Math.hypot(to[0] - from[0], to[1] - from[1]);
      if (place && way < begin) return;
      const part = size > 0 ? Math.min(Math.max((way - begin) / size, 0), 1) : 0;
      place = [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])];
    });
    return place;
  }

  // y at x, of a curve that goes to the right only; null outside and in gaps. Curves of the same time end where the
  // rounding of their places has it.
  at(x) {
    const rounding = 0.02;
    for (const run of this.runs)
      for (let i = 1; i < run.length; ++i) {
        const [from, to] = [run[i - 1], run[i]];
        if (x < from[0] - rounding || x > to[0] + rounding) continue;
        return to[0] > from[0] ? from[1] + ((x - from[0]) / (to[0] - from[0])) * (to[1] - from[1]) : to[1];
      }
    return null;
  }

  // { curve, place, way, distance } of what is nearest to a place, as it is drawn now.
  nearest(x, y, [toX, toY]) {
    let best = null;
    this.pieces((from, to, way) => {
      const [ax, ay, bx, by] = [x.shown(from[0]), y.shown(from[1]), x.shown(to[0]), y.shown(to[1])];
      const [dx, dy] = [bx - ax, by - ay];
      const square = dx * dx + dy * dy;
      const part = square > 0 ? Math.min(Math.max(((toX - ax) * dx + (toY - ay) * dy) / square, 0), 1) : 0;
      const distance = Math.hypot(ax + part * dx - toX, ay + part * dy - toY);
      if (best && distance >= best.distance) return;
      const place = [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])];
      if (!x.contains(place[0]) || !y.contains(place[1])) return;
      best = { curve: this, place, distance, way: way + part * Math.hypot(to[0] - from[0], to[1] - from[1]) };
    });
    return best;
  }
}
