// Which plots there are.

import { percent } from "../both/text.js";
import { CurveChart } from "./curve_chart.js";
import { LoopChart } from "./loop_chart.js";

const place = (values, best) => values.reduce((top, value, i) => (value !== null && value > (values[top] ?? -Infinity) ? i : top), best);

export function plots(data) {
  const { history, injury, snapshots, status, titles } = data;
  const shown = shownForces(history, status);
  const peak = place(shown, 0);
  const high = shown[peak];
  const closing = status === "bottomed out" ? "Without a finite limit at full compression: the curve leaves the plot." : "";
  const over = (y, series, more) => ({
    x: { label: titles.time, unit: "s" },
    y,
    series: series.map((each) => ({ x: history.time, ...each })),
    overTime: true,
    rest: peak,
    ...more,
  });
  const loop = (label, values) => ({
    time: history.time,
    x: { label, unit: "m", values },
    y: { label: titles.force, unit: "N", values: history.force, high },
    note: closing,
    turn: place(values, 0),
    closed: status === "released" || history.force.at(-1) === 0,
    rest: peak,
  });
  const list = [
    new CurveChart({
      name: "force", title: "Force over time", note: closing,
      ...over({ label: titles.force, unit: "N", high }, [{ label: titles.force, y: history.force, colour: "line-0" }]),
    }),
    new CurveChart({ name: "acceleration", title: "Deceleration over time", note: closing, ...deceleration(over, history, injury, peak, titles) }),
    new LoopChart({
      name: "force-penetration", title: "Force against penetration",
      ...loop(titles.penetration, history.penetration),
    }),
    new LoopChart({ name: "force-motion", title: "Force against displacement", ...loop(titles.motion, history.motion) }),
    new CurveChart({
      name: "motion", title: "Penetration and displacement over time",
      ...over({ label: "Distance", unit: "m" }, [
        { label: titles.motion, y: history.motion, colour: "line-0" },
        { label: titles.penetration, y: history.penetration, colour: "line-1", dash: "dashed" },
        { label: titles.support_deflection, y: history.support_deflection, colour: "line-2", dash: "dotted" },
      ]),
    }),
    energy(over, history, data.energy_residual_fraction, titles),
  ];
  if (snapshots.length > 0) list.push(...contact(snapshots));
  return list;
}

// A pad that bottoms out on a rigid support has no finite force: what it has in the last hundredth of its
// thickness would hide all the rest.
function shownForces({ force, penetration }, status) {
  if (status !== "bottomed out") return force;
  const end = 0.99 * Math.max(...penetration);
  return force.map((value, i) => (penetration[i] < end ? value : null));
}

// The deceleration in g, with the windows of the head injury criterion and the 3 ms clip.
function deceleration(over, history, injury, peak, titles) {
  const y = { label: titles.deceleration, unit: "g", high: history.deceleration[peak] };
  const series = [{ label: titles.deceleration, y: history.deceleration, colour: "line-0" }];
  if (!injury) return over(y, series);
  const { hic15, hic36, clip_3ms: clip } = injury;
  const span = (name, { value }) => `${name} ${Number(value.toPrecision(4))}`;
  const level = `${titles.clip_3ms} ${Number(clip.value.toPrecision(4))} g`;
  return over(y, series, {
    bands: [
      { from: hic36.begin, to: hic36.end, colour: "band", label: span(titles.hic36, hic36) },
      { from: hic15.begin, to: hic15.end, colour: "band-2", label: span(titles.hic15, hic15) },
    ],
    lines: [
      { y: clip.value, label: level, dash: "dashed" },
      { y: 80, label: "80 g for 3 ms (FMVSS 201)", dash: "dotted" },
    ],
  });
}

const looks = {
  loading: [{ colour: "line-2", dash: "dotted" }, { colour: "line-0", dash: "dashed" }, { colour: "line-3", dash: "dashed" }],
  "peak force": [{ colour: "text", dash: "solid" }],
  unloading: [{ colour: "line-1", dash: "dashed" }, { colour: "line-3", dash: "dotted" }],
};

// Strain and stress over the radius, a curve a moment.
function contact(snapshots) {
  const turns = {};
  const moments = snapshots.map((snapshot) => {
    const turn = (turns[snapshot.when] = (turns[snapshot.when] ?? -1) + 1);
    return { ...snapshot, ...looks[snapshot.when][turn], label: `${Number((1000 * snapshot.time).toPrecision(3))} ms, ${snapshot.when}` };
  });
  const known = snapshots.filter((snapshot) => snapshot.determined).map((snapshot) => snapshot.deviation);
  const notes = [];
  if (known.length > 0)
    notes.push(`The integral of these stresses differs from the force by ${percent(Math.max(...known))} at most.`);
  if (known.length < snapshots.length)
    notes.push("Where the pad is locked, or rigid foam is held, the law fixes only the force, not how it is shared out.");
  const high = Math.max(...moments.flatMap(({ stress, strain }) => stress.filter((value, i) => strain[i] < 0.995)));
  const over = (name, title, label, unit, column) =>
    new CurveChart({
      name, title,
      note: column === "stress" ? notes.join(" ") : "",
      x: { label: "Radius", unit: "m" },
      y: column === "stress" ? { label, unit, high } : { label, unit },
      logarithmic: column === "stress" && isSteep(snapshots, high),
      series: moments.map((moment) => ({ ...moment, x: moment.radius, y: moment[column] })),
    });
  if (moments.some(({ stress }) => Math.max(...stress) > high))
    notes.push("Within half a hundredth of full compression the stress leaves the plot.");
  return [
    over("stress", "Stress over the contact", "Stress", "Pa", "stress"),
    over("strain", "Strain over the contact", "Strain", "1", "strain"),
  ];
}

// Near full compression the stress on the axis dwarfs all others.
function isSteep(snapshots, high) {
  return high > 30 * Math.min(...snapshots.map(({ stress }) => Math.max(...stress)));
}

function energy(over, history, residual, titles) {
  return new CurveChart({
    name: "energy", title: "Energy over time",
    note:
      `The sum of these curves (work by trapezoids) stays within ${percent(history.energy_residual_fraction)} of the impact ` +
      `energy. By the solver's own audit, of higher order, the residual at the end is ${percent(residual)}.`,
    ...over({ label: "Energy", unit: "J" }, [
      { label: titles.total_energy, y: history.total_energy, colour: "text" },
      { label: titles.kinetic_energy, y: history.kinetic_energy, colour: "line-0", dash: "dashed" },
      { label: titles.support_energy, y: history.support_energy, colour: "line-2", dash: "dotted" },
      { label: titles.pad_energy, y: history.pad_energy, colour: "line-1" },
    ]),
  });
}
