// The live page: every change is solved at once without what is uncertain; once nothing has moved for a moment the whole
// answer follows, grey until it is there.

const pause = 150;  // ms without a change
const byId = (id) => document.getElementById(id);

class LivePage {
  constructor({ quick, thorough }, state, lists) {
    Object.assign(this, { quick, thorough, state, lists });
    this.serial = 0;
    byId("controls").hidden = false;
    byId("more").open = matchMedia("(min-width: 62rem)").matches;
    this.fillChoices();
    this.listen();
    this.refresh(true);
  }

  // --- What can be chosen

  fillChoices() {
    const options = (select, entries) => select.replaceChildren(...entries.map(([value, text]) => new Option(text, value)));
    const { foams, standards } = this.lists;
    options(byId("foam"), foams.map(({ name, title }) => [name, title || name]));
    options(byId("standard"), [
      ["", "none"],
      ...standards.flatMap(({ name, title, variants }) => [[name, title], ...variants.map((variant) => [`${name}:${variant}`, `${title}: ${variant}`])]),
    ]);
    options(byId("nose"), [["sphere", "Sphere"], ["flat-disc", "Flat disc"], ["cylinder", "Cylinder, lying"]]);
    options(byId("support"), [["rigid", "Rigid"], ["linear", "Linear spring"]]);
  }

  // A value that is not on offer is shown as what it is.
  choose(select, value) {
    if (![...select.options].some((option) => option.value === value)) select.add(new Option(value || "as in the case", value));
    select.value = value;
  }

  showChoices() {
    const { state } = this;
    const pad = state.pads[state.active];
    this.choose(byId("foam"), typeof pad.material === "string" ? pad.material : pad.layers ? "in layers" : "foam of the case");
    byId("foam").disabled = Boolean(pad.layers);
    this.choose(byId("nose"), state.case.impactor?.nose ?? "sphere");
    this.choose(byId("support"), state.case.support?.type ?? "");
    this.choose(byId("standard"), state.standard);
    byId("units").value = state.units;
    byId("thinnest").disabled = state.standard === "" || Boolean(pad.layers);
    byId("thinnest").title = state.standard === "" ? "Choose a standard first" : "";
    byId("add").disabled = state.pads.length >= 4;
  }

  // --- Sliders: places are logarithms, so that thin pads can be set as finely as thick ones

  slidersOf(numbers) {
    const { units } = this.state;
    const length = units === "us" ? ["in", 0.0254] : ["mm", 1e-3];
    const speed = units === "us" ? ["mph", 0.44704] : units === "engineering-metric" ? ["km/h", 1 / 3.6] : ["m/s", 1];
    const mass = units === "us" ? ["lb", 0.45359237] : ["kg", 1];
    const pads = numbers.layers.length
      ? numbers.layers.map((value, i) => ({ key: `pad.layers[${i + 1}].thickness`, label: `Layer ${i + 1}`, unit: length, value }))
      : [{ key: "pad.thickness", label: "Thickness", unit: length, value: numbers.thickness }];
    return [...pads, { key: "impactor.speed", label: "Speed", unit: speed, value: numbers.speed }, { key: "impactor.mass", label: "Mass", unit: mass, value: numbers.mass }];
  }

  showSliders(numbers) {
    const all = this.slidersOf(numbers);
    const names = all.map(({ key, unit }) => key + unit[0]).join();
    const box = byId("sliders");
    if (box.dataset.names !== names) {
      box.dataset.names = names;
      box.replaceChildren(...all.map((slider) => this.sliderRow(slider)));
    }
    for (const { key, value, unit } of all) {
      const row = box.querySelector(`[data-key="${key}"]`);
      const [range, field] = row.querySelectorAll("input");
      const place = Math.log(value);
      // The range stays where it is while something in it is dragged.
      if (!row.dataset.middle || Math.abs(place - row.dataset.middle) > 1.2) {
        row.dataset.middle = place;
        Object.assign(range, { min: place - Math.log(4), max: place + Math.log(4) });
      }
      if (document.activeElement !== range) range.value = place;
      if (document.activeElement !== field) field.value = `${Number((value / unit[1]).toPrecision(4))} ${unit[0]}`;
      range.setAttribute("aria-valuetext", `${Number((value / unit[1]).toPrecision(3))} ${unit[0]}`);
    }
  }

