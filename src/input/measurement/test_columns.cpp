#include "input/measurement/test_columns.hpp"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/quantity.hpp"
#include "input/measurement/test_names.hpp"
#include "input/spelling.hpp"

namespace dashpad::input {

namespace {

std::string listing(const std::vector<TestColumn>& columns) {
  std::vector<std::string> names;
  for (const TestColumn& column : columns) names.push_back(column.of.name);
  return short_listing(names);
}

/// The columns that the user named, by the whole header or the name without unit.
std::vector<TestColumn> called(const std::vector<TestColumn>& all, const std::string& wanted) {
  const std::string whole = lower_case(wanted);
  std::vector<TestColumn> found;
  for (const TestColumn& column : all) {
    if (lower_case(column.of.name) == whole) return {column};
    if (column.name == whole || column.name.substr(0, column.name.find_first_of("_ ")) == whole)
      found.push_back(column);
  }
  return found;
}

std::vector<TestColumn> of_kind(const std::vector<TestColumn>& all, TestKind kind) {
  std::vector<TestColumn> found;
  std::ranges::copy_if(all, std::back_inserter(found),
                       [&](const TestColumn& column) { return column.kind == kind; });
  return found;
}

struct Finder {
  const std::vector<TestColumn>& all;
  std::size_t line;
  MeasurementFaults& faults;

  /// The column or columns that are `wanted` or else of the first of `kinds` that there are. There may be
  /// several if `several` may be and each has its rate.
  [[nodiscard]] std::vector<TestColumn> find(const std::string& wanted, const std::string& what,
                                             const char* example, std::initializer_list<TestKind> kinds,
                                             bool several) const {
    std::vector<TestColumn> found;
    if (!wanted.empty()) found = called(all, wanted);
    for (const TestKind kind : kinds)
      if (wanted.empty() && found.empty()) found = of_kind(all, kind);
    if (found.empty())
      faults.add(line, wanted, "",
                 fmt::format("there is no column for the {}, such as {}; name one with --{}; available: {}",
                             what, example, what, listing(all)));
    const auto has_rate = [](const TestColumn& column) { return !column.rate.empty(); };
    if (several && std::ranges::all_of(found, has_rate)) return found;
    // Of several, the one that has no more words.
    const auto is_plain = [&](const TestColumn& column) { return column.name == what; };
    if (wanted.empty() && std::ranges::count_if(found, is_plain) == 1)
      std::erase_if(found, std::not_fn(is_plain));
    if (found.size() > 1) {
      faults.add(
          line, wanted, "",
          fmt::format("several columns could be the {}: {}; choose one with --{}{}", what, listing(found),
                      what,
                      several ? ", or give each its rate in its header after an @, such as \"stress_kPa "
                                "@ 10 1/s\""
                              : ""));
      found.clear();
    }
    return found;
  }

  /// Sets the factor of a column to SI.
  void settle(TestColumn& column, const std::string& given, const char* si_unit, const std::string& what,
              const char* example) const {
    const std::string unit = given.empty() ? column.of.unit : given;
    const auto [factor, rule] = read_si("1 " + unit, si_unit);
    const bool is_known = !unit.empty() && rule.empty() && factor > 0;
    if (unit.empty())
      faults.add(line, column.of.name, "",
                 fmt::format("its unit is not stated; put it in the header, as in {}_{}, or give --{}-unit",
                             what, example, what));
    else if (!is_known)
      faults.add(line, column.of.name, unit, fmt::format("{}; give another unit with --{}-unit", rule, what));
    column.of.factor = is_known ? factor : 1;
  }

  /// Whether it is a displacement.
  bool settle_strain(TestColumn& column, const StressStrainColumns& wanted) const {
    const std::string& of_length = wanted.strain_unit.empty() ? column.of.unit : wanted.strain_unit;
    if (is_unit_of_dimension(of_length, "m") ||
        (column.kind == TestKind::displacement && of_length.empty())) {
      settle(column, wanted.strain_unit, "m", "strain", "mm");
      if (!wanted.thickness)
        faults.add(
            line, column.of.name, "",
            "is a displacement; for a strain, give the specimen thickness, such as --thickness \"25 mm\"");
      column.of.factor /= wanted.thickness.value_or(1);
      return true;
    }
    const std::string unit = lower_case(wanted.strain_unit.empty() ? column.of.unit : wanted.strain_unit);
    const bool is_ratio = unit == "fraction" || unit == "mm/mm" || unit == "m/m" || unit == "in/in";
    const auto in_one = is_ratio ? std::optional{1.0} : units_in_strain_one(unit);
    if (!in_one)
      faults.add(line, column.of.name, unit,
                 "for a strain, give --strain-unit fraction, percent or microstrain");
    column.of.factor = 1 / in_one.value_or(1);
    return false;
  }

