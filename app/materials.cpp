// dashpad materials: lists the material cards, or shows one.

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/output/text/case.hpp"
#include "streams.hpp"

namespace dashpad::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* materials_footer = R"(Examples:
  dashpad materials                        all cards, a line each
  dashpad materials ensolite-aac-9         one card: source, law, parameters, fitted range
  dashpad materials ensolite-aac-9 --units us
  dashpad materials ./my-foam.toml         a card anywhere: a name that ends in .toml is a file

Exit codes: 0 done, 2 no such card, or a card with faults (the other cards are listed all the same).)";

struct MaterialsRequest {
  std::string name;
  std::string units;
  std::string folder;
};

std::string names_of(const std::vector<fs::path>& cards) {
  std::string names;
  for (const fs::path& card : cards) names += (names.empty() ? "" : ", ") + card.stem().string();
  return names.empty() ? "none" : names;
}

int show(const MaterialsRequest& request, const fs::path& folder) {
  const Material material = input::read_material(find_card(request.name, folder));
  write_output(output::material_text(material, unit_system(request.units)));
  return exit_done;
}

int list_all_materials(const fs::path& folder) {
  return list_cards(fmt::format("Materials in {}:\n", folder.string()), input::list_materials(folder),
                    [](const fs::path& card) { return output::material_line(input::read_material(card)); });
}

}  // namespace

fs::path find_card(const std::string& name, const fs::path& folder) {
  if (name.ends_with(".toml")) return name;
  const std::vector<fs::path> cards = input::list_materials(folder);
  const auto card = std::ranges::find(cards, name, [](const fs::path& path) { return path.stem().string(); });
  if (card == cards.end())
    throw Refused(
        {fmt::format("{}: no such material in {}; there are: {}", name, folder.string(), names_of(cards))});
  return *card;
}

void add_materials(CLI::App& app, Action& action, const fs::path& executable) {
  CLI::App* sub = app.add_subcommand("materials", "List the material cards, or show one");
  const auto request = std::make_shared<MaterialsRequest>();
  sub->add_option("NAME", request->name, "Card to show in full")->type_name("");
  add_units(*sub, request->units);
  add_material_folder(*sub, request->folder);
  sub->footer(materials_footer);
  sub->callback([request, &action, executable] {
    action = [request, executable] {
      const fs::path folder = chosen_folder(request->folder, executable);
      return request->name.empty() ? list_all_materials(folder) : show(*request, folder);
    };
  });
}

}  // namespace dashpad::app
