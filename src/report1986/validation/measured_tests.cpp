#include "dashpad/report1986/validation/measured_tests.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dashpad/report1986/validation/energy.hpp"
#include "report1986/validation/measured_tests_constants.hpp"
#include "report1986/validation/measured_tests_csv.hpp"
#include "report1986/validation/measured_tests_table.hpp"
#include "report1986/validation/measured_tests_words.hpp"

namespace dashpad::report1986 {

namespace {

namespace fs = std::filesystem;

/// The points of both supports, checked: deflections and forces go up; the plate is one point.
void read_supports(const fs::path& file, ValidationData& data, std::vector<input::Fault>& faults) {
  CsvTable table(file, {"support", "deflection_in", "force_lb"}, faults);
  bool has_plate = false;
  for (const CsvRecord& record : table.records()) {
    const TestSupport support = read_support(table, record);
    const StaticPoint point{table.number(record, "deflection_in"), table.number(record, "force_lb")};
    if (support == TestSupport::plate) {
      if (has_plate) table.fault(record, "support", "the plate is linear: one point");
      has_plate = true;
      data.plate_stiffness_lb_per_in = point.force_lb / point.deflection_in;
      if (data.plate_stiffness_lb_per_in == 0 || std::isinf(data.plate_stiffness_lb_per_in))
        table.fault(record, "force_lb", "gives a stiffness that is too large or too small to compute with");
      continue;
    }
    const StaticPoint last = data.load_cell.empty() ? StaticPoint{} : data.load_cell.back();
    if (point.deflection_in <= last.deflection_in)
      table.fault(record, "deflection_in", "must be more than that of the point before");
    if (point.force_lb <= last.force_lb)
      table.fault(record, "force_lb", "must be more than that of the point before");
    data.load_cell.push_back(point);
  }
  if (!table.records().empty() && data.load_cell.empty()) table.fault("has no point of the load cell");
  if (!table.records().empty() && !has_plate) table.fault("has no point of the plate");
}

void read_constants(const fs::path& file, ValidationData& data, std::vector<input::Fault>& faults) {
  CsvTable table(file, {"name", "value", "unit", "where"}, faults);
  for (const CsvRecord& record : table.records()) {
    PrintedConstant constant{table.text(record, "name"), table.number(record, "value"),
                             table.text(record, "unit"), table.text(record, "where")};
    if (std::ranges::count(data.printed, constant.name, &PrintedConstant::name) > 0)
      table.fault(record, "name", "is there twice");
    data.printed.push_back(std::move(constant));
  }
  if (table.records().empty()) return;
  for (const char* name : constants_of_the_study)
    if (std::ranges::count(data.printed, name, &PrintedConstant::name) == 0)
      table.fault("has no constant " + std::string(name));
}

void read_table_3_2(const fs::path& file, ValidationData& data, std::vector<input::Fault>& faults) {
  CsvTable table(file,
                 {"projectile", "speed_mph", "energy_in_lb", "peak_force_lb", "rebound_energy_in_lb",
                  "support_energy_in_lb", "speed_ratio", "rebound_mph"},
                 faults);
  for (const CsvRecord& record : table.records())
    data.table_3_2.push_back({read_projectile(table, record), table.number(record, "speed_mph"),
                              table.number(record, "energy_in_lb"), table.number(record, "peak_force_lb"),
                              table.number(record, "rebound_energy_in_lb"),
                              table.number(record, "support_energy_in_lb"),
                              table.fraction(record, "speed_ratio"), table.number(record, "rebound_mph")});
}

}  // namespace

std::optional<double> peak_strain(const MeasuredTest& test) {
  if (test.plug_strain && test.diameter_strain) return (*test.plug_strain + *test.diameter_strain) / 2;
  return test.plug_strain ? test.plug_strain : test.diameter_strain;
}

double ValidationData::constant(const std::string& name) const {
  const auto found = std::ranges::find(printed, name, &PrintedConstant::name);
  if (found == printed.end()) throw std::out_of_range("no printed constant is called " + name);
  return found->value;
}

ValidationData read_validation_data(const fs::path& folder, std::vector<input::Fault>& faults) {
  ValidationData data;
  const std::size_t before = faults.size();
  const auto table = [&](const char* name) {
    data.files.push_back({"a table of the measured tests", folder / name});
    return data.files.back().file;
  };
  data.measured.tests = read_certain_rows(table("table-3-1.csv"), faults);
  data.measured.unplaced = read_unplaced(table("table-3-1-unplaced.csv"), data.measured.tests, faults);
  read_table_3_2(table("table-3-2.csv"), data, faults);
  read_constants(table("printed-constants.csv"), data, faults);
  read_supports(table("supports.csv"), data, faults);
  if (faults.size() == before) data.pad_thickness_in = data.constant("pad_thickness_in");
  return data;
}

const char* to_string(Projectile projectile) {
  return projectile == Projectile::aluminium ? "aluminium" : "steel";
}

const char* to_string(TestSupport support) {
  return support == TestSupport::load_cell ? "load cell" : "flexible plate";
}

}  // namespace dashpad::report1986
