// Tables for other programs.

#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dashpad/output/impact.hpp"
#include "dashpad/output/materials.hpp"
#include "dashpad/output/pulse.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "result/history_columns.hpp"

namespace dashpad::output {

namespace {

struct Column {
  std::string header;
  std::vector<double> values = {};  ///< values in the unit of the header
};

/// A quantity of the table of results, given in SI.
Column column(const char* key, std::vector<double> values, const UnitSystem& units) {
  const ResultQuantity& of = result_quantity(key);
  const double factor = scaled_unit(of.si_unit, units).scale;
  for (double& value : values) value *= factor;
  return {key_with_unit(of, units), std::move(values)};
}

/// A header row, then the rows; what is not finite is an empty field.
std::string csv_text(const std::vector<Column>& columns) {
  fmt::memory_buffer text;
  const auto end_field = [&](const Column& column) {
    text.push_back(&column == &columns.back() ? '\n' : ',');
  };
  for (const Column& column : columns) {
    text.append(column.header);
    end_field(column);
  }
  for (std::size_t row = 0; row < columns.front().values.size(); ++row)
    for (const Column& column : columns) {
      if (std::isfinite(column.values[row]))
        fmt::format_to(std::back_inserter(text), "{}", column.values[row]);
      end_field(column);
    }
  return fmt::to_string(text);
}

}  // namespace

std::string history_csv(const History& history, const UnitSystem& units) {
  std::vector<Column> columns;
  for (const HistoryColumn& each : history_columns())
    if (const std::vector<double>& values = history.*each.values; !each.is_optional || !values.empty())
      columns.push_back(column(each.key, values, units));
  for (std::size_t i = 0; i < history.layer_strain.size(); ++i) {
    columns.push_back(column("axis_strain", history.layer_strain[i], units));
    columns.back().header += fmt::format("_layer_{}", i + 1);
  }
  for (const Column& column : columns)
    if (column.values.size() != history.size())
      throw std::invalid_argument("history: the column " + column.header + " is incomplete");
  return csv_text(columns);
}

std::string pulse_csv(const injury::PulseReport& report, const UnitSystem& units) {
  Column acceleration{key_with_unit(result_quantity("acceleration"), units)};
  for (const double value : report.pulse.acceleration)
    acceleration.values.push_back(value / standard_gravity);
  return csv_text({column("time", report.pulse.time, units), std::move(acceleration)});
}

std::string material_test_csv(const laboratory::MaterialTestReport& report, const UnitSystem& units) {
  const double time_unit = value_in(units, 1, "s"), stress_unit = value_in(units, 1, "Pa");
  Column rate{"rate_1_per_s"}, time{"time_" + unit_for(units, "s")}, strain{"strain"},
      strain_rate{"strain_rate_1_per_s"}, stress{"stress_" + unit_for(units, "Pa")},
      stress_1984{"stress_1984_" + unit_for(units, "Pa")};
  for (const laboratory::MaterialTestRun& run : report.runs) {
    const laboratory::ColumnTest& test = run.column;
    std::size_t next = 0;
    for (std::size_t i = 0; i < test.size(); ++i) {
      rate.values.push_back(run.rate.value_or(NAN));
      time.values.push_back(time_unit * test.time[i]);
      strain.values.push_back(test.strain[i]);
      strain_rate.values.push_back(test.rate[i]);
      stress.values.push_back(stress_unit * test.stress[i]);
      if (!run.update_of_1984) continue;
      // The update has fewer times than the exact stress, and each of them is one of its times.
      const laboratory::UpdateOf1984& update = *run.update_of_1984;
      const bool is_place =
          next < update.time.size() && test.time[i] >= update.time[next] - 1e-6 * update.step;
      stress_1984.values.push_back(is_place ? stress_unit * update.stress[next++] : NAN);
    }
  }
  std::vector<Column> columns{std::move(rate), std::move(time), std::move(strain), std::move(strain_rate),
                              std::move(stress)};
  if (report.test.steps_of_1984) columns.push_back(std::move(stress_1984));
  return csv_text(columns);
}

}  // namespace dashpad::output
