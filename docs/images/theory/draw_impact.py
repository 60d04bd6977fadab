"""Draws the pictures of sections 1 to 4 of docs/theory.md. Curves are computed by the command.

    draw_impact.py COMMAND [FOLDER]      from the root of the project; FOLDER: where the pictures go, if not here
"""

import csv
import io
import json
import math
import pathlib
import subprocess
import sys
import tempfile

DASHBOARD = "examples/dashboard-20mph.toml"
INK, BLUE, RED, GREY, PALE = "#223344", "#1a56b0", "#b3401a", "#6b7785", "#dfe6ee"
STYLE = (
    f"text{{fill:{INK};font-family:sans-serif;font-size:14px}}.s{{font-size:16px;font-style:italic;fill:{BLUE}}}"
    f".l{{fill:none;stroke:{INK};stroke-width:1.5}}.d{{fill:none;stroke:{BLUE};stroke-width:1.3}}"
    f".r{{fill:none;stroke:{RED};stroke-width:1.8}}.b{{fill:none;stroke:{BLUE};stroke-width:1.8}}"
    f".g{{fill:none;stroke:{GREY};stroke-width:1}}.h{{fill:none;stroke:{GREY};stroke-width:1;stroke-dasharray:4 4}}"
    f".f{{fill:{PALE};stroke:{INK};stroke-width:1.3}}.c{{stroke:{GREY};stroke-width:.8;fill:#eef2f6}}"
)

command = sys.argv[1]
folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else pathlib.Path(__file__).parent)


def n(value):
    return f"{value:.1f}".removesuffix(".0")


def write(name, width, height, title, parts):
    text = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
        f'role="img" aria-labelledby="t">\n<title id="t">{title}</title>\n<style>{STYLE}</style>\n'
        f'<rect width="{width}" height="{height}" fill="#fff"/>\n' + "\n".join(parts) + "\n</svg>\n"
    )
    (folder / f"{name}.svg").write_text(text, encoding="utf-8")


def simplified(points, tolerance=0.2):
    """Leaves out points closer than the tolerance to the line between those that stay (Ramer, Douglas, Peucker)."""
    (x0, y0), (x1, y1) = points[0], points[-1]
    long = math.hypot(x1 - x0, y1 - y0)

    def distance(x, y):
        if long == 0:
            return math.hypot(x - x0, y - y0)
        return abs((x1 - x0) * (y - y0) - (x - x0) * (y1 - y0)) / long

    far = max(range(len(points)), key=lambda i: distance(*points[i]))
    if distance(*points[far]) <= tolerance:
        return [points[0], points[-1]]
    return simplified(points[: far + 1], tolerance)[:-1] + simplified(points[far:], tolerance)


def path(points, kind="l"):
    return f'<path class="{kind}" d="M' + " ".join(f"{n(x)} {n(y)}" for x, y in simplified(points)) + '"/>'


def line(x1, y1, x2, y2, kind="l"):
    return f'<path class="{kind}" d="M{n(x1)} {n(y1)}L{n(x2)} {n(y2)}"/>'


def label(x, y, text, kind="", anchor="middle"):
    """Text; _ sets the letters up to the next blank or comma as a subscript."""
    parts, rest = "", text
    while "_" in rest:
        before, _, rest = rest.partition("_")
        end = next((i for i, c in enumerate(rest) if c in " ,()/="), len(rest))
        parts += f'{before}<tspan font-size="13" dy="4">{rest[:end]}</tspan>'
        rest = rest[end:]
        if rest:
            parts += f'<tspan dy="-4">{rest[0]}</tspan>'
            rest = rest[1:]
    mark = f' class="{kind}"' if kind else ""
    return f'<text{mark} x="{n(x)}" y="{n(y)}" text-anchor="{anchor}">{parts}{rest}</text>'


def arrow(x1, y1, x2, y2, both=True, kind="d"):
    """A line with a head at its end, or at both."""
    long = math.hypot(x2 - x1, y2 - y1)
    u, v = (x2 - x1) / long, (y2 - y1) / long
    heads = [(x2, y2, u, v)] + ([(x1, y1, -u, -v)] if both else [])
    d = f"M{n(x1)} {n(y1)}L{n(x2)} {n(y2)}"
    for x, y, a, b in heads:
        ends = [(x - 7 * a + side * b, y - 7 * b - side * a) for side in (-3.5, 3.5)]
        d += "M" + "L".join(f"{n(p)} {n(q)}" for p, q in (ends[0], (x, y), ends[1]))
    return f'<path class="{kind}" d="{d}"/>'


