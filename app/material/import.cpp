// dashpad material, and dashpad material import: material cards from decks and tables.

#include <algorithm>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/material_deck.hpp"
#include "dashpad/model/pad/material.hpp"
#include "dashpad/output/card_toml.hpp"
#include "input/measurement/measurement_text.hpp"
#include "output.hpp"
#include "quantities/text.hpp"
#include "test_columns.hpp"

namespace dashpad::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* material_footer = R"(Examples:
  dashpad material import foam.k --units t-mm-s -o my-foam.toml
  dashpad material import tests.csv --rate "0.01 1/s" -o my-foam.toml
  dashpad material export my-foam.toml --format ls-dyna-083 --units t-mm-s -o foam.k

See also dashpad material import --help and dashpad material export --help. To list or show cards: dashpad materials.)";

constexpr const char* import_footer = R"(Examples:
  dashpad material import foam.k --units t-mm-s                   show the card on the screen
  dashpad material import seat_0000.rad                           in the units that the deck states
  dashpad material import foam.k --units mm-t-s -o my-foam.toml   write it to a file
  dashpad material import car.k --units t-mm-s -o cards/          write each foam of a deck to a folder
  dashpad material import car.k --units t-mm-s --material 12      one foam of several, by number or name
  dashpad material import tests.csv --rate "0.01 1/s" -o my-foam.toml
  dashpad material import slow.csv fast.csv --rate "0.01 1/s" --rate "40 1/s" -o my-foam.toml
  dashpad material import warm.csv cold.csv --rate "0.01 1/s" --rate "0.01 1/s" --temperature "23 degC" --temperature "-20 degC"
  dashpad material import machine.txt --thickness "25 mm" --area "25 cm2" --rate "0.02 1/s"

Decks: LS-DYNA keywords *MAT_057 (LOW_DENSITY_FOAM), 063 (CRUSHABLE_FOAM), 083 (FU_CHANG_FOAM) and 163
(MODIFIED_CRUSHABLE_FOAM) with their *DEFINE_CURVE and *DEFINE_TABLE; Radioss starter blocks /MAT/LAW33, LAW62, LAW70
and LAW90 with their /FUNCT; Abaqus *LOW DENSITY FOAM and *HYPERFOAM. Give the units of the deck with --units, unless it
states them itself (/BEGIN and /UNIT of Radioss, *CONTROL_UNITS of LS-DYNA). Files that a deck includes from its folder
are read with --allow-includes.

Tables of compression tests (CSV, text): strain (as a fraction or in %) and stress, with units in the header, such
as strain_percent,stress_kPa; or displacement and force, with --thickness and --area of the specimen. German, French,
Spanish and Italian column names are recognised; --strain and --stress name others. Give the strain rate with --rate,
or in the headings of several columns: "stress_kPa @ 10 1/s". Several files make one foam; give a --rate for each. The
loading curve follows the largest strain so far and is made to rise within the noise; the change is reported. The
unloading in the slowest test becomes the unloading curve. For whole cycles, relaxation and noise, use dashpad fit.

Values that the file does not give are assumed, and properties that a card cannot express are left out. Both are
listed, and kept in the card as reservations. See docs/material-decks.md.

Files: without -o, the card goes to standard output and messages go to standard error. An existing file is not
overwritten unless --force is given. A file is written completely or not at all.

Exit codes: 0 success, 1 the card could not be written, 2 invalid input (nothing was written).)";

struct ImportRequest {
  std::vector<std::string> files;
  std::string units;
  TestColumnsRequest tests;
  std::vector<std::string> temperatures;
  std::optional<std::string> material;
  std::string out = "-";
  bool force = false;
  bool allows_includes = false;
};

using Wrong = std::vector<std::string>;
using Found = std::vector<input::DeckMaterial>;

/// The values of the options for tables.
struct TableSettings {
  input::TestConditions conditions;
  input::StressStrainColumns columns;
};

/// The temperature in K; one that cannot be that of a foam is an error.
double temperature_of(const std::string& text, Wrong& errors) {
  constexpr double any = 300;
  const double value = quantity_of("--temperature", text, "K", errors).value_or(any);
  if (!(value > 0))
    errors.push_back(fmt::format("--temperature {}: must be above absolute zero, -273.15 degC", text));
  else if (value > highest_temperature)
    errors.push_back(fmt::format("--temperature {}: must be at most {:g} K", text, highest_temperature));
  return value;
}

