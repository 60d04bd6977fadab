// What is said of a point: the label of its series, and its values with the labels of the axes.

import { number } from "../both/text.js";

export function tipTexts({ series, entry }, { x, y }) {
  const { given } = series;
  const named = (label, text) => (label ? `${label}: ${text}` : text);
  const texts = [given.label];
  if (given.x) texts.push(named(x.label, number(given.x[entry])));
  if (given.y2) texts.push(named(y.label, `${number(given.y[entry])} to ${number(given.y2[entry])}`));
  else if (given.y) texts.push(named(y.label, number(given.y[entry])));
  return texts;
}
