#include "live/shown.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dashpad/input/standard_file.hpp"
#include "dashpad/output/assessment.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/output/materials.hpp"
#include "dashpad/output/text/case.hpp"
#include "input/fault_json.hpp"
#include "input/spelling.hpp"
#include "live/request.hpp"
#include "live/written.hpp"

namespace dashpad::live {

namespace {

/// Faults of some files do not hide the others.
Json with_faults(Json shown, const std::vector<input::Fault>& faults) {
  if (!faults.empty()) shown.update(faults_json(faults));
  return shown;
}

Json list_all_materials(const Json& request, const std::filesystem::path& folder) {
  const auto cards = input::list_materials(folder);
  if (!cards) return faults_json(cards.faults());
  std::vector<Material> materials;
  std::vector<input::Fault> faults;
  Json files = Json::array();
  for (const std::filesystem::path& card : *cards) {
    files.push_back({{"kind", "the material card"}, {"file", card.string()}});
    if (auto material = input::read_material(card))
      materials.push_back(*std::move(material));
    else
      add(material.faults(), faults);
  }
  const auto document = [&](output::Pictures pictures) {
    return output::materials_document(materials, units_of(request), pictures);
  };
  return with_faults({{"heading", fmt::format("Materials in {}:\n", folder.string())},
                      {"files", std::move(files)},
                      {"written", written(request, {.document = document})}},
                     faults);
}

}  // namespace

Json check_case(const Json& request, const Folders& folders) {
  const auto asked = read_asked(request, folders);
  if (!asked) {
    Json refused = faults_json(asked.faults());
    const auto data = [](const input::Fault& fault) { return dashpad::fault_json(fault); };
    refused["written"]["json"] = result_json_text({{"faults", array_of(asked.faults(), data)}});
    return refused;
  }
  std::vector<input::InputFile> files = asked->given.files;
  if (auto standard = standard_file(request, folders)) files.push_back(*std::move(standard));
  const input::CaseFile& given = asked->given;
  return {{"files", array_of(files,
                             [](const input::InputFile& file) {
                               return Json{{"kind", file.kind}, {"file", file.file.string()}};
                             })},
          {"written",
           {{"text", output::checked_case(asked->name, given.impact, given.options, units_of(request))},
            {"json", output::case_json(given.impact, given.options)}}}};
}

Json show_materials(const Json& request, const Folders& folders) {
  const std::string name = text_of(request, "name");
  if (name.empty()) return list_all_materials(request, folders.materials);
  std::filesystem::path card = name;
  if (!name.ends_with(".toml")) {
    const auto cards = input::list_materials(folders.materials);
    if (!cards) return faults_json(cards.faults());
    const auto found = std::ranges::find(
        *cards, name, [](const std::filesystem::path& path) { return path.stem().string(); });
    if (found == cards->end())
      return faults_json(
          input::fault_of_file(name, input::no_such("material", name, folders.materials, *cards)));
    card = *found;
  }
  const auto material = input::read_material(card);
  if (!material) return faults_json(material.faults());
  const auto document = [&](output::Pictures pictures) {
    return output::material_document(*material, units_of(request), pictures);
  };
  return {{"files", {{{"kind", "the material card"}, {"file", card.string()}}}},
          {"written", written(request, {.document = document})}};
}

Json show_standards(const Json& request, const Folders& folders) {
  if (!text_of(request, "standard").empty()) {
    const auto standard = read_standard(request, folders);
    if (!standard) return faults_json(standard.faults());
    const auto document = [&](output::Pictures /*pictures*/) {
      return output::standard_document(**standard, units_of(request));
    };
    const std::string file = standard_file(request, folders)->file.string();
    return {{"files", {{{"kind", "the standard"}, {"file", file}}}},
            {"written", written(request, {.document = document})}};
  }
  const auto files = input::list_standards(folders.standards);
  if (!files) return faults_json(files.faults());
  std::string text = fmt::format("Standards in {}:\n", folders.standards.string());
  std::vector<input::Fault> faults;
  for (const std::filesystem::path& file : *files) {
    if (const auto standard = input::read_standard(file))
      text += output::standard_line(*standard);
    else
      add(standard.faults(), faults);
  }
  return with_faults({{"written", {{"text", text}}}}, faults);
}

}  // namespace dashpad::live
