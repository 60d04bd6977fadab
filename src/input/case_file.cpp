#include "dashpad/input/case_file.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/quantities/constants.hpp"
#include "input/case_tables.hpp"
#include "input/disk.hpp"
#include "input/spelling.hpp"
#include "input/table_reader.hpp"
#include "model/pad/layer/layer_law.hpp"

namespace dashpad::input {
namespace {

/// Numbers of a case that it states in another way, such as a mass by a weight.
using OtherValues = std::vector<std::pair<const OtherWay*, double>>;

/// Whether a table states the number `key` in another way, which is then added to `others`; true as well if
/// it states both ways or neither, which is at fault.
bool states_otherwise(TableReader& table, const std::string& key, OtherValues& others) {
  const auto way = std::ranges::find(other_ways(), table.full_key(key), &OtherWay::instead_of);
  if (way == other_ways().end()) return false;
  const std::string other = std::string(way->key).substr(table.full_key("").size());
  const bool is_given = table.has(key);
  if (!table.has(other)) {
    if (!is_given) table.fault(key, way->rule_if_missing);
    return !is_given;
  }
  const double value = is_given ? no_value : table.value(other, way->unit);
  if (is_given)
    table.fault(other, fmt::format("give {} or {}, not both", key, other));
  else if (!std::isnan(value) && !way->bounds.contain(value))
    table.fault(other, rule_of(way->bounds, way->unit));
  else
    others.emplace_back(&*way, value);
  return true;
}

void read_impactor(TableReader& table, const std::filesystem::path& folder, std::vector<InputFile>& files,
                   ImpactCase& impact) {
  Impactor& impactor = impact.impactor;
  OtherValues others;
  for (const Parameter<Impactor>& parameter : Impactor::parameters) {
    if (!states_otherwise(table, parameter.key, others)) read_parameter(table, parameter, impactor);
    // Messages name the keys in this order.
    if (parameter.member == &Impactor::mass) impactor.nose = read_nose(table, folder, files);
  }
  // An impactor that falls also presses on the pad by its weight.
  if (table.has("drop_height") && !table.has("gravity")) impactor.gravity = standard_gravity;
  if (table.has("drop_height") && impactor.gravity == 0)
    table.fault("drop_height", "a fall needs gravity, which is 0 in this case; give a speed instead");
  for (const auto& [way, value] : others) way->set(impact, value);
  table.refuse_others();
}

bool is_card_name(std::string_view name) {
  return std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '_' || c == '-';
  });
}

std::optional<std::filesystem::path> find_card(TableReader& pad, const Folders& folders) {
  const std::string name = pad.text("material");
  if (name.empty()) return std::nullopt;
  if (name.ends_with(".toml")) return pad.file("material", folders.of_file);
  if (!is_card_name(name)) {
    const auto cards = list_materials(folders.materials);
    pad.fault("material", "must be the name of a card (letters, digits, . _ -) or a path that ends in .toml" +
                              (cards ? did_you_mean(name, names_of(*cards)) : ""));
    return std::nullopt;
  }
  const auto card = folders.materials / (name + ".toml");
  if (is_there(card)) return card;
  if (const auto cards = pad.faults().take(list_materials(folders.materials)))
    pad.fault("material", no_such("card", name, folders.materials, *cards));
  return std::nullopt;
}

std::optional<Material> read_material_in_line(TableReader& pad) {
  const auto law = read_law(pad);
  const auto fitted = read_fitted(pad);
  Uncertainty uncertainty = read_uncertainty(pad, law.value_or(PadLaw()));
  if (!law) return std::nullopt;
  Material material;
  material.name = foam_of_the_case;
  material.law = *law;
  material.fitted = fitted;
  material.uncertainty = std::move(uncertainty);
  return material;
}

/// A material in a case, with its condition.
struct MaterialEntry {
  Material material;
  PadCondition condition;
  bool to_check = false;  ///< given in the case itself
};

struct PadEntry {
  Pad pad;
  std::vector<MaterialEntry> materials;  ///< of the pad, or one per layer
  std::vector<std::filesystem::path> cards;
  bool states_neighbours = false;
};

/// `table`: [pad] or a layer of it.
MaterialEntry read_material_entry(TableReader& table, const Folders& folders,
                                  std::vector<std::filesystem::path>& cards) {
  MaterialEntry entry;
  PadMaterial pad_material = read_pad_material(table, folders);
  if (pad_material.card && !std::ranges::count(cards, *pad_material.card))
    cards.push_back(*pad_material.card);
  entry.to_check = pad_material.is_in_line && pad_material.material.has_value();
  entry.material = std::move(pad_material.material).value_or(Material());
  entry.condition = read_parameters<PadCondition>(table);
  return entry;
}

