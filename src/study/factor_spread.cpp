#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/input/fault.hpp"
#include "study/factor_table.hpp"

namespace dashpad::study {
namespace {

constexpr double most_levels = 1e6;

double read_entry(const input::TomlNode& entry, const std::string& key, const std::string& unit,
                  input::FaultList& faults) {
  if (unit != "1") return input::read_quantity(entry, key, unit, faults);
  if (entry.kind == input::TomlNode::Kind::number && std::isfinite(entry.number)) return entry.number;
  faults.add(entry, key, "must be a finite plain number, without quotes and unit");
  return std::nan("");
}

Levels read_values(input::TableReader& table, const std::string& unit) {
  Levels levels;
  const input::TomlNode* list = table.array("values");
  if (!list) return levels;
  if (list->children.empty()) table.fault("values", "must hold one value or more");
  for (const input::TomlNode& entry : list->children)
    levels.values.push_back(read_entry(entry, table.full_key("values") + entry.key, unit, table.faults()));
  return levels;
}

/// 0 after a fault.
std::size_t read_count(input::TableReader& table) {
  const double count = table.number("count");
  if (count >= 2 && count <= most_levels && count == std::floor(count))
    return static_cast<std::size_t>(count);
  if (!std::isnan(count))
    table.fault("count", fmt::format("must be a whole number from 2 to {:.0f}", most_levels));
  return 0;
}

/// Both ends are exact.
Levels read_range(input::TableReader& table, const std::string& unit) {
  const double from = read_value(table, "from", unit), to = read_value(table, "to", unit);
  const std::size_t count = read_count(table);
  const bool logarithmic =
      table.has("spacing") && table.choice("spacing", {"linear", "logarithmic"}) == "logarithmic";
  if (from == to) table.fault("to", "must differ from the value of from");
  const bool possible = !logarithmic || (!(from <= 0) && !(to <= 0));
  if (!possible) table.fault("spacing", "a logarithmic range needs two ends that are more than 0");
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

Empirical read_measured(input::TableReader& table, const std::string& unit, const FactorFolders& folders) {
  const std::string file = table.text("file");
  const std::string column = table.text("column", input::Presence::optional);
  if (file.empty()) return {};
  input::Reading<std::vector<double>> values = read_empirical(folders.of_study / file, column, unit);
  if (!values) table.fault("file", "cannot be used; see its faults");
  return {table.faults().take(std::move(values)).value_or(std::vector<double>())};
}

/// An amount, or a share of the mean: "5 %".
double read_deviation(input::TableReader& table, double mean, const std::string& unit) {
  const input::TomlNode* entry = table.has("deviation") ? table.node().child("deviation") : nullptr;
  const bool is_share = entry && entry->kind == input::TomlNode::Kind::text && entry->text.ends_with('%');
  // A share of a temperature in K or of a strain would be read in two ways; of other units it says one thing.
  if (is_share && unit != "K") return std::abs(mean) * table.quantity("deviation", "1");
  return read_value(table, "deviation", unit);
}

Spread read_distribution(input::TableReader& table, const std::string& unit, const FactorFolders& folders) {
  const std::string kind =
      table.choice("distribution", {"normal", "lognormal", "uniform", "triangular", "empirical"});
  const auto value = [&](const char* key) { return read_value(table, key, unit); };
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

double read_value(input::TableReader& table, const std::string& key, const std::string& unit) {
  return unit == "1" ? table.number(key) : table.quantity(key, unit);
}

Spread read_spread(input::TableReader& table, const std::string& unit, const FactorFolders& folders) {
  const bool values = table.has("values"), range = table.has("from") || table.has("to") || table.has("count");
  const bool distribution = table.has("distribution");
  if (int{values} + int{range} + int{distribution} != 1) {
    table.faults().add(table.node().line, table.full_key("values"), "",
                       "give one of: values = [...]; from, to and count; distribution");
    return Levels{};
  }
  if (values) return read_values(table, unit);
  if (range) return read_range(table, unit);
  return read_distribution(table, unit, folders);
}

}  // namespace dashpad::study
