// Pads below the same impact, side by side.

const keysOfFigures = { "Peak acceleration": "peak_acceleration_g", HIC15: "hic15", HIC36: "hic36", "Unlimited HIC": "hic_unlimited", "HIC(d)": "hic_d", "3 ms clip": "clip_3ms_g", "Cumulative 3 ms clip": "cumulative_3ms_g" };

class ComparedPads {
  constructor(page) {
    this.page = page;
    this.cards = new Map();
  }

  // Unless `isOver` says that another state is to be shown. What has not changed is not solved again.
  async compare(isWhole, isOver) {
    const { pads } = this.page.state;
    if (pads.length < 2) return;
    const engine = isWhole ? this.page.thorough : this.page.quick;
    const [kept, answers] = [new Map(), []];
    for (let i = 0; i < pads.length; ++i) {
      const request = { ...this.page.request(false, i), quick: !isWhole, intervals: isWhole };
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
    byId("pads").replaceChildren(this.differences(cards, isWhole ? answers : []), beside);
    if (this.isAdded) byId("pads").scrollIntoView({ block: "nearest" });
    this.isAdded = false;
  }

  // The key figures of the pads, with how much more or less than that of the first.
  differences(cards, answers) {
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
      return Number.isFinite(more) && text !== of ? ` (${more > 0 ? "+" : "\u2212"}${Number(Math.abs(more).toPrecision(2))}\u00a0%)` : "";
    };
    for (const [label, text] of first) {
      const cells = others.map((figures) => figures.get(label) ?? "\u2013");
      table.append(row("td", [label, text, ...cells.map((cell) => `${cell}${share(cell, text)}`)]));
    }
    const part = document.createElement("div");
    const pads = this.page.state.pads.map((pad) => JSON.stringify(pad));
    const copies = pads.flatMap((pad, i) => (pads.indexOf(pad) < i ? `Pad ${"ABCD"[i]} is a copy of pad ${"ABCD"[pads.indexOf(pad)]}: choose another foam or thickness.` : []));
    const lowest = [...first.keys()].filter((label) => /acceleration|HIC|clip/.test(label)).flatMap((label) => this.lowest(label, all, answers));
    part.append(...copies.map((words) => textElement("p", words)), table, ...lowest);
    return part;
  }

  // The pad with the lowest figure, and how far the next is above it, or which could be lower, by their intervals.
  lowest(label, all, answers) {
    const order = all.map((figures, i) => [Number.parseFloat(figures.get(label)), "ABCD"[i]]).filter(([value]) => Number.isFinite(value)).sort(([a], [b]) => a - b);
    if (answers.length === 0 || order.length < 2 || order[0][0] === order[1][0]) return [];
    const intervalOf = (letter) => {
      const { result } = answers["ABCD".indexOf(letter)];
      return (result?.result ?? result)?.intervals?.figures[keysOfFigures[label.replace(/\s/g, " ")]];
    };
    const own = intervalOf(order[0][1]);
    const alike = order.slice(1).map(([, letter]) => letter).filter((letter) => intervalOf(letter)?.low <= own?.high);
    const share = 100 - (100 * order[0][0]) / order[1][0];
    const how = alike.length > 0 ? `; within their uncertainty it cannot be told apart from pad ${alike.sort().join(" or ").replace(/ or (?=.* or )/g, ", ")}` : `, ${share.toPrecision(2)} % below pad ${order[1][1]}`;
    return [textElement("p", `Lowest ${label.replace(/^(Peak|Cumulative)/, (word) => word.toLowerCase())}: pad ${order[0][1]}${how}.`)];
  }

  padCard(answer, i, isWhole) {
    const { state, lists } = this.page;
    const pad = state.pads[i];
    const letter = "ABCD"[i];
    const card = Object.assign(document.createElement("section"), { className: i === state.active ? "pad active" : "pad" });
    const thickness = answer.faults || pad.layers ? "" : `, ${Sliders.text(answer.numbers.thickness, Sliders.unit("m", state.units)).replace(" ", "\u00a0")}`;
    const title = lists.foams.find(({ name }) => name === pad.material)?.title;
    card.append(textElement("h2", `${letter}: ${pad.layers ? `${pad.layers.length} layers` : title || (pad.material ?? "foam of the case")}${thickness}`));
    if (answer.faults) {
      card.append(textElement("p", answer.faults[0].text));
    } else {
      // The names of the drawing's parts are those of one page.
      const own = { ...answer, html: answer.html.replace(/\bdd-[0-9a-f]{8}(?=-)/g, `$&-${letter}`) };
      const parts = this.page.partsOf(own, isWhole);
      const [verdict, tone] = this.page.titleOf(own, parts, isWhole);
      card.append(Object.assign(textElement("p", verdict), { className: `answer ${tone}` }));
      card.append(...[".drawing", ".key-figures"].flatMap((each) => parts.querySelector(each) ?? []));
    }
    const buttons = Object.assign(document.createElement("p"), { className: "buttons" });
    const button = (text, make) => {
      const element = Object.assign(textElement("button", text), { type: "button" });
      element.setAttribute("aria-label", text === "Remove" ? `Remove pad ${letter}` : `Change pad ${letter}`);
      element.addEventListener("click", () => {
        // These cards may be of a state before.
        if (this.page.state.pads.length !== state.pads.length) return;
        this.page.change(make, true);
        byId("foam").focus();
      });
      buttons.append(element);
    };
    button("Change this pad", (next) => (next.active = i));
    button("Remove", (next) => {
      next.pads.splice(i, 1);
      next.active = Math.min(next.active > i ? next.active - 1 : next.active, next.pads.length - 1);
    });
    card.append(buttons);
    return card;
  }
}