void refuse_beside_layers(TableReader& table) {
  if (table.has("thickness")) table.fault("thickness", "must be left out; the layers determine it");
  const auto refuse = [&](const char* key) {
    if (table.has(key)) table.fault(key, "must be left out, since each layer has its own");
  };
  for (const char* key :
       {"material", "law", "parameters", "curve", "rate", "unloading", "fitted", "uncertainty"})
    refuse(key);
  for (const Parameter<PadCondition>& parameter : PadCondition::parameters) refuse(parameter.key);
}

void read_layers(TableReader& table, const Folders& folders, PadEntry& into) {
  refuse_beside_layers(table);
  const TomlNode* nodes = table.array("layers");
  if (!nodes) return;
  if (nodes->children.empty() || nodes->children.size() > max_layers) {
    table.fault("layers", fmt::format("must have 1 to {} layers, each under [[pad.layers]]", max_layers));
    return;
  }
  std::vector<PadLayer> layers;
  table.each_table("layers", *nodes, [&](TableReader& layer) {
    layers.push_back(read_parameters<PadLayer>(layer));
    into.materials.push_back(read_material_entry(layer, folders, into.cards));
    layer.refuse_others();
    layers.back().material = into.materials.back().material;
    layers.back().condition = into.materials.back().condition;
  });
  set_layers(into.pad, std::move(layers));
}

Floor read_floor(TableReader& table) {
  std::vector<std::string> names;
  for (const Floor floor : floors) names.push_back(name_of(floor));
  return floor_named(table.choice("floor", names)).value_or(Floor::bonded);
}

PadEntry read_pad(TableReader& table, const Folders& folders) {
  PadEntry entry;
  for (const Parameter<Pad>& parameter : Pad::parameters)
    if (parameter.member != &Pad::thickness) read_parameter(table, parameter, entry.pad);
  if (table.has("floor")) entry.pad.floor = read_floor(table);
  if (table.has("layers")) {
    read_layers(table, folders, entry);
  } else {
    read_parameter(table, Pad::parameters[0], entry.pad);
    entry.materials = {read_material_entry(table, folders, entry.cards)};
    entry.pad.material = entry.materials.front().material;
    entry.pad.condition = entry.materials.front().condition;
  }
  entry.states_neighbours = table.has("neighbours");
  if (!entry.states_neighbours) entry.pad.neighbours = nominal_neighbours(entry.pad);
  table.refuse_others();
  return entry;
}

Options read_options(TableReader& table) {
  const auto options = read_parameters<Options>(table);
  for (const Parameter<Options>& parameter : Options::parameters)
    if (const double value = parameter.of(options); !std::isnan(value) && !parameter.bounds.contain(value))
      table.fault(parameter.key, *broken_rule(value, parameter.bounds, parameter.unit));
  table.refuse_others();
  return options;
}

/// Whether the key of a broken rule belongs to the case rather than to its card.
bool is_of_case(std::string_view key) {
  const auto has = [&](const auto& parameters) {
    return std::ranges::any_of(parameters, [&](const auto& parameter) { return key == parameter.key; });
  };
  return key == "layers" || has(Pad::parameters) || has(PadCondition::parameters);
}

/// Rules for layers, which for a layer with a card concern the choice of that card.
constexpr std::string_view rules_of_layers[] = {"law", "rate", "unloading"};

/// Drops broken rules that are reported with the card itself, under the keys of [pad] or of a layer.
void drop_faults_of_card(const std::string& prefix, bool is_layer, std::vector<Violation>& broken) {
  std::erase_if(broken, [&](Violation& violation) {
    if (!violation.key.starts_with(prefix)) return false;
    const std::string_view key = std::string_view(violation.key).substr(prefix.size());
    if (is_of_case(key) || key.starts_with("layers[")) return false;
    if (!is_layer || !std::ranges::count(rules_of_layers, key)) return true;
    violation.key = prefix + "material";
    return false;
  });
}

