// [unknowns] of a fit file.

#include <algorithm>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/study/application.hpp"
#include "fit/fit_tables.hpp"

namespace dashpad::fit {

using input::Presence;
using input::TableReader;
using input::TomlNode;

namespace {

struct UnknownEntry {
  std::string key;
  const TomlNode* node;
};

/// "pad.curve.modulus" in quotes or as tables within tables.
void collect_unknowns(const TomlNode& table, const std::string& prefix, std::vector<UnknownEntry>& entries) {
  for (const TomlNode& child : table.children) {
    const std::string key = prefix + child.key;
    const bool holds_tables =
        child.kind == TomlNode::Kind::table && !child.children.empty() &&
        std::ranges::all_of(child.children,
                            [](const TomlNode& of) { return of.kind == TomlNode::Kind::table; }) &&
        child.child("prior") == nullptr;
    if (holds_tables)
      collect_unknowns(child, key + ".", entries);
    else
      entries.push_back({key, &child});
  }
}

/// "log" where both bounds are positive and more than a factor 10 apart, if nothing is said.
bool read_is_logarithmic(TableReader& table, const Unknown& unknown) {
  if (!table.has("scale")) return unknown.lowest > 0 && unknown.highest > 10 * unknown.lowest;
  return table.choice("scale", {"log", "linear"}) == "log";
}

void read_bounds(TableReader& table, Unknown& unknown) {
  unknown.lowest = unknown.highest = no_value;
  const TomlNode* bounds = table.array("bounds");
  if (!bounds) return;
  if (bounds->children.size() != 2) {
    table.fault("bounds", "must be two values, the lower one first, such as [\"1 kPa\", \"1 MPa\"]");
    return;
  }
  const auto bound = [&](std::size_t i) {
    return value_of(bounds->children[i], table.full_key("bounds") + bounds->children[i].key, unknown.unit,
                    table.faults());
  };
  unknown.lowest = bound(0);
  unknown.highest = bound(1);
}

Unknown read_unknown(TableReader& table, const CaseQuantity& quantity, const ImpactCase& base) {
  Unknown unknown;
  unknown.key = quantity.key;
  unknown.unit = quantity.unit;
  read_bounds(table, unknown);
  unknown.start = table.has("start") ? value_in(table, "start", unknown.unit) : quantity.get(base);
  if (auto prior = table.table("prior", Presence::optional)) {
    unknown.prior.emplace();
    unknown.prior->mean = value_in(*prior, "mean", unknown.unit);
    unknown.prior->deviation = value_or_share(*prior, "deviation", unknown.unit, unknown.prior->mean);
    prior->refuse_others();
  }
  unknown.is_logarithmic = read_is_logarithmic(table, unknown);
  table.refuse_others();
  return unknown;
}
}  // namespace

void read_unknowns(TableReader& top, bool has_base, Fit& fit, Lines& lines) {
  const auto table = top.table("unknowns");
  if (!table) return;
  lines["unknowns"] = table->node().line;
  std::vector<UnknownEntry> entries;
  collect_unknowns(table->node(), "", entries);
  const CaseQuantities quantities = quantities_of(fit.base);
  for (const auto& [key, node] : entries) {
    const std::string path = "unknowns." + key;
    for (const char* part : {"", ".bounds", ".start", ".prior", ".scale"}) {
      const TomlNode* own = *part ? node->child(part + 1) : node;
      lines[path + part] = own ? own->line : node->line;
    }
    const CaseQuantity* const found = quantities.find(key);
    if (found == nullptr) {
      const bool on_trust = !has_base && (study::is_of_law(key) || key.starts_with("support."));
      if (!on_trust) top.faults().add(*node, path, study::rule_for_unknown(key, fit.base));
    } else if (node->kind != TomlNode::Kind::table) {
      top.faults().add(*node, path, "must be a table: {bounds = [..., ...]}");
    } else {
      TableReader reader(*node, path, top.faults());
      fit.unknowns.push_back(read_unknown(reader, *found, fit.base));
    }
  }
}

}  // namespace dashpad::fit
