#include "output/text/material_test_answer.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "output/text/material_test_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

using laboratory::CushionPoint;
using laboratory::MaterialTestReport;
using laboratory::MaterialTestRun;

std::string number(double value) { return brief(rounded_to(value, 3)); }

/// The first limit.
std::string answer_to_limit(const MaterialTestReport& report, const MaterialTestRun& run,
                            const MaterialTestValues& shown) {
  const std::string limit = shown.stress(report.test.stress_limits.front());
  if (const std::optional<CushionPoint>& at = run.at_limits.front())
    return fmt::format("Takes {} before its stress reaches {}", shown.energy(at->energy), limit);
  return fmt::format("Takes {} and does not reach {}", shown.energy(run.figures.energy_in), limit);
}

std::string answer_without_rate(const MaterialTestReport& report, const MaterialTestRun& run,
                                const MaterialTestValues& shown) {
  const std::string hold = brief_quantity(report.test.hold, "s", shown.units, 3);
  if (run.relaxed && run.relaxed->at_end_of_ramp > 0)
    return fmt::format("Keeps {} of its stress for {} at a strain of {}",
                       MaterialTestValues::share(run.relaxed->after_hold / run.relaxed->at_end_of_ramp), hold,
                       MaterialTestValues::strain(report.test.strain));
  if (run.crept)
    return fmt::format("Creeps from a strain of {} to {} in {} under {}",
                       MaterialTestValues::strain(run.crept->at_end_of_loading),
                       MaterialTestValues::strain(run.crept->after_hold), hold,
                       shown.stress(report.test.stress));
  if (!run.at_limits.empty()) return answer_to_limit(report, run, shown);
  const CushionPoint& best = run.figures.best_efficiency;
  if (runs_out(run))
    return fmt::format("Best used at {}: it has then taken {}", shown.stress(best.stress),
                       shown.energy(best.energy));
  return fmt::format("Takes {} up to a strain of {}, and has not run out there", shown.energy(best.energy),
                     MaterialTestValues::strain(best.strain));
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

std::string MaterialTestValues::strain(double value) { return brief(value, 3); }

std::string MaterialTestValues::share(double value) { return number(100 * value) + " %"; }

std::string material_test_answer(const MaterialTestReport& report, const UnitSystem& units) {
  const MaterialTestRun& run = headline_run(report);
  return answer_without_rate(report, run, {units}) +
         (run.rate ? fmt::format(" (at {})", rate_words(run)) : "");
}

}  // namespace dashpad::output