TableSettings table_settings(const ImportRequest& request, Wrong& errors) {
  TableSettings settings{.conditions = {.rates = rates_of(request.tests, request.files.size(), errors)},
                         .columns = columns_of(request.tests, errors)};
  std::vector<double>& temperatures = settings.conditions.temperatures;
  for (const std::string& text : request.temperatures) temperatures.push_back(temperature_of(text, errors));
  if (!temperatures.empty() && temperatures.size() != request.files.size())
    errors.push_back(fmt::format("--temperature: give one for each file; {} {} given for {}",
                                 temperatures.size(), temperatures.size() == 1 ? "was" : "were",
                                 plural(request.files.size(), "file")));
  return settings;
}

/// Checks the options that depend on the kind of file. Returns the units of a deck, if they are given.
std::optional<UnitSystem> judge_import(const ImportRequest& request, bool are_tables, Wrong& errors) {
  if (are_tables) {
    if (request.allows_includes) errors.emplace_back("--allow-includes: applies only to decks");
    if (!request.units.empty())
      errors.emplace_back("--units: applies only to decks; a table states its units");
    return std::nullopt;
  }
  if (!request.temperatures.empty()) errors.emplace_back("--temperature: applies only to tables");
  if (!request.tests.rates.empty())
    errors.emplace_back("--rate: applies only to tables; a deck states its rates");
  if (request.tests.has_columns())
    errors.emplace_back(
        "--strain, --stress, --strain-unit, --stress-unit, --thickness, --area: apply only to tables");
  if (request.files.size() > 1)
    errors.emplace_back(
        "FILE: only one deck can be given; if there are several files, all must be tables of tests");
  return request.units.empty() ? std::nullopt : deck_units_of(request.units, errors);
}

/// Keeps the foam of that number or name.
void keep_only(const std::string& wanted, Found& found, Wrong& errors) {
  std::string names;
  for (const input::DeckMaterial& each : found)
    names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", each.id, each.material.name);
  std::erase_if(found, [&](const input::DeckMaterial& each) {
    return each.material.name != wanted && fmt::format("{}", each.id) != wanted;
  });
  if (found.empty())
    errors.push_back(fmt::format("--material {}: no such foam; available: {}", wanted, names));
}

/// One file for each card in a folder, or one file for all.
std::vector<Target> targets_of(const ImportRequest& request, const Found& found, Wrong& errors) {
  std::error_code ignored;
  const bool into_folder = request.out.ends_with('/') || fs::is_directory(request.out, ignored);
  std::vector<Target> targets;
  for (const input::DeckMaterial& each : found)
    targets.push_back({"-o", into_folder ? (fs::path(request.out) / (each.material.name + ".toml")).string()
                                         : request.out});
  if (!into_folder && found.size() > 1) {
    errors.push_back(fmt::format("{}: has {} foams; give a folder with -o, or select one with --material",
                                 request.files.front(), found.size()));
    targets.resize(1);
  }
  return targets;
}

std::string understood(const input::DeckMaterial& found) {
  const Material& material = found.material;
  std::string text = fmt::format("{}, line {}: {}\n", found.card, found.line, material.title);
  if (!found.units.empty()) text += fmt::format("  units {}\n", found.units);
  std::visit(
      [&]<class Law>(const Law& law) {
        if constexpr (SharesSlip<Law>) {
          const auto* const base = std::get_if<TableCurve>(&law.curves.base);
          const auto* const rates = std::get_if<CurvesRateEffect>(&law.curves.rate_effect);
          text += base ? fmt::format("  law {}, {} points up to a strain of {:g} ({:g} kPa) at {:g} 1/s\n",
                                     Law::name, base->strain.size(), base->strain.back(),
                                     base->stress.back() / 1000, law.curves.slowest_rate)
                       : fmt::format("  law {}, a curve given by coefficients, at {:g} 1/s\n", Law::name,
                                     law.curves.slowest_rate);
          if (rates)
            for (const auto& [rate, curve] : rates->curves)
              text += fmt::format("  {} points up to a strain of {:g} ({:g} kPa) at {:g} 1/s\n",
                                  curve.strain.size(), curve.strain.back(), curve.stress.back() / 1000, rate);
          if constexpr (std::is_same_v<Law, CrushableFoam>)
            text += fmt::format("  unloads with a modulus of {:g} MPa\n", law.unloading_modulus / 1e6);
          else if (law.unloading_curve)
            text += fmt::format("  unloads along a curve of {} points\n", law.unloading_curve->strain.size());
          else
            text += fmt::format("  unloads with a factor of {:g} and a shape of {:g}\n", law.unloading_factor,
                                law.unloading_shape);
        } else if constexpr (std::is_same_v<Law, ViscoelasticFoam>) {
          text += fmt::format("  law {}, moduli {:g} and {:g} kPa, exponents {:g} and {:g}\n", Law::name,
                              law.first_modulus / 1000, law.second_modulus / 1000, law.first_exponent,
                              law.second_exponent);
          for (const auto& [share, time] :
               {std::pair{law.first_share, law.first_time}, std::pair{law.second_share, law.second_time}})
            if (share > 0)
              text += fmt::format(
                  "  a branch with {:g} times the long-term stress relaxes with a time constant of {:g} s\n",
                  share, time);
        }
      },
      material.law);
  for (const std::string& assumption : found.assumptions) text += "  assumed: " + assumption + "\n";
  for (const std::string& difference : found.differences) text += "  differs: " + difference + "\n";
  return text;
}

