// dashpad material export: a card as a deck of another solver.

#include <optional>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/output/deck/exports.hpp"
#include "dashpad/output/material_deck.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "output.hpp"

namespace dashpad::app {

namespace {

constexpr const char* export_material_footer = R"(Examples:
  dashpad material export vn600 --format ls-dyna-083 --units t-mm-s
  dashpad material export my-foam.toml --format radioss-90 --units kg-mm-ms -o foam.inc
  dashpad material export eps-15 --format ls-dyna-163 --units t-mm-s --first-id 9001 -o foam.k

Formats for the law foam:
  ls-dyna-057   *MAT_LOW_DENSITY_FOAM: one curve, no rates
  ls-dyna-083   *MAT_FU_CHANG_FOAM: one curve per rate
  radioss-70    /MAT/LAW70: one curve per rate, a measured unloading curve
  radioss-90    /MAT/LAW90: one curve per rate
Formats for the law crushable-foam:
  ls-dyna-063   *MAT_CRUSHABLE_FOAM: one curve, no rates
  ls-dyna-163   *MAT_MODIFIED_CRUSHABLE_FOAM: one curve per rate
  radioss-33    /MAT/LAW33: one curve, no rates
Format for the law viscoelastic-foam:
  radioss-62    /MAT/LAW62: one or two terms and branches

CARD is the name of a card as listed by dashpad materials, or a file that ends in .toml. The deck contains the
numbers of the card with all their digits, so that dashpad material import reads them back; a curve given by a formula
is written as points. Properties that the deck cannot express are listed on the screen and in its comments. See
docs/material-decks.md.

Files: without -o the deck goes to standard output and messages go to standard error. An existing file is not
overwritten unless --force is given. A file is written completely or not at all.

Exit codes: 0 success, 1 the deck could not be written, 2 invalid input and nothing was written.)";

struct ExportMaterialRequest {
  std::string card, format, units;
  std::optional<std::string> density;
  int first_id = 1;
  std::string out = "-";
  std::string folder;
  bool force = false;
};

int export_material(const ExportMaterialRequest& request) {
  std::vector<std::string> errors;
  std::vector<input::InputFile> files;
  const std::optional<std::filesystem::path> card =
      find_card(request.card, chosen_folder(request.folder), errors);
  if (card) files.push_back({"the material card", *card});
  std::optional<Material> material = card ? taken(input::read_material(*card), errors) : std::nullopt;
  output::MaterialDeckOptions options{request.format, consistent_systems().front(), request.first_id};
  if (const auto units = deck_units_of(request.units, errors)) options.units = *units;
  const auto density = positive_quantity_of("--density", request.density, "kg/m3", errors);
  if (material && density) material->density = density;
  if (material) {
    const std::string why = output::why_no_material_deck(*material, options);
    if (!why.empty()) errors.push_back("--format " + request.format + ": " + why);
  }
  judge_targets({{"-o", request.out}}, files, request.force, errors);
  if (!errors.empty()) throw Refused(std::move(errors));
  std::string account =
      fmt::format("{} as {}, units {}\n", material->name, request.format, options.units.name);
  for (const std::string& remark : output::not_in_material_deck(*material, options))
    account += "  differs: " + remark + "\n";
  if (request.out != "-") account += "written: " + request.out + "\n";
  publish(
      {{"-o", request.out}}, request.force,
      [&](const Target&) { return output::material_deck(*material, options); }, account);
  return exit_done;
}

}  // namespace

void add_material_export(CLI::App& material, Action& action) {
  const auto [sub, request] = add_subcommand<ExportMaterialRequest>(
      material, action, "export", "Make a deck for another solver from a card", export_material_footer,
      export_material);
  std::vector<std::string> names;
  for (const output::MaterialDeckFormat& format : output::material_deck_formats())
    names.emplace_back(format.name);
  add_option(sub, "CARD", request.card, "Name of a card, or a file")->required();
  add_option(sub, "--format F", request.format, "Solver and material law; see below")
      ->required()
      ->check(CLI::IsMember(names));
  add_deck_units(sub, request.units);
  sub.get_option("--units")->required();
  add_option(sub, "-o,--out FILE", request.out, "Output file (default: standard output)");
  add_option(sub, "--first-id N", request.first_id,
             "Number of the material and of its first curve (default: 1)")
      ->check(CLI::Range(1, output::highest_curve_id));
  add_option(sub, "--density DENSITY", request.density,
             "Density instead of the card's, such as \"100 kg/m3\"");
  add_force(sub, request.force);
  add_material_folder(sub, request.folder);
}

}  // namespace dashpad::app
