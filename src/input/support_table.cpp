#include "input/support_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "input/parameter_table.hpp"

namespace dashpad::input {
namespace {

constexpr std::size_t most_points = 10'000;

Support read_linear(TableReader& table) {
  const double stiffness = table.quantity("stiffness", "N/m");
  if (stiffness > 0) return Support::linear(stiffness);
  if (stiffness <= 0) table.fault("stiffness", "must be more than 0");
  return Support::rigid();
}

/// Reports a coordinate that does not exceed that of the point before.
bool increases(double from, double to, const TomlNode& node, const std::string& key, std::string_view name,
               FaultList& faults) {
  if (to <= from)
    faults.add(node, key,
               fmt::format("the {} must be more than {}", name, from > 0 ? "that of the point before" : "0"));
  return to > from;
}

Support read_curve(TableReader& table) {
  const TomlNode* points = table.array("points");
  if (!points) return Support::rigid();
  if (points->children.empty() || points->children.size() > most_points) {
    table.fault("points", fmt::format("must have between 1 and {} points", most_points));
    return Support::rigid();
  }
  bool good = true;
  Support::Point before;
  std::vector<Support::Point> curve;
  for (const TomlNode& node : points->children) {
    const std::string key = table.full_key("points") + node.key;
    if (node.kind != TomlNode::Kind::array || node.children.size() != 2) {
      table.faults().add(node, key, "a point is a deflection and a force, such as [\"0.1 in\", \"100 lbf\"]");
      good = false;
      continue;
    }
    const TomlNode& deflection = node.children[0];
    const TomlNode& force = node.children[1];
    const Support::Point point{read_quantity(deflection, key, "m", table.faults()),
                               read_quantity(force, key, "N", table.faults())};
    good &= increases(before.deflection, point.deflection, deflection, key, "deflection", table.faults());
    good &= increases(before.force, point.force, force, key, "force", table.faults());
    curve.push_back(point);
    before = point;
  }
  return good ? Support::through(curve) : Support::rigid();
}

}  // namespace

SupportEntry read_support(TableReader& table) {
  const std::size_t faults = table.faults().size();
  const std::string type = table.choice("type", {"rigid", "linear", "curve"});
  if (type.empty()) return {.is_known = false};
  Support support = type == "linear"  ? read_linear(table)
                    : type == "curve" ? read_curve(table)
                                      : Support::rigid();
  const Backing backing = read_parameters<Backing>(table);
  for (const double Backing::*mass : {&Backing::mass, &Backing::body_mass}) {
    const char* const key = mass == &Backing::mass ? "mass" : "body_mass";
    if (table.has(key) && backing.*mass == 0)
      table.fault(key, "must be more than 0; without one, leave the key out");
  }
  table.refuse_others();
  return {std::move(support), backing, table.faults().size() == faults};
}

}  // namespace dashpad::input
