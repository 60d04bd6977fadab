// dashpad material: cards from other programs' files, and decks from cards.

#include "material/material.hpp"

#include <stdexcept>

#include "dashpad/input/material_deck.hpp"

namespace dashpad::app {

namespace {

constexpr const char* material_footer = R"(Examples:
  dashpad material import foam.k --units t-mm-s -o my-foam.toml
  dashpad material import tests.csv --rate "0.01 1/s" -o my-foam.toml
  dashpad material export my-foam.toml --format ls-dyna-083 --units t-mm-s -o foam.k

dashpad material import --help and dashpad material export --help say more. To list or show cards: dashpad materials.)";

}  // namespace

void add_deck_units(CLI::App& app, std::string& units) {
  app.add_option(
         "--units", units,
         "Units of the deck: kg-mm-ms (kN, GPa), kg-m-s (N, Pa), t-mm-s (N, MPa), lbf-s2/in-in-s (lbf, psi)")
      ->type_name("SYSTEM");
}

std::optional<UnitSystem> deck_units_of(const std::string& name, std::vector<std::string>& wrong) {
  try {
    return input::deck_system(name);
  } catch (const std::invalid_argument& error) {
    wrong.push_back(std::string("--units ") + name + ": " + error.what());
    return std::nullopt;
  }
}

void add_material(CLI::App& app, Action& action, const std::filesystem::path& executable) {
  CLI::App* sub =
      app.add_subcommand("material", "Material cards from other programs' files, and decks from cards");
  sub->require_subcommand(1);
  sub->footer(material_footer);
  add_material_import(*sub, action);
  add_material_export(*sub, action, executable);
}

}  // namespace dashpad::app
