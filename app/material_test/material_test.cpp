// dashpad material-test: a pad material in the laboratory.

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/output/materials.hpp"
#include "dashpad/spit1984/column.hpp"
#include "documents.hpp"
#include "material_test/request.hpp"
#include "output.hpp"
#include "progress_line.hpp"

namespace dashpad::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* material_test_footer = R"(Examples:
  dashpad material-test ensolite-aac-9                    up and down at constant rate, 1 and 100 per second
  dashpad material-test ensolite-aac-9 --test parabolic --explicit-1984 --picture figure-2-9.svg
  dashpad material-test ensolite-aac-21 --rate 1,10,100 --stress-limit "50 kPa,100 kPa"
  dashpad material-test ensolite-aac-21 --test relaxation --strain 0.5 --hold "2 s"
  dashpad material-test ensolite-aac-9 --test creep --stress "50 kPa" --hold "100 ms"
  dashpad material-test ensolite-aac-9 --test cyclic --strain 0.6 --low 0.2 --cycles 3 --csv cycles.csv
  dashpad material-test ./my-foam.toml --test history --history my-strains.csv --report my-foam.html

A single pad column is driven through the test; its stress is exact up to quadrature. Figures: peak stress,
energy per volume, hysteresis, efficiency and ideality, and with --stress-limit how much the foam takes below
a stress. --explicit-1984 adds what the program of 1984 makes of it. docs/laboratory.md explains them all.

MATERIAL is the name of a card, as dashpad materials lists them, or a file that ends in .toml. A history is a
table with a header line that names its units: time_s,strain or "time [ms];strain [%]".

Files: - as FILE of --json or --csv is standard output; the text then goes to standard error. An existing file
is kept unless --force is given. A file is written whole or not at all.

Exit codes: 0 done, 1 a result could not be written, 2 refused and nothing was run.)";

struct MaterialTestCommand {
  MaterialTestRequest test;
  std::optional<std::string> json, csv, picture;
  DocumentFiles documents;
  std::string units;
  std::string materials;
  bool force = false;
};

std::vector<Target> targets(const MaterialTestCommand& request) {
  return targets_of({{"--json", request.json},
                     {"--csv", request.csv},
                     {"--report", request.documents.page},
                     {"--markdown", request.documents.markdown},
                     {"--picture", request.picture}});
}

/// Throws Refused with all that is wrong.
laboratory::MaterialTestReport run_test(const MaterialTestCommand& request, const fs::path& folder) {
  std::vector<std::string> wrong;
  const std::optional<fs::path> card = find_card(request.test.material, folder, wrong);
  std::vector<input::InputFile> files;
  if (card) files.push_back({"the material card", *card});
  if (request.test.history) files.push_back({"the strain history", *request.test.history});
  judge_targets(targets(request), files, request.force, wrong);
  judge_picture(request.picture, wrong);
  const laboratory::MaterialTest test = test_of(request.test, wrong);
  const std::optional<Material> material = card ? taken(input::read_material(*card), wrong) : std::nullopt;
  if (!wrong.empty()) throw Refused(std::move(wrong));
  try {
    const ProgressLine line{"Testing the material"};
    return laboratory::run_material_test(*material, test, spit1984::stresses_of_update);
  } catch (const std::invalid_argument& error) {
    throw Refused({fmt::format("--test {}: {}", request.test.test, error.what())});
  }
}

int show(const MaterialTestCommand& request, const fs::path& folder) {
  const laboratory::MaterialTestReport report = run_test(request, folder);
  const UnitSystem& units = unit_system(request.units);
  const auto text_of = [&](const Target& target) {
    if (target.option == "--json") return output::material_test_json(report);
    if (target.option == "--csv") return output::material_test_csv(report, units_of_files(units));
    if (is_document(target))
      return document_text(target, [&](output::Pictures pictures) {
        return output::material_test_document(report, units, pictures);
      });
    return output::picture(output::material_test_plot(report, units), *output::picture_format(target.file));
  };
  publish(targets(request), request.force, text_of,
          output::to_terminal(output::material_test_document(report, units), output::Detail::main));
  return exit_done;
}

}  // namespace

void add_material_test(CLI::App& app, Action& action, const std::filesystem::path& executable) {
  CLI::App* sub = app.add_subcommand("material-test", "Test a pad material in the laboratory");
  const auto request = std::make_shared<MaterialTestCommand>();
  sub->add_option("MATERIAL", request->test.material, "Card: its name, or a file")->required()->type_name("");
  add_test_options(*sub, request->test);
  add_file(*sub, "--json", request->json, "Write everything as JSON, SI (- for standard output)");
  add_file(*sub, "--csv", request->csv, "Write the stresses as CSV (- for standard output)");
  add_documents(*sub, request->documents);
  add_file(*sub, "--picture", request->picture, "Draw stress and efficiency (.svg, .png, .pdf)");
  add_units(*sub, request->units);
  add_force(*sub, request->force);
  add_material_folder(*sub, request->materials);
  sub->footer(material_test_footer);
  when_named(*sub, action,
             [request, executable] { return show(*request, chosen_folder(request->materials, executable)); });
}

}  // namespace dashpad::app