  sliderRow({ key, label, unit }) {
    const row = Object.assign(document.createElement("p"), { className: "control slider" });
    row.dataset.key = key;
    const name = Object.assign(document.createElement("label"), { htmlFor: `field ${key}`, textContent: label });
    const field = Object.assign(document.createElement("input"), { type: "text", id: `field ${key}`, autocomplete: "off" });
    const range = Object.assign(document.createElement("input"), { type: "range", step: "any" });
    range.setAttribute("aria-label", label);
    range.addEventListener("input", () => {
      const value = Math.exp(Number(range.value)) / unit[1];
      const text = `${Number(value.toPrecision(3))} ${unit[0]}`;
      field.value = text;
      this.set(key, text);
    });
    field.addEventListener("change", () => this.set(key, /[a-z]/i.test(field.value) ? field.value.trim() : `${field.value.trim()} ${unit[0]}`));
    row.append(name, range, field);
    return row;
  }

  // --- Changes

  change(make, isDone = false) {
    this.state = structuredClone(this.state);
    make(this.state);
    this.refresh(isDone);
  }

  set(key, text) {
    this.change((state) => {
      const pad = state.pads[state.active];
      const layer = /^pad\.layers\[(\d)\]/.exec(key);
      if (layer) pad.layers[layer[1] - 1].thickness = text;
      if (key === "pad.thickness") pad.thickness = text;
      if (!key.startsWith("impactor.")) return;
      const name = key.slice(9);
      const impactor = (state.case.impactor ??= {});
      // A number of a standard gives way to one of the user.
      const value = Number(/^[\d.eE+-]+/.exec(text)?.[0]) * { m: 1, "m/s": 1, mph: 0.44704, "km/h": 1 / 3.6, kg: 1, lb: 0.45359237 }[/[a-z/]+$/i.exec(text)?.[0]];
      if (state.standard && Number.isFinite(value)) state.user[name] = value;
      else {
        delete impactor[name === "speed" ? "drop_height" : "weight"];
        impactor[name] = text;
      }
    });
  }

