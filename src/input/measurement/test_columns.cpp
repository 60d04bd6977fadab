#include "input/measurement/test_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/quantity.hpp"
#include "input/spelling.hpp"
#include "quantities/text.hpp"
#include "quantities/unit.hpp"

namespace dashpad::input {

namespace {

enum class Kind { strain, displacement, stress, force, time, other };

/// Parts of names, in lower case.
constexpr std::array strain_words{"strain",      "dehnung",     "stauchung",    "déformation", "deformation",
                                  "deformación", "deformacion", "deformazione", "verformung",  "epsilon"};
constexpr std::array displacement_words{"displacement",   "extension",   "deflection", "travel",
                                        "stroke",         "crosshead",   "weg",        "traverse",
                                        "déplacement",    "deplacement", "course",     "corsa",
                                        "desplazamiento", "spostamento", "position"};
constexpr std::array stress_words{"stress", "spannung", "contrainte", "esfuerzo", "tensión",
                                  "sforzo", "tensione", "sigma",      "pressure", "druck"};
constexpr std::array force_words{"force",  "load",  "kraft", "last",  "charge",
                                 "fuerza", "carga", "forza", "carico"};

bool holds_any(const std::string& name, const auto& words) {
  return std::ranges::any_of(words,
                             [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

bool is_unit_of_dimension(const std::string& unit, const char* si_unit) {
  return !unit.empty() && unit_factor(tidy_unit(unit), si_unit).match == UnitMatch::same_dimension;
}

bool is_unit_of_strain(const std::string& unit) {
  return !unit.empty() && (units_in_strain_one(unit) || unit == "mm/mm" || unit == "m/m" || unit == "in/in");
}

bool is_any_unit(const std::string& unit) {
  const UnitMatch match = unit_factor(tidy_unit(unit), "Pa").match;
  return is_unit_of_strain(unit) || match == UnitMatch::same_dimension || match == UnitMatch::other_dimension;
}

/// A column with the parts of its header: "stress", "kPa" and "10 1/s" of "stress_kPa @ 10 1/s".
struct TestColumn {
  injury::MeasuredColumn of;         ///< with its unit
  std::string name = {}, rate = {};  ///< the name in lower case
  Kind kind = Kind::other;
};

std::string inside_brackets(std::string_view text) {
  for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')')})
    if (text.starts_with(open) && text.ends_with(close))
      return std::string(without_blanks(text.substr(1, text.size() - 2)));
  return std::string(text);
}

TestColumn parts_of(const injury::MeasuredColumn& column, const std::string& unit_below) {
  TestColumn parts{.of = column};
  const auto at = column.name.find('@');
  const std::string header(without_blanks(std::string_view(column.name).substr(0, at)));
  if (at != std::string::npos) parts.rate = without_blanks(std::string_view(column.name).substr(at + 1));
  parts.name = lower_case(header);
  parts.of.unit = unit_below;
  if (const auto open = header.find_last_of("[(");
      open != std::string::npos && open > 0 && (header.ends_with(']') || header.ends_with(')'))) {
    parts.name = lower_case(without_blanks(std::string_view(header).substr(0, open)));
    parts.of.unit = inside_brackets(std::string_view(header).substr(open));
    return parts;
  }
  // "strain_percent", "stress kPa", "Kraft / N", "Weg, mm"
  for (auto mark = header.find_last_of("_ ,/"); mark != std::string::npos && mark > 0;
       mark = header.find_last_of("_ ,/", mark - 1)) {
    const std::string unit(without_blanks(std::string_view(header).substr(mark + 1)));
    const bool begins_as_unit = !unit.empty() && unit.front() != '/' && unit != "1" && unit != "-";
    if (!begins_as_unit || !is_any_unit(unit)) continue;
    std::string_view name = std::string_view(header).substr(0, mark);
    while (!name.empty() && std::string_view("_ ,/").find(name.back()) != std::string_view::npos)
      name.remove_suffix(1);
    parts.name = lower_case(name);
    parts.of.unit = unit;
  }
  return parts;
}

/// By its unit and the words in its name; a deformation may be a strain or, in mm, a displacement.
Kind kind_of(const TestColumn& column) {
  const std::string &name = column.name, &unit = column.of.unit;
  if (name.find("rate") != std::string::npos || name.find("true") != std::string::npos) return Kind::other;
  const bool is_strain = holds_any(name, strain_words), moves = holds_any(name, displacement_words);
  if (is_unit_of_dimension(unit, "m")) return is_strain || moves ? Kind::displacement : Kind::other;
  if (is_unit_of_dimension(unit, "N")) return Kind::force;
  if (is_unit_of_dimension(unit, "Pa")) return Kind::stress;
  if (is_unit_of_dimension(unit, "s")) return Kind::time;
  if (is_strain && (unit.empty() || is_unit_of_strain(unit))) return Kind::strain;
  if (!unit.empty() && is_unit_of_strain(unit) && (moves || name == "e" || name == "compression"))
    return Kind::strain;
  if (holds_any(name, stress_words)) return Kind::stress;
  if (unit.empty() && moves) return Kind::displacement;
  if (unit.empty() && holds_any(name, force_words)) return Kind::force;
  return looks_like(ColumnKind::time, column.of) ? Kind::time : Kind::other;
}

std::vector<TestColumn> columns_of(const CsvHeader::Row& names, const CsvHeader::Row* units) {
  std::vector<TestColumn> all;
  for (std::size_t i = 0; i < names.fields.size(); ++i) {
    const injury::MeasuredColumn column{
        .name = names.fields[i].empty() ? fmt::format("column {}", i + 1) : quoted_part(names.fields[i]),
        .number = static_cast<int>(i + 1)};
    TestColumn parts =
        parts_of(column, units && i < units->fields.size() ? inside_brackets(units->fields[i]) : "");
    parts.kind = kind_of(parts);
    all.push_back(std::move(parts));
  }
  return all;
}

/// The row that names most columns of a test, with the row of units below it, if there is one.
std::vector<TestColumn> named_test_columns(const CsvHeader& header, std::size_t& line) {
  std::vector<TestColumn> best;
  std::ptrdiff_t most = -1;
  for (std::size_t i = 0; i < header.rows.size(); ++i) {
    const CsvHeader::Row& names = header.rows[i];
    if (names.fields.size() < std::min<std::size_t>(header.width, 2)) continue;
    const auto is_unit = [](const std::string& field) {
      return field.empty() || is_any_unit(inside_brackets(field));
    };
    if (std::ranges::all_of(names.fields, is_unit) && i > 0) continue;
    const bool has_units =
        i + 1 < header.rows.size() && std::ranges::all_of(header.rows[i + 1].fields, is_unit);
    std::vector<TestColumn> all = columns_of(names, has_units ? &header.rows[i + 1] : nullptr);
    const auto known =
        std::ranges::count_if(all, [](const TestColumn& column) { return column.kind != Kind::other; });
    if (known < most) continue;
    most = known;
    best = std::move(all);
    line = names.line;
  }
  return best;
}

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

std::vector<TestColumn> of_kind(const std::vector<TestColumn>& all, Kind kind) {
  std::vector<TestColumn> found;
  std::ranges::copy_if(all, std::back_inserter(found),
                       [&](const TestColumn& column) { return column.kind == kind; });
  return found;
}

struct Finder {
  const std::vector<TestColumn>& all;
  std::size_t line;
  MeasurementFaults& faults;

