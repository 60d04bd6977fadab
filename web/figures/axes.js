// Axes of figures: linear, or logarithmic with the logarithms as places.

import { axis, characterWidth, widthOfNumbers } from "../both/axes.js";
import { niceStep } from "./scale.js";

// Room for the longest number that a linear axis may get.
function room(low, high) {
  const decimals = Math.max(0, Math.ceil(-Math.log10((high - low) / 10)));
  const digits = Math.max(1, Math.ceil(Math.log10(Math.max(Math.abs(low), Math.abs(high)))));
  const plain = digits + (decimals > 0 ? decimals + 1 : 0) + (low < 0 ? 1 : 0);
  const characters = decimals > 6 || digits > 7 ? 8 : plain;
  return Math.max(48, characterWidth * (characters + 2.5));
}

const mantissas = [[1, 2, 3, 4, 5, 6, 7, 8, 9], [1, 2, 5], [1, 3], [1]];
const mantissa = (place) => Math.round(10 ** (place - Math.floor(place + 1e-9)));
const isWhole = (place) => Math.abs(place - Math.round(place)) < 1e-6;

// The distance of the two nearest of them, in decades.
const least = (list) => Math.min(...list.map((value, i) => Math.log10((list[i + 1] ?? 10) / value)));

// What has a number: of these mantissas, or of every so many decades, or at even distances where the axis shows
// a small part of a decade.
function plan(low, high, pixels, space) {
  const decade = pixels / (high - low);
  const choice = mantissas.find((list) => decade * least(list) >= space);
  if (!choice) return { every: Math.ceil(space / decade) };
  const count = all(low, high).filter((place) => choice.includes(mantissa(place))).length;
  // Far up the axis numbers are closest.
  return count < 3 ? { step: niceStep(10 ** high * (1 - 10 ** (-space / decade))) } : { choice };
}

// The places of 1 to 9 in each decade.
function all(low, high) {
  const places = [];
  for (let decade = Math.floor(low); decade <= high; ++decade)
    for (let times = 1; times <= 9; ++times) places.push(decade + Math.log10(times));
  return places.filter((place) => place >= low - 1e-9 && place <= high + 1e-9);
}

function steps(low, high, step) {
  const places = [];
  const last = (10 ** high * (1 + 1e-9)) / step;
  for (let i = Math.ceil(10 ** low / step - 1e-9); i <= last; ++i) places.push(Math.log10(i * step));
  return places;
}

function isNumbered(place, { every, choice, step }) {
  if (step) return true;
  return every ? isWhole(place) && Math.round(place) % every === 0 : choice.includes(mantissa(place));
}

const raised = (power) => [...String(power)].map((digit) => (digit === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit])).join("");

function logarithmText(place) {
  const value = Number((10 ** place).toPrecision(6));
  if (place > -4.5 && place < 5.5) return String(value);
  const power = Math.floor(place + 1e-6);
  const times = Number((10 ** (place - power)).toPrecision(4));
  return times === 1 ? `10${raised(power)}` : `${times}·10${raised(power)}`;
}

function logarithmic(space, pixels) {
  let chosen = {};
  const only = (plot, splits) => splits.map((place) => (isNumbered(place, chosen) ? place : null));
  return {
    splits: (plot, index, low, high) => {
      chosen = plan(low, high, pixels(plot), space);
      if (chosen.step) return steps(low, high, chosen.step);
      return chosen.every > 1 ? all(low, high).filter(isWhole) : all(low, high);
    },
    filter: only,
    values: (plot, places) => places.map((place) => (place === null ? "" : logarithmText(place))),
  };
}

export function axes(x, y) {
  const inner = (plot, side) => plot.bbox[side] / devicePixelRatio;
  return [
    {
      ...axis(),
      size: 32,
      space: (plot, index, low, high) => room(low, high),
      ...(x.logarithmic ? logarithmic(44, (plot) => inner(plot, "width")) : {}),
    },
    {
      ...axis(),
      size: widthOfNumbers,
      space: 36,
      ...(y.logarithmic ? logarithmic(26, (plot) => inner(plot, "height")) : {}),
    },
  ];
}
