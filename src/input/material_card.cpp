#include <algorithm>

#include "dashpad/input/case_file.hpp"
#include "input/law_table.hpp"

namespace dashpad::input {
namespace {

constexpr std::size_t most_also_published = 100;

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

}  // namespace

Material read_material(const std::filesystem::path& file) {
  const TomlNode root = read_toml(file);
  FaultList faults(file.string());
  TableReader card(root, "", faults);
  Material material;
  material.name = file.stem().string();
  material.title = card.text("title");
  material.source = card.text("source");
  const auto law = read_law(card);
  material.law = law.value_or(PadLaw());
  material.fitted = read_fitted(card);
  material.also_published = read_also_published(card);
  card.refuse_others();

  std::vector<Violation> broken = violations(material);
  if (!law)
    std::erase_if(broken,
                  [](const Violation& violation) { return violation.key.starts_with("parameters."); });
  faults.add(broken, root);
  faults.throw_if_any();
  return material;
}

std::vector<std::filesystem::path> list_materials(const std::filesystem::path& folder) {
  std::error_code error;
  std::vector<std::filesystem::path> cards;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().extension() == ".toml" && entry->is_regular_file()) cards.push_back(entry->path());
  if (error)
    throw InputError(
        {Fault{folder.string(), 0, "", "", "is not a readable folder of materials: " + error.message()}});
  std::ranges::sort(cards);
  return cards;
}

}  // namespace dashpad::input
