// dashpad materials: all material cards, or one in full.

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/output/materials.hpp"
#include "input/disk.hpp"
#include "input/spelling.hpp"
#include "output_files.hpp"

namespace dashpad::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* materials_footer = R"(Examples:
  dashpad materials                        all cards, one per line
  dashpad materials --picture foams.svg    their loading curves
  dashpad materials vn600                  one card: source, reservations, law, curves, stresses, tested range
  dashpad materials vn600 --report card.html
  dashpad materials ensolite-aac-9 --units us
  dashpad materials ./my-foam.toml         a card from anywhere: a name that ends in .toml is read as a file

The table gives the tested strain and strain rates (1/s), the first reservation, and the number of further
reservations; docs/materials.md describes the origin of each card. A picture can be .svg, .png or .pdf. An existing
file is not overwritten unless --force is given.

Exit codes: 0 success, 1 the picture could not be written, 2 no such card, or a card with errors (the other cards
are still listed, but not drawn).)";

struct MaterialsRequest {
  std::string name;
  OutputFiles files;
  std::string folder;
};

/// Throws Refused if an output file cannot be written, before anything is read.
void judge(const MaterialsRequest& request, const std::vector<fs::path>& cards) {
  std::vector<input::InputFile> files;
  for (const fs::path& card : cards) files.push_back({"the material card", card});
  std::vector<std::string> errors;
  judge_files(request.files, files, errors);
  judge_picture(request.files, errors);
  if (!errors.empty()) throw Refused(std::move(errors));
}

/// Writes the document to its files, and below `heading` to standard output.
void publish(const MaterialsRequest& request, const std::vector<Material>& materials,
             const std::string& heading, const MakeDocument& document) {
  const auto picture = [&](const Target& target) {
    return picture_text(output::materials_plot(materials, unit_system(request.files.units)), target);
  };
  publish(request.files, document, {{"--picture", picture}},
          heading + output::to_terminal(document(output::Pictures::left_out), output::Detail::all));
}

int show_one(const MaterialsRequest& request, const fs::path& folder) {
  std::vector<std::string> errors;
  const std::optional<fs::path> card = find_card(request.name, folder, errors);
  if (!card) throw Refused(std::move(errors));
  judge(request, {*card});
  const Material material = input::read_material(*card).value();
  publish(request, {material}, "", [&](output::Pictures pictures) {
    return output::material_document(material, unit_system(request.files.units), pictures);
  });
  return exit_done;
}

int list_all_materials(const MaterialsRequest& request, const fs::path& folder) {
  const std::vector<fs::path> cards = input::list_materials(folder).value();
  judge(request, cards);
  std::vector<Material> materials;
  std::vector<std::string> faults;
  for (const fs::path& card : cards)
    if (auto material = taken(input::read_material(card), faults)) materials.push_back(*std::move(material));
  const std::string heading = fmt::format("Materials in {}:\n", folder.string());
  const auto document = [&](output::Pictures pictures) {
    return output::materials_document(materials, unit_system(request.files.units), pictures);
  };
  if (!faults.empty()) {
    write_output(heading + output::to_terminal(document(output::Pictures::left_out), output::Detail::all));
    throw Refused(std::move(faults));
  }
  if (materials.empty() && !request.files.of("--picture").empty())
    throw Refused({fmt::format("--picture: there are no materials in {}", folder.string())});
  publish(request, materials, heading, document);
  return exit_done;
}

int show_materials(const MaterialsRequest& request) {
  const fs::path folder = chosen_folder(request.folder);
  return request.name.empty() ? list_all_materials(request, folder) : show_one(request, folder);
}

}  // namespace

std::optional<fs::path> find_card(const std::string& name, const fs::path& folder,
                                  std::vector<std::string>& errors) {
  if (name.ends_with(".toml") || input::given_stream(name) != nullptr) return name;
  const std::vector<fs::path> cards = input::list_materials(folder).value();
  const auto card = std::ranges::find(cards, name, [](const fs::path& path) { return path.stem().string(); });
  if (card != cards.end()) return *card;
  errors.push_back(name + ": " + input::no_such("material", name, folder, cards));
  return std::nullopt;
}

void add_materials(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<MaterialsRequest>(
      app, action, "materials", "List the material cards, or show one", materials_footer, show_materials);
  add_option(sub, "NAME", request.name, "Card to show in full");
  add_file(sub, request.files, "--picture", "Draw the loading curves (.svg, .png, .pdf)");
  add_documents(sub, request.files);
  add_units(sub, request.files.units);
  add_force(sub, request.files.force);
  add_material_folder(sub, request.folder);
}

}  // namespace dashpad::app
