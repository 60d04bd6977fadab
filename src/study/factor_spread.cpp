// The spread of a factor: levels, distributions, measured values.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/input/fault.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "input/measurement/csv_table.hpp"
#include "input/measurement/measurement_text.hpp"
#include "input/spelling.hpp"
#include "study/factor_spread.hpp"

namespace dashpad::study {

namespace {

constexpr std::size_t max_values = 1'000'000;

struct Column {
  std::size_t place = 0;
  std::size_t width = 1;  ///< columns of the header
  std::string name;
  double factor = 1;
};

/// The factor from the unit of a header to SI.
double unit_factor(const std::string& written, const std::string& unit, const Column& column,
                   std::size_t line, input::MeasurementFaults& faults) {
  if (unit == "1") {
    if (written.empty() || written == "1" || written == "-") return 1;
    faults.add(line, column.name, written, "must have no unit, since it is a pure number");
    return 1;
  }
  if (written.empty()) {
    faults.add(line, column.name, "",
               "the header must give the unit in brackets, such as [" +
                   examples_of_units(unit).substr(0, examples_of_units(unit).find(',')) + "]");
    return 1;
  }
  const auto [factor, rule] = read_si("1 " + written, unit);
  if (rule.empty()) return factor;
  faults.add(line, column.name, written, rule);
  return 1;
}

Column choose(const input::CsvRow& header, const std::string& wanted, const std::string& unit,
              input::MeasurementFaults& faults) {
  std::vector<std::string> names, titles;
  for (const std::string_view field : header.fields) {
    titles.push_back(input::to_utf8(input::without_blanks(field)));
    names.push_back(input::split_header(titles.back()).name);
  }
  std::size_t place = 0;
  if (!wanted.empty()) {
    while (place < names.size() && names[place] != wanted && titles[place] != wanted) ++place;
    if (place == names.size())
      faults.refuse(
          header.line, "", wanted,
          "no such column; available: " + input::listing(titles) + input::did_you_mean(wanted, names));
  } else if (header.filled() > 1) {
    faults.refuse(
        header.line, "", "",
        "has several columns; choose one with column = \"...\"; available: " + input::listing(titles));
  }
  if (input::read_number(titles[place]).kind == input::NumberKind::number)
    faults.refuse(header.line, "", titles[place], "needs a header line that names the column and its unit");
  Column column{place, header.fields.size(), titles[place], 1};
  column.factor = unit_factor(input::split_header(titles[place]).unit, unit, column, header.line, faults);
  return column;
}

constexpr double max_levels = 1e6;

Levels read_values(input::TableReader& table, const std::string& unit) {
  Levels levels;
  const input::TomlNode* list = table.array("values");
  if (!list) return levels;
  if (list->children.empty()) table.fault("values", "must have at least one value");
  for (const input::TomlNode& entry : list->children)
    levels.values.push_back(
        input::read_value(entry, table.full_key("values") + entry.key, unit, table.faults()));
  return levels;
}

/// Reads a range whose ends are both exact.
Levels read_range(input::TableReader& table, const std::string& unit) {
  const double from = table.value("from", unit), to = table.value("to", unit);
  const auto count = static_cast<std::size_t>(table.whole_number("count", 2, max_levels).value_or(0));
  const bool logarithmic =
      table.has("spacing") && table.choice("spacing", {"linear", "logarithmic"}) == "logarithmic";
  if (from == to) table.fault("to", "must differ from the value of from");
  const bool possible = !logarithmic || (!(from <= 0) && !(to <= 0));
  if (!possible) table.fault("spacing", "both ends of a logarithmic range must be more than 0");
  Levels levels;
  if (!(std::isfinite(from) && std::isfinite(to)) || !possible) return levels;
  for (std::size_t i = 0; i < count; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(count - 1);
    levels.values.push_back(i + 1 == count ? to
                            : logarithmic  ? from * std::pow(to / from, part)
                                           : from + (to - from) * part);
  }
  return levels;
}

Empirical read_measured(input::TableReader& table, const std::string& unit, const input::Folders& folders) {
  const std::string file = table.text("file");
  const std::string column = table.text("column", input::Presence::optional);
  if (file.empty()) return {};
  input::Reading<std::vector<double>> values = read_empirical(folders.of_file / file, column, unit);
  if (!values) table.fault("file", "cannot be used; see the errors in it");
  return {table.faults().take(std::move(values)).value_or(std::vector<double>())};
}

/// An amount, or a share of the mean: "5 %".
double read_deviation(input::TableReader& table, double mean, const std::string& unit) {
  const input::TomlNode* entry = table.has("deviation") ? table.node().child("deviation") : nullptr;
  const bool is_share = entry && entry->kind == input::TomlNode::Kind::text && entry->text.ends_with('%');
  // A share of a temperature in K or of a strain would be read in two ways; of other units it says one thing.
  if (is_share && unit != "K") return std::abs(mean) * table.quantity("deviation", "1");
  return table.value("deviation", unit);
}

Spread read_distribution(input::TableReader& table, const std::string& unit, const input::Folders& folders) {
  const std::string kind =
      table.choice("distribution", {"normal", "lognormal", "uniform", "triangular", "empirical"});
  const auto value = [&](const char* key) { return table.value(key, unit); };
  if (kind == "normal") {
    const double mean = value("mean");
    return Normal{mean, read_deviation(table, mean, unit)};
  }
  if (kind == "lognormal") {
    const double median = value("median");
    return Lognormal{median, table.number("spread")};
  }
  if (kind == "uniform") return Uniform{value("low"), value("high")};
  if (kind == "triangular") return Triangular{value("low"), value("mode"), value("high")};
  if (kind == "empirical") return read_measured(table, unit, folders);
  return Normal{};  // a fault is there
}

}  // namespace

input::Reading<std::vector<double>> read_empirical(const std::filesystem::path& file,
                                                   const std::string& column, const std::string& unit) {
  return input::reading_of([&]() -> std::vector<double> {
    input::MeasurementFaults faults(file.string());
    const std::string content = input::read_measurement(file);
    const std::string_view text = input::text_in(content, faults);
    const char separator = input::header_separator(text);
    input::CsvRows rows(text, separator);
    input::CsvRow row;
    if (!rows.next(row)) faults.refuse(0, "", "", "is empty");
    const Column chosen = choose(row, column, unit, faults);
    std::vector<double> values;
    while (rows.next(row)) {
      const bool there = chosen.place < row.fields.size();
      const std::string_view field =
          there ? input::without_blanks(row.fields[chosen.place]) : std::string_view();
      const input::ReadNumber read = input::read_csv_number(field);
      if (!row.fault.empty())
        faults.add(row.line, "", "", std::string(row.fault));
      else if (row.filled() > chosen.width)
        faults.add(row.line, "", "", "has more fields than the header");
      else if (read.kind != input::NumberKind::number)
        faults.add(row.line, chosen.name, field, input::rule_for(read.kind));
      else
        values.push_back(read.value * chosen.factor);
      if (values.size() > max_values)
        faults.refuse(row.line, "", "", fmt::format("has more than {} values", max_values));
    }
    faults.throw_if_any();
    std::ranges::sort(values);
    return values;
  });
}

Spread read_spread(input::TableReader& table, const std::string& unit, const input::Folders& folders) {
  const bool values = table.has("values"), range = table.has("from") || table.has("to") || table.has("count");
  const bool distribution = table.has("distribution");
  if (int{values} + int{range} + int{distribution} != 1) {
    table.faults().add(table.node().line, table.full_key("values"), "",
                       "give one of these: values = [...]; from, to and count; or distribution");
    return Levels{};
  }
  if (values) return read_values(table, unit);
  if (range) return read_range(table, unit);
  return read_distribution(table, unit, folders);
}

}  // namespace dashpad::study
