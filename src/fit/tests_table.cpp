// [[tests]] of a fit file.

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "dashpad/input/measurement/tables.hpp"
#include "dashpad/quantities/constants.hpp"
#include "fit/fit_tables.hpp"

namespace dashpad::fit {

using input::Presence;
using input::TableReader;
using input::TomlNode;

namespace {

input::StressStrainColumns read_columns(TableReader& table) {
  input::StressStrainColumns columns;
  if (auto names = table.table("columns", Presence::optional)) {
    for (const auto& [key, name] :
         {std::pair{"strain", &columns.strain}, {"stress", &columns.stress}, {"time", &columns.time}})
      if (names->has(key)) *name = names->text(key);
    names->refuse_others();
  }
  columns.strain_unit = table.text("strain_unit", Presence::optional);
  columns.stress_unit = table.text("stress_unit", Presence::optional);
  for (const auto& [key, unit, value] :
       {std::tuple{"thickness", "m", &columns.thickness}, {"area", "m2", &columns.area}})
    if (table.has(key)) {
      *value = table.quantity(key, unit);
      if (**value <= 0) table.fault(key, "must be more than 0");
    }
  columns.time_unit = table.text("time_unit", Presence::optional);
  return columns;
}

void read_range(TableReader& table, MaterialMeasurement& test) {
  if (!table.has("range")) return;
  const TomlNode* range = table.array("range");
  if (!range) return;
  const bool sound =
      range->children.size() == 2 &&
      std::ranges::all_of(range->children,
                          [](const TomlNode& node) { return node.kind == TomlNode::Kind::number; }) &&
      range->children[0].number < range->children[1].number && range->children[0].number >= 0 &&
      range->children[1].number <= 1;
  if (!sound) {
    table.fault("range", "must be two strains from 0 to 1, the lower one first, such as [0, 0.5]");
    return;
  }
  test.lowest_strain = range->children[0].number;
  test.highest_strain = range->children[1].number;
}

/// Times of strains that go on at one rate, up or down.
std::vector<double> times_at(double rate, const std::vector<double>& strain) {
  std::vector<double> times{0};
  for (std::size_t i = 1; i < strain.size(); ++i)
    times.push_back(times.back() + std::abs(strain[i] - strain[i - 1]) / rate);
  return times;
}

}  // namespace

void take_points(input::StressStrainTable read, std::optional<double> rate, MaterialMeasurement& test) {
  test.strain = std::move(read.strain);
  test.stress = std::move(read.stress);
  test.time = rate ? times_at(*rate, test.strain) : std::move(read.time);
  test.remarks = std::move(read.remarks);
}

MaterialMeasurement read_test(TableReader& table, const input::Folders& folders,
                              std::vector<input::InputFile>& files) {
  MaterialMeasurement test;
  test.file = table.text("file");
  const input::StressStrainColumns columns = read_columns(table);
  std::optional<double> rate;
  if (table.has("rate")) {
    rate = table.quantity("rate", "1/s");
    if (*rate <= 0) table.fault("rate", "must be more than 0; the direction follows from the strains");
  }
  if (rate && !columns.time.empty()) table.fault("rate", "give a rate or a time column, not both");
  if (!rate && columns.time.empty())
    table.fault("rate",
                "is missing; give the strain rate of the test, such as \"0.01 1/s\", or name a time column: "
                "columns = {time = \"time\"}");
  read_range(table, test);
  if (table.has("temperature"))
    if (const double temperature = table.quantity("temperature", "K"); std::isfinite(temperature))
      test.temperature = temperature;
  test.has_offset = table.flag("offset");
  test.is_held_out = table.flag("hold_out");
  test.is_base = table.flag("is_base");
  if (test.has_offset && test.is_held_out)
    table.fault("offset", "an offset cannot be fitted for a test that is held out");
  if (!test.file.empty()) {
    const std::filesystem::path file = folders.of_file / test.file;
    files.push_back({"the measurements", file});
    if (auto read = taken_with_keys(input::read_stress_strain_csv(file, columns), table.faults())) {
      if (rate && !(*rate > 0)) rate.reset();  // a fault
      take_points(*std::move(read), rate, test);
    }
  }
  if (table.has("noise")) {
    double largest = no_value;
    for (std::size_t i = 0; i < test.stress.size(); ++i)
      if (counts(test, i) && !(test.stress[i] <= largest)) largest = test.stress[i];
    test.noise = value_or_share(table, "noise", "Pa", largest);
  }
  table.refuse_others();
  return test;
}

}  // namespace dashpad::fit
