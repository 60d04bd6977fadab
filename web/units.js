// Other units: texts, tables and the drawing wait in a template for each system; axes of plots take its factors.

function unitSwitch(panels) {
  const templates = [...document.querySelectorAll("template[data-units]")];
  const place = document.querySelector("[data-units]:not(template)");
  if (!place || templates.length === 0) return;
  const systems = [place, ...templates].map(({ dataset, content }) => ({
    title: dataset.units,
    order: Number(dataset.order),
    units: JSON.parse(dataset.factors ?? "{}"),
    parts: content,
  }));
  let shown = systems[0];

  const show = (system) => {
    if (system === shown) return;
    // Templates are written against the system that the page was written in.
    if (shown !== systems[0] && system !== systems[0]) show(systems[0]);
    // What is taken out of the page is kept where the other came from.
    document.dispatchEvent(new Event("before-units"));
    shown.parts = document.createDocumentFragment();
    for (const part of [...system.parts.querySelectorAll("[data-part]")]) {
      const old = document.querySelector(`[data-part="${part.dataset.part}"]`);
      old.replaceWith(part);
      shown.parts.append(old);
    }
    for (const list of system.parts.querySelectorAll("[data-texts-of]")) {
      const texts = document.querySelectorAll(`[data-part="${list.dataset.textsOf}"] > svg:first-child :is(desc, text)`);
      [...list.children].forEach((item, i) => ([texts[i].textContent, item.textContent] = [item.textContent, texts[i].textContent]));
      shown.parts.append(list);
    }
    shown = system;
    for (const panel of panels) panel.setUnits(system.units);
    document.dispatchEvent(new Event("units"));
  };

  const choices = Object.assign(document.createElement("fieldset"), { className: "units" });
  choices.append(textElement("legend", "Units"));
  for (const system of [...systems].sort((one, other) => one.order - other.order)) {
    const choice = Object.assign(document.createElement("input"), { type: "radio", name: "units", checked: system === shown });
    choice.addEventListener("change", () => show(system));
    const label = document.createElement("label");
    label.append(choice, textElement("span", system.title));
    choices.append(label);
  }
  const words = place.querySelector('[data-part=words]');
  if (words) words.after(choices);
  else place.prepend(choices);
}
