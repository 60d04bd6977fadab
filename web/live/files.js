// Files of the reader's own: cases, cards of foams, compression tests and measured pulses.

class OwnFiles {
  constructor(page) {
    this.page = page;
    for (const id of ["open", "tests"]) byId(id).addEventListener("change", ({ target }) => this.open([...target.files]));
    byId("fit").addEventListener("click", () => this.fitTests());
    byId("own").addEventListener("change", () => this.lacking?.every((id) => byId(id).value.trim()) && this.fitTests());
    byId("copy-card").addEventListener("click", () => page.copy(page.state.cards[this.card], "The card is copied.", "fit-found"));
    document.addEventListener("dragover", (event) => event.preventDefault());
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      this.open([...event.dataTransfer.files]);
    });
  }

  async open(files) {
    const large = files.find(({ size }) => size > 1 << 20);
    if (large) return this.page.showFaults([{ text: `${large.name} is larger than 1 MiB` }]);
    const isCase = ({ name }) => /\.toml$/i.test(name);
    for (const file of files.filter(isCase)) await this.read(file);
    const tables = files.filter((file) => !isCase(file));
    if (tables.length === 0) return;
    const texts = await Promise.all(tables.map(async (file) => [file.name, await file.text()]));
    const [pulse] = texts.filter(([, text]) => OwnFiles.isPulse(text));
    if (pulse) return this.usePulse(...pulse);
    this.tests = texts;
    byId("fit").disabled = false;
    byId("own").open = true;
    await this.fitTests();
  }

  // By the names and units of the columns, on the lines that are not numbers alone.
  static isPulse(text) {
    const head = text.slice(0, 4000).split("\n").filter((line) => /[a-z]{2}|\bg\b/i.test(line)).join("\n");
    return /\bacc(el\w*|_\w+)?\b|\bdecel\w*|(^|[\s,;"_([])(g|m\/s\^?2)($|[\s,;")\]])/im.test(head);
  }

  usePulse(name, text) {
    this.pulse = name;
    this.page.thorough.addFiles({ [name]: text });
    this.page.refresh(true);
  }

  // The measured pulse, by itself and beside the computed one, for the case as it is now.
  async comparePulse(isOver) {
    if (!this.pulse) return;
    const answer = await this.page.thorough.ask({ ...this.page.request(true), do: "pulse", pulse: this.pulse });
    if (!answer || isOver()) return;
    if (answer.faults) {
      this.pulse = null;
      return this.page.showFaults(answer.faults.map(({ text }) => ({ text })));
    }
    this.showDropped(`The pulse in ${this.pulse}: ${answer.title}`, [answer.comparison, answer.html]);
    byId("fitted").open = true;
  }

  // A case, or a card of a foam, which the case then uses.
  async read(file) {
    const text = await file.text();
    if (/^\s*law\s*=/m.test(text) && !/^\s*\[impactor\]/m.test(text)) return this.useCard(file.name, text);
    const answer = await this.page.quick.ask({ do: "read", text });
    // Its lines are those of the file.
    if (answer?.faults) return this.page.showFaults(answer.faults.map((fault) => ({ text: fault.text.replace(/^the case/, file.name) })));
    if (answer) this.page.change((state) => Object.assign(state, { case: { ...answer.case, pad: undefined }, pads: [answer.case.pad ?? {}], active: 0, user: {} }), true);
  }

  // Cards travel in the link; one of the reader takes no other's name.
  useCard(file, text) {
    const own = file.replace(/\.\w+$/, "").replace(/[^\w-]/g, "-").slice(0, 50) || "card";
    const name = this.page.lists.foams.some((foam) => foam.name === own) ? `${own}-own` : own;
    this.page.change((state) => {
      state.pads[state.active] = { thickness: state.pads[state.active].thickness ?? "25 mm", material: name };
      const used = new Set(state.pads.map(({ material }) => material));
      state.cards = Object.fromEntries([...Object.entries(state.cards ?? {}).filter(([card]) => used.has(card)), [name, text]]);
    }, true);
    return name;
  }

  // A card from the tests that were chosen; what they lack are the fields beside them.
  async fitTests() {
    const found = byId("fit-found");
    found.textContent = "Fitting ...";
    this.lacking = null;
    byId("fit").disabled = byId("test-faults").hidden = true;
    const engine = new EngineWorker(this.page.quick.module, Object.fromEntries(this.tests));
    const given = Object.fromEntries(["thickness", "area", "rate"].map((what) => [what, byId(`test-${what}`).value.trim()]).filter(([, text]) => text));
    const answer = await engine.ask({ do: "fit", files: this.tests.map(([name]) => name), units: this.page.state.units, ...given }, 60);
    engine.worker.terminate();
    found.textContent = "";
    byId("fit").disabled = false;
    byId("test-faults").hidden = !answer.faults;
    byId("test-faults").replaceChildren(...(answer.faults ?? []).map(({ text }) => textElement("li", text.replace(/, such as --\w+ "[^"]*"/g, ""))));
    if (answer.faults) return this.askForLacking(answer.faults);
    found.textContent = `${answer.title}.${answer.card ? "" : " The fit did not converge, so there is no card."}`;
    if (answer.card) this.card = this.useCard(this.tests[0][0], answer.card);
    byId("copy-card").hidden = !answer.card;
    this.showDropped(`The fit: ${answer.title}`, [answer.html]);
  }

  // What the tests do not say is to be filled in; then they are fitted by themselves.
  askForLacking(faults) {
    const lacking = ["thickness", "area", "rate"].filter((what) => faults.some(({ text }) => text.includes(`such as --${what}`)));
    if (lacking.length === 0) return;
    this.lacking = lacking.map((what) => `test-${what}`);
    const first = byId(this.lacking.find((id) => !byId(id).value.trim()) ?? this.lacking[0]);
    first.scrollIntoView({ block: "center" });
    first.focus({ preventScroll: true });
  }

  showDropped(title, pages) {
    this.dropped = { title, pages: pages.filter(Boolean) };
    this.showPages();
  }

  // The pages of what was dropped, made anew with that of the case, whose script they share.
  showPages() {
    byId("fitted").hidden = !this.dropped;
    if (!this.dropped) return;
    const [summary, place] = byId("fitted").children;
    summary.textContent = this.dropped.title;
    place.replaceChildren();
    for (const html of this.dropped.pages) {
      const parts = document.createElement("template");
      parts.innerHTML = html;
      for (const each of parts.content.querySelectorAll("section[id], figure[id]")) each.removeAttribute("id");
      place.append(...parts.content.querySelector(".lead").childNodes, ...parts.content.querySelector("main").childNodes);
      for (const heading of place.querySelectorAll("h1")) {
        const lower = document.createElement("h2");
        lower.append(...heading.childNodes);
        heading.replaceWith(lower);
      }
    }
  }
}