  /// The column or columns that are `wanted` or else of the first of `kinds` that there are.
  [[nodiscard]] std::vector<TestColumn> find(const std::string& wanted, const std::string& what,
                                             const char* example, std::initializer_list<Kind> kinds,
                                             bool several) const {
    std::vector<TestColumn> found;
    if (!wanted.empty()) {
      found = called(all, wanted);
    } else {
      for (const Kind kind : kinds)
        if (found.empty()) found = of_kind(all, kind);
      // Of several, the one that has no more words.
      const auto is_plain = [&](const TestColumn& column) { return column.name == what; };
      if (!several && std::ranges::count_if(found, is_plain) == 1)
        std::erase_if(found, std::not_fn(is_plain));
    }
    if (found.empty())
      faults.add(line, wanted, "",
                 fmt::format("there is no column for the {}, such as {}; name one with --{}; available: {}",
                             what, example, what, listing(all)));
    if (found.size() > 1 && !several) {
      faults.add(line, wanted, "",
                 fmt::format("several columns could be the {}: {}; choose one with --{}", what,
                             listing(found), what));
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

  void settle_strain(TestColumn& column, const StressStrainColumns& wanted) const {
    const std::string& of_length = wanted.strain_unit.empty() ? column.of.unit : wanted.strain_unit;
    if (is_unit_of_dimension(of_length, "m") || (column.kind == Kind::displacement && of_length.empty())) {
      settle(column, wanted.strain_unit, "m", "strain", "mm");
      if (!wanted.thickness)
        faults.add(
            line, column.of.name, "",
            "is a displacement; for a strain, give the specimen thickness, such as --thickness \"25 mm\"");
      column.of.factor /= wanted.thickness.value_or(1);
      return;
    }
    const std::string unit = lower_case(wanted.strain_unit.empty() ? column.of.unit : wanted.strain_unit);
    const bool is_ratio = unit == "fraction" || unit == "mm/mm" || unit == "m/m" || unit == "in/in";
    const auto in_one = is_ratio ? std::optional{1.0} : units_in_strain_one(unit);
    if (!in_one)
      faults.add(line, column.of.name, unit,
                 "for a strain, give --strain-unit fraction or --strain-unit percent");
    column.of.factor = 1 / in_one.value_or(1);
  }

  void settle_stress(TestColumn& column, const StressStrainColumns& wanted) const {
    const std::string& of_force = wanted.stress_unit.empty() ? column.of.unit : wanted.stress_unit;
    if (!is_unit_of_dimension(of_force, "N") && (column.kind != Kind::force || !of_force.empty()))
      return settle(column, wanted.stress_unit, "Pa", "stress", "kPa");
    settle(column, wanted.stress_unit, "N", "stress", "N");
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
                                        {Kind::strain, Kind::displacement}, false)) {
    finder.settle_strain(strain, wanted);
    columns.strain = std::move(strain.of);
  }
  if (beside != Beside::time)
    for (TestColumn& stress : finder.find(wanted.stress, "stress", "stress_kPa", {Kind::stress, Kind::force},
                                          beside == Beside::stresses)) {
      finder.settle_stress(stress, wanted);
      const std::optional<double> rate = stress.rate.empty() ? std::optional{0.0} : rate_in(stress.rate);
      if (!rate)
        faults.add(columns.line, stress.of.name, stress.rate,
                   "must be a strain rate above 0, such as 10 1/s");
      columns.stresses.push_back({std::move(stress.of), rate.value_or(0)});
    }
  if (beside == Beside::time || !wanted.time.empty())
    for (TestColumn& time : finder.find(wanted.time, "time", "time_s", {Kind::time}, false)) {
      finder.settle(time, wanted.time_unit, "s", "time", "s");
      columns.time = std::move(time.of);
    }
  faults.throw_if_any();
  return columns;
}

std::optional<double> strain_in(const CsvRow& row, const TestColumns& columns, MeasurementFaults& faults) {
  const ReadNumber read = read_csv_number(field_in(row, columns.strain));
  if (read.kind == NumberKind::number) return read.value / (1 / columns.strain.factor);
  add_fault(row, columns.strain, rule_for(read.kind), faults);
  return std::nullopt;
}

std::string too_large_strain(const TestColumns& columns) {
  return columns.strain.factor == 1
             ? "a strain must be below 1; if it is in per cent, give --strain-unit percent"
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