  listen() {
    const chosen = (id, make) => byId(id).addEventListener("change", ({ target }) => this.change((state) => make(state, target.value), true));
    chosen("foam", (state, value) => {
      const { thickness, neighbours } = state.pads[state.active];
      state.pads[state.active] = { thickness, material: value, ...(neighbours === undefined ? {} : { neighbours }) };
    });
    chosen("nose", (state, value) => (state.case.impactor = nosesOf(state.case.impactor ?? {}, "80 mm")[value] ?? state.case.impactor));
    chosen("support", (state, value) => (state.case.support = supportsOnOffer[value] ?? state.case.support));
    chosen("standard", (state, value) => ([state.standard, state.user] = [value, {}]));
    chosen("units", (state, value) => (state.units = value));
    byId("add").addEventListener("click", () =>
      this.change((state) => {
        state.pads.splice(state.active + 1, 0, structuredClone(state.pads[state.active]));
        state.active += 1;
      }, true),
    );
    byId("thinnest").addEventListener("click", () => this.findThinnest());
    byId("copy-link").addEventListener("click", () => this.copy(location.href.split("#")[0] + linkOf(this.state), "The link is copied."));
    byId("copy-case").addEventListener("click", () => this.copy(byId("case").textContent, "The case is copied."));
    byId("open").addEventListener("change", ({ target }) => target.files[0] && this.read(target.files[0]));
    byId("controls").addEventListener("submit", (event) => event.preventDefault());
    document.addEventListener("dragover", (event) => event.preventDefault());
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      if (event.dataTransfer.files[0]) this.read(event.dataTransfer.files[0]);
    });
    addEventListener("popstate", ({ state }) => {
      if (!isState(state)) return;
      this.state = state;
      this.refresh(true, false);
    });
  }

  async copy(text, words) {
    try {
      await navigator.clipboard.writeText(text);
      byId("found").textContent = words;
    } catch {
      byId("found").textContent = "The browser does not let a page copy; the address line has the link, and the case stands below.";
    }
  }

  // --- Answers

  request(whole, pad = this.state.active) {
    const { state } = this;
    return { do: "solve", case: caseOf(state, pad), standard: state.standard, units: state.units, quick: !whole, whole, intervals: whole, ...(state.standard ? state.user : {}) };
  }

  refresh(isDone, isNew = true) {
    this.showChoices();
    const serial = ++this.serial;
    clearTimeout(this.timer);
    const settle = () => this.settle(serial, isNew);
    this.animate();
    if (isDone) settle();
    else this.timer = setTimeout(settle, pause);
  }

  // The answer without what is uncertain, once a frame at most.
  async animate() {
    if (this.isAnimating) return (this.isStale = true);
    this.isAnimating = true;
    do {
      this.isStale = false;
      const { serial } = this;
      const answer = await this.quick.ask(this.request(false));
      if (answer && serial > (this.settled ?? 0)) this.show(answer, false);
      if (this.state.pads.length > 1) await this.comparePads();
    } while (this.isStale);
    this.isAnimating = false;
  }

  async settle(serial, isNew) {
    const answer = await this.thorough.ask(this.request(true));
    if (!answer || serial !== this.serial) return;
    this.settled = serial;
    this.show(answer, true);
    await this.comparePads(true);
    if (isNew && !answer.faults) {
      const link = linkOf(this.state);
      // The first state needs no link, and one that is too long would not be read.
      if (link.length < largestLink && link !== location.hash) history[location.hash || this.hasMoved ? "pushState" : "replaceState"](this.state, "", this.hasMoved ? link : location.hash || "#");
      this.hasMoved = true;
    }
  }

  show(answer, isWhole) {
    this.showFaults(answer.faults ?? []);
    document.body.classList.toggle("pending", !isWhole || Boolean(answer.faults));
    if (answer.faults) return;
    this.showSliders(answer.numbers);
    byId("case").textContent = answer.toml;
    document.title = `${answer.title} - Dashpad`;
    Object.assign(byId("brief"), { textContent: answer.title, className: `brief ${answer.tone}` });
    const parts = document.createElement("template");
    parts.innerHTML = answer.html;
    this.time?.stop();
    const lead = parts.content.querySelector(".lead");
    byId("result").querySelector(".lead").replaceWith(lead);
    if (!isWhole) return;
    byId("result").querySelector("main").replaceWith(parts.content.querySelector("main"));
    this.listeners?.abort();
    this.listeners = new AbortController();
    this.time = enliven(this.listeners.signal);
    if (!this.hasPlayed && this.time?.button) this.time.play();
    this.hasPlayed = true;
    byId("result").dataset.answer = this.serial;
  }

  showFaults(faults) {
    const list = byId("faults");
    list.hidden = faults.length === 0;
    list.replaceChildren(...faults.map(({ key, text }) => Object.assign(document.createElement("li"), { textContent: text || key })));
    for (const row of document.querySelectorAll("[data-key]"))
      for (const input of row.matches("select") ? [row] : row.querySelectorAll("input"))
        if (faults.some(({ key }) => key && key === row.dataset.key)) input.setAttribute("aria-invalid", "true");
        else input.removeAttribute("aria-invalid");
  }

  // The other pads below the same impact, side by side.
  async comparePads(isWhole = false) {
    const { state } = this;
    byId("pads").hidden = state.pads.length < 2;
    if (state.pads.length < 2) return;
    const answers = [];
    for (let i = 0; i < state.pads.length; ++i) {
      const answer = await (isWhole ? this.thorough : this.quick).ask({ ...this.request(false, i), quick: !isWhole, intervals: isWhole });
      if (answer === null) return;
      answers.push(answer);
    }
    byId("pads").replaceChildren(...answers.map((answer, i) => this.padCard(answer, i)));
  }

  padCard(answer, i) {
    const { state } = this;
    const pad = state.pads[i];
    const card = Object.assign(document.createElement("section"), { className: i === state.active ? "pad active" : "pad" });
    const thickness = pad.layers ? `${pad.layers.length} layers` : pad.thickness;
    card.append(textElement("h2", `${"ABCD"[i]}: ${pad.layers ? "" : `${pad.material ?? "foam of the case"}, `}${thickness}`));
    if (answer.faults) {
      card.append(textElement("p", answer.faults[0].text));
    } else {
      card.append(Object.assign(textElement("p", answer.title), { className: `answer ${answer.tone}` }));
      const parts = document.createElement("template");
      // The names of the drawing's parts are those of one page.
      parts.innerHTML = answer.html.replace(/\bdd-[0-9a-f]{8}(?=-)/g, `$&-${"abcd"[i]}`);
      const [drawing, figures] = [".drawing", ".key-figures"].map((each) => parts.content.querySelector(each));
      if (drawing) card.append(drawing);
      if (figures) card.append(figures);
    }
    const buttons = Object.assign(document.createElement("p"), { className: "buttons" });
    const button = (text, make) => {
      const element = Object.assign(textElement("button", text), { type: "button" });
      element.addEventListener("click", () => this.change(make, true));
      buttons.append(element);
    };
    if (i !== state.active) button("Change this pad", (next) => (next.active = i));
    button("Remove", (next) => {
      next.pads.splice(i, 1);
      next.active = Math.min(next.active > i ? next.active - 1 : next.active, next.pads.length - 1);
    });
    card.append(buttons);
    return card;
  }

  async findThinnest() {
    const { state } = this;
    byId("found").textContent = "Searching ...";
    const answer = await this.thorough.ask({ ...this.request(true), do: "solve-for", key: "pad.thickness" }, 60);
    if (!answer) return;
    if (answer.faults) return (byId("found").textContent = answer.faults[0].text);
    byId("found").textContent = `${answer.title}.`;
    const turn = answer.result.turns.find(({ passes_above: above }) => above);
    if (turn === undefined) return;
    // The place from which it passes for certain, if there is one, rounded up to a tenth of a millimetre.
    const value = Math.ceil((turn.high ?? turn.value) * 1e4) / 10;
    this.change((next) => (next.pads[state.active].thickness = `${value} mm`), true);
  }

  // A case, or a card of a foam, which the case then uses.
  async read(file) {
    if (file.size > 1 << 20) return this.showFaults([{ text: `${file.name} is larger than 1 MiB` }]);
    const text = await file.text();
    if (/^\s*law\s*=/m.test(text) && !/^\s*\[impactor\]/m.test(text)) {
      const name = file.name.replace(/\.toml$/, "").replace(/[^\w-]/g, "-");
      for (const engine of [this.quick, this.thorough]) engine.addCard(name, text);
      byId("foam").add(new Option(name, name));
      return this.change((state) => (state.pads[state.active] = { thickness: state.pads[state.active].thickness ?? "25 mm", material: name }), true);
    }
    const answer = await this.quick.ask({ do: "read", text });
    if (answer?.faults) return this.showFaults(answer.faults);
    if (answer) this.change((state) => Object.assign(state, { case: { ...answer.case, pad: undefined }, pads: [answer.case.pad ?? {}], active: 0, user: {} }), true);
  }
}

async function begin() {
  const module = await compiledEngine();
  const [quick, thorough] = [new EngineWorker(module), new EngineWorker(module)];
  const lists = await quick.ask({ do: "list" });
  new LivePage({ quick, thorough }, stateOf(location.hash) ?? JSON.parse(byId("state").textContent), lists);
}

begin().catch((error) => {
  byId("controls").hidden = false;
  byId("faults").hidden = false;
  byId("faults").replaceChildren(textElement("li", `This browser cannot run the engine of this page: ${error.message}`));
});
