#include <algorithm>

#include "dashpad/input/case_file.hpp"
#include "input/disk.hpp"
#include "input/law_table.hpp"
#include "input/number_list.hpp"

namespace dashpad::input {
namespace {

constexpr std::size_t most_also_published = 100;
constexpr std::size_t most_temperatures = 2000;
constexpr double most_density = 20'000;  // kg/m3

std::vector<std::pair<std::string, std::string>> read_also_published(TableReader& card) {
  std::vector<std::pair<std::string, std::string>> values;
  auto table = card.table("also_published", Presence::optional);
  if (!table) return values;
  if (table->node().children.size() > most_also_published) {
    card.fault("also_published", "holds more than 100 values");
    return values;
  }
  for (const TomlNode& entry : table->node().children) values.emplace_back(entry.key, table->text(entry.key));
  return values;
}

std::optional<double> read_density(TableReader& card) {
  const double density = card.quantity("density", "kg/m3");
  if (density > 0 && density <= most_density) return density;
  if (density == density) card.fault("density", "must be more than 0 and at most 20000 kg/m3");
  return std::nullopt;
}

TemperatureTable read_temperatures(TableReader& table) {
  TemperatureTable result;
  result.temperature =
      read_quantities(table, "temperatures", "K", most_temperatures).value_or(std::vector<double>());
  result.factor = read_numbers(table, "factors").value_or(std::vector<double>());
  table.refuse_others();
  return result;
}

/// Of a law that was found from strikes by a sphere.
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
    if (text.kind == TomlNode::Kind::text && !text.text.empty() && all.size() < most_also_published)
      all.push_back(text.text);
    else
      card.faults().add(text, "reservations" + text.key, "must be a text, one of at most 100");
  return all;
}

}  // namespace

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
