// A field and a slider for each number that is dragged. Places of sliders are logarithms, so that thin pads can be set as
// finely as thick ones.

class Sliders {
  // `set(key, text, dragged)` takes what the reader has chosen.
  constructor(box, set) {
    Object.assign(this, { box, set });
  }

  // Units of fields, with their value in SI, by the unit in SI.
  static unit(si, units) {
    const own = { "N/m": ["N/mm", 1e3], rad: ["deg", Math.PI / 180], m2: ["cm2", 1e-4], 1: ["", 1] };
    const chosen = {
      si: { m: ["mm", 1e-3] },
      us: { m: ["in", 0.0254], "m/s": ["mph", 0.44704], kg: ["lb", 0.45359237], "N/m": ["lbf/in", 175.12683524647636], m2: ["in2", 6.4516e-4] },
      "engineering-metric": { m: ["mm", 1e-3], "m/s": ["km/h", 1 / 3.6] },
    };
    return chosen[units][si] ?? own[si] ?? [si, 1];
  }

  static text(value, unit, digits = 4) {
    return `${Number((value / unit[1]).toPrecision(digits))} ${unit[0]}`.trim();
  }

  // A number without a unit.
  static isNumber(text) {
    return /^[-+.\d]+(e[-+]?\d+)?$/i.test(text);
  }

  // Thickness, speed and mass, and the other numbers of nose and support.
  static lists(numbers, units) {
    const slider = (key, label, si, value) => ({ key, label, unit: Sliders.unit(si, units), value });
    const pads = numbers.layers.length
      ? numbers.layers.map((value, i) => slider(`pad.layers[${i + 1}].thickness`, `Layer ${i + 1}`, "m", value))
      : [slider("pad.thickness", "Thickness", "m", numbers.thickness)];
    const words = (key) => key.replace(/^.*\./, "").replace(/_/g, " ").replace(/^./, (letter) => letter.toUpperCase());
    return [
      [...pads, slider("impactor.speed", "Speed", "m/s", numbers.speed), slider("impactor.mass", "Mass", "kg", numbers.mass)],
      numbers.more.map(({ key, unit, value }) => slider(key, words(key), unit, value)),
    ];
  }

  // `dragged` is the key of the slider in the reader's hand.
  show(all, dragged) {
    const { box } = this;
    const names = all.map(({ key, unit }) => key + unit[0]).join();
    if (box.dataset.names !== names) {
      box.dataset.names = names;
      box.replaceChildren(...all.map((slider) => this.row(slider)));
    }
    for (const { key, value, unit } of all) {
      const row = box.querySelector(`[data-key="${key}"]`);
      const [field, range] = row.querySelectorAll("input");
      const text = Sliders.text(value, unit);
      range.setAttribute("aria-valuetext", text);
      // What is dragged or typed at this moment is the reader's.
      if (dragged === key) continue;
      if (!row.dataset.typed) field.value = text;
      const place = Math.log(value);
      if (!row.dataset.middle || (Math.abs(place - row.dataset.middle) > 1.35 && document.activeElement !== range)) {
        row.dataset.middle = place;
        Object.assign(range, { min: place - Math.log(4), max: place + Math.log(4) });
        [0.25, 4].forEach((times, i) => (row.querySelectorAll(".end")[i].textContent = Sliders.text(times * value, unit, 2)));
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
      const text = Sliders.text(Math.exp(Number(range.value)), unit, 3);
      field.value = text;
      this.set(key, text, key);
    });
    field.addEventListener("input", () => (row.dataset.typed = "yes"));
    // A browser tells no change where the text is again what it was.
    field.addEventListener("blur", () => delete row.dataset.typed);
    field.addEventListener("keydown", ({ key: pressed }) => pressed === "Enter" && delete row.dataset.typed);
    field.addEventListener("change", () => {
      delete row.dataset.typed;
      const text = field.value.trim();
      this.set(key, Sliders.isNumber(text) ? `${text} ${unit[0]}`.trim() : text);
    });
    const ends = ["end", "end"].map((className) => Object.assign(textElement("span", ""), { className }));
    row.append(name, field, range, ...ends);
    return row;
  }
}
