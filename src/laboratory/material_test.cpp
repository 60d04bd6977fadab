#include "dashpad/laboratory/material_test.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <boost/math/tools/minima.hpp>

#include "laboratory/column.hpp"
#include "model/root.hpp"
#include "quantities/text.hpp"

namespace dashpad::laboratory {
namespace {

constexpr int max_steps_of_1984 = 100'000;

StrainHistory history_of(const MaterialTest& test, double rate) {
  switch (test.kind) {
    case TestKind::constant_rate: return constant_rate_test(rate, test.strain);
    case TestKind::parabolic: return parabolic_test(rate, test.strain);
    case TestKind::relaxation: return ramp_and_hold_test(rate, test.strain, test.hold);
    case TestKind::cyclic: return cyclic_test(rate, test.strain, test.low, test.cycles);
    case TestKind::history: return measured_test(test.times, test.strains);
    case TestKind::creep: break;
  }
  throw std::invalid_argument("creep has no strain history: its stress is given");
}

/// The times of the update's strains, from 0 on.
std::vector<double> times_of_1984(const StrainHistory& history, int steps) {
  const double step = end_of_first_loading(history) / steps;
  const double count = std::floor(duration_of(history) / step * (1 + 1e-9));
  if (!(count <= max_steps_of_1984))
    throw std::invalid_argument(
        fmt::format("the update of 1984 would take {:.3g} steps of {:.3g} s, and at most {} are on offer; "
                    "shorten the test, or take fewer --steps",
                    count, step, max_steps_of_1984));
  std::vector<double> times;
  for (int i = 0; i <= static_cast<int>(count); ++i) times.push_back(i * step);
  return times;
}

/// Relaxation is fast at first: more places near the beginning of the hold.
std::vector<double> marks_in_hold(double ramp, double hold) {
  std::vector<double> times{ramp};
  for (const double share : {1e-4, 1e-3, 1e-2, 0.1}) times.push_back(ramp + share * hold);
  return times;
}

/// Enough for smooth curves, and not too many for a file.
int places_for(std::size_t pieces) {
  const auto few = static_cast<int>(std::clamp<std::size_t>(600 / pieces, 20, 200));
  return std::min(few, std::max(2, static_cast<int>(200'000 / pieces)));
}

/// Of the place of output that is nearest.
double stress_at(const ColumnTest& column, double time) {
  const auto after = std::lower_bound(column.time.begin(), column.time.end(), time);
  auto i = static_cast<std::size_t>(after - column.time.begin());
  if (i == column.size() || (i > 0 && time - column.time[i - 1] < column.time[i] - time)) --i;
  return column.stress[i];
}

UpdateOf1984 compare_with(StressUpdate update_stress, const Material& material, const StrainHistory& history,
                          std::vector<double> times, int steps, const ColumnTest& column) {
  const double step = times[1];
  UpdateOf1984 update{.step = step,
                      .time = std::move(times),
                      .strain = {},
                      .stress = {},
                      .exact = {},
                      .update_at_turn = {},
                      .exact_at_turn = {}};
  for (const double time : update.time) {
    update.strain.push_back(std::max(strain_at(history, time), 0.0));
    update.exact.push_back(stress_at(column, time));
  }
  update.stress = update_stress(material, update.strain, update.step);
  if (const auto turn = static_cast<std::size_t>(steps); turn + 1 < update.time.size()) {
    update.update_at_turn = {update.stress[turn], update.stress[turn + 1]};
    update.exact_at_turn = {update.exact[turn], update.exact[turn + 1]};
  }
  return update;
}

MaterialTestRun strain_run(const Material& material, const MaterialTest& test, double rate,
                           StressUpdate update) {
  const StrainHistory history = history_of(test, rate);
  MaterialTestRun run;
  std::vector<double> marks;
  if (test.steps_of_1984) marks = times_of_1984(history, *test.steps_of_1984);
  const std::vector<double> times = marks;
  if (test.kind == TestKind::relaxation)
    for (const double mark : marks_in_hold(test.strain / rate, test.hold)) marks.push_back(mark);
  std::sort(marks.begin(), marks.end());
  const StrainHistory split = split_at(history, marks);
  run.column = drive(material.law, split, places_for(split.pieces.size()));
  if (test.kind == TestKind::relaxation) {
    const double ramp = test.strain / rate;
    run.relaxed = {stress_at(run.column, ramp), stress_at(run.column, ramp + 0.1 * test.hold),
                   run.column.stress.back()};
  }
  if (test.steps_of_1984)
    run.update_of_1984 = compare_with(update, material, history, times, *test.steps_of_1984, run.column);
  return run;
}

/// Absent where the law does not reach the stress.
std::optional<MaterialTestRun> creep_run(const Material& material, const MaterialTest& test, double rate) {
  std::optional<ColumnTest> column = creep(material.law, {test.stress, rate, test.hold});
  if (!column) return std::nullopt;
  MaterialTestRun run;
  run.column = *std::move(column);
  const double loaded = run.column.time.back() - test.hold;
  const auto at = std::min_element(run.column.time.begin(), run.column.time.end(), [&](double a, double b) {
    return std::abs(a - loaded) < std::abs(b - loaded);
  });
  run.crept = {run.column.strain[static_cast<std::size_t>(at - run.column.time.begin())],
               run.column.strain.back()};
  return run;
}

/// A strain of 0.95 that was computed is not beyond 0.95.
double without_rounding(double value) { return rounded_to(value, 12); }

std::vector<Flag> flags_of(const Material& material, const MaterialTestRun& run) {
  std::vector<Flag> flags;
  double fastest = 0;
  for (const double rate : run.column.rate) fastest = std::max(fastest, std::abs(rate));
  for (const Extrapolation& extrapolation :
       extrapolations(material, without_rounding(run.column.largest_strain), without_rounding(fastest)))
    flags.push_back(flag_of(name_of(extrapolation.beyond), extrapolation.text));
  if (!has_curves(material.law) && std::ranges::any_of(run.column.events, [](const ColumnEvent& event) {
        return event.kind == ColumnEvent::Kind::contact_taken_up;
      }))
    flags.push_back(flag_of(
        "ASSUMPTION",
        std::holds_alternative<RigidFoam>(material.law)
            ? "reloaded after contact was lost; the foam does not recover, and carries nothing below its "
              "largest strain"
            : "reloaded after contact was lost; the law is silent there, and the column is taken to have "
              "followed the platen without force, and to start again from stress zero"));
  if (run.unloads && -run.figures.hysteresis > std::max(1e-9, run.figures.energy_error))
    flags.push_back(flag_of(
        "ENERGY GAIN",
        fmt::format("the law gives back {:.3g} % more energy than was put in", -100 * run.figures.hysteresis),
        {{"energy_gained_fraction", -run.figures.hysteresis}}));
  if (const auto& update = run.update_of_1984;
      update && std::ranges::any_of(update->stress, [&](double stress) {
        return stress > highest_drawn * run.figures.peak_stress ||
               stress < lowest_drawn * run.figures.peak_stress;
      }))
    flags.push_back(flag_of(
        "OUT OF BOUNDS",
        fmt::format("with steps of {:.3g} s the update of 1984 leaves the range from {:g} to {:g} times "
                    "the exact peak stress; those points are not drawn",
                    update->step, lowest_drawn, highest_drawn),
        {{"step_s", update->step}}));
  return flags;
}

void add_figures(MaterialTestRun& run, const Material& material, const MaterialTest& test) {
  run.cushion = cushion_curve(run.column);
  run.figures = cushion_figures(run.column);
  run.unloads = std::ranges::any_of(run.column.rate, [](double rate) { return rate < 0; });
  for (const double limit : test.stress_limits) run.at_limits.push_back(at_stress_limit(run.cushion, limit));
  run.flags = flags_of(material, run);
}

std::vector<double> rates_of(const FoamCurves& curves) {
  std::vector<double> rates{curves.slowest_rate};
  std::visit(
      [&rates]<class Effect>(const Effect& effect) {
        if constexpr (std::is_same_v<Effect, PowerRateEffect>)
          rates.push_back(effect.highest_rate);
        else if constexpr (std::is_same_v<Effect, FactorRateEffect>)
          rates.insert(rates.end(), effect.rate.begin(), effect.rate.end());
        else if constexpr (std::is_same_v<Effect, CurvesRateEffect>)
          for (const CurvesRateEffect::AtRate& at : effect.curves) rates.push_back(at.rate);
      },
      curves.rate_effect);
  return rates;
}

CushionPoint point_of(double strain, double stress, double energy) {
  return {strain, stress, energy, stress > 0 ? energy / stress : 0,
          stress > 0 && strain > 0 ? energy / (stress * strain) : 0};
}

CushionPoint point(const CushionCurve& curve, std::size_t i) {
  return {curve.strain[i], curve.stress[i], curve.energy[i], curve.efficiency[i], curve.ideality[i]};
}

/// The point before the first place: stress = S1 (strain / e1)^q, with q from the first two places.
CushionPoint before_first(const CushionCurve& curve, double limit) {
  const double e = curve.strain[0], S = curve.stress[0];
  const double q =
      curve.strain.size() > 1 ? std::log(curve.stress[1] / S) / std::log(curve.strain[1] / e) : 1;
  const double share = q > 0 ? std::pow(limit / S, 1 / q) : 0;
  return point_of(e * share, limit, curve.energy[0] * share * limit / S);
}

/// ln(stress) at ln(strain) = x, by Neville's scheme over four places around the interval before place i.
double log_stress(const CushionCurve& curve, std::size_t i, double x) {
  const std::size_t n = curve.strain.size();
  const std::size_t count = std::min<std::size_t>(4, n);
  const std::size_t first = std::min(i < 2 ? 0 : i - 2, n - count);
  std::array<double, 4> place{}, value{};
  for (std::size_t k = 0; k < count; ++k) {
    place[k] = std::log(curve.strain[first + k]);
    value[k] = std::log(curve.stress[first + k]);
  }
  for (std::size_t level = 1; level < count; ++level)
    for (std::size_t k = 0; k + level < count; ++k)
      value[k] =
          ((x - place[k + level]) * value[k] - (x - place[k]) * value[k + 1]) / (place[k] - place[k + level]);
  return value[0];
}

/// Hermite's cubic from place i - 1 to place i.
double energy_between(const CushionCurve& curve, std::size_t i, double strain) {
  const double width = curve.strain[i] - curve.strain[i - 1];
  const double t = (strain - curve.strain[i - 1]) / width;
  const double rise = curve.energy[i] - curve.energy[i - 1];
  return curve.energy[i - 1] + t * t * (3 - 2 * t) * rise +
         t * (1 - t) * width * ((1 - t) * curve.stress[i - 1] - t * curve.stress[i]);
}

CushionPoint between(const CushionCurve& curve, std::size_t i, double limit) {
  const double low = std::log(curve.strain[i - 1]);
  const double high = std::log(curve.strain[i]);
  const auto missing = [&](double x) { return log_stress(curve, i, x) - std::log(limit); };
  const RootBracket ends{.low = low, .high = high, .f_low = missing(low), .f_high = missing(high)};
  const bool is_between = ends.f_low < 0 && ends.f_high > 0;
  const double strain = std::exp(is_between ? narrowed(ends, missing).low : high);
  return point_of(strain, limit, energy_between(curve, i, strain));
}

/// Whether the efficiency has no kink at place i: its bend there is that of the places around.
bool is_smooth(const CushionCurve& curve, std::size_t i) {
  if (i < 3 || i + 3 >= curve.efficiency.size()) return false;
  const auto bend = [&](std::size_t k) {
    return std::abs(curve.efficiency[k - 1] - 2 * curve.efficiency[k] + curve.efficiency[k + 1]);
  };
  return bend(i) < 3 * std::max(bend(i - 2), bend(i + 2));
}

/// The highest efficiency, between places where the curve is smooth.
CushionPoint best_of(const CushionCurve& curve) {
  const auto best = std::ranges::max_element(curve.efficiency);
  if (best == curve.efficiency.end()) return {};
  const auto i = static_cast<std::size_t>(best - curve.efficiency.begin());
  if (!is_smooth(curve, i)) return point(curve, i);
  const auto at = [&](double strain) {
    const std::size_t next = strain > curve.strain[i] ? i + 1 : i;
    return point_of(strain, std::exp(log_stress(curve, next, std::log(strain))),
                    energy_between(curve, next, strain));
  };
  const double strain =
      boost::math::tools::brent_find_minima([&](double e) { return -at(e).efficiency; }, curve.strain[i - 1],
                                            curve.strain[i + 1], std::numeric_limits<double>::digits / 2)
          .first;
  const CushionPoint found = at(strain);
  return found.efficiency > *best ? found : point(curve, i);
}

/// The largest stress: where it is no end of a stretch, the vertex of the parabola through three places in
/// time.
void find_peak(const ColumnTest& test, CushionFigures& figures) {
  const auto peak = std::ranges::max_element(test.stress);
  if (peak == test.stress.end() || !(*peak > 0)) return;
  const auto i = static_cast<std::size_t>(peak - test.stress.begin());
  figures.peak_stress = *peak;
  figures.strain_at_peak = test.strain[i];
  const auto at_an_event = [&](const ColumnEvent& event) { return event.time == test.time[i]; };
  if (i == 0 || i + 1 == test.size() || std::ranges::any_of(test.events, at_an_event)) return;
  const double before = test.time[i - 1] - test.time[i], after = test.time[i + 1] - test.time[i];
  const double fall_before = (test.stress[i - 1] - *peak) / before;
  const double fall_after = (test.stress[i + 1] - *peak) / after;
  const double bend = (fall_after - fall_before) / (after - before);
  if (!(before < 0 && after > 0 && bend < 0)) return;
  const double slope = fall_before - bend * before;
  const double shift = -slope / (2 * bend);
  if (!(shift > before && shift < after)) return;
  figures.peak_stress += slope * shift / 2;
  const double rise_before = (test.strain[i - 1] - test.strain[i]) / before;
  const double rise_after = (test.strain[i + 1] - test.strain[i]) / after;
  const double curl = (rise_after - rise_before) / (after - before);
  figures.strain_at_peak += shift * (rise_before + curl * (shift - before));
}

}  // namespace

const char* to_string(TestKind kind) {
  constexpr const char* names[]{"constant-rate", "parabolic", "relaxation", "creep", "cyclic", "history"};
  return names[static_cast<std::size_t>(kind)];
}

MaterialTestReport run_material_test(const Material& material, const MaterialTest& test,
                                     StressUpdate update_of_1984) {
  if (test.steps_of_1984 && update_of_1984 == nullptr)
    throw std::invalid_argument("steps of 1984 need the update of 1984");
  MaterialTestReport report{material, test, {}};
  std::string unreached;
  const bool is_measured = test.kind == TestKind::history;
  for (const double rate : is_measured ? std::vector<double>{0} : test.rates) {
    std::optional<MaterialTestRun> run =
        test.kind == TestKind::creep ? creep_run(material, test, rate)
                                     : std::optional{strain_run(material, test, rate, update_of_1984)};
    if (!run) {
      unreached += fmt::format("{}{:g}", unreached.empty() ? "" : ", ", rate);
      continue;
    }
    if (!is_measured) run->rate = rate;
    add_figures(*run, material, test);
    report.runs.push_back(*std::move(run));
  }
  if (!unreached.empty())
    throw std::invalid_argument(
        fmt::format("the law does not reach a stress of {:g} Pa below a strain of 0.999 at {} per second",
                    test.stress, unreached));
  return report;
}

std::vector<double> tested_rates(const Material& material) {
  return std::visit(
      [&material]<class Law>(const Law& law) -> std::vector<double> {
        if constexpr (SharesSlip<Law>)
          return rates_of(law.curves);
        else if (material.fitted && material.fitted->lowest_rate > 0)
          return {material.fitted->lowest_rate, material.fitted->highest_rate};
        else
          return {material.fitted ? material.fitted->highest_rate : 1.0};
      },
      material.law);
}

LoadingCurve loading_curve(const Material& material, double rate, double strain, int steps) {
  const StrainHistory loading{{{.duration = strain / rate, .strain = 0, .rate = rate}}};
  ColumnTest column = drive(material.law, loading, steps);
  return {std::move(column.strain), std::move(column.stress)};
}

CushionCurve cushion_curve(const ColumnTest& test) {
  CushionCurve curve;
  double strain = 0;
  double stress = 0;
  for (std::size_t i = 0; i < test.size(); ++i) {
    if (test.strain[i] < strain) break;
    stress = std::max(stress, test.stress[i]);
    if (test.strain[i] == strain) continue;
    strain = test.strain[i];
    const CushionPoint p = point_of(strain, stress, test.work[i]);
    curve.strain.push_back(p.strain);
    curve.stress.push_back(p.stress);
    curve.energy.push_back(p.energy);
    curve.efficiency.push_back(p.efficiency);
    curve.ideality.push_back(p.ideality);
  }
  return curve;
}

CushionFigures cushion_figures(const ColumnTest& test) {
  CushionFigures figures;
  find_peak(test, figures);
  for (std::size_t i = 1; i < test.size(); ++i) {
    const double done = test.work[i] - test.work[i - 1];
    if (test.strain[i] > test.strain[i - 1])
      figures.energy_in += done;
    else
      figures.energy_returned -= done;
  }
  if (figures.energy_in > 0) {
    figures.hysteresis = 1 - figures.energy_returned / figures.energy_in;
    figures.energy_error = test.work_error / figures.energy_in + 1e-15;
  }
  figures.best_efficiency = best_of(cushion_curve(test));
  return figures;
}

std::optional<CushionPoint> at_stress_limit(const CushionCurve& curve, double limit) {
  if (!(limit > 0 && std::isfinite(limit)))
    throw std::invalid_argument(fmt::format("stress limit is {}: must be more than 0 (Pa)", limit));
  const auto first = std::lower_bound(curve.stress.begin(), curve.stress.end(), limit);
  if (first == curve.stress.end()) return std::nullopt;
  const auto i = static_cast<std::size_t>(first - curve.stress.begin());
  if (*first == limit) return point(curve, i);
  return i == 0 ? before_first(curve, limit) : between(curve, i, limit);
}

}  // namespace dashpad::laboratory
