// Material cards, and the uncertainty of materials.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/input/case_file.hpp"
#include "input/case_tables.hpp"
#include "input/disk.hpp"
#include "input/spelling.hpp"
#include "input/table_reader.hpp"

namespace dashpad::input {

namespace {

/// Reads two numbers; violations(Material) checks their values.
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
  of.is_held_out = misfit->flag("held_out");
  if (misfit->has("nose_over_pad")) of.nose_over_pad = misfit->number("nose_over_pad");
  misfit->refuse_others();
  return of;
}

/// The keys of a law's numbers in a card.
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
                         "must be a numeric parameter of this law" + did_you_mean(entry.text, known));
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
    const auto add_fault = [&](const TomlNode& toml_node, const std::string& rule) {
      table.faults().add(toml_node, table.full_key(key) + row.key, rule);
    };
    if (row.kind != TomlNode::Kind::array) add_fault(row, "must list a number for each entry of \"keys\"");
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

constexpr std::size_t max_also_published = 100;
constexpr std::size_t max_temperatures = 2000;
constexpr double max_density = 20'000;  // kg/m3

std::vector<std::pair<std::string, std::string>> read_also_published(TableReader& card) {
  std::vector<std::pair<std::string, std::string>> values;
  auto table = card.table("also_published", Presence::optional);
  if (!table) return values;
  if (table->node().children.size() > max_also_published) {
    card.fault("also_published", "has more than 100 values");
    return values;
  }
  for (const TomlNode& entry : table->node().children) values.emplace_back(entry.key, table->text(entry.key));
  return values;
}

std::optional<double> read_density(TableReader& card) {
  const double density = card.quantity("density", "kg/m3");
  if (density > 0 && density <= max_density) return density;
  if (density == density) card.fault("density", "must be more than 0 and at most 20000 kg/m3");
  return std::nullopt;
}

TemperatureTable read_temperatures(TableReader& table) {
  TemperatureTable result;
  result.temperature =
      read_quantities(table, "temperatures", "K", max_temperatures).value_or(std::vector<double>());
  result.factor = read_numbers(table, "factors").value_or(std::vector<double>());
  table.refuse_others();
  return result;
}

/// Reads how a law was determined from strikes by a sphere.
double read_strikes(TableReader& table) {
  table.choice("nose", {"sphere"});
  const double radius = table.number("nose_over_pad");
  if (radius <= 0 || radius > 1e6) table.fault("nose_over_pad", "must be more than 0 and at most 1e6");
  table.refuse_others();
  return radius;
}

std::vector<std::string> read_reservations(TableReader& card) {
  std::vector<std::string> all;
  if (!card.has("reservations")) return all;
  const TomlNode* texts = card.array("reservations");
  if (!texts) return all;
  for (const TomlNode& text : texts->children)
    if (text.kind == TomlNode::Kind::text && !text.text.empty() && all.size() < max_also_published)
      all.push_back(text.text);
    else
      card.faults().add(text, "reservations" + text.key, "must be non-empty text (at most 100 entries)");
  return all;
}

}  // namespace

Uncertainty read_uncertainty(TableReader& table, const PadLaw& law) {
  auto node = table.table("uncertainty", Presence::optional);
  if (!node) return {};
  Uncertainty uncertainty{.recoil = read_range(*node, "recoil"),
                          .unloading_factor = read_range(*node, "unloading_factor"),
                          .lag_strain = read_range(*node, "lag_strain"),
                          .rate_exponent = read_range(*node, "rate_exponent"),
                          .scatter = {},
                          .misfit = read_misfit(*node),
                          .posterior = read_posterior(*node, law)};
  if (node->has("scatter")) uncertainty.scatter = node->number("scatter");
  node->refuse_others();
  return uncertainty;
}

Reading<Material> read_material(const std::filesystem::path& file) {
  const Reading<TomlFile> toml = read_toml(file);
  if (!toml) return toml.faults();
  FaultList faults(*toml);
  TableReader card(toml->root, "", faults);
  Material material;
  material.name = file.stem().string();
  material.title = card.text("title");
  material.source = card.text("source");
  if (card.has("basis"))
    material.basis = card.choice("basis", {"test", "datasheet", "solver card", "reconstruction"});
  material.licence = card.text("licence", Presence::optional);
  if (card.has("density")) material.density = read_density(card);
  material.reservations = read_reservations(card);
  if (card.has("density_exponent")) material.density_exponent = card.number("density_exponent");
  if (auto table = card.table("temperature", Presence::optional))
    material.temperature_table = read_temperatures(*table);
  const auto law = read_law(card);
  material.law = law.value_or(PadLaw());
  material.fitted = read_fitted(card);
  if (auto table = card.table("measured_by", Presence::optional))
    material.nose_over_pad = read_strikes(*table);
  material.uncertainty = read_uncertainty(card, material.law);
  material.also_published = read_also_published(card);
  card.refuse_others();

  std::vector<Violation> broken = violations(material);
  if (!law)
    std::erase_if(broken, [](const Violation& violation) { return !violation.key.starts_with("fitted."); });
  faults.add(broken);
  return faults.reading(std::move(material));
}

Reading<std::vector<std::filesystem::path>> list_materials(const std::filesystem::path& folder) {
  return toml_files(folder, "materials");
}

}  // namespace dashpad::input