/// The broken rules of a case: numbers by the keys that gave them; materials of cards with their cards.
std::vector<Violation> violations_in_terms_of(const TomlNode& root, const ImpactCase& impact,
                                              const std::vector<MaterialEntry>& materials,
                                              bool support_to_check) {
  std::vector<Violation> broken = violations(impact);
  if (!support_to_check)
    std::erase_if(broken, [](const Violation& violation) { return violation.key.starts_with("support."); });
  const bool is_layered = !impact.pad.layers.empty();
  for (std::size_t i = 0; i < materials.size(); ++i)
    if (!materials[i].to_check)
      drop_faults_of_card(is_layered ? fmt::format("pad.layers[{}].", i + 1) : "pad.", is_layered, broken);
  // Faults of layers were reported when they were read.
  if (materials.empty())
    std::erase_if(broken, [](const Violation& violation) {
      const std::string_view key = violation.key;
      return key.starts_with("pad.") &&
             (!is_of_case(key.substr(4)) || key == "pad.thickness" || key == "pad.earlier_penetration");
    });
  for (Violation& violation : broken)
    for (const OtherWay& way : other_ways())
      if (violation.key == way.instead_of &&
          std::string_view(way.key).ends_with("." + root.nearest(way.key).key)) {
        violation.key = way.key;
        violation.rule = fmt::format("{} {}", way.what_follows, violation.rule);
      }
  return broken;
}

/// Files named in the case are relative to the folder of `file`.
Reading<CaseFile> case_in(TomlFile& toml, const std::filesystem::path& file,
                          const std::filesystem::path& materials, const std::vector<std::string>& settings) {
  FaultList faults(toml);
  const std::vector<LaterSetting> later = put_settings(settings, toml.root, faults);
  TableReader top(toml.root, "", faults);
  CaseFile result;
  result.files.push_back({"the case file", file});
  ImpactCase& impact = result.impact;
  std::vector<MaterialEntry> materials_of_pad;
  impact.title = top.text("title", Presence::optional);
  if (auto table = top.table("impactor")) read_impactor(*table, file.parent_path(), result.files, impact);
  if (auto table = top.table("pad")) {
    PadEntry entry = read_pad(*table, {file.parent_path(), materials});
    impact.pad = std::move(entry.pad);
    result.states_neighbours = entry.states_neighbours;
    materials_of_pad = std::move(entry.materials);
    for (std::filesystem::path& card : entry.cards)
      result.files.push_back({"the material card", std::move(card)});
  }
  bool support_to_check = false;
  if (auto table = top.table("support")) {
    SupportEntry entry = read_support(*table);
    impact.support = std::move(entry.support);
    impact.backing = entry.backing;
    support_to_check = entry.is_known;
  }
  if (auto table = top.table("blows", Presence::optional)) {
    impact.blows = read_parameters<Blows>(*table);
    table->refuse_others();
  }
  if (auto table = top.table("solver", Presence::optional)) result.options = read_options(*table);
  top.refuse_others();

  if (faults.size() == 0) put_later(later, impact, faults);
  faults.add(violations_in_terms_of(toml.root, impact, materials_of_pad, support_to_check));
  return faults.reading(std::move(result));
}

}  // namespace

Reading<CaseFile> read_case_tree(TomlFile& toml, const std::filesystem::path& file,
                                 const std::filesystem::path& materials) {
  return case_in(toml, file, materials, {});
}

PadMaterial read_pad_material(TableReader& pad, const Folders& folders) {
  PadMaterial of;
  const bool named = pad.has("material");
  of.is_in_line = pad.has("law") || pad.has("parameters") || pad.has("curve");
  if (named && of.is_in_line) pad.fault("material", "give a material or a law with parameters, not both");
  if (!named && !of.is_in_line)
    pad.fault("material", "is missing; give the name of a card, or a law with parameters");
  if (named && !of.is_in_line) of.card = find_card(pad, folders);
  if (of.card) of.material = pad.faults().take(read_material(*of.card));
  if (of.is_in_line && !named) of.material = read_material_in_line(pad);
  return of;
}

Reading<CaseFile> read_case(const std::filesystem::path& file, const std::filesystem::path& materials,
                            const std::vector<std::string>& settings) {
  Reading<TomlFile> toml = read_toml(file);
  return toml ? case_in(*toml, file, materials, settings) : toml.faults();
}

Reading<CaseFile> read_case_text(std::string text, const std::filesystem::path& file,
                                 const std::filesystem::path& materials,
                                 const std::vector<std::string>& settings) {
  Reading<TomlFile> toml = read_toml_text(file.string(), std::move(text));
  return toml ? case_in(*toml, file, materials, settings) : toml.faults();
}

}  // namespace dashpad::input