def dot(x, y, colour=INK):
    return f'<circle cx="{n(x)}" cy="{n(y)}" r="3.5" fill="{colour}"/>'


def cap(x, tip, radius, height, kind="f"):
    """The lower part of a sphere whose tip is at (x, tip)."""
    half = math.sqrt(radius**2 - (radius - height) ** 2)
    left, right, top = n(x - half), n(x + half), n(tip - height)
    return f'<path class="{kind}" d="M{left} {top}A{radius} {radius} 0 0 0 {right} {top}Z"/>'


class Axes:
    """A frame with scales: `at` gives the place of a pair of values."""

    def __init__(self, left, top, width, height, x_range, y_range):
        self.left, self.top, self.width, self.height = left, top, width, height
        self.x, self.y = x_range, y_range

    def at(self, x, y):
        return (
            self.left + (x - self.x[0]) / (self.x[1] - self.x[0]) * self.width,
            self.top + self.height - (y - self.y[0]) / (self.y[1] - self.y[0]) * self.height,
        )

    def frame(self, x_ticks, y_ticks, x_name, y_name):
        bottom = self.top + self.height
        parts = [line(self.left, bottom, self.left + self.width, bottom, "g")]
        parts.append(line(self.left, self.top, self.left, bottom, "g"))
        for value, text in x_ticks:
            x, _ = self.at(value, self.y[0])
            parts += [line(x, bottom, x, bottom + 4, "g"), label(x, bottom + 19, text)]
        for value, text in y_ticks:
            _, y = self.at(self.x[0], value)
            parts += [line(self.left - 4, y, self.left, y, "g"), label(self.left - 7, y + 5, text, anchor="end")]
        parts.append(label(self.left + self.width / 2, bottom + 40, x_name))
        parts.append(label(self.left, self.top - 9, y_name, anchor="start"))
        return parts

    def curve(self, points, kind):
        return path([self.at(x, y) for x, y in points], kind)


def ticks(*values):
    return [(value, f"{value:g}") for value in values]


def printed(*arguments):
    done = subprocess.run([command, *arguments], capture_output=True, text=True, check=True)
    return done.stdout


def rows_of(*arguments):
    table = csv.DictReader(io.StringIO(printed(*arguments, "--csv", "-")))
    return [{name: float(value) for name, value in row.items()} for row in table]


# --- The problem: before and during the impact ---


