// dashpad material export: a card as a deck of another solver.

#include <optional>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/output/deck/exports.hpp"
#include "dashpad/output/material_deck.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "output.hpp"
#include "quantities/text.hpp"

namespace dashpad::app {

namespace {

constexpr const char* export_material_footer = R"(Examples:
  dashpad material export vn600 --format ls-dyna-083 --units t-mm-s
  dashpad material export my-foam.toml --format radioss-90 --units kg-mm-ms -o foam.inc
  dashpad material export eps-15 --format ls-dyna-163 --units t-mm-s --first-id 9001 -o foam.k
  dashpad material export vn600 --format ls-dyna-083 --units t-mm-s --up-to 0.9 -o foam.k --check-deck check.k
  dashpad material export vn600 --format ls-dyna-057 --units t-mm-s --rate "100 1/s" --points 50 -o foam.k

Formats for the foam law:
  ls-dyna-057   *MAT_LOW_DENSITY_FOAM: one curve, no rates
  ls-dyna-083   *MAT_FU_CHANG_FOAM: one curve per rate
  radioss-70    /MAT/LAW70: one curve per rate, a measured unloading curve
  radioss-90    /MAT/LAW90: one curve per rate
  abaqus-low-density-foam   *LOW DENSITY FOAM: one curve per rate, an unloading curve
  abaqus-hyperfoam          *HYPERFOAM: one curve or coefficients, no rates, no energy loss
Formats for the crushable-foam law:
  ls-dyna-063   *MAT_CRUSHABLE_FOAM: one curve, no rates
  ls-dyna-163   *MAT_MODIFIED_CRUSHABLE_FOAM: one curve per rate
  radioss-33    /MAT/LAW33: one curve, no rates
Format for the viscoelastic-foam law:
  radioss-62    /MAT/LAW62: one or two terms and branches

CARD is the name of a card as listed by dashpad materials, or a file whose name ends in .toml. The deck contains the
numbers of the card with all their digits, so that dashpad material import can read them back; a curve defined by a
formula is written as points. With --up-to, --rate or --points, each curve is written instead as evenly spaced points
with six digits: at most 100, the number that LS-DYNA keeps by default. --up-to extends the curves beyond the tested
strain as the card does; a solver would extend them along a straight line, which is often too soft. Properties that the
deck cannot express are listed on the screen and in the comments of the deck. See docs/material-decks.md.

Files: without -o, the deck goes to standard output and messages go to standard error. An existing file is not
overwritten unless --force is given. A file is written completely or not at all.

Exit codes: 0 success, 1 the deck could not be written, 2 invalid input (nothing was written).)";

struct ExportMaterialRequest {
  std::string card, format, units;
  std::optional<std::string> density, rate;
  std::optional<double> up_to;
  std::optional<int> points;
  std::string check_deck;
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
  options.rate = positive_quantity_of("--rate", request.rate, "1/s", errors);
  options.up_to = request.up_to;
  options.points = request.points;
  std::vector<Target> targets{{"-o", request.out}};
  if (!request.check_deck.empty()) {
    targets.push_back({"--check-deck", request.check_deck});
    if (request.format.starts_with("radioss"))
      errors.emplace_back("--check-deck: applies only to LS-DYNA and Abaqus formats");
    if (request.out == "-" || request.check_deck == "-")
      errors.emplace_back("--check-deck: must be a file, and needs -o FILE, the deck that it includes");
  }
  if (material) {
    const std::string why = output::why_no_material_deck(*material, options);
    if (!why.empty()) errors.push_back("--format " + request.format + ": " + why);
  }
  judge_targets(targets, files, request.force, errors);
  if (!errors.empty()) throw Refused(std::move(errors));
  std::string account =
      fmt::format("{} as {}, units {}\n", material->name, request.format, options.units.name);
  for (const std::string& remark : output::not_in_material_deck(*material, options))
    account += wrapped("  differs: " + remark, 4) + "\n";
  if (request.out != "-") account += "written: " + request.out + "\n";
  if (!request.check_deck.empty())
    account += "written: " + request.check_deck + " (not run in that solver)\n";
  publish(
      targets, request.force,
      [&](const Target& target) {
        if (target.option == "-o") return output::material_deck(*material, options);
        const std::filesystem::path folder = std::filesystem::absolute(target.file).parent_path();
        return output::material_check_deck(
            *material, options, std::filesystem::absolute(request.out).lexically_relative(folder).string());
      },
      account);
  return exit_done;
}

}  // namespace

void add_material_export(CLI::App& material, Action& action) {
  const auto [sub, request] = add_subcommand<ExportMaterialRequest>(
      material, action, "export", "Write a card as a deck for another solver", export_material_footer,
      export_material);
  std::vector<std::string> names;
  for (const output::MaterialDeckFormat& format : output::material_deck_formats())
    names.emplace_back(format.name);
  add_option(sub, "CARD", request.card, "Name of a card, or a card file (.toml)")->required();
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
             "Density, such as \"100 kg/m3\", to use instead of the card's");
  add_option(sub, "--up-to STRAIN", request.up_to,
             "Extend the curves to this strain (at most 0.99), as the card does");
  add_option(sub, "--rate RATE", request.rate,
             "Strain rate, such as \"100 1/s\", for formats with a single curve (default: the lowest)");
  add_option(sub, "--points N", request.points, "Number of evenly spaced points per curve, 4 to 100");
  add_option(sub, "--check-deck FILE", request.check_deck,
             "LS-DYNA, Abaqus: also write a deck that compresses one element, and the force to expect");
  add_force(sub, request.force);
  add_material_folder(sub, request.folder);
}

}  // namespace dashpad::app
