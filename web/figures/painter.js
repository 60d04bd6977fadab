// Draws the series of a panel, in the order in which they are given, on the axes that uPlot has drawn.

import { clipped } from "./clip.js";
import { colourOf, drawPoints, fillArea, fillBand, setStroke } from "./looks.js";

// The parts of a column of places without a gap.
export function runs(places) {
  const list = [[]];
  for (const place of places) {
    if (place) list.at(-1).push(place);
    else if (list.at(-1).length > 0) list.push([]);
  }
  return list.filter((run) => run.length > 0);
}

export function paint(plot, series) {
  const { ctx, bbox } = plot;
  const ratio = ctx.canvas.width / plot.width;
  const at = (xs, ys) =>
    xs.map((x, i) => (x === null ? null : [plot.valToPos(x, "x", true), plot.valToPos(ys[i], "y", true)]));
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  // Areas and bands lie behind everything else, and lines across behind the data.
  for (const each of series) if (each.style === "area") area(ctx, each, at(each.x, each.y), ratio);
  for (const each of series) if (each.style === "band") band(ctx, each, at(each.x, each.y), at(each.x, each.y2));
  for (const each of series)
    if (each.style === "vertical" || each.style === "horizontal") across(plot, each, ratio);
  for (const each of series) {
    if (each.style === "points") drawPoints(ctx, at(each.x, each.y).filter(Boolean), each, ratio);
    else if (each.y && each.x && !["area", "band"].includes(each.style)) line(plot, each, at(each.x, each.y), ratio);
  }
  ctx.restore();
}

function area(ctx, series, places, ratio) {
  ctx.beginPath();
  for (const run of runs(places)) {
    ctx.moveTo(...run[0]);
    for (const place of run.slice(1)) ctx.lineTo(...place);
    ctx.closePath();
  }
  fillArea(ctx, series, ratio);
}

function band(ctx, series, edge, other) {
  const others = runs(other);
  ctx.beginPath();
  for (const [i, run] of runs(edge).entries()) {
    ctx.moveTo(...run[0]);
    for (const [x, y] of [...run, ...others[i].reverse()]) ctx.lineTo(x, y);
    ctx.closePath();
  }
  fillBand(ctx, series);
}

function across(plot, series, ratio) {
  const { ctx, bbox } = plot;
  setStroke(ctx, series, ratio);
  ctx.beginPath();
  for (const place of series.x ?? []) {
    const x = plot.valToPos(place, "x", true);
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
  }
  for (const place of series.y ?? []) {
    const y = plot.valToPos(place, "y", true);
    ctx.moveTo(bbox.left, y);
    ctx.lineTo(bbox.left + bbox.width, y);
  }
  ctx.stroke();
}

// Enlarged, a line may go far beyond the plot: dashes out there would take a long time.
function line({ ctx, bbox }, series, places, ratio) {
  const edge = 50 * ratio;
  const box = {
    left: bbox.left - edge,
    right: bbox.left + bbox.width + edge,
    low: bbox.top - edge,
    high: bbox.top + bbox.height + edge,
  };
  setStroke(ctx, series, ratio);
  ctx.beginPath();
  for (const run of runs(places)) {
    let pen = null;
    for (let i = 1; i < run.length; ++i) {
      const part = clipped(run[i - 1], run[i], box);
      if (!part) continue;
      if (pen !== part[0]) ctx.moveTo(...part[0]);
      ctx.lineTo(...part[1]);
      pen = part[1];
    }
  }
  ctx.stroke();
  dots(ctx, series, runs(places).filter((run) => run.length === 1), ratio);
}

// Points between two gaps, which no line can show.
function dots(ctx, series, lone, ratio) {
  ctx.fillStyle = colourOf(series);
  for (const [[x, y]] of lone) {
    ctx.beginPath();
    ctx.arc(x, y, 2.2 * ratio, 0, 2 * Math.PI);
    ctx.fill();
  }
}