def problem():
    radius, thick, gap = 120, 66, 88
    parts = []
    for x, push, deep in ((185, 0, 0), (535, 74, 40)):
        surface, yielded = 170, push - deep
        top, back = surface + yielded, surface + yielded + thick
        floor = surface + thick + gap
        edge = math.sqrt(2 * radius * deep - deep**2)
        outline = f"M{x - 135} {top}"
        if deep:
            outline += f"H{n(x - edge)}A{radius} {radius} 0 0 0 {n(x + edge)} {top}"
        parts.append(f'<path class="c" d="{outline}H{x + 135}V{back}H{x - 135}Z"/>')
        parts.append(cap(x, surface + push, radius, 116))
        parts.append(f'<path class="f" d="M{x - 135} {back}h270v8h-270z"/>')
        for side in (-70, 70):
            coil = [(x + side, back + 8)]
            length = floor - back - 8
            coil += [(x + side + (9 if i % 2 else -9), back + 8 + length * (i + 0.5) / 8) for i in range(8)]
            coil.append((x + side, floor))
            parts.append('<path class="l" d="M' + " ".join(f"{n(a)} {n(b)}" for a, b in coil) + '"/>')
        parts.append(line(x - 140, floor, x + 140, floor))
        parts += [line(x - 135 + 18 * i, floor, x - 143 + 18 * i, floor + 9, "g") for i in range(16)]
        parts.append(label(x, floor + 34, "first contact: t = 0" if not push else "later: X = Y + X_s"))
    parts += [arrow(185, 92, 185, 132, False), label(193, 117, "V_in", "s", "start")]
    parts += [label(185, 38, "impactor of mass M"), label(185, 208, "pad")]
    parts += [label(185, 272, "support"), label(185, 292, "F_s", "s")]
    parts += [arrow(60, 170, 60, 236), label(66, 209, "L", "s", "start")]
    parts += [line(185, 50, 281, 122, "d"), label(240, 81, "R", "s"), dot(185, 50, BLUE)]
    # Levels of first contact, and of the state below it.
    parts += [line(330, 170, 700, 170, "h"), line(660, 204, 720, 204, "h"), line(535, 244, 640, 244, "h")]
    parts += [arrow(690, 170, 690, 204), label(698, 193, "X_s", "s", "start")]
    parts += [arrow(535, 204, 535, 244), label(529, 228, "Y", "s", "end")]
    parts += [arrow(382, 170, 382, 244), label(376, 214, "X", "s", "end"), line(370, 244, 535, 244, "h")]
    r = 62
    s = radius - math.sqrt(radius**2 - r**2)
    parts += [line(535, 192, 535, 110, "h"), line(535 + r, 244 - s, 535 + r, 120, "h"), arrow(535, 130, 535 + r, 130)]
    parts += [label(535 + r / 2, 124, "r", "s"), arrow(535 + r, 244 - s, 535 + r, 244)]
    parts.append(label(604, 241, "s", "s", "start"))
    write("problem", 740, 380, "Impactor, pad and support at first contact and later", parts)


# --- A column and its strain: a sphere with R = 3 L at Y = L / 2, to scale ---


def column():
    thick = 110
    radius, deep, x0, surface = 3 * thick, thick / 2, 300, 110
    back, edge = surface + thick, math.sqrt(2 * 3 * 0.5 - 0.25) * thick
    parts, wide = [], 18

    def depth(r):
        return radius - math.sqrt(radius**2 - r**2)

    for i in range(-13, 13):
        x = x0 + i * wide
        top = surface + max(deep - depth(abs(i + 0.5) * wide), 0)
        parts.append(f'<path class="c" d="M{n(x)} {n(top)}h{wide}V{back}h-{wide}z"/>')
    parts.append(cap(x0, surface + deep, radius, 150))
    r = 30 / 25.4 * thick
    s = depth(r)
    parts.append(f'<path d="M{n(x0 + r - 9)} {n(surface + deep - s)}h18V{back}h-18z" fill="#f3c9b5" stroke="{RED}"/>')
    parts += [line(x0 - 250, back, x0 + 320, back), line(x0 - 250, surface, x0 + 320, surface, "h")]
    parts.append(line(x0, surface + deep, x0 + 245, surface + deep, "h"))
    parts.append(line(x0 + r, surface + deep - s, x0 + 190, surface + deep - s, "h"))
    parts += [arrow(x0 - 207, surface, x0 - 207, back), label(x0 - 213, surface + 62, "L", "s", "end")]
    parts += [arrow(x0, surface, x0, surface + deep), label(x0 - 8, surface + 33, "Y", "s", "end")]
    for begin, end, place, name in ((0, deep - s, 19, "Y − s"), (deep - s, deep, 48, "s")):
        parts.append(arrow(x0 + 180, surface + begin, x0 + 180, surface + end))
        parts.append(label(x0 + 188, surface + place, name, "s", "start"))
    parts += [arrow(x0, 70, x0 + r, 70), label(x0 + r / 2, 63, "r", "s")]
    parts += [line(x0 + r, 60, x0 + r, surface + deep - s, "h"), line(x0, 60, x0, surface, "h")]
    parts += [label(x0, 35, "nose"), label(x0 + 318, surface - 7, "surface at first contact", anchor="end")]
    axes = Axes(x0, 280, 250, 110, (0, 250 / thick * 25.4), (0, 0.55))
    parts += axes.frame(ticks(0, 10, 20, 30, 40, 50), ticks(0, 0.25, 0.5), "r, mm", "ε")
    points = [(r_mm, (12.7 - 76.2 + math.sqrt(76.2**2 - r_mm**2)) / 25.4) for r_mm in [i * 42.121 / 40 for i in range(41)]]
    parts += [axes.curve(points + [(57, 0)], "r"), dot(*axes.at(30, 0.2577), RED)]
    x, y = axes.at(30, 0.2577)
    parts += [line(x, back, x, y, "h"), label(x + 8, y - 4, "0.258", anchor="start")]
    x, y = axes.at(42.12, 0)
    parts.append(label(x, y - 8, "r_max", "s", "start"))
    write("column", 640, 440, "Columns under a sphere, and their strain over the distance from the axis", parts)


