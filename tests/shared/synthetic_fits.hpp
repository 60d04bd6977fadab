#pragma once
/// Measurements made up from a known truth with seeded noise, to see whether fits find it again.

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/fit/fit.hpp"
#include "dashpad/fit/report.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/laboratory/column_test.hpp"
#include "study/sampling.hpp"

namespace dashpad::test {

/// Independent normal numbers, by Box and Muller.
class NormalNumbers {
 public:
  explicit NormalNumbers(std::uint64_t seed) : seed_(seed) {}
  double next() {
    const double u = study::random_fraction(seed_, place_, 0, study::Purpose::draw);
    const double v = study::random_fraction(seed_, place_++, 1, study::Purpose::draw);
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * 3.141592653589793 * v);
  }

 private:
  std::uint64_t seed_;
  std::uint64_t place_ = 0;
};

struct SyntheticFit {
  std::string name;
  fit::Fit fit;
  std::vector<double> truth;                   ///< of the unknowns
  std::optional<double> true_peak_force = {};  ///< N, of the impact that is held out
};

inline ImpactCase case_with(const PadLaw& law) {
  ImpactCase impact;
  impact.impactor = {5, Sphere{.radius = 0.1}, 3};
  impact.pad.thickness = 0.05;
  impact.pad.material.name = "made up";
  impact.pad.material.title = "Made up";
  impact.pad.material.law = law;
  return impact;
}

/// Up to a strain and down again at one rate, some points each way, so many times.
inline fit::MaterialMeasurement loops(const PadLaw& law, double rate, double largest, int points, int cycles,
                                      double noise, NormalNumbers& normal) {
  fit::MaterialMeasurement test;
  test.file = "made-up.csv";
  test.noise = noise;
  const auto add = [&](double strain) {
    const double before = test.strain.empty() ? 0 : test.strain.back();
    const double time = test.time.empty() ? 0 : test.time.back();
    test.time.push_back(time + std::abs(strain - before) / rate);
    test.strain.push_back(strain);
  };
  for (int cycle = 0; cycle < cycles; ++cycle) {
    for (int i = cycle == 0 ? 1 : 2; i <= points; ++i) add(largest * i / points);
    for (int i = points - 1; i >= 1; --i) add(largest * i / points);
  }
  std::vector<double> times{0}, strains{0};
  times.insert(times.end(), test.time.begin(), test.time.end());
  strains.insert(strains.end(), test.strain.begin(), test.strain.end());
  test.stress = laboratory::stress_at_ends(law, laboratory::measured_test(times, strains));
  for (double& stress : test.stress) stress += noise * normal.next();
  return test;
}

inline fit::MaterialMeasurement loading_part(fit::MaterialMeasurement test, int points) {
  for (auto* values : {&test.time, &test.strain, &test.stress})
    values->resize(static_cast<std::size_t>(points));
  return test;
}

/// Adds an unknown whose truth and start are those of the base.
inline void add_unknown(SyntheticFit& made, const std::string& key, double lowest, double highest) {
  for (const CaseQuantity& quantity : quantities_of(made.fit.base))
    if (quantity.key == key) {
      const double truth = quantity.get(made.fit.base);
      made.fit.unknowns.push_back(
          {key, quantity.unit, lowest, highest, truth, lowest > 0 && highest > 10 * lowest, {}});
      made.truth.push_back(truth);
    }
}

/// Avalle's curve with friction and an unloading by the work: two loops at one rate.
inline SyntheticFit avalle_loops(std::uint64_t seed) {
  Foam foam;
  foam.friction = 0.08;
  foam.unloading_factor = 0.3;
  foam.unloading_shape = 1.2;
  foam.curves.base = AvalleCurve{100e3, 2e6, 0.5, 40e3, 2, 0.65};
  foam.curves.slowest_rate = 0.01;
  SyntheticFit made{"Avalle, friction and unloading, from two loops", {}, {}};
  made.fit.base = case_with(foam);
  add_unknown(made, "pad.curve.plateau_stress", 10e3, 1e6);
  add_unknown(made, "pad.curve.modulus", 100e3, 20e6);
  add_unknown(made, "pad.curve.densification_stress", 4e3, 400e3);
  add_unknown(made, "pad.curve.densification_exponent", 1, 5);
  add_unknown(made, "pad.parameters.friction", 0, 0.4);
  add_unknown(made, "pad.parameters.unloading_factor", 0, 1);
  add_unknown(made, "pad.parameters.unloading_shape", 0.1, 10);
  NormalNumbers normal(seed);
  made.fit.tests.push_back(loops(foam, 0.01, 0.6, 25, 2, 2e3, normal));
  made.fit.starts = 2;
  made.fit.seed = seed;
  return made;
}

