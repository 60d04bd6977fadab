#!/usr/bin/python3
"""The impact of a rigid sphere on a foam pad as an engineer would write it with NumPy and SciPy.

Method of lines: columns at fixed depths s below the sphere's lowest point, finer towards the axis, each with its own
stress. The law gives each stress's rate, and the rate of the penetration follows from the balance of pad and support:

    dX/dt = V,  M dV/dt = -F,  dF/dt = K (V - dY/dt) = 2 pi sum of w (R - s) d(stress)/dt

One scalar equation a call of the right-hand side, by scipy.optimize.brentq; all columns at once by NumPy; phases
(loading, unloading) end at events of solve_ivp. Laws 2, 4 and 5 (docs/theory.md, Eqs. 11 and 14 to 17), linear support.
SI; forces, stresses and strains are positive in compression.

Prints a CSV row for each solution: columns,rtol,speed_share,peak_force,peak_penetration,rebound_speed,cpu_s. A figure
is nan where solve_ivp gave up."""

import argparse
import json
import math
import sys
import time

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

SMALLEST_STRAIN = 1e-8  # below it the slope of e^m, infinite at zero, is held


def unloading(e, largest, rate, law):
    """The factor E of laws 4 and 5 and its slope over the strain."""
    d = min((law["residual_strain_time"] * abs(rate)) ** law["residual_strain_exponent"], 1 - 1e-6)
    return (1 - d * largest / e) / (1 - d), d * largest / (e * e * (1 - d))


class LinearViscoelastic:
    def __init__(self, p):
        self.p = p

    def at(self, t, e):
        self.e, self.h = e, 1 / self.p["relaxation_time"]

    def envelope(self, rate, largest):
        """G and dG/de."""
        p = self.p
        viscous = (p["initial_modulus"] - p["asymptotic_modulus"]) * p["relaxation_time"]
        return p["asymptotic_modulus"] * self.e + viscous * rate, p["asymptotic_modulus"]


class NineParameter:
    def __init__(self, p):
        self.p = p

    def at(self, t, e):
        self.shape_at(e)
        self.h = 1 / self.p["relaxation_time"]

    def shape_at(self, e):
        """A and dA/de."""
        m, n = self.p["contact_exponent"], self.p["compaction_exponent"]
        self.e = e
        self.shape = e**m * (1 - e) ** -n
        self.slope = self.shape * (m / e + n / (1 - e))

    def envelope(self, rate, largest):
        p = self.p
        b = p["asymptotic_modulus"] + p["rate_modulus"] * abs(rate) ** p["rate_exponent"]
        g, slope = b * self.shape, b * self.slope
        if rate >= 0:
            return g, slope
        factor, factor_slope = unloading(self.e, largest, rate, p)
        return g * factor, slope * factor + g * factor_slope


class TwentyOneParameter(NineParameter):
    def at(self, t, e):
        self.shape_at(e)
        p = self.p
        log_e = np.log(e)
        u = np.exp(p["rate_strain_exponent"] * log_e) / p["rate_strain_scale"]
        w = np.exp(p["growth_strain_exponent"] * log_e) / p["growth_strain_scale"]
        y = np.exp(p["onset_strain_exponent"] * log_e) / p["onset_strain_scale"]
        self.sensitive = p["rate_stress"] * (np.exp(w) - np.exp(-y))
        self.sensitive_slope = p["rate_stress"] / e * (
            p["growth_strain_exponent"] * w * np.exp(w) + p["onset_strain_exponent"] * y * np.exp(-y))
        self.power = p["rate_exponent"] * np.exp(-u)
        self.power_slope = -self.power * p["rate_strain_exponent"] * u / e
        a = p["relaxation_exponent"]
        self.h = a * max(t, 1e-12) ** (a - 1) / (p["relaxation_scale"] * p["relaxation_strain_base"] ** e)

    def envelope(self, rate, largest):
        p = self.p
        g, slope = p["asymptotic_modulus"] * self.shape, p["asymptotic_modulus"] * self.slope
        if rate == 0:
            return g, slope
        log_rate = math.log(abs(rate))
        factor = np.exp(self.power * log_rate)
        g = g + self.sensitive * factor
        slope = slope + factor * (self.sensitive_slope + self.sensitive * self.power_slope * log_rate)
        if rate > 0:
            return g, slope
        back, back_slope = unloading(self.e, largest, rate, p)
        return g * back, slope * back + g * back_slope


LAWS = {"linear-viscoelastic": LinearViscoelastic, "nine-parameter": NineParameter,
        "twenty-one-parameter": TwentyOneParameter}
MOTION, VELOCITY, PENETRATION, COLUMNS = 0, 1, 2, 3


