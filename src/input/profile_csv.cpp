#include "input/case_tables.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "dashpad/quantities/quantity.hpp"
#include "input/disk.hpp"
#include "input/measurement/csv_table.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::input {
namespace {

/// "depth [mm]", "depth (mm)" and "depth_mm" are a depth in mm.
HeaderText name_and_unit(const injury::MeasuredColumn& column) {
  const HeaderText in_brackets = split_header(column.name);
  if (!in_brackets.unit.empty()) return {lower_case(in_brackets.name), in_brackets.unit};
  const auto mark = column.name.find_last_of("_ ");
  if (mark == std::string::npos) return {lower_case(column.name), column.unit};
  return {lower_case(std::string_view(column.name).substr(0, mark)), column.name.substr(mark + 1)};
}

/// The column of that name; absent if there is none. Several such columns, or a wrong unit, are faults.
std::optional<injury::MeasuredColumn> find_column(const CsvColumns& columns, const std::string& name,
                                                  const std::string& si_unit, std::size_t line,
                                                  MeasurementFaults& faults) {
  std::optional<injury::MeasuredColumn> found;
  for (const injury::MeasuredColumn& column : columns.all) {
    const HeaderText header = name_and_unit(column);
    if (header.name != name) continue;
    if (found) {
      faults.add(line, column.name, "", fmt::format("is a second column called {}", name));
      return std::nullopt;
    }
    found = column;
    const auto [factor, rule] =
        header.unit.empty() ? SiValue{0, fmt::format("the {} column needs a unit in its header", name)}
                            : read_si("1 " + header.unit, si_unit);
    found->factor = factor;
    if (!rule.empty()) faults.add(line, column.name, "", rule);
  }
  return found;
}

struct ProfileColumns {
  injury::MeasuredColumn depth, size;
  Profile::Of of = Profile::Of::radius;
};

ProfileColumns choose(const CsvHeader& header, MeasurementFaults& faults) {
  constexpr const char* example = ", such as depth_mm,radius_mm";
  const CsvColumns named = named_columns(header, example, faults);
  const std::size_t line = named.names->line;
  const auto depth = find_column(named, "depth", "m", line, faults);
  const auto radius = find_column(named, "radius", "m", line, faults);
  const auto area = find_column(named, "area", "m2", line, faults);
  faults.throw_if_any();
  if (!depth) faults.refuse(line, "", "", fmt::format("needs a depth column in the header{}", example));
  if (!radius && !area)
    faults.refuse(line, "", "", fmt::format("needs a radius or area column in the header{}", example));
  if (radius && area) faults.refuse(line, "", "", "give a radius or an area, not both");
  return {*depth, radius ? *radius : *area, radius ? Profile::Of::radius : Profile::Of::area};
}

/// NaN after a fault.
double read_field(const CsvRow& row, const injury::MeasuredColumn& column, const std::string& si_unit,
                  MeasurementFaults& faults) {
  const auto value = number_in(row, column, faults);
  const std::string rule = value ? rule_of(stated_magnitudes, *value, si_unit) : "";
  if (value && rule.empty()) return *value;
  if (value) add_fault(row, column, rule, faults);
  return std::numeric_limits<double>::quiet_NaN();
}

Profile profile_in(const std::filesystem::path& file) {
  const std::string content = read_text_file(file).value();
  MeasurementFaults faults(file.string());
  const CsvTable table = csv_table_in(content, faults);
  const ProfileColumns columns = choose(table.header, faults);

  Profile profile{.of = columns.of};
  std::vector<std::size_t> lines;
  each_row(table, faults, [&](const CsvRow& row) {
    if (profile.points.size() == Profile::max_points)
      faults.refuse(row.line, "", "",
                    fmt::format("has more than {} rows; thin them out", Profile::max_points));
    const auto read = [&](const injury::MeasuredColumn& column, const char* unit) {
      return read_field(row, column, unit, faults);
    };
    profile.points.push_back(
        {read(columns.depth, "m"), read(columns.size, columns.of == Profile::Of::radius ? "m" : "m2")});
    lines.push_back(row.line);
  });
  faults.throw_if_any();
  for (const Profile::Fault& fault : profile.faults()) {
    const bool is_row = profile.points.size() > 1;
    faults.add(is_row ? lines[fault.point] : 0, "", "", is_row ? fault.rule : "needs at least two rows");
  }
  faults.throw_if_any();
  return profile;
}

}  // namespace

Reading<Profile> read_profile_csv(const std::filesystem::path& file) {
  return reading_of([&] { return profile_in(file); });
}

}  // namespace dashpad::input
