// The columns of compression tests as their headers name them, in five languages, with their units.

#include "input/measurement/test_names.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "quantities/text.hpp"
#include "quantities/unit.hpp"

namespace dashpad::input {

namespace {

/// Parts of names, in lower case.
constexpr std::array strain_words{"strain",      "dehnung",     "stauchung",    "déformation", "deformation",
                                  "deformación", "deformacion", "deformazione", "verformung",  "epsilon"};
constexpr std::array displacement_words{"disp",           "extension",   "deflection", "travel",
                                        "stroke",         "crosshead",   "weg",        "traverse",
                                        "déplacement",    "deplacement", "course",     "corsa",
                                        "desplazamiento", "spostamento", "position",   "distance"};
constexpr std::array stress_words{"stress", "spannung", "contrainte", "esfuerzo", "tensión",
                                  "sforzo", "tensione", "sigma",      "pressure", "druck"};
constexpr std::array force_words{"force",  "load",  "kraft", "last",  "charge",
                                 "fuerza", "carga", "forza", "carico"};

/// Of rates, of true stresses and strains, and of what a machine was told to do.
constexpr std::array words_of_others{"rate", "true",     "soll",     "setpoint", "set point", "command",
                                     "cmd",  "consigne", "consigna", "comando",  "demand",    "target"};

bool holds_any(const std::string& name, const auto& words) {
  return std::ranges::any_of(words,
                             [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

bool is_unit_of_strain(const std::string& unit) {
  return !unit.empty() && (units_in_strain_one(unit) || unit == "mm/mm" || unit == "m/m" || unit == "in/in");
}

bool is_any_unit(const std::string& unit) {
  const UnitMatch match = unit_factor(tidy_unit(unit), "Pa").match;
  return is_unit_of_strain(unit) || match == UnitMatch::same_dimension || match == UnitMatch::other_dimension;
}

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
    const std::string inside = inside_brackets(std::string_view(header).substr(open));
    if (!unit_below.empty() && !is_any_unit(inside)) return parts;  // "Compressive strain (Extension)"
    parts.name = lower_case(without_blanks(std::string_view(header).substr(0, open)));
    parts.of.unit = inside;
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
TestKind kind_of(const TestColumn& column) {
  const std::string &name = column.name, &unit = column.of.unit;
  if (holds_any(name, words_of_others)) return TestKind::other;
  const bool is_strain = holds_any(name, strain_words), moves = holds_any(name, displacement_words);
  if (is_unit_of_dimension(unit, "m")) return is_strain || moves ? TestKind::displacement : TestKind::other;
  if (is_unit_of_dimension(unit, "N")) return TestKind::force;
  if (is_unit_of_dimension(unit, "Pa")) return TestKind::stress;
  if (is_unit_of_dimension(unit, "s")) return TestKind::time;
  if (is_strain && (unit.empty() || is_unit_of_strain(unit))) return TestKind::strain;
  if (!unit.empty() && is_unit_of_strain(unit) && (moves || name == "e" || name == "compression"))
    return TestKind::strain;
  if (holds_any(name, stress_words)) return TestKind::stress;
  if (unit.empty() && moves) return TestKind::displacement;
  if (unit.empty() && holds_any(name, force_words)) return TestKind::force;
  return looks_like(ColumnKind::time, column.of) ? TestKind::time : TestKind::other;
}

std::vector<TestColumn> columns_of(const CsvHeader::Row& names, const CsvHeader::Row* units) {
  std::vector<TestColumn> all;
  for (std::size_t i = 0; i < names.fields.size(); ++i) {
    const injury::MeasuredColumn column{
        .name = names.fields[i].empty() ? fmt::format("column {}", i + 1) : quoted_part(names.fields[i]),
        .number = static_cast<int>(i + 1)};
    TestColumn parts =
        parts_of(column, units && i < units->fields.size() ? inside_brackets(units->fields[i]) : "");
    if (holds_any(parts.name, force_words)) parts.of.unit = unit_of_weight(parts.of.unit);
    parts.kind = kind_of(parts);
    all.push_back(std::move(parts));
  }
  return all;
}

/// Whether a row below names has units: most of its fields, and no number.
bool has_units(const CsvHeader::Row& row) {
  const auto is_unit = [](const std::string& field) { return is_any_unit(inside_brackets(field)); };
  const auto units = std::ranges::count_if(row.fields, is_unit);
  const auto empty =
      std::ranges::count_if(row.fields, [](const std::string& field) { return field.empty(); });
  return units > 0 && 2 * (units + empty) >= std::ssize(row.fields) &&
         std::ranges::none_of(row.fields, [&](const std::string& field) {
           return reads_as_number(field) && !is_unit(field);  // 1 is a unit of strain
         });
}

}  // namespace

std::vector<TestColumn> named_test_columns(const CsvHeader& header, std::size_t& line) {
  std::vector<TestColumn> best;
  std::pair<std::ptrdiff_t, std::ptrdiff_t> most{-1, 0};  // known names; numbers among them, negative
  for (std::size_t i = 0; i < header.rows.size(); ++i) {
    const CsvHeader::Row& names = header.rows[i];
    if (names.fields.size() < std::min<std::size_t>(header.width, 2)) continue;
    const auto is_unit = [](const std::string& field) {
      return field.empty() || is_any_unit(inside_brackets(field));
    };
    if (std::ranges::all_of(names.fields, is_unit) && i > 0) continue;
    const CsvHeader::Row* const below = i + 1 < header.rows.size() ? &header.rows[i + 1] : nullptr;
    std::vector<TestColumn> all = columns_of(names, below && has_units(*below) ? below : nullptr);
    const std::pair own{
        std::ranges::count_if(all, [](const TestColumn& column) { return column.kind != TestKind::other; }),
        -std::ranges::count_if(names.fields, reads_as_number)};
    if (own < most) continue;
    most = own;
    best = std::move(all);
    line = names.line;
  }
  return best;
}

std::string unit_of_weight(const std::string& unit) {
  std::string name = lower_case(unit);
  for (const auto& [word, letter] :
       {std::pair("kilogram", "kg"), std::pair("gram", "g"), std::pair("pound", "lb")})
    if (name == word || name == std::string(word) + 's') name = letter;
  if (name == "lbs") name = "lb";
  return is_unit_of_dimension(unit, "kg") && is_unit_of_dimension(name + "f", "N") ? name + "f" : unit;
}

bool is_unit_of_dimension(const std::string& unit, const char* si_unit) {
  return !unit.empty() && unit_factor(tidy_unit(unit), si_unit).match == UnitMatch::same_dimension;
}

}  // namespace dashpad::input
