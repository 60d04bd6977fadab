// A material test as a table for other programs.

#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "dashpad/output/material_test.hpp"

namespace dashpad::output {

namespace {

void add(fmt::memory_buffer& text, double value, char end) {
  if (std::isfinite(value)) fmt::format_to(std::back_inserter(text), "{}", value);
  text.push_back(end);
}

/// The rows of one run. The update of 1984 has fewer places; each of them is one of the exact stress.
void add_rows(fmt::memory_buffer& text, const laboratory::MaterialTestRun& run, bool with_1984,
              double time_unit, double stress_unit) {
  const laboratory::ColumnTest& column = run.column;
  std::size_t next = 0;
  for (std::size_t i = 0; i < column.size(); ++i) {
    add(text, run.rate.value_or(NAN), ',');
    add(text, time_unit * column.time[i], ',');
    add(text, column.strain[i], ',');
    add(text, column.rate[i], ',');
    add(text, stress_unit * column.stress[i], with_1984 ? ',' : '\n');
    if (!with_1984) continue;
    const laboratory::UpdateOf1984& update = *run.update_of_1984;
    const bool is_place =
        next < update.time.size() && (column.time[i] >= update.time[next] - 1e-6 * update.step);
    add(text, is_place ? stress_unit * update.stress[next] : NAN, '\n');
    if (is_place) ++next;
  }
}

}  // namespace

std::string material_test_csv(const laboratory::MaterialTestReport& report, const UnitSystem& units) {
  const bool with_1984 = report.test.steps_of_1984.has_value();
  const std::string time = unit_for(units, "s"), stress = unit_for(units, "Pa");
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "rate_1_per_s,time_{},strain,strain_rate_1_per_s,stress_{}", time,
                 stress);
  if (with_1984) fmt::format_to(std::back_inserter(text), ",stress_1984_{}", stress);
  text.push_back('\n');
  for (const laboratory::MaterialTestRun& run : report.runs)
    add_rows(text, run, with_1984, value_in(units, 1, "s"), value_in(units, 1, "Pa"));
  return fmt::to_string(text);
}

}  // namespace dashpad::output
