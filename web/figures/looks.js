// How series look, as in the stills: colour, dashes and shape of each turn.

import { colour } from "../both/colours.js";

const colours = 7;
// Lengths of dashes and gaps. As many as share no factor with the number of colours.
const dashes = [[], [10, 4], [3, 3], [10, 4, 2, 4], [16, 4, 2, 4, 2, 4], [6, 4, 2, 2]];
const dashesAcross = [5, 3];
const shapes = [disc, square, (...place) => triangle(...place, 1), diamond, (...place) => triangle(...place, -1), disc];
const ring = 5;

// A series may bring a colour of its own, from a scale.
export const colourOf = ({ turn, colour: own }) => own ?? colour(turn === null ? "across" : `turn-${turn % colours}`);

// Lines that lie on each other stay visible: the later ones are narrower, and only the first is solid.
export function stroke({ style, turn }) {
  if (style === "vertical" || style === "horizontal") return { width: 1.4, dash: dashesAcross };
  if (style === "solid") return { width: 2, dash: dashes[0] };
  if (style === "dashed") return { width: 2, dash: dashes[1] };
  return { width: Math.max(1.4, 2.4 - 0.2 * turn), dash: dashes[turn % dashes.length] };
}

function disc(context, x, y, size) {
  context.moveTo(x + size, y);
  context.arc(x, y, size, 0, 2 * Math.PI);
}

function square(context, x, y, size) {
  context.rect(x - 0.9 * size, y - 0.9 * size, 1.8 * size, 1.8 * size);
}

function polygon(context, x, y, corners) {
  corners.forEach(([right, down], i) => (i ? context.lineTo(x + right, y + down) : context.moveTo(x + right, y + down)));
  context.closePath();
}

function triangle(context, x, y, size, up) {
  polygon(context, x, y, [[0, -1.2 * size * up], [1.1 * size, 0.8 * size * up], [-1.1 * size, 0.8 * size * up]]);
}

function diamond(context, x, y, size) {
  polygon(context, x, y, [[0, -1.25 * size], [1.25 * size, 0], [0, 1.25 * size], [-1.25 * size, 0]]);
}

// `places` in pixels of the canvas, of which there are `ratio` to one of the page.
export function drawPoints(context, places, series, ratio) {
  const turn = series.turn % shapes.length;
  const size = (places.length > 300 ? 2.4 : 3.6) * ratio;
  context.beginPath();
  for (const [x, y] of places) shapes[turn](context, x, y, size);
  context.fillStyle = context.strokeStyle = colourOf(series);
  context.lineWidth = 1.4 * ratio;
  context.setLineDash([]);
  if (turn === ring) context.stroke();
  else context.fill();
}

export function setStroke(context, series, ratio) {
  const { width, dash } = stroke(series);
  context.strokeStyle = colourOf(series);
  context.lineWidth = width * ratio;
  context.lineJoin = "round";
  context.setLineDash(dash.map((length) => length * ratio));
}

// The line closes the seams between outlines.
export function fillArea(context, series, ratio) {
  context.fillStyle = context.strokeStyle = colourOf(series);
  context.lineWidth = 0.6 * ratio;
  context.setLineDash([]);
  context.fill();
  context.stroke();
}

export function fillBand(context, series) {
  context.globalAlpha = 0.22;
  context.fillStyle = colourOf(series);
  context.fill("evenodd");
  context.globalAlpha = 1;
}