# --- The five laws ---

CARDS = {
    "elastic": "modulus = '300 kPa'",
    "linear-viscoelastic": "asymptotic_modulus = '150 kPa'\ninitial_modulus = '450 kPa'\nrelaxation_time = '10 ms'",
    "rigid-foam": "crush_stress = '150 kPa'\ncrush_strain = 0.5\nsecond_stress = '300 kPa'\nsecond_strain = 0.8",
}


def laws():
    parts = []
    with tempfile.TemporaryDirectory() as scratch:
        names = []
        for law, parameters in CARDS.items():
            card = pathlib.Path(scratch, f"{law}.toml")
            text = f"title = '{law}'\nsource = 'none'\nlaw = '{law}'\n[parameters]\n{parameters}\n"
            card.write_text(text, encoding="utf-8")
            names.append(str(card))
        names += ["ensolite-aac-9", "ensolite-aac-21"]
        titles = ["1 elastic", "2 linear viscoelastic", "3 rigid foam", "4 nine-parameter", "5 twenty-one-parameter"]
        for i, (name, title) in enumerate(zip(names, titles)):
            axes = Axes(60 + 240 * (i % 3), 48 + 270 * (i // 3), 170, 170, (0, 0.85), (0, 700))
            parts += axes.frame(ticks(0, 0.4, 0.8), ticks(0, 200, 400, 600), "ε", "σ, kPa")
            parts.append(label(axes.left + 50, axes.top - 28, title, anchor="start"))
            rows = rows_of("material-test", name, "--rate", "1,100", "--strain", "0.8")
            for rate, kind in ((1, "b"), (100, "r")):
                loop = [(row["strain"], row["stress_Pa"] / 1e3) for row in rows if row["rate_1_per_s"] == rate]
                parts.append(axes.curve(loop, kind))
    x, y = 540, 380
    parts += [line(x, y, x + 30, y, "b"), label(x + 38, y + 5, "rate 1 per second", anchor="start")]
    parts += [line(x, y + 26, x + 30, y + 26, "r"), label(x + 38, y + 31, "rate 100 per second", anchor="start")]
    write("laws", 740, 545, "Loading to a strain of 0.8 and unloading, for the five laws", parts)


# --- Envelope and relaxation: law 4, loaded at 100 per second to a strain of 0.5, and held ---


def envelope():
    test = ("--test", "relaxation", "--rate", "100", "--strain", "0.5", "--hold", "25 ms")
    rows = rows_of("material-test", "ensolite-aac-9", *test)
    axes = Axes(60, 40, 420, 200, (0, 30), (0, 200))
    parts = axes.frame(ticks(0, 5, 10, 15, 20, 25, 30), ticks(0, 50, 100, 150, 200), "t, ms", "stress, kPa")
    parts.append(axes.curve([(row["time_s"] * 1e3, row["stress_Pa"] / 1e3) for row in rows], "r"))
    held = 54.88226805 * 0.5**0.675 / 0.5**1.09
    parts.append(axes.curve([(5, 180.782), (5, held), (30, held)], "h"))
    parts.append(label(430, axes.at(0, held)[1] + 18, "G at rate 0", anchor="end"))
    x, y = axes.at(5, 180.782)
    parts += [label(x + 10, y + 5, "σ = G at 100 per second", anchor="start"), line(x, 240, x, 220, "g")]
    parts.append(label(x + 6, 232, "held from here on", anchor="start"))
    x, y = axes.at(5 + 8.81, 112.761)
    parts += [dot(x, y, RED), label(x + 8, y - 6, "σ, one τ later", anchor="start")]
    write("envelope", 520, 295, "The stress of law 4 relaxes to its envelope", parts)


# --- The contact integral: law 4 at 100 per second under a sphere with R = 3 L, at Y = 0.9 L ---


def contact_integral():
    m, power, rate_factor, deep, radius = 0.675, 1.09, 135.590, 22.86, 76.2  # kPa, mm

    def shape(strain):
        return strain**m / (1 - strain) ** power

    count, steps = 8, 400
    depths = [deep * i / count / steps for i in range(count * steps + 1)]
    shapes = [shape((deep - s) / 25.4) for s in depths]
    measures = [0.0]  # w, from the edge of the contact inwards
    for a, b in zip(shapes[::-1], shapes[-2::-1]):
        measures.append(measures[-1] + (a + b) / 2 * deep / count / steps / 25.4)
    measures.reverse()
    left = Axes(60, 40, 240, 190, (0, 24), (0, 850))
    right = Axes(415, 40, 260, 190, (0, 2), (0, 12))
    parts = left.frame(ticks(0, 5, 10, 15, 20), ticks(0, 200, 400, 600, 800), "s, mm", "σ a′(s), N/mm")
    parts += right.frame(ticks(0, 0.5, 1, 1.5, 2), ticks(0, 5, 10), "w", "g, N/mm")
    pressed = [(s, rate_factor * a * 2 * math.pi * (radius - s) / 1e3) for s, a in zip(depths, shapes)]
    weighted = [(w, rate_factor * (radius - s) / 1e3) for w, s in zip(measures, depths)]
    parts += [left.curve(pressed, "r"), right.curve(weighted, "r")]
    for axes, points in ((left, pressed), (right, weighted)):
        parts += [dot(*axes.at(*points[i * steps])) for i in range(count + 1)]
    write("contact-integral", 700, 290, "The integrand of the force over the depth s, and over the measure w", parts)


# --- The phases of an impact, with its events ---


def phases():
    with tempfile.TemporaryDirectory() as scratch:
        file = str(pathlib.Path(scratch, "result.json"))
        history = rows_of("run", DASHBOARD, "--no-intervals", "--json", file)
        result = json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
    turning = max(history, key=lambda row: row["penetration_m"])["time_s"] * 1e3
    top = Axes(60, 44, 400, 170, (0, 26), (0, 6500))
    low = Axes(60, 270, 400, 150, (0, 26), (0, 90))
    late = Axes(530, 44, 180, 170, (24.1, 24.4), (0, 70))
    parts = []
    for begin, end, colour in ((0, turning, "#e8eef7"), (turning, result["release"]["time_s"] * 1e3, "#f8ede7")):
        x1, x2 = top.at(begin, 0)[0], top.at(end, 0)[0]
        parts += [f'<path d="M{n(x1)} {a.top}H{n(x2)}V{a.top + a.height}H{n(x1)}z" fill="{colour}"/>' for a in (top, low)]
    parts += top.frame(ticks(0, 5, 10, 15, 20, 25), [(0, "0"), (2000, "2"), (4000, "4"), (6000, "6")], "", "F, kN")
    parts += low.frame(ticks(0, 5, 10, 15, 20, 25), ticks(0, 40, 80), "t, ms", "X, Y, X_s, mm")
    parts += late.frame(ticks(24.1, 24.2, 24.3, 24.4), ticks(0, 20, 40, 60), "t, ms", "F, N: the end")
    times = [row["time_s"] * 1e3 for row in history]
    parts.append(top.curve([(t, row["force_N"]) for t, row in zip(times, history)], "r"))
    tail = [(t, row["force_N"]) for t, row in zip(times, history) if row["force_N"] < 70 and t > 20]
    parts.append(late.curve(tail, "r"))
    for name, kind, place in (("motion_m", "l", (5, 55, "X")), ("penetration_m", "r", (18, 12, "Y")),
                              ("support_deflection_m", "b", (9.5, 36, "X_s"))):
        parts.append(low.curve([(t, row[name] * 1e3) for t, row in zip(times, history)], kind))
        parts.append(label(*low.at(*place[:2]), place[2], "s"))
    parts += [label(top.at(turning / 2 - 2.5, 0)[0], 62, "loading"), label(top.at(21.8, 0)[0], 62, "unloading")]
    x, y = top.at(result["time_to_peak_force_s"] * 1e3, result["peak_force_N"])
    parts += [dot(x, y), label(x - 8, y + 1, "peak", anchor="end")]
    row = max(history, key=lambda row: row["penetration_m"])
    x, y = top.at(turning, row["force_N"])
    parts += [dot(x, y), label(x + 8, y + 6, "turning", anchor="start"), line(x, y, x, 420, "h")]
    parts += [dot(*top.at(0, 0)), label(112, 208, "first contact", anchor="start")]
    ends = (("force_below_weight", "F = M × 1 g", 44.48), ("contact_end", "t_e", 5.757), ("release", "release", 0))
    for name, text, force in ends:
        x, y = late.at(result[name]["time_s"] * 1e3, force)
        parts += [dot(x, y), label(x + 8, y - (14 if text == "t_e" else 5), text, "s" if text == "t_e" else "", "start")]
    write("phases", 740, 475, "Force and motion over time, with the phases and events", parts)


# --- Refinement: rebound speed of four runs ---


def refinement():
    speeds, extrapolated = [], []
    for tolerance in ("1e-2", "1e-3", "1e-4"):
        with tempfile.TemporaryDirectory() as scratch:
            file = str(pathlib.Path(scratch, "result.json"))
            history = rows_of("run", DASHBOARD, "--no-intervals", "--tolerance", tolerance, "--json", file)
            result = json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
        if result["solver"]["runs"] != len(speeds) + 2:
            raise SystemExit("these tolerances no longer end after 2, 3 and 4 runs")
        speeds.append(-history[-1]["velocity_m_per_s"])
        extrapolated.append(result["rebound_speed_m_per_s"])
    speeds.insert(0, speeds[0] - 3 * (extrapolated[0] - speeds[0]))  # from Eq. 31 of the second run
    squares = [0.2**2 / 4**k for k in range(4)]
    parts = []
    for left, number, x_range, y_range, x_ticks, y_ticks in (
        (75, 1, (0, 0.042), (8.6015, 8.6068), ticks(0, 0.01, 0.02, 0.03, 0.04), ticks(8.602, 8.604, 8.606)),
        (460, 2, (0, 0.0028), (8.60178, 8.60222), ticks(0, 0.001, 0.002),
         [(v, f"{v:.4f}") for v in (8.6018, 8.602, 8.6022)]),
    ):
        axes = Axes(left, 45, 240, 230, x_range, y_range)
        parts += axes.frame(x_ticks, y_ticks, "ρ²", "rebound speed, m/s")
        for k in range(1, 4):
            if number == 2 and k == 1:
                continue
            start = (squares[k - 1], speeds[k - 1])
            if number == 2 and k == 2:
                slope = (speeds[1] - extrapolated[1]) / squares[1]
                start = (0.0028, extrapolated[1] + slope * 0.0028)
            parts.append(axes.curve([start, (0, extrapolated[k - 1])], "h"))
        for k in range(4):
            if squares[k] <= x_range[1]:
                x, y = axes.at(squares[k], speeds[k])
                parts.append(dot(x, y))
                if number == 2 or k < 3:
                    place = (x - 8, y + 4) if k == 0 else (x + 8, y + 16)
                    parts.append(label(*place, f"x_{k + 1}", "s", "end" if k == 0 else "start"))
        for k in (2, 3) if number == 2 else ():
            x, y = axes.at(0, extrapolated[k - 1])
            parts += [dot(x, y, RED), label(x + 8, y + (-11 if k == 3 else 17), f"x*_{k + 1}", "s", "start")]
        if number == 2:
            x, (low, high) = axes.left + 48, [axes.at(0, extrapolated[k])[1] for k in (1, 2)]
            parts += [arrow(x, low, x, high), label(x - 6, (low + high) / 2 + 5, "error", anchor="end")]
            parts += [line(axes.left, high, x + 6, high, "g"), line(axes.left, low, x + 6, low, "g")]
    write("refinement", 740, 335, "Rebound speed of four runs over the square of the resolution", parts)


for draw in (problem, column, laws, envelope, contact_integral, phases, refinement):
    draw()
