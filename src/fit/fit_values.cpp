// Values in the tables of fit files.

#include <cmath>

#include "dashpad/quantities/constants.hpp"
#include "fit/fit_tables.hpp"

namespace dashpad::fit {

using input::TableReader;
using input::TomlNode;

double value_of(const TomlNode& node, const std::string& key, const std::string& unit,
                input::FaultList& faults) {
  if (unit == "m/s2" && node.kind == TomlNode::Kind::text && node.text.ends_with(" g")) {
    // In files g is the gram; of an acceleration it is standard gravity.
    TomlNode with_gravity = node;
    with_gravity.text.replace(node.text.size() - 1, 1, "gravity");
    return read_quantity(with_gravity, key, unit, faults);
  }
  if (unit != "1") return read_quantity(node, key, unit, faults);
  if (node.kind == TomlNode::Kind::number && std::isfinite(node.number)) return node.number;
  faults.add(node, key, "must be a plain number, without quotes and unit");
  return no_value;
}

double value_in(TableReader& table, const std::string& key, const std::string& unit) {
  if (!table.has(key)) {
    table.fault(key, "is missing");
    return no_value;
  }
  return value_of(*table.node().child(key), table.full_key(key), unit, table.faults());
}

double value_or_share(TableReader& table, const std::string& key, const std::string& unit, double whole) {
  if (!table.has(key)) {
    table.fault(key, "is missing");
    return no_value;
  }
  const TomlNode& node = *table.node().child(key);
  if (node.kind == TomlNode::Kind::text && node.text.ends_with('%'))
    return table.quantity(key, "1") * std::abs(whole);
  return value_of(node, table.full_key(key), unit, table.faults());
}

bool flag_in(TableReader& table, const std::string& key) {
  if (!table.has(key)) return false;
  const std::string written = table.node().child(key)->written();
  if (written != "true" && written != "false") table.fault(key, "must be true or false");
  return written == "true";
}

}  // namespace dashpad::fit
