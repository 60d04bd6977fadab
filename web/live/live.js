// The live page: every change is solved at once without what is uncertain; once nothing has moved for a moment the whole
// answer follows, grey until it is there.

const pause = 40;  // ms without a change
const long = 15;  // ms of an answer without what is uncertain, from which on a verdict is first given to 1e-3
const byId = (id) => document.getElementById(id);

class LivePage {
  constructor({ quick, thorough }, state, lists) {
    Object.assign(this, { quick, thorough, state, lists });
    this.serial = 0;
    byId("controls").hidden = false;
    byId("more").open = matchMedia("(min-width: 62rem)").matches;
    this.sliders = ["sliders", "more-sliders"].map((box) => new Sliders(byId(box), (...chosen) => this.set(...chosen)));
    this.files = new OwnFiles(this);
    this.pads = new ComparedPads(this);
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
      ...standards.filter(({ variants }) => variants.length === 0).map(({ name, title }) => [name, title]),
    ]);
    // Those with variants are groups.
    for (const { name, title, variants, variant_titles: titles } of standards.filter(({ variants }) => variants.length > 0)) {
      const group = Object.assign(document.createElement("optgroup"), { label: title });
      const short = title.split(",")[0];
      group.append(new Option(title, name), ...variants.map((variant, i) => new Option(`${short}: ${titles[i] || `variant ${variant}`}`, `${name}:${variant}`)));
      byId("standard").append(group);
    }
    options(byId("nose"), [["sphere", "Sphere"], ["flat-disc", "Flat disc"], ["cylinder", "Cylinder, lying"]]);
    options(byId("support"), [["rigid", "Rigid"], ["linear", "Linear spring"]]);
  }

  // A value that is not on offer is shown as what it is.
  choose(select, value) {
    if (![...select.options].some((option) => option.value === value)) select.add(new Option(value || "as in the case", value));
    select.value = value;
    // Longer names do not fit into the control.
    const whole = select.parentElement.querySelector(".whole");
    const text = select.selectedOptions[0].textContent;
    if (whole) whole.textContent = text.length > 32 ? text : "";
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
    byId("add").disabled = state.pads.length >= 4;
    const why = { "Thinnest pad: choose a standard first.": state.standard === "", "Thinnest pad: not for a pad in layers.": pad.layers, "At most four pads.": state.pads.length >= 4 };
    byId("why-not").textContent = Object.keys(why).filter((words) => why[words]).join(" ");
  }

  // --- Changes

  // `dragged` is the key of a slider that makes the change.
  change(make, isDone = false, dragged = null) {
    this.state = structuredClone(this.state);
    this.dragged = dragged;
    byId("found").textContent = this.told = "";
    this.searching?.giveUp("");
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
      if (value) this.told = "Mass, nose and speed are now those of the standard, as far as it states them. Pad and support remain those of the case: check that the support is that of the test.";
    });
    chosen("units", (state, value) => (state.units = value));
    byId("add").addEventListener("click", () =>
      this.change((state) => {
        state.active = state.pads.push(structuredClone(state.pads[state.active])) - 1;
        this.pads.isAdded = true;
      }, true),
    );
    byId("thinnest").addEventListener("click", () => (this.isSearching ? this.searching.giveUp("the search is cancelled") : this.findThinnest()));
    byId("copy-link").addEventListener("click", () => this.copy(location.href.split("#")[0] + linkOf(this.state), `The link is copied.${location.protocol === "file:" ? " It has the path of this file: for somebody else, put what follows # behind the address of their copy of the page." : ""}`, "copied"));
    byId("copy-case").addEventListener("click", () => this.copy(byId("case").textContent, "The case is copied.", "copied"));
    byId("controls").addEventListener("submit", (event) => event.preventDefault());
    // The browser's back and forward, and a link that is put into the address of this page.
    addEventListener("popstate", (event) => {
      const state = isState(event.state) ? event.state : stateOf(location.hash);
      if (!state) return this.showFaults([{ rule: "this link cannot be read" }]);
      [this.state, this.link, this.dragged] = [state, linkOf(state), null];
      byId("found").textContent = this.told = "";
      this.searching?.giveUp("");
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
      const begun = performance.now();
      const answer = await this.quick.ask(this.request(false), 10, this.command());
      this.isLong = performance.now() - begun > long;
      const isOld = () => (this.settled ?? 0) >= serial;
      if (answer && !isOld()) this.show(answer, false);
      if (!this.isStale) await this.pads.compare(false, () => this.isStale || isOld());
    }
    this.isAnimating = false;
  }

  async settle(serial, isNew) {
    const answered = async (request) => {
      const answer = await this.thorough.ask(request, 10, this.command());
      if (!answer || serial !== this.serial) return null;
      this.settled = serial;
      this.show(answer, true, request.whole);
      return answer;
    };
    // The verdict first, without what is drawn below it.
    if (this.isLong && !(await answered({ ...this.request(true), whole: false, tolerance: 1e-3 }))) return;
    const answer = await answered(this.request(true));
    if (!answer) return;
    await this.pads.compare(true, () => serial !== this.serial);
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

  show(answer, isJudged, isWhole = isJudged) {
    this.showFaults(answer.faults ?? []);
    document.body.classList.toggle("pending", !isJudged || Boolean(answer.faults));
    document.body.classList.toggle("partial", !isWhole);
    if (answer.faults) return this.dropVerdict();
    this.judged = this.state.standard;
    if (this.told) byId("found").textContent = this.told;
    this.told = "";
    Sliders.lists(answer.numbers, this.state.units).forEach((list, i) => this.sliders[i].show(list, this.dragged));
    byId("case").textContent = answer.toml;
    byId("solves").textContent = this.command();
    const parts = this.partsOf(answer, isJudged);
    const [words, tone] = this.titleOf(answer, parts, isJudged);
    const name = this.state.pads.length > 1 ? `${"ABCD"[this.state.active]}: ` : "";
    const title = name + words;
    parts.querySelector("h1").prepend(name);
    this.offerOtherSpeed(answer, parts);
    document.title = `${title} - Dashpad`;
    Object.assign(byId("brief"), { textContent: title, className: `brief ${tone}` });
    const onTime = this.time?.slider && document.activeElement === this.time.slider;
    this.time?.stop();
    byId("result").querySelector(".lead").replaceWith(parts.querySelector(".lead"));
    if (isJudged) byId("result").dataset.answer = this.serial;
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
  }

  // A verdict by another standard is none.
  dropVerdict() {
    if (this.judged === undefined || this.judged === this.state.standard) return;
    this.judged = undefined;
    const words = "No answer: mend the marked field";
    const lead = Object.assign(document.createElement("div"), { className: "lead" });
    lead.append(textElement("h1", words));
    byId("result").querySelector(".lead").replaceWith(lead);
    byId("result").querySelector("main").replaceChildren();
    byId("pads").replaceChildren();
    Object.assign(byId("brief"), { textContent: words, className: "brief" });
    document.title = `${words} - Dashpad`;
  }

  // In place of the option that the command has for it.
  offerOtherSpeed(answer, parts) {
    const [choice] = answer.result?.other_choices ?? [];
    // A pass at another speed than the standard's is none by it.
    if (choice?.speed !== "case" || choice.nose || choice.verdict === "pass") return;
    const speed = answer.result.impactor.speed_m_per_s.case_value;
    const shown = Sliders.text(speed, Sliders.unit("m/s", this.state.units));
    const button = Object.assign(textElement("button", `Use the case's speed, ${shown} (then: ${choice.verdict})`), { type: "button" });
    button.addEventListener("click", () => this.set("impactor.speed", `${speed} m/s`));
    const line = Object.assign(document.createElement("p"), { className: "buttons" });
    line.append(button);
    parts.querySelector("h1").after(line);
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
    parts.innerHTML = answer.html.replace(/; to check, run (?:(?:and )?with(?:out)? (?:--keep-\w+ ?)+)+/g, "");
    const { content } = parts;
    if (this.isVerdict(isWhole)) return content;
    content.querySelector("h1").textContent = this.titleOf(answer, content, isWhole)[0];
    content.querySelector("h1").className = "plain";
    for (const sign of content.querySelectorAll(".key-figures .sign")) sign.remove();
    for (const each of content.querySelectorAll(".key-figures :is(.good, .doubtful, .bad)")) each.classList.replace(each.classList[0], "plain");
    return content;
  }

  // What solves the case that is shown as text.
  command() {
    const { standard, user } = this.state;
    const replaced = Object.entries(user).map(([name, value]) => ` --${name} "${value}"`).join("");
    return standard ? `dashpad assess case.toml --standard ${standard}${replaced}` : "dashpad run case.toml";
  }

  showFaults(faults) {
    const keys = { "--mass": "impactor.mass", "--speed": "impactor.speed" };
    const known = faults.map((fault) => ({ ...fault, key: fault.key || keys[fault.file?.split(" ")[0]] || "" }));
    document.body.classList.toggle("fault", faults.length > 0);
    const list = byId("faults");
    // Beneath the first field with a fault. Without faults it is elsewhere: the rows of sliders are replaced.
    const place = known.map(({ key }) => document.querySelector(`[data-key="${CSS.escape(key)}"]`)?.closest(".control")).find(Boolean);
    place?.closest("details")?.setAttribute("open", "");
    (place ?? byId("standard").closest(".control")).after(list);
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

  async findThinnest() {
    const found = byId("found");
    if (document.body.classList.contains("fault")) return (found.textContent = "Mend the marked field first.");
    const { serial } = this;
    this.searching ??= new EngineWorker(this.quick.module, this.quick.files);
    this.isSearching = true;
    const begun = performance.now();
    const tell = () => (byId("thinnest").textContent = `Cancel the search (${Math.round((performance.now() - begun) / 1000)} s)`);
    tell();
    const clock = setInterval(tell, 1000);
    found.textContent = "Searching between a quarter of the thickness and four times it ...";
    // To 0.1 %: next to bottoming out a step more takes seconds.
    const answer = await this.searching.ask({ ...this.request(true), do: "solve-for", key: "pad.thickness", tolerance: 1e-3 }, 60, `dashpad solve-for pad.thickness case.toml --standard ${this.state.standard}`);
    clearInterval(clock);
    this.isSearching = false;
    byId("thinnest").textContent = "Thinnest pad that passes";
    if (!answer || serial !== this.serial) return;
    if (answer.faults) return (found.textContent = `${answer.faults[0].text.replace(/^./, (letter) => letter.toUpperCase())}.`);
    const turn = answer.result.turns.find(({ passes_above: above }) => above);
    // The place from which the whole interval passes, rounded up to a tenth of a millimetre. Without one nothing is chosen.
    const isCertain = Number.isFinite(turn?.high);
    const thickness = isCertain && `${Math.ceil(turn.high * 1e4) / 10} mm`;
    if (isCertain) this.change((next) => (next.pads[next.active].thickness = thickness), true);
    found.textContent = `${answer.title}. ${isCertain ? `The thickness is set to ${thickness}` : "The thickness is left as it is, since none passes with its 95 % interval"}.`;
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
