#include "dashpad/laboratory/material_test.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "laboratory/arc.hpp"
#include "model/pad/foam/foam_rules.hpp"
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
  throw std::invalid_argument("a creep test has no strain history: its stress is prescribed");
}

/// The times of the update's strains, s, from 0 on.
std::vector<double> times_of_1984(const StrainHistory& history, int steps) {
  const double step = end_of_first_loading(history) / steps;
  const double count = std::floor(duration_of(history) / step * (1 + 1e-9));
  if (!(count <= max_steps_of_1984))
    throw std::invalid_argument(
        fmt::format("the 1984 update would need {:.3g} steps of {:.3g} s, but at most {} are allowed; "
                    "shorten the test, or use fewer --steps",
                    count, step, max_steps_of_1984));
  std::vector<double> times;
  for (int i = 0; i <= static_cast<int>(count); ++i) times.push_back(i * step);
  return times;
}

/// Extra places of output in a hold, most of them near its beginning, where relaxation is fast.
std::vector<double> marks_in_hold(double ramp, double hold) {
  std::vector<double> times{ramp};
  for (const double share : {1e-4, 1e-3, 1e-2, 0.1}) times.push_back(ramp + share * hold);
  return times;
}

/// Number of places of output in a piece: enough for smooth curves, and not too many for a file.
int places_for(std::size_t pieces) {
  const auto few = static_cast<int>(std::clamp<std::size_t>(600 / pieces, 20, 200));
  return std::min(few, std::max(2, static_cast<int>(200'000 / pieces)));
}

/// Stress at the nearest place of output, Pa.
double stress_at(const ColumnTest& column, double time) {
  const auto after = std::lower_bound(column.time.begin(), column.time.end(), time);
  auto i = static_cast<std::size_t>(after - column.time.begin());
  if (i == column.size() || (i > 0 && time - column.time[i - 1] < column.time[i] - time)) --i;
  return column.stress[i];
}

UpdateOf1984 compare_with(StressUpdate update_stress, const Material& material, const StrainHistory& history,
                          std::vector<double> times, int steps, const ColumnTest& column) {
  const double step = times[1];
  UpdateOf1984 update{.step = step, .time = std::move(times)};
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

/// A creep test; nothing if the law does not reach the stress.
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

/// A value without its rounding, so that a computed 0.95 is not beyond 0.95.
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
            ? "the column was reloaded after contact was lost; the foam does not recover, and carries no "
              "stress below its largest strain"
            : "the column was reloaded after contact was lost; the law does not cover this, so the column is "
              "assumed to have followed the platen without force and to start again from zero stress"));
  if (run.unloads && -run.figures.hysteresis > std::max(1e-9, run.figures.energy_error))
    flags.push_back(flag_of(
        "ENERGY GAIN",
        fmt::format("the law returns {:.3g} % more energy than was put in", -100 * run.figures.hysteresis),
        {{"energy_gained_fraction", -run.figures.hysteresis}}));
  if (const auto& update = run.update_of_1984;
      update && std::ranges::any_of(update->stress, [&](double stress) {
        return stress > highest_drawn * run.figures.peak_stress ||
               stress < lowest_drawn * run.figures.peak_stress;
      }))
    flags.push_back(
        flag_of("OUT OF BOUNDS",
                fmt::format("with steps of {:.3g} s, the 1984 update goes outside the range from {:g} to "
                            "{:g} times the exact peak stress; the points outside it are not drawn",
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

}  // namespace

const char* to_string(TestKind kind) {
  constexpr const char* names[]{"constant-rate", "parabolic", "relaxation", "creep", "cyclic", "history"};
  return names[static_cast<std::size_t>(kind)];
}

MaterialTestReport run_material_test(const Material& material, const MaterialTest& test,
                                     StressUpdate update_of_1984) {
  if (test.steps_of_1984 && update_of_1984 == nullptr)
    throw std::invalid_argument("steps of 1984 were given without the 1984 update");
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
  if (const FoamCurves* const curves = foam_curves(material.law)) return dashpad::tested_rates(*curves);
  if (material.fitted && material.fitted->lowest_rate > 0)
    return {material.fitted->lowest_rate, material.fitted->highest_rate};
  return {material.fitted ? material.fitted->highest_rate : 1.0};
}

LoadingCurve loading_curve(const Material& material, double rate, double strain, int steps) {
  const StrainHistory loading{{{.duration = strain / rate, .strain = 0, .rate = rate}}};
  ColumnTest column = drive(material.law, loading, steps);
  return {std::move(column.strain), std::move(column.stress)};
}

}  // namespace dashpad::laboratory
