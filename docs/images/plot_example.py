#!/usr/bin/env python3
"""Draws docs/images/helmet-pad-10fps.svg, the picture of the README.

Needs python3-matplotlib (Debian) and the command, which `./do run` builds. From anywhere:

    /usr/bin/python3 docs/images/plot_example.py [--dashpad COMMAND] [--output FILE]

The ending of FILE says its format (svg, png, pdf). The same history gives the same svg, byte for byte.
"""

import argparse
import csv
import pathlib
import subprocess

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASE = ROOT / "examples" / "helmet-pad-10fps.toml"
FORCE, PENETRATION = "#1f4e9c", "#2a8a4a"


def history(command):
    """Columns of the history that `dashpad run --csv` writes, in SI."""
    result = subprocess.run([command, "run", CASE, "--csv", "-"], check=True, text=True, stdout=subprocess.PIPE,
                            stderr=subprocess.DEVNULL)
    rows = list(csv.DictReader(result.stdout.splitlines()))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def draw(h):
    time = [1e3 * t for t in h["time_s"]]
    force = [1e-3 * f for f in h["force_N"]]
    penetration = [1e3 * y for y in h["penetration_m"]]

    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.2), gridspec_kw={"width_ratios": [1.35, 1]})

    lengths = left.twinx()
    lines = left.plot(time, force, color=FORCE, linewidth=2, label="force (left scale)")
    lines += lengths.plot(time, penetration, color=PENETRATION, linestyle="-.", label="penetration (right scale)")
    left.set_xlabel("time since first contact, ms")
    left.set_ylabel("force, kN", color=FORCE)
    lengths.set_ylabel("penetration, mm", color=PENETRATION)
    left.set_xlim(0, max(time))
    left.set_ylim(0, 1.45 * max(force))
    lengths.set_ylim(0, 1.45 * max(penetration))
    left.legend(handles=lines, loc="upper left", framealpha=1, fontsize=9)
    left.set_title("The impact over time", fontsize=11)
    left.grid(alpha=0.3)

    top = force.index(max(force))
    right.plot(penetration[: top + 1], force[: top + 1], color=FORCE, linewidth=2, label="up to the peak force")
    right.plot(penetration[top:], force[top:], color=FORCE, linewidth=2, linestyle=":", label="after it")
    right.fill(penetration, force, color=FORCE, alpha=0.12, linewidth=0, label="energy absorbed by the pad")
    right.set_xlabel("penetration, mm")
    right.set_ylabel("force, kN", color=FORCE)
    right.set_xlim(0, 1.05 * max(penetration))
    right.set_ylim(0, 1.45 * max(force))
    right.legend(loc="upper left", framealpha=1, fontsize=9)
    right.set_title("Force over penetration", fontsize=11)
    right.grid(alpha=0.3)

    figure.suptitle("Headform of 5 kg, radius 75 mm, at 3.05 m/s (10 ft/s) on 45 mm of a helmet pad's foam",
                    fontsize=11)
    figure.tight_layout()
    return figure


def main():
    parser = argparse.ArgumentParser(description="Draws the picture of the README.")
    parser.add_argument("--dashpad", default=ROOT / "build/release/app/dashpad", help="the command dashpad")
    parser.add_argument("--output", default=pathlib.Path(__file__).with_name("helmet-pad-10fps.svg"))
    arguments = parser.parse_args()

    matplotlib.rcParams["svg.hashsalt"] = "dashpad"
    metadata = {"Date": None} if str(arguments.output).endswith(".svg") else {}
    draw(history(arguments.dashpad)).savefig(arguments.output, dpi=150, facecolor="white", metadata=metadata)


if __name__ == "__main__":
    main()
