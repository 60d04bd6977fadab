// The standards that a study file names.

#include "study/study_standards.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "dashpad/injury/standard.hpp"
#include "dashpad/input/standard_file.hpp"

namespace dashpad::study {

namespace {

/// The standard that an entry names, with its variants; absent after a fault.
std::optional<injury::Standard> read_standard(const input::TomlNode& entry, const std::string& key,
                                              const input::Folders& folders,
                                              const std::filesystem::path& presets,
                                              input::FaultList& faults) {
  if (entry.kind != input::TomlNode::Kind::text || entry.text.empty()) {
    faults.add(entry, key, "must be the name of a standard or a .toml file in quotes");
    return std::nullopt;
  }
  const input::StandardChoice choice = input::standard_choice(entry.text);
  input::Reading<std::filesystem::path> file =
      choice.name.ends_with(".toml") ? input::Reading<std::filesystem::path>(folders.of_file / choice.name)
                                     : input::find_standard(choice.name, presets);
  if (!file) {
    faults.add(entry, key, file.faults().front().rule);
    return std::nullopt;
  }
  const auto standard = faults.take(input::read_standard(*file));
  if (!standard) return std::nullopt;
  try {
    return injury::with_variants(*standard, choice.variants);
  } catch (const std::invalid_argument& error) {
    faults.add(entry, key, error.what());
    return std::nullopt;
  }
}

/// Gives the base case the impactor of a standard, which may not contradict an earlier one's, and adds what
/// it limits to the responses.
void apply(const injury::Standard& standard, const input::TomlNode& entry, const std::string& key,
           Study& study, input::FaultList& faults) {
  const Impactor& earlier = study.base.impactor;
  const auto contradicts = [](const injury::StandardValue& value, double used) {
    return value.value && injury::differ(*value.value, used);
  };
  if (!study.standards.empty() &&
      (contradicts(standard.mass, earlier.mass) || contradicts(standard.speed, earlier.speed) ||
       contradicts(standard.radius, sphere_radius(earlier.nose))))
    faults.add(entry, key, "has another impactor than " + study.standards.front() + "; make a study of each");
  study.base = injury::with_impactor_of(standard, study.base);
  for (const injury::Criterion& criterion : standard.criteria) {
    if (criterion.has_level())
      faults.add(entry, key, "limits a time above a level, which studies do not keep");
    else if (!std::ranges::count(study.responses, criterion.quantity->key))
      study.responses.emplace_back(criterion.quantity->key);
  }
  study.standards.push_back(entry.text);
}

}  // namespace

void read_standards(input::TableReader& top, const input::Folders& folders,
                    const std::filesystem::path& presets, Study& study) {
  if (!top.has("standard")) return;
  const input::TomlNode& node = *top.node().child("standard");
  std::vector<std::pair<const input::TomlNode*, std::string>> entries{{&node, "standard"}};
  if (node.kind == input::TomlNode::Kind::array) {
    entries.clear();
    for (const input::TomlNode& entry : node.children) entries.emplace_back(&entry, "standard" + entry.key);
    if (entries.empty()) top.fault("standard", "must name a standard");
  }
  for (const auto& [entry, key] : entries)
    if (const auto standard = read_standard(*entry, key, folders, presets, top.faults()))
      apply(*standard, *entry, key, study, top.faults());
}

}  // namespace dashpad::study
