#include "output/text/material_test_words.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

using laboratory::CushionPoint;
using laboratory::MaterialTestReport;
using laboratory::MaterialTestRun;

std::string number(double value) { return brief(rounded_to(value, 3)); }

std::string answer_without_rate(const MaterialTestReport& report, const MaterialTestRun& run,
                                const MaterialTestValues& shown) {
  const std::string hold = brief_quantity(report.test.hold, "s", shown.units, 3);
  if (run.relaxed && run.relaxed->at_end_of_ramp > 0)
    return fmt::format("After {} at a strain of {}, {} of the stress remains", hold,
                       brief(report.test.strain, 3),
                       MaterialTestValues::share(run.relaxed->after_hold / run.relaxed->at_end_of_ramp));
  if (run.crept)
    return fmt::format("Creeps from a strain of {} to {} in {} under {}",
                       brief(run.crept->at_end_of_loading, 3), brief(run.crept->after_hold, 3), hold,
                       shown.stress(report.test.stress));
  if (!run.at_limits.empty()) {
    const std::string limit = shown.stress(report.test.stress_limits.front());
    if (const std::optional<CushionPoint>& at = run.at_limits.front())
      return fmt::format("Absorbs {} before its stress reaches {}", shown.energy(at->energy), limit);
    return fmt::format("Absorbs {} without reaching {}", shown.energy(run.figures.energy_in), limit);
  }
  const CushionPoint& best = run.figures.best_efficiency;
  if (runs_out(run))
    return fmt::format("Best used up to {}, having absorbed {}", shown.stress(best.stress),
                       shown.energy(best.energy));
  return fmt::format("Absorbs {} up to a strain of {}, with its efficiency still rising",
                     shown.energy(best.energy), brief(best.strain, 3));
}

}  // namespace

const MaterialTestRun& headline_run(const MaterialTestReport& report) {
  return *std::ranges::max_element(report.runs, {},
                                   [](const MaterialTestRun& run) { return run.rate.value_or(0); });
}

bool runs_out(const MaterialTestRun& run) {
  constexpr double end_of_loading = 0.999;
  return !run.cushion.strain.empty() &&
         run.figures.best_efficiency.strain < end_of_loading * run.cushion.strain.back();
}

std::string MaterialTestValues::stress(double value) const {
  return number(value_in(units, value, "Pa")) + " " + shown_unit(unit_for(units, "Pa"));
}

std::string MaterialTestValues::energy(double value) const {
  return number(value_in(units, value, "Pa")) + " " + energy_density_unit(units);
}

std::string MaterialTestValues::share(double value) { return number(100 * value) + " %"; }

std::string material_test_answer(const MaterialTestReport& report, const UnitSystem& units) {
  const MaterialTestRun& run = headline_run(report);
  return answer_without_rate(report, run, {units}) +
         (run.rate ? fmt::format(" (at {})", rate_words(run)) : "");
}

std::string test_words(const laboratory::MaterialTest& test, const UnitSystem& units) {
  const std::string strain = brief(test.strain), hold = brief_quantity(test.hold, "s", units);
  switch (test.kind) {
    case laboratory::TestKind::constant_rate:
      return fmt::format("Loaded to a strain of {} and unloaded to zero at the same constant rate.", strain);
    case laboratory::TestKind::parabolic:
      return fmt::format(
          "Loaded to a strain of {} and unloaded to zero along a parabola in time; the rate is the mean "
          "loading rate.",
          strain);
    case laboratory::TestKind::relaxation:
      return fmt::format("Loaded to a strain of {} at a constant rate, and held there for {}.", strain, hold);
    case laboratory::TestKind::creep:
      return fmt::format("Loaded to a stress of {} at a constant strain rate, and held there for {}.",
                         brief_quantity(test.stress, "Pa", units), hold);
    case laboratory::TestKind::cyclic:
      return fmt::format("Loaded to a strain of {} and unloaded to {} at a constant rate, {} {}.", strain,
                         brief(test.low), test.cycles, test.cycles == 1 ? "time" : "times");
    case laboratory::TestKind::history:
      return fmt::format("Made to follow the strain history in {}, linear between its {} points.",
                         one_line(test.history_name), test.times.size());
  }
  return "";
}

std::string rate_words(const laboratory::MaterialTestRun& run) {
  return run.rate ? brief(*run.rate) + " per second" : "measured";
}

std::vector<std::string> flag_words(const laboratory::MaterialTestReport& report) {
  std::vector<std::pair<Flag, std::string>> all;
  for (const laboratory::MaterialTestRun& run : report.runs)
    for (const Flag& flag : run.flags) {
      const auto same = std::ranges::find(all, flag.text, [](const auto& entry) { return entry.first.text; });
      const std::string rate = run.rate ? brief(*run.rate) : "";
      if (same == all.end())
        all.emplace_back(flag, rate);
      else
        replace_all(same->second, " and ", ", "), same->second += " and " + rate;
    }
  std::vector<std::string> lines;
  for (const auto& [flag, rates] : all)
    lines.push_back(one_line(rates.empty() ? flag.text
                                           : fmt::format("{} (at {} per second){}", flag.name, rates,
                                                         flag.text.substr(flag.name.size()))));
  return lines;
}

std::vector<std::string> notes_on(const laboratory::MaterialTestReport& report) {
  double stress_error = 0, energy_error = 0;
  for (const laboratory::MaterialTestRun& run : report.runs) {
    stress_error = std::max(stress_error, run.column.stress_error);
    energy_error = std::max(energy_error, run.figures.energy_error);
  }
  std::vector<std::string> notes{
      fmt::format("Estimated errors: stresses, {} of the peak stress; energies, {} of the energy input.",
                  percentage(stress_error), percentage(energy_error)),
      "Energies are per unit volume. Efficiency is energy divided by the largest stress so far; ideality is "
      "efficiency divided by strain. Both are for the first loading."};
  if (!range_of(report.material))
    notes.emplace_back("The card states no fitted range, so extrapolation cannot be detected.");
  if (report.test.steps_of_1984)
    notes.emplace_back(
        "1984: the explicit update in the report's Eq. 16, in the arithmetic of the computer used then. A "
        "positive jump at the end of the first loading is the report's stress-discontinuity artifact.");
  for (const std::string& remark : report.test.history_remarks)
    notes.push_back("REMARK: " + one_line(remark));
  return notes;
}

}  // namespace dashpad::output
