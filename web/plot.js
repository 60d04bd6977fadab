// A plot: its panels, the words at the pointer, and entries of the legend that switch series off and on.

class Tip {
  constructor(svg) {
    this.svg = svg;
    this.box = Object.assign(document.createElement("div"), { className: "tip", hidden: true });
    this.box.setAttribute("role", "status");
    svg.after(this.box);
    this.owner = null;
  }

  show(panel, [label, ...values]) {
    this.owner = panel;
    this.box.replaceChildren(...(label ? [textElement("strong", label)] : []), ...values.map((text) => textElement("div", text)));
    this.box.hidden = false;
    const frame = this.box.offsetParent.getBoundingClientRect();
    const mark = panel.marks.lastElementChild.getBoundingClientRect();
    const { offsetWidth: width, offsetHeight: height } = this.box;
    const left = (mark.left + mark.right) / 2 - frame.left - width / 2;
    const above = mark.top - frame.top - height - 8;
    this.box.style.left = `${Math.min(Math.max(left, 0), frame.width - width)}px`;
    this.box.style.top = `${above >= 0 ? above : mark.bottom - frame.top + 8}px`;
  }

  hide(panel) {
    if (this.owner === panel) this.box.hidden = true;
  }
}

function makeSwitch(entry, plot) {
  const { label } = entry.dataset;
  entry.setAttribute("role", "button");
  entry.setAttribute("tabindex", "0");
  entry.setAttribute("aria-pressed", "true");
  entry.setAttribute("aria-label", label);
  const turn = () => {
    const isOn = entry.getAttribute("aria-pressed") !== "true";
    for (const each of plot.querySelectorAll("[data-label], [data-of]")) {
      if ((each.dataset.label || each.dataset.of) !== label) continue;
      if (each.hasAttribute("aria-pressed")) each.setAttribute("aria-pressed", String(isOn));
      else each.classList.toggle("dp-off", !isOn);
    }
  };
  entry.addEventListener("click", turn);
  entry.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    turn();
  });
}

// The panels of an svg.dp-plot.
function panelsOf(svg) {
  // An image has no parts that could be pointed at.
  svg.setAttribute("role", "group");
  svg.setAttribute("aria-label", svg.querySelector("title").textContent);
  // Browsers would show it wherever the pointer rests.
  svg.querySelector("title").remove();
  const tip = new Tip(svg);
  const panels = [...svg.querySelectorAll(".dp-panel")].filter((group) => group.querySelector(".dp-series"));
  svg.querySelectorAll(".dp-entry, .dp-end[data-label], .dp-mark[data-label]").forEach((entry) => makeSwitch(entry, svg));
  return panels.map((group) => new Panel(group, tip));
}
