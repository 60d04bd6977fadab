// A field and a slider for each number that is dragged. Places of sliders are logarithms, so that thin pads can be set as
// finely as thick ones.

class Sliders {
  // `set(key, text, dragged)` takes what the reader has chosen.
  constructor(box, set) {
    Object.assign(this, { box, set });
  }

  static list(numbers, units) {
    const length = units === "us" ? ["in", 0.0254] : ["mm", 1e-3];
    const speed = units === "us" ? ["mph", 0.44704] : units === "engineering-metric" ? ["km/h", 1 / 3.6] : ["m/s", 1];
    const mass = units === "us" ? ["lb", 0.45359237] : ["kg", 1];
    const pads = numbers.layers.length
      ? numbers.layers.map((value, i) => ({ key: `pad.layers[${i + 1}].thickness`, label: `Layer ${i + 1}`, unit: length, value }))
      : [{ key: "pad.thickness", label: "Thickness", unit: length, value: numbers.thickness }];
    return [...pads, { key: "impactor.speed", label: "Speed", unit: speed, value: numbers.speed }, { key: "impactor.mass", label: "Mass", unit: mass, value: numbers.mass }];
  }

  // `dragged` is the key of the slider in the reader's hand.
  show(numbers, units, dragged) {
    const { box } = this;
    const all = Sliders.list(numbers, units);
    const names = all.map(({ key, unit }) => key + unit[0]).join();
    if (box.dataset.names !== names) {
      box.dataset.names = names;
      box.replaceChildren(...all.map((slider) => this.row(slider)));
    }
    for (const { key, value, unit } of all) {
      const row = box.querySelector(`[data-key="${key}"]`);
      const [field, range] = row.querySelectorAll("input");
      const text = `${Number((value / unit[1]).toPrecision(4))} ${unit[0]}`;
      range.setAttribute("aria-valuetext", text);
      // What is dragged or typed at this moment is the reader's.
      if (dragged === key) continue;
      if (!row.dataset.typed) field.value = text;
      const place = Math.log(value);
      if (!row.dataset.middle || (Math.abs(place - row.dataset.middle) > 1.2 && document.activeElement !== range)) {
        row.dataset.middle = place;
        Object.assign(range, { min: place - Math.log(4), max: place + Math.log(4) });
      }
      range.value = place;
    }
  }

  row({ key, label, unit }) {
    const row = Object.assign(document.createElement("p"), { className: "control slider" });
    row.dataset.key = key;
    const name = Object.assign(document.createElement("label"), { htmlFor: `field ${key}`, textContent: label });
    const field = Object.assign(document.createElement("input"), { type: "text", id: `field ${key}`, autocomplete: "off" });
    const range = Object.assign(document.createElement("input"), { type: "range", step: 0.005 });
    range.setAttribute("aria-label", `${label}, slider`);
    range.addEventListener("input", () => {
      const text = `${Number((Math.exp(Number(range.value)) / unit[1]).toPrecision(3))} ${unit[0]}`;
      field.value = text;
      this.set(key, text, key);
    });
    field.addEventListener("input", () => (row.dataset.typed = "yes"));
    field.addEventListener("change", () => {
      delete row.dataset.typed;
      const text = field.value.trim();
      this.set(key, /^[-+.\d]+(e[-+]?\d+)?$/i.test(text) ? `${text} ${unit[0]}` : text);
    });
    row.append(name, field, range);
    return row;
  }
}
