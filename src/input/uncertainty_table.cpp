#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "input/law_table.hpp"
#include "input/number_list.hpp"
#include "input/spelling.hpp"

namespace dashpad::input {
namespace {

/// Two numbers, the lower first; which values are admitted says violations(Material).
std::optional<ValueRange> read_range(TableReader& table, const std::string& key) {
  if (!table.has(key)) return std::nullopt;
  const auto values = read_numbers(table, key);
  if (!values) return std::nullopt;
  if (values->size() != 2) {
    table.fault(key, "must be two numbers, the lower first");
    return std::nullopt;
  }
  if (std::isnan(values->front()) || std::isnan(values->back())) return std::nullopt;
  return ValueRange{values->front(), values->back()};
}

std::optional<Misfit> read_misfit(TableReader& table) {
  auto misfit = table.table("misfit", Presence::optional);
  if (!misfit) return std::nullopt;
  Misfit of{.peak_acceleration = misfit->number("peak_acceleration"),
            .hic = misfit->number("hic"),
            .rebound_speed = misfit->number("rebound_speed"),
            .penetration = misfit->number("penetration"),
            .nose_over_pad = {}};
  const double impacts = misfit->number("impacts");
  if (impacts >= 1 && impacts <= 1e6 && impacts == std::floor(impacts))
    of.impacts = static_cast<int>(impacts);
  else if (!std::isnan(impacts))
    misfit->fault("impacts", "must be a whole number, 1 or more");
  of.is_held_out = misfit->has("held_out") && misfit->yes_or_no("held_out");
  if (misfit->has("nose_over_pad")) of.nose_over_pad = misfit->number("nose_over_pad");
  misfit->refuse_others();
  return of;
}

/// The numbers of a law by the keys of its card.
std::vector<std::string> keys_of(const PadLaw& law) {
  ImpactCase of;
  of.pad.material.law = law;
  std::vector<std::string> keys;
  for (const CaseQuantity& quantity : quantities_of(of))
    for (const char* group : {"pad.parameters.", "pad.curve.", "pad.rate."})
      if (quantity.key.starts_with(group)) keys.push_back(quantity.key.substr(std::string("pad.").size()));
  return keys;
}

std::vector<std::string> read_keys(TableReader& table, const PadLaw& law) {
  std::vector<std::string> keys;
  const TomlNode* list = table.array("keys");
  if (!list) return keys;
  const std::vector<std::string> known = keys_of(law);
  for (const TomlNode& entry : list->children) {
    if (entry.kind != TomlNode::Kind::text || !std::ranges::count(known, entry.text))
      table.faults().add(entry, table.full_key("keys") + entry.key,
                         "must be a number of this law" + did_you_mean(entry.text, known));
    keys.push_back(entry.text);
  }
  return keys;
}

std::vector<std::vector<double>> read_rows(TableReader& table, const std::string& key) {
  std::vector<std::vector<double>> rows;
  const TomlNode* list = table.array(key);
  if (!list) return rows;
  for (const TomlNode& row : list->children) {
    rows.emplace_back();
    const auto add_fault = [&](const TomlNode& of, const std::string& rule) {
      table.faults().add(of, table.full_key(key) + row.key, rule);
    };
    if (row.kind != TomlNode::Kind::array) add_fault(row, "must be a list of numbers, one for each of keys");
    for (const TomlNode& entry : row.children)
      if (entry.kind == TomlNode::Kind::number && std::isfinite(entry.number))
        rows.back().push_back(entry.number);
      else
        add_fault(entry, "must be a number");
  }
  return rows;
}

PosteriorAxes read_posterior(TableReader& table, const PadLaw& law) {
  auto posterior = table.table("posterior", Presence::optional);
  if (!posterior) return {};
  PosteriorAxes axes{.keys = read_keys(*posterior, law),
                     .minus = read_rows(*posterior, "minus"),
                     .plus = read_rows(*posterior, "plus")};
  posterior->refuse_others();
  return axes;
}

}  // namespace

Uncertainty read_uncertainty(TableReader& table, const PadLaw& law) {
  auto of = table.table("uncertainty", Presence::optional);
  if (!of) return {};
  Uncertainty uncertainty{.recoil = read_range(*of, "recoil"),
                          .unloading_factor = read_range(*of, "unloading_factor"),
                          .lag_strain = read_range(*of, "lag_strain"),
                          .rate_exponent = read_range(*of, "rate_exponent"),
                          .scatter = {},
                          .misfit = read_misfit(*of),
                          .posterior = read_posterior(*of, law)};
  if (of->has("scatter")) uncertainty.scatter = of->number("scatter");
  of->refuse_others();
  return uncertainty;
}

}  // namespace dashpad::input
