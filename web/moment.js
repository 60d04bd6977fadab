// On the page of one impact all plots show the same moment: who points at one sees it in the others.

// Loops are a distance and a force that other plots have over time: the name of the loop says which distance.
class Moments {
  constructor(panels) {
    this.panels = panels;
    this.overTime = panels.filter((panel) => panel.x.quantity === "Time");
    this.curves = new Map();
    for (const panel of this.overTime)
      for (const curve of panel.curves)
        if (curve.style === "line" && curve.label && curve.path && !this.curves.has(curve.label)) this.curves.set(curve.label, { panel, curve });
    this.listeners = [];
    const ends = [...this.curves.values()].map(({ panel, curve }) => panel.x.value(curve.runs.at(-1).at(-1)[0]) / panel.x.factor);
    this.end = Math.max(0, ...ends);
    for (const panel of panels) panel.onMoment = (stop) => this.pointed(panel, stop);
  }

  // The value of a curve at a time, which is in the unit of the page.
  value(name, time) {
    const place = this.place(name, time);
    return place === null ? null : this.curves.get(name).panel.y.value(place);
  }

  // Where that is on the y axis of the curve; null where it is not known.
  place(name, time) {
    const known = this.curves.get(name);
    return known && time !== null ? known.curve.at(known.panel.x.placeOf(time * known.panel.x.factor)) : null;
  }

  // What a panel shows of the moment: places with their curves.
  marks(panel, time) {
    const marks = [];
    for (const curve of panel.curves.filter((each) => each.style === "line" && each.isOn)) {
      if (this.overTime.includes(panel)) {
        const x = panel.x.placeOf(time * panel.x.factor);
        const y = curve.at(x);
        if (y !== null && curve.label && this.curves.get(curve.label)) marks.push([[x, y], curve]);
      } else if (curve.label) {
        const [x, y] = [this.value(curve.label, time), this.value(panel.y.quantity, time)];
        if (x !== null && y !== null) marks.push([[panel.x.placeOf(x), panel.y.placeOf(y)], curve]);
      }
    }
    return marks;
  }

  pointed(panel, stop) {
    // Where nobody points any more, the standing moment is for all.
    this.show(stop && this.timeOf(panel, stop), stop ? panel : null);
  }

  timeOf(panel, { curve, place }) {
    if (this.overTime.includes(panel)) return panel.x.value(place[0]) / panel.x.factor;
    let best = null;
    let least = 20;  // px: beyond it, it is no curve of that kind
    for (let i = 0; i <= 400; ++i) {
      const time = (i / 400) * this.end;
      for (const [[x, y], of] of this.marks(panel, time)) {
        const distance = Math.hypot(x - place[0], y - place[1]);
        // The way back of a loop is a curve of its own, without a name.
        if ((of === curve || !curve.label) && distance < least) [best, least] = [time, distance];
      }
    }
    return best;
  }

  // The same in words; "" where it is not known.
  text(name, time) {
    const place = this.place(name, time);
    if (place === null) return "";
    const { y } = this.curves.get(name).panel;
    return `${y.text(place)} ${y.unitName()}`.trim();
  }

  timeOfSi(seconds) {
    return seconds === undefined ? null : seconds * this.overTime[0].x.written.perSi;
  }

  timeText(time) {
    const { x } = this.overTime[0];
    return `${x.text(x.placeOf(time * x.factor))} ${x.unitName()}`;
  }

  // In the SI; null where it is not known.
  siValue(name, time) {
    const value = this.value(name, time);
    return value === null ? null : value / this.curves.get(name).panel.y.perSi;
  }

  // Everything stays at that time when nobody points at anything.
  stand(time) {
    this.standing = time;
    this.show(time);
  }

  // `source` shows its own mark. Null: nobody points at anything.
  show(pointedAt, source = null) {
    const time = pointedAt ?? this.standing ?? null;
    for (const panel of this.panels) {
      if (panel === source) continue;
      panel.point(time === null ? [] : this.marks(panel, time), time !== null && this.overTime.includes(panel) ? panel.x.placeOf(time * panel.x.factor) : null);
    }
    for (const listener of this.listeners) listener(time);
  }
}