/// Hyperfoam with a power of the rate: loading at three rates.
inline SyntheticFit hyperfoam_rates(std::uint64_t seed) {
  Foam foam;
  foam.curves.base = HyperfoamCurve{80e3, 10, 8e3, -2, 0.65};
  foam.curves.slowest_rate = 0.01;
  foam.curves.rate_effect = PowerRateEffect{0.12, -0.1, 1000};
  SyntheticFit made{"hyperfoam with a power of the rate, loading at three rates", {}, {}};
  made.fit.base = case_with(foam);
  add_unknown(made, "pad.curve.first_modulus", 8e3, 800e3);
  add_unknown(made, "pad.curve.first_exponent", 1, 40);
  add_unknown(made, "pad.curve.second_modulus", 1e3, 100e3);
  add_unknown(made, "pad.rate.exponent", 0, 0.5);
  add_unknown(made, "pad.rate.exponent_slope", -1, 1);
  NormalNumbers normal(seed);
  for (const double rate : {0.01, 1.0, 100.0})
    made.fit.tests.push_back(loading_part(loops(foam, rate, 0.6, 40, 1, 2e3, normal), 40));
  made.fit.starts = 2;
  made.fit.seed = seed;
  return made;
}

/// The nine-parameter law from the figures of impacts at six speeds.
inline SyntheticFit nine_parameter_impacts(std::uint64_t seed) {
  NineParameter law;
  law.asymptotic_modulus = 200e3;
  law.contact_exponent = 0.5;
  law.compaction_exponent = 1;
  law.relaxation_time = 0.02;
  law.rate_modulus = 40e3;
  law.rate_exponent = 0.4;
  law.residual_strain_time = 0.01;
  law.residual_strain_exponent = 0.3;
  SyntheticFit made{"nine-parameter law from impacts at six speeds", {}, {}};
  made.fit.base = case_with(law);
  made.fit.has_case = true;
  add_unknown(made, "pad.parameters.asymptotic_modulus", 20e3, 2e6);
  add_unknown(made, "pad.parameters.compaction_exponent", 0, 4);
  add_unknown(made, "pad.parameters.rate_modulus", 2e3, 400e3);
  add_unknown(made, "pad.parameters.contact_exponent", 0.1, 1);
  NormalNumbers normal(seed);
  for (const double speed : {0.3, 0.7, 1.2, 2.0, 3.0, 4.0}) {
    fit::ImpactMeasurement impact;
    impact.file = "made-up.toml";
    impact.impact = made.fit.base;
    impact.impact.impactor.speed = speed;
    const Summary summary = solve(impact.impact, impact.options).summary;
    const auto add = [&](fit::ImpactFigure figure, double value) {
      const double deviation = 0.02 * value;
      impact.figures.push_back({figure, value + deviation * normal.next(), deviation});
    };
    add(fit::ImpactFigure::peak_force, *summary.peak_force);
    add(fit::ImpactFigure::peak_penetration, summary.peak_penetration);
    add(fit::ImpactFigure::rebound_speed, *summary.rebound_speed);
    add(fit::ImpactFigure::contact_time, summary.contact_end->time);
    made.fit.impacts.push_back(impact);
  }
  made.fit.starts = 2;
  made.fit.seed = seed;
  return made;
}

/// An elastic pad and what neighbours do in it, from the depths of noses of three radii at two speeds: what
/// goes with 1/R tells the two apart.
inline SyntheticFit neighbours_of_noses(std::uint64_t seed) {
  SyntheticFit made{"neighbours and modulus from noses of three radii", {}, {}};
  made.fit.base = case_with(Elastic{.modulus = 300e3});
  made.fit.base.pad.neighbours = 0.7;
  made.fit.has_case = true;
  add_unknown(made, "pad.parameters.modulus", 30e3, 3e6);
  add_unknown(made, "pad.neighbours", 0, 2);
  NormalNumbers normal(seed);
  for (const double radius : {0.05, 0.1, 0.3})
    for (const double speed : {0.5, 1.0}) {
      fit::ImpactMeasurement impact;
      impact.file = "made-up.toml";
      impact.impact = made.fit.base;
      impact.impact.impactor.nose = Sphere{radius};
      impact.impact.impactor.mass = 2;
      impact.impact.impactor.speed = speed;
      const double depth = solve(impact.impact, impact.options).summary.peak_penetration;
      const double deviation = 0.01 * depth;
      impact.figures.push_back(
          {fit::ImpactFigure::peak_penetration, depth + deviation * normal.next(), deviation});
      made.fit.impacts.push_back(impact);
    }
  made.fit.starts = 2;
  made.fit.seed = seed;
  return made;
}

