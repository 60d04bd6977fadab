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
    this.cards = new Map();
    this.sliders = ["sliders", "more-sliders"].map((box) => new Sliders(byId(box), (...chosen) => this.set(...chosen)));
    this.files = new OwnFiles(this);
    this.fillChoices();
    this.listen();
    history.replaceState(state, "");
    this.link = linkOf(state);
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

  // --- Changes

  // `dragged` is the key of a slider that makes the change.
  change(make, isDone = false, dragged = null) {
    this.state = structuredClone(this.state);
    this.dragged = dragged;
    byId("found").textContent = "";
    make(this.state);
    this.refresh(isDone);
  }

  set(key, text, dragged) {
    const make = (state) => {
      const pad = state.pads[state.active];
      const layer = /^pad\.layers\[(\d)\]/.exec(key);
      const name = key.slice(key.lastIndexOf(".") + 1);
      // Files have numbers without a unit as numbers, not as text.
      const value = Sliders.isNumber(text) ? Number(text) : text;
      if (layer) pad.layers[layer[1] - 1].thickness = text;
      else if (name === "thickness") pad.thickness = text;
      else if (key.startsWith("support.")) state.case.support = { ...state.case.support, [name]: value };
      // A number of a standard gives way to one of the user.
      else if (state.standard && ["mass", "radius", "speed"].includes(name)) state.user[name] = text;
      else {
        delete state.case.impactor?.[{ speed: "drop_height", mass: "weight" }[name]];
        state.case.impactor = { ...state.case.impactor, [name]: value };
      }
    };
    this.change(make, false, dragged);
  }

  listen() {
    const chosen = (id, make) => byId(id).addEventListener("change", ({ target }) => this.change((state) => make(state, target.value), true));
    chosen("foam", (state, value) => {
      const { thickness, neighbours } = state.pads[state.active];
      state.pads[state.active] = { thickness, material: value, ...(neighbours === undefined ? {} : { neighbours }) };
    });
    // A nose or a support that was there before comes back with its sizes; how the nose strikes stays.
    const [noses, supports] = [{}, {}];
    chosen("nose", (state, value) => {
      const own = state.case.impactor ?? {};
      noses[own.nose ?? "sphere"] = partOf(own, false);
      const nose = noses[value] ?? nosesOf(own, "80 mm")[value];
      if (nose) state.case.impactor = { ...partOf(own, true), ...nose };
    });
    chosen("support", (state, value) => {
      supports[state.case.support?.type] = state.case.support;
      state.case.support = supports[value] ?? supportsOnOffer[value] ?? state.case.support;
    });
    byId("standard").addEventListener("change", ({ target: { value } }) => {
      this.change((state) => ([state.standard, state.user] = [value, {}]), true);
      if (value) byId("found").textContent = "Mass, nose and speed are now those of the standard, as far as it states them. Pad and support remain those of the case: check that the support is that of the test.";
    });
    chosen("units", (state, value) => (state.units = value));
    byId("add").addEventListener("click", () =>
      this.change((state) => {
        state.active = state.pads.push(structuredClone(state.pads[state.active])) - 1;
      }, true),
    );
    byId("thinnest").addEventListener("click", () => this.findThinnest());
    byId("copy-link").addEventListener("click", () => this.copy(location.href.split("#")[0] + linkOf(this.state), `The link is copied.${location.protocol === "file:" ? " It has the path of this file: for somebody else, put what follows # behind the address of their copy of the page." : ""}`, "copied"));
    byId("copy-case").addEventListener("click", () => this.copy(byId("case").textContent, "The case is copied.", "copied"));
    byId("controls").addEventListener("submit", (event) => event.preventDefault());
    // The browser's back and forward, and a link that is put into the address of this page.
    addEventListener("popstate", (event) => {
      const state = isState(event.state) ? event.state : stateOf(location.hash);
      if (!state) return this.showFaults([{ rule: "this link cannot be read" }]);
      [this.state, this.link, this.dragged] = [state, linkOf(state), null];
      byId("found").textContent = "";
      this.refresh(true, false);
    });
  }

  async copy(text, words, place) {
    try {
      await navigator.clipboard.writeText(text);
      byId(place).textContent = words;
    } catch {
      byId(place).textContent = "This browser does not let a page copy. The link is in the address bar, and the case is shown below.";
    }
  }

  // --- Answers

  request(whole, pad = this.state.active) {
    const { state } = this;
    return { ...(state.standard ? state.user : {}), do: "solve", case: caseOf(state, pad), standard: state.standard, units: state.units, quick: !whole, whole, intervals: whole, whole_foam: state.pads[pad].material in (state.cards ?? {}) };
  }

  refresh(isDone, isNew = true) {
    const cards = Object.fromEntries(Object.entries(this.state.cards ?? {}).map(([name, text]) => [`materials/${name}.toml`, text]));
    for (const engine of [this.quick, this.thorough, this.searching]) engine?.addFiles(cards);
    this.showChoices();
    const serial = ++this.serial;
    clearTimeout(this.timer);
    document.body.classList.add("pending");
    byId("pads").hidden = this.state.pads.length < 2;
    this.animate();
    const settle = () => this.settle(serial, isNew);
    if (isDone) settle();
    else this.timer = setTimeout(settle, pause);
  }

  // The answer without what is uncertain, for the last of the states that wait.
  async animate() {
    this.isStale = true;
    if (this.isAnimating) return;
    this.isAnimating = true;
    while (this.isStale) {
      this.isStale = false;
      const { serial } = this;
      const answer = await this.quick.ask(this.request(false));
      const isOld = () => (this.settled ?? 0) >= serial;
      if (answer && !isOld()) this.show(answer, false);
      if (!this.isStale) await this.comparePads(false, () => this.isStale || isOld());
    }
    this.isAnimating = false;
  }

  async settle(serial, isNew) {
    const answer = await this.thorough.ask(this.request(true));
    if (!answer || serial !== this.serial) return;
    this.settled = serial;
    this.show(answer, true);
    await this.comparePads(true, () => serial !== this.serial);
    await this.files.comparePulse(() => serial !== this.serial);
    if (serial !== this.serial) return;
    const link = linkOf(this.state);
    if (isNew && !answer.faults && link !== this.link) {
      this.link = link;
      // One that is too long would not be read.
      history.pushState(this.state, "", link.length < largestLink ? link : "#");
    }
    byId("result").dataset.complete = serial;
  }

  show(answer, isWhole) {
    this.showFaults(answer.faults ?? []);
    document.body.classList.toggle("pending", !isWhole || Boolean(answer.faults));
    if (answer.faults) return;
    Sliders.lists(answer.numbers, this.state.units).forEach((list, i) => this.sliders[i].show(list, this.dragged));
    byId("case").textContent = answer.toml;
    this.showCommand();
    const parts = this.partsOf(answer, isWhole);
    const [title, tone] = this.titleOf(answer, parts, isWhole);
    document.title = `${title} - Dashpad`;
    Object.assign(byId("brief"), { textContent: title, className: `brief ${tone}` });
    const onTime = this.time?.slider && document.activeElement === this.time.slider;
    this.time?.stop();
    byId("result").querySelector(".lead").replaceWith(parts.querySelector(".lead"));
    if (!isWhole) return;
    byId("announced").textContent = title;
    byId("result").querySelector("main").replaceWith(parts.querySelector("main"));
    this.files.showPages();
    this.listeners?.abort();
    this.listeners = new AbortController();
    this.time = enliven(this.listeners.signal);
    if (onTime) this.time?.slider?.focus();
    if (!this.hasPlayed && this.time?.button) this.time.play();
    this.hasPlayed = true;
    byId("result").dataset.answer = this.serial;
  }

  // Without its interval a figure is no verdict yet.
  isVerdict(isWhole) {
    return isWhole || this.state.standard === "";
  }
  titleOf(answer, parts, isWhole) {
    const figure = parts.querySelector(".key-figures li");
    if (this.isVerdict(isWhole) || !figure) return [answer.title, answer.tone];
    return [`${figure.querySelector(".label").textContent} ${figure.querySelector("b").firstChild.textContent.trim()}`, "plain"];
  }
  partsOf(answer, isWhole) {
    const parts = document.createElement("template");
    parts.innerHTML = answer.html;
    const { content } = parts;
    if (this.isVerdict(isWhole)) return content;
    content.querySelector("h1").textContent = this.titleOf(answer, content, isWhole)[0];
    content.querySelector("h1").className = "plain";
    for (const sign of content.querySelectorAll(".key-figures .sign")) sign.remove();
    for (const each of content.querySelectorAll(".key-figures :is(.good, .doubtful, .bad)")) each.classList.replace(each.classList[0], "plain");
    return content;
  }

  // What solves the case that is shown as text.
  showCommand() {
    const { standard, user } = this.state;
    const replaced = Object.entries(user).map(([name, value]) => ` --${name} "${value}"`).join("");
    byId("solves").textContent = standard ? `dashpad assess case.toml --standard ${standard}${replaced}` : "dashpad run case.toml";
  }

  showFaults(faults) {
    const keys = { "--mass": "impactor.mass", "--speed": "impactor.speed" };
    const known = faults.map((fault) => ({ ...fault, key: fault.key || keys[fault.file?.split(" ")[0]] || "" }));
    document.body.classList.toggle("fault", faults.length > 0);
    const list = byId("faults");
    list.hidden = faults.length === 0;
    const words = ({ key, value, rule, text }) => {
      const label = document.querySelector(`[data-key="${CSS.escape(key)}"] label, label:has(+ [data-key="${CSS.escape(key)}"])`)?.textContent ?? key;
      return rule ? `${label}${label && value ? ` ${value}` : ""}${label ? ": " : ""}${rule}` : text;
    };
    list.replaceChildren(...known.map((fault) => textElement("li", words(fault))));
    for (const row of document.querySelectorAll("[data-key]")) {
      const input = row.matches("select") ? row : row.querySelector('input[type="text"]');
      if (known.some(({ key }) => key && key === row.dataset.key)) input.setAttribute("aria-invalid", "true");
      else input.removeAttribute("aria-invalid");
    }
  }

  // The pads below the same impact, side by side, unless `isOver` says that another state is to be shown. What has not
  // changed is not solved again.
  async comparePads(isWhole, isOver) {
    const { pads } = this.state;
    if (pads.length < 2) return;
    const engine = isWhole ? this.thorough : this.quick;
    const [kept, answers] = [new Map(), []];
    for (let i = 0; i < pads.length; ++i) {
      const request = { ...this.request(false, i), quick: !isWhole, intervals: isWhole };
      const text = JSON.stringify(request);
      const answer = this.cards.get(text) ?? (await engine.ask(request));
      if (answer === null || isOver()) return;
      kept.set(text, answer);
      answers.push(answer);
    }
    // Those with intervals stay while others are dragged, and the other way round.
    this.cards = new Map([...[...this.cards].slice(-8), ...kept]);
    byId("pads").classList.toggle("provisional", !isWhole);
    const cards = answers.map((answer, i) => this.padCard(answer, i, isWhole));
    const beside = Object.assign(document.createElement("div"), { className: "beside" });
    beside.append(...cards);
    byId("pads").replaceChildren(beside, this.differences(cards));
  }

  // The key figures of the pads, with how much more or less than that of the first.
  differences(cards) {
    const figuresOf = (card) =>
      new Map([...card.querySelectorAll(".key-figures li")].map((figure) => [figure.querySelector(".label").textContent, figure.querySelector("b").textContent.trim()]));
    const all = cards.map(figuresOf);
    const [first, ...others] = all;
    const table = Object.assign(document.createElement("table"), { className: "differences" });
    const row = (kind, words) => {
      const line = document.createElement("tr");
      line.append(...words.map((text, i) => textElement(i === 0 ? "th" : kind, text)));
      line.firstElementChild.scope = "row";
      return line;
    };
    table.append(textElement("caption", "Difference from pad A"), row("th", ["", ...cards.map((_, i) => "ABCD"[i])]));
    const share = (text, of) => {
      const more = (100 * Number.parseFloat(text)) / Number.parseFloat(of) - 100;
      return Number.isFinite(more) && text !== of ? ` (${more > 0 ? "+" : "\u2212"}${Math.abs(more).toPrecision(2)} %)` : "";
    };
    for (const [label, text] of first) {
      const cells = others.map((figures) => figures.get(label) ?? "");
      table.append(row("td", [label, text, ...cells.map((cell) => `${cell}${share(cell, text)}`)]));
    }
    const part = document.createElement("div");
    part.append(...[...first.keys()].filter((label) => /acceleration|HIC|clip/.test(label)).flatMap((label) => this.lowest(label, all)), table);
    return part;
  }

  // The pad with the lowest figure, and how far the next is above it.
  lowest(label, all) {
    const order = all.map((figures, i) => [Number.parseFloat(figures.get(label)), "ABCD"[i]]).filter(([value]) => Number.isFinite(value)).sort(([a], [b]) => a - b);
    if (order.length < 2 || order[0][0] === order[1][0]) return [];
    const share = 100 - (100 * order[0][0]) / order[1][0];
    return [textElement("p", `Lowest ${label.replace(/^(Peak|Cumulative)/, (word) => word.toLowerCase())}: pad ${order[0][1]}, ${share.toPrecision(2)} % below pad ${order[1][1]}.`)];
  }

  padCard(answer, i, isWhole) {
    const { state } = this;
    const pad = state.pads[i];
    const letter = "ABCD"[i];
    const card = Object.assign(document.createElement("section"), { className: i === state.active ? "pad active" : "pad" });
    const thickness = answer.faults || pad.layers ? "" : `, ${Sliders.text(answer.numbers.thickness, Sliders.unit("m", state.units))}`;
    const title = this.lists.foams.find(({ name }) => name === pad.material)?.title;
    card.append(textElement("h2", `${letter}: ${pad.layers ? `${pad.layers.length} layers` : title || (pad.material ?? "foam of the case")}${thickness}`));
    if (answer.faults) {
      card.append(textElement("p", answer.faults[0].text));
    } else {
      // The names of the drawing's parts are those of one page.
      const own = { ...answer, html: answer.html.replace(/\bdd-[0-9a-f]{8}(?=-)/g, `$&-${letter}`) };
      const parts = this.partsOf(own, isWhole);
      const [verdict, tone] = this.titleOf(own, parts, isWhole);
      card.append(Object.assign(textElement("p", verdict), { className: `answer ${tone}` }));
      card.append(...[".drawing", ".key-figures"].flatMap((each) => parts.querySelector(each) ?? []));
    }
    const buttons = Object.assign(document.createElement("p"), { className: "buttons" });
    const button = (text, make) => {
      const element = Object.assign(textElement("button", text), { type: "button" });
      element.setAttribute("aria-label", text === "Remove" ? `Remove pad ${letter}` : `Change pad ${letter}`);
      element.addEventListener("click", () => {
        // These cards may be of a state before.
        if (this.state.pads.length !== state.pads.length) return;
        this.change(make, true);
        byId("foam").focus();
      });
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
    const found = byId("found");
    found.textContent = "Searching ...";
    const { serial } = this;
    this.searching ??= new EngineWorker(this.quick.module, this.quick.files);
    const answer = await this.searching.ask({ ...this.request(true), do: "solve-for", key: "pad.thickness" }, 60);
    if (!answer || serial !== this.serial) return;
    if (answer.faults) return (found.textContent = answer.faults[0].text);
    const turn = answer.result.turns.find(({ passes_above: above }) => above);
    // The place from which it passes for certain, rounded up to a tenth of a millimetre. Without one nothing is chosen.
    const isCertain = Number.isFinite(turn?.high);
    const thickness = isCertain && `${Math.ceil(turn.high * 1e4) / 10} mm`;
    if (isCertain) this.change((next) => (next.pads[next.active].thickness = thickness), true);
    found.textContent = `${answer.title}. ${isCertain ? `The thickness is set to ${thickness}` : "The thickness is left as it is, since none passes for certain"}.`;
  }
}

async function begin() {
  const module = await compiledEngine();
  const [quick, thorough] = [new EngineWorker(module), new EngineWorker(module)];
  const lists = await quick.ask({ do: "list" });
  const linked = stateOf(location.hash);
  const page = new LivePage({ quick, thorough }, linked ?? JSON.parse(byId("state").textContent), lists);
  if (!linked && location.hash.length > 1) byId("found").textContent = "The link cannot be read; the page shows its original case.";
  return page;
}

begin().catch((error) => {
  byId("controls").hidden = false;
  byId("faults").hidden = false;
  byId("faults").replaceChildren(textElement("li", `This browser cannot run the engine of this page: ${error.message}`));
});