class Impact:
    def __init__(self, case, columns, speed):
        self.law = LAWS[case["law"]](case["parameters"])
        self.mass, self.thickness, self.stiffness = case["mass"], case["thickness"], case["stiffness"]
        self.speed = speed
        z = (np.arange(columns) + 0.5) / columns
        self.s = self.thickness * z**3  # the stress varies most near the axis, where the pad is nearly closed
        self.weight = 2 * np.pi * (case["radius"] - self.s) * 3 * self.thickness * z**2 / columns
        self.largest = None  # strains at the turning point

    def prepare(self, t, state):
        """Which columns carry, and what the law knows of them without the rate."""
        strain = (state[PENETRATION] - self.s) / self.thickness
        stress = state[COLUMNS:]
        self.active = strain > 0 if self.largest is None else (strain > 0) & (stress > 0)
        self.stress = stress[self.active]
        self.active_weight = self.weight[self.active]
        self.active_largest = None if self.largest is None else self.largest[self.active]
        self.law.at(t, np.clip(strain[self.active], SMALLEST_STRAIN, 1 - 1e-6))

    def stress_rate(self, rate):
        g, slope = self.law.envelope(rate, self.active_largest)
        return slope * rate + self.law.h * (g - self.stress)

    def imbalance(self, speed, velocity):
        """Rate of the support's force minus that of the pad's, at a speed of penetration."""
        pad = self.active_weight @ self.stress_rate(speed / self.thickness)
        return self.stiffness * (velocity - speed) - pad

    def speed_of_penetration(self, velocity):
        if len(self.stress) == 0:
            return velocity
        # A little away from rest, where the powers of the rate have infinite slopes.
        way = 1 if self.largest is None else -1
        low, high = way * 1e-12 * self.speed, way * 10 * self.speed
        if way * self.imbalance(low, velocity) <= 0:
            return 0.0
        return brentq(self.imbalance, low, high, args=(velocity,), xtol=1e-3 * self.rtol * self.speed)

    def derivative(self, t, state):
        self.prepare(t, state)
        velocity = state[VELOCITY]
        speed = self.speed_of_penetration(velocity)
        slope = np.zeros_like(state)
        slope[MOTION] = velocity
        slope[VELOCITY] = -self.stiffness * (state[MOTION] - state[PENETRATION]) / self.mass
        slope[PENETRATION] = speed
        if speed != 0:
            slope[COLUMNS:][self.active] = self.stress_rate(speed / self.thickness)
        return slope

    # Events: loading ends where holding the pad would let the support's force fall behind the pad's.
    def turning(self, t, state):
        self.prepare(t, state)
        return self.imbalance(0.0, state[VELOCITY]) / (self.stiffness * self.speed)

    def peak(self, t, state):
        self.prepare(t, state)
        return (state[VELOCITY] - self.speed_of_penetration(state[VELOCITY])) / self.speed

    def release(self, t, state):
        self.prepare(t, state)
        return self.active_weight @ self.stress / self.force_at_turning - 1e-6

    turning.terminal, turning.direction = True, -1
    release.terminal, release.direction = True, -1

    def force(self, state):
        return self.stiffness * (state[MOTION] - state[PENETRATION])

    def solve(self, rtol, method):
        """Peak force, peak penetration, rebound speed. Raises ArithmeticError or ValueError where it gives up."""
        self.rtol = rtol
        size = COLUMNS + len(self.s)
        state = np.zeros(size)
        state[VELOCITY] = self.speed
        stress_scale = self.stiffness * self.thickness / (math.pi * self.thickness**2)
        atol = rtol * 1e-3 * np.concatenate([[self.thickness, self.speed, self.thickness],
                                             np.full(size - COLUMNS, stress_scale)])

        def run(begin, state, events):
            return solve_ivp(self.derivative, (begin, begin + 1.0), state, method=method, rtol=rtol, atol=atol,
                             events=events, max_step=1e-3)

        loading = run(0, state, [self.turning, self.peak])
        if loading.status != 1:
            raise ArithmeticError("no turning point: " + loading.message)
        turned = loading.y_events[0][0]
        self.largest = (turned[PENETRATION] - self.s) / self.thickness
        self.force_at_turning = self.force(turned)
        back = run(loading.t[-1], turned, [self.release, self.peak])
        if back.status != 1:
            raise ArithmeticError("no release: " + back.message)
        peaks = [self.force(y) for events in (loading, back) for y in events.y_events[1]]
        return (max(peaks + [self.force_at_turning]), turned[PENETRATION], -back.y_events[0][0][VELOCITY])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--case", required=True, help="JSON file: law, parameters, mass, radius, ... in SI")
    parser.add_argument("--columns", type=int, required=True)
    parser.add_argument("--rtol", type=float, required=True)
    parser.add_argument("--repeat", type=int, default=1, help="solutions at full speed")
    parser.add_argument("--shares", type=float, nargs="*", default=[], help="other speeds, as shares of the full")
    parser.add_argument("--method", default="RK45", help="of solve_ivp")
    arguments = parser.parse_args()
    with open(arguments.case) as file:
        case = json.load(file)
    for share in arguments.shares + [1.0] * arguments.repeat:
        impact = Impact(case, arguments.columns, share * case["speed"])
        begin = time.process_time()
        try:
            figures = impact.solve(arguments.rtol, arguments.method)
        except (ArithmeticError, ValueError) as error:
            print(f"scipy_impact: {error}", file=sys.stderr)
            figures = (math.nan,) * 3
        spent = time.process_time() - begin
        print(",".join(repr(float(x)) for x in (arguments.columns, arguments.rtol, share, *figures, spent)))


main()
