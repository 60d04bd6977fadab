#include "output/text/material_test_words.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "quantities/text.hpp"

namespace dashpad::output {

std::string test_words(const laboratory::MaterialTest& test, const UnitSystem& units) {
  const std::string strain = brief(test.strain), hold = brief_quantity(test.hold, "s", units);
  switch (test.kind) {
    case laboratory::TestKind::constant_rate:
      return fmt::format("Loaded to a strain of {} at constant rate, and unloaded to zero at the same rate.",
                         strain);
    case laboratory::TestKind::parabolic:
      return fmt::format(
          "Loaded to a strain of {} and unloaded to zero on a parabola; the rate is the mean rate of "
          "loading.",
          strain);
    case laboratory::TestKind::relaxation:
      return fmt::format("Loaded to a strain of {} at constant rate, and held there for {}.", strain, hold);
    case laboratory::TestKind::creep:
      return fmt::format("Loaded to a stress of {} at constant strain rate, and held at that stress for {}.",
                         brief_quantity(test.stress, "Pa", units), hold);
    case laboratory::TestKind::cyclic:
      return fmt::format("Loaded to a strain of {} and unloaded to {} at constant rate, {} {}.", strain,
                         brief(test.low), test.cycles, test.cycles == 1 ? "time" : "times");
    case laboratory::TestKind::history:
      return fmt::format("Driven through the strain history of {}, straight between its {} points.",
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
      if (same == all.end())
        all.emplace_back(flag, run.rate ? brief(*run.rate) : "");
      else
        same->second += ", " + (run.rate ? brief(*run.rate) : "");
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
      fmt::format("Estimated errors: stresses {} of the peak stress, energies {} of the energy put in.",
                  percentage(stress_error), percentage(energy_error)),
      "Energies are per volume. Efficiency is energy over the largest stress so far, ideality that over the "
      "strain; of the first loading."};
  if (!range_of(report.material))
    notes.emplace_back("The card states no fitted range: no result can be called extrapolated.");
  if (report.test.steps_of_1984)
    notes.emplace_back(
        "1984: the explicit update of the report's Eq. 16, in the arithmetic of its machine. A jump above "
        "zero "
        "at the end of the first loading is what the report calls the stress-discontinuity artifact.");
  for (const std::string& remark : report.test.history_remarks)
    notes.push_back("REMARK: " + one_line(remark));
  return notes;
}

}  // namespace dashpad::output