/// An impact that is held out, of which the peak force is predicted; `speed` in m/s.
inline void hold_out_an_impact(SyntheticFit& made, double speed) {
  fit::ImpactMeasurement impact;
  impact.file = "held-out.toml";
  impact.impact = made.fit.base;
  impact.impact.impactor.speed = speed;
  impact.is_held_out = true;
  made.true_peak_force = *solve(impact.impact, {.tolerance = 1e-6}).summary.peak_force;
  impact.figures.push_back(
      {fit::ImpactFigure::peak_force, *made.true_peak_force, 0.02 * *made.true_peak_force});
  made.fit.impacts.push_back(impact);
}

/// Avalle's loops with errors of which neighbours are correlated by rho, and a force zero that is off.
inline SyntheticFit drifting_avalle_loops(std::uint64_t seed) {
  constexpr double rho = 0.5, noise = 2e3, offset = 3e3;
  SyntheticFit made = avalle_loops(seed);
  made.name = "the same with correlated errors and a shifted zero of the force";
  NormalNumbers none(seed);
  fit::MaterialMeasurement& test = made.fit.tests.front();
  test = loops(made.fit.base.pad.material.law, 0.01, 0.6, 25, 2, 0, none);
  test.noise = noise;
  test.has_offset = true;
  NormalNumbers normal(seed + 1'000'000);
  double error = normal.next();
  for (double& stress : test.stress) {
    stress += offset + noise * error;
    error = rho * error + std::sqrt(1 - rho * rho) * normal.next();
  }
  made.truth.push_back(offset);
  return made;
}

/// The nine-parameter law from the whole pulses of impacts at two speeds: noise of 0.5 % of the peak at each
/// of 120 samples, clocks that nobody set.
inline SyntheticFit nine_parameter_pulses(std::uint64_t seed) {
  SyntheticFit made = nine_parameter_impacts(seed);
  made.name = "nine-parameter law from two whole pulses";
  made.fit.impacts.clear();
  NormalNumbers normal(seed);
  for (const double speed : {1.0, 3.0}) {
    fit::ImpactMeasurement impact;
    impact.file = "made-up.toml";
    impact.impact = made.fit.base;
    impact.impact.impactor.speed = speed;
    const Solution solution = solve(impact.impact, {.tolerance = 1e-6});
    const double peak = *solution.summary.peak_acceleration;
    const double end = solution.summary.contact_end->time;
    const History& history = solution.history;
    Pulse pulse;
    std::size_t after = 0;
    for (int i = -20; i <= 140; ++i) {
      const double time = end * i / 120;
      while (after < history.size() && history.time[after] < time) ++after;
      double exact = 0;
      if (i >= 0 && after < history.size())
        exact = after == 0 ? history.acceleration[0]
                           : std::lerp(history.acceleration[after - 1], history.acceleration[after],
                                       (time - history.time[after - 1]) /
                                           (history.time[after] - history.time[after - 1]));
      pulse.time.push_back(5 + time);
      pulse.acceleration.push_back(exact + 0.005 * peak * normal.next());
    }
    impact.pulse = fit::deceleration_of({pulse});
    impact.pulse->file = "made-up.csv";
    impact.pulse->deviation = 0.005 * peak;
    made.fit.impacts.push_back(impact);
  }
  return made;
}

/// How often intervals that end within the bounds hold the truth.
struct Coverage {
  int intervals = 0;
  int hold = 0;
  int open = 0;
  int failed = 0;                           ///< fits
  int flat = 0;                             ///< fits with a flat direction
  std::map<std::string, int> hold_of = {};  ///< each unknown, and the prediction, apart
  [[nodiscard]] double share() const { return intervals > 0 ? double(hold) / intervals : 0; }
  void add(const std::string& key, bool holds) {
    ++intervals;
    hold += holds ? 1 : 0;
    hold_of[key] += holds ? 1 : 0;
  }
};

inline void count(const SyntheticFit& made, Coverage& into) {
  const fit::FitReport report = fit::run_fit(made.fit);
  if (!report.converged) {
    ++into.failed;
    return;
  }
  into.flat += report.flat_directions.empty() ? 0 : 1;
  for (std::size_t i = 0; i < made.truth.size(); ++i) {
    const fit::FittedUnknown& found = report.unknowns[i];
    if (!found.is_identified()) {
      ++into.open;
      continue;
    }
    into.add(found.key, *found.low <= made.truth[i] && made.truth[i] <= *found.high);
  }
  if (!made.true_peak_force) return;
  for (const fit::MetFigure& met_figure : report.figures)
    if (met_figure.is_held_out && met_figure.computed && met_figure.prediction_deviation)
      into.add("predicted peak force", std::abs(*met_figure.computed - *made.true_peak_force) <=
                                           1.96 * *met_figure.prediction_deviation);
}

}  // namespace dashpad::test
