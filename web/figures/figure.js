// A figure: its name and title, its panels, one legend for them all, the source, a note.

import { element } from "../both/text.js";
import { Legend } from "./legend.js";
import { Panel } from "./panel.js";

export const titleOf = ({ name, title }) => [name, title].filter(Boolean).join(": ");

export function figureElement(figure, id) {
  const legend = new Legend(() => panels.forEach((panel) => panel.changed()));
  const panels = figure.panels.map((panel) => new Panel(panel, titleOf(figure), (series) => legend.isOn(series)));
  legend.add(figure.panels.flatMap((panel) => panel.series));
  const made = element(
    "figure",
    { attributes: { id } },
    element("figcaption", {}, element("h3", { text: titleOf(figure) })),
    ...panels.map((panel) => panel.element),
    legend.element,
  );
  if (figure.source) made.append(element("p", { className: "source", text: figure.source }));
  if (figure.note) made.append(element("p", { className: "note", text: figure.note }));
  return made;
}
