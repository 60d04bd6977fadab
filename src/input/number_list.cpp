#include "input/number_list.hpp"

#include <fmt/format.h>

#include <limits>

#include "quantities/magnitude_bounds.hpp"

namespace dashpad::input {
namespace {

constexpr std::size_t most_numbers = 2000;

/// Each by `read`.
template <class Read>
std::optional<std::vector<double>> read_list(TableReader& table, const std::string& key, std::size_t most,
                                             Read&& read) {
  const TomlNode* list = table.array(key);
  if (!list) return std::nullopt;
  if (list->children.size() > most) {
    table.fault(key, fmt::format("has {} entries; {} are the most", list->children.size(), most));
    return std::nullopt;
  }
  std::vector<double> values;
  for (const TomlNode& entry : list->children) values.push_back(read(entry, table.full_key(key) + entry.key));
  return values;
}

}  // namespace

std::optional<std::vector<double>> read_numbers(TableReader& table, const std::string& key, double scale) {
  return read_list(table, key, most_numbers, [&](const TomlNode& entry, const std::string& full) {
    const bool is_number = entry.kind == TomlNode::Kind::number;
    const std::string rule = is_number ? rule_of(stated_magnitudes, entry.number, "1") : "must be a number";
    if (rule.empty()) return scale * entry.number;
    table.faults().add(entry, full, rule);
    return std::numeric_limits<double>::quiet_NaN();
  });
}

std::optional<std::vector<double>> read_quantities(TableReader& table, const std::string& key,
                                                   const std::string& si_unit, std::size_t most) {
  return read_list(table, key, most, [&](const TomlNode& entry, const std::string& full) {
    return read_quantity(entry, full, si_unit, table.faults());
  });
}

}  // namespace dashpad::input