  void settle_stress(TestColumn& column, const StressStrainColumns& wanted) const {
    const std::string given = unit_of_weight(wanted.stress_unit);
    const std::string& of_force = given.empty() ? column.of.unit : given;
    if (!is_unit_of_dimension(of_force, "N") && (column.kind != TestKind::force || !of_force.empty()))
      return settle(column, wanted.stress_unit, "Pa", "stress", "kPa");
    settle(column, given, "N", "stress", "N");
    if (!wanted.area)
      faults.add(line, column.of.name, "",
                 "is a force; for a stress, give the specimen area, such as --area \"25 cm2\"");
    column.of.factor /= wanted.area.value_or(1);
  }
};

/// A rate per second: "10 1/s", "10/s" or "10".
std::optional<double> rate_in(std::string text) {
  const auto end = text.find_first_not_of("0123456789.+-eE ");
  if (end == std::string::npos) text += " 1/s";
  const bool is_alone = text.find(' ') >= end;
  if (end != std::string::npos && text[end] == '/' && is_alone) text.insert(end, " 1");
  const auto [rate, rule] = read_si(text, "1/s");
  return rule.empty() && rate > 0 ? std::optional(rate) : std::nullopt;
}

}  // namespace

TestColumns find_test_columns(const CsvHeader& header, const StressStrainColumns& wanted, Beside beside,
                              MeasurementFaults& faults) {
  TestColumns columns;
  const std::vector<TestColumn> all = named_test_columns(header, columns.line);
  if (all.empty())
    faults.refuse(header.first_line, "", "",
                  "needs a header line, such as strain,stress_kPa, that names the columns and their units");
  const Finder finder{all, columns.line, faults};
  for (TestColumn& strain : finder.find(wanted.strain, "strain", "strain or strain_percent",
                                        {TestKind::strain, TestKind::displacement}, false)) {
    columns.is_displacement = finder.settle_strain(strain, wanted);
    columns.strain = std::move(strain.of);
  }
  if (beside != Beside::time)
    for (TestColumn& stress : finder.find(wanted.stress, "stress", "stress_kPa",
                                          {TestKind::stress, TestKind::force}, beside == Beside::stresses)) {
      finder.settle_stress(stress, wanted);
      const std::optional<double> rate = stress.rate.empty() ? std::optional{0.0} : rate_in(stress.rate);
      if (!rate)
        faults.add(columns.line, stress.of.name, stress.rate,
                   "must be a strain rate above 0, such as 10 1/s");
      columns.stresses.push_back({std::move(stress.of), rate.value_or(0)});
    }
  if (beside == Beside::time || !wanted.time.empty())
    for (TestColumn& time : finder.find(wanted.time, "time", "time_s", {TestKind::time}, false)) {
      finder.settle(time, wanted.time_unit, "s", "time", "s");
      columns.time = std::move(time.of);
    }
  faults.throw_if_any();
  return columns;
}

std::optional<double> strain_in(const CsvRow& row, const TestColumns& columns, MeasurementFaults& faults) {
  const ReadNumber read = read_csv_number(field_in(row, columns.strain));
  if (read.kind == NumberKind::number) return (read.value - columns.zero) / (1 / columns.strain.factor);
  add_fault(row, columns.strain, rule_for(read.kind), faults);
  return std::nullopt;
}

std::string too_large_strain(const TestColumns& columns) {
  return columns.strain.factor == 1 ? "a strain must be below 1; if it is in per cent, give --strain-unit "
                                      "percent; if in microstrain, "
                                      "--strain-unit microstrain"
                                    : "a strain must be below 100 %";
}

void make_compression_positive(std::vector<double>& values, const std::string& name,
                               std::vector<std::string>& remarks) {
  if (values.empty()) return;
  const auto [least, largest] = std::ranges::minmax(values);
  if (!(-least > largest)) return;
  for (double& value : values) value = -value;
  remarks.push_back(fmt::format("{}: compression is negative in the file; its sign was reversed", name));
}

}  // namespace dashpad::input
