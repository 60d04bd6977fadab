// [[tests]] of a fit file.

#include <algorithm>
#include <cmath>

#include "dashpad/input/measurement/stress_strain_csv.hpp"
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
  if (table.has("strain_unit")) columns.strain_unit = table.choice("strain_unit", {"fraction", "percent"});
  columns.stress_unit = table.text("stress_unit", Presence::optional);
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
                          [](const TomlNode& of) { return of.kind == TomlNode::Kind::number; }) &&
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

MaterialMeasurement read_test(TableReader& table, const FitFolders& folders,
                              std::vector<input::InputFile>& files) {
  MaterialMeasurement test;
  test.file = table.text("file");
  const input::StressStrainColumns columns = read_columns(table);
  std::optional<double> rate;
  if (table.has("rate")) {
    rate = table.quantity("rate", "1/s");
    if (*rate <= 0) table.fault("rate", "must be more than 0; up or down is seen from the strains");
  }
  if (rate && !columns.time.empty()) table.fault("rate", "give a rate or a column of times, not both");
  if (!rate && columns.time.empty())
    table.fault("rate",
                "is missing; say how fast the test was, such as \"0.01 1/s\", or name a column of "
                "times: columns = {time = \"time\"}");
  read_range(table, test);
  test.has_offset = flag_in(table, "offset");
  test.is_held_out = flag_in(table, "hold_out");
  if (test.has_offset && test.is_held_out)
    table.fault("offset", "cannot be found from a test that is held out");
  if (!test.file.empty()) {
    const std::filesystem::path file = folders.of_fit / test.file;
    files.push_back({"the measurements", file});
    if (auto read = table.faults().take(input::read_stress_strain_csv(file, columns))) {
      test.strain = std::move(read->strain);
      test.stress = std::move(read->stress);
      test.time = std::move(read->time);
      if (rate && *rate > 0) test.time = times_at(*rate, test.strain);
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