int import_material(const ImportRequest& request) {
  Wrong errors;
  const bool are_tables = std::ranges::all_of(request.files, input::is_stress_table);
  const TableSettings settings = table_settings(request, errors);
  const std::optional<UnitSystem> units = judge_import(request, are_tables, errors);
  Found found;
  if (are_tables) {
    const std::vector<fs::path> files(request.files.begin(), request.files.end());
    if (auto table = taken(input::read_stress_tables(files, settings.conditions, settings.columns), errors))
      found.push_back(*std::move(table));
  } else if (units || (request.units.empty() && errors.empty())) {
    const auto includes = request.allows_includes ? input::Includes::allowed : input::Includes::ignored;
    found =
        taken(input::read_material_deck(request.files.front(), units, includes), errors).value_or(Found());
  }
  if (request.material && !found.empty()) keep_only(*request.material, found, errors);
  const std::vector<Target> targets = targets_of(request, found, errors);
  std::vector<input::InputFile> sources;
  for (const std::string& file : request.files) sources.push_back({"the imported file", file});
  judge_targets(targets, sources, request.force, errors);
  if (!errors.empty()) throw Refused(std::move(errors));
  std::string account;
  for (const input::DeckMaterial& each : found) account += understood(each);
  for (const Target& target : targets)
    if (!target.is_standard_output()) account += "written: " + target.file + "\n";
  const auto text_of = [&](const Target& target) {
    const auto place =
        static_cast<std::size_t>(std::ranges::find(targets, target.file, &Target::file) - targets.begin());
    return output::card_toml(found[place].material);
  };
  publish(targets, request.force, text_of, account);
  return exit_done;
}

}  // namespace

void add_deck_units(CLI::App& app, std::string& units) {
  add_option(app, "--units SYSTEM", units,
             "Units of the deck: kg-mm-ms (kN, GPa), kg-m-s (N, Pa), t-mm-s (N, MPa), g-mm-ms (N, MPa), "
             "g-cm-us (Mbar), lbf-s2/in-in-s (lbf, psi)");
}

std::optional<UnitSystem> deck_units_of(const std::string& name, std::vector<std::string>& errors) {
  try {
    return input::deck_system(name);
  } catch (const std::invalid_argument& error) {
    errors.push_back(std::string("--units ") + name + ": " + error.what());
    return std::nullopt;
  }
}

void add_material(CLI::App& app, Action& action) {
  CLI::App* sub =
      app.add_subcommand("material", "Convert other solvers' decks to material cards, and cards to decks");
  sub->require_subcommand(1);
  sub->footer(material_footer);
  add_material_import(*sub, action);
  add_material_export(*sub, action);
}

void add_material_import(CLI::App& material, Action& action) {
  const auto [sub, request] = add_subcommand<ImportRequest>(
      material, action, "import", "Make a card from another solver's deck or from tables of tests",
      import_footer, import_material);
  add_option(sub, "FILE", request.files, "LS-DYNA, Radioss or Abaqus deck, or tables of compression tests")
      ->required();
  add_deck_units(sub, request.units);
  add_test_columns(sub, request.tests);
  add_option(sub, "--temperature TEMPERATURE", request.temperatures,
             "Temperature of a table's specimen, such as \"-20 degC\", one for each table; that of the first "
             "is the temperature of the card, the others give factors on its stresses");
  add_flag(sub, "--allow-includes", request.allows_includes,
           "Also read the files that a deck includes from its own folder");
  add_option(sub, "--material NAME", request.material, "Only this foam of a deck, by number or name");
  add_option(sub, "-o,--out FILE", request.out, "Output file or folder (default: standard output)");
  add_force(sub, request.force);
}

}  // namespace dashpad::app
