#include <stdexcept>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/input/standard_file.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "dashpad/uncertainty/intervals.hpp"
#include "dashpad/version.hpp"
#include "input/option_values.hpp"
#include "output.hpp"
#include "progress_line.hpp"
#include "system.hpp"

namespace dashpad::app {

void add_units(CLI::App& app, std::string& units) {
  std::vector<std::string> names;
  for (const UnitSystem& system : unit_systems()) names.push_back(system.name);
  units = names.front();
  add_option(app, "--units SYSTEM", units, "Units of the output: si (default), us or engineering-metric")
      ->check(CLI::IsMember(names));
}

void add_all(CLI::App& app, output::Detail& detail) {
  app.add_flag_callback(
      "--all", [&detail] { detail = output::Detail::all; },
      "Show every figure to five digits, with its error");
}

CLI::Option* add_flag(CLI::App& app, const std::string& name, bool& flag, const std::string& help) {
  return app.add_flag(name, flag, help)->disable_flag_override();
}

void add_tolerance(CLI::App& app, std::optional<std::string>& tolerance) {
  add_option(app, "--tolerance X", tolerance,
             "Relative error allowed, from 1e-8 to 1e-2 (default: as in the case, otherwise 1e-4)");
}

std::optional<double> tolerance_of(const std::optional<std::string>& text, std::vector<std::string>& errors) {
  return text ? taken(input::read_tolerance(*text), errors) : std::nullopt;
}

void add_force(CLI::App& app, bool& force) { add_flag(app, "--force", force, "Overwrite existing files"); }

std::optional<injury::Standard> standard_of(const std::string& name, const std::filesystem::path& folder,
                                            std::vector<input::InputFile>& files,
                                            std::vector<std::string>& errors) {
  try {
    const input::StandardChoice choice = input::standard_choice(name);
    files.push_back({"the standard", input::find_standard(choice.name, folder).value()});
    return injury::with_variants(input::read_standard(files.back().file).value(), choice.variants);
  } catch (const input::InputError& error) {
    add_lines(error.faults(), errors);
  } catch (const std::invalid_argument& error) {
    errors.push_back(fmt::format("--standard: {}", error.what()));
  }
  return std::nullopt;
}

std::optional<double> quantity_of(const char* option, const std::optional<std::string>& text,
                                  const std::string& si_unit, std::vector<std::string>& errors) {
  return text ? taken(input::read_option(option, *text, si_unit), errors) : std::nullopt;
}

std::optional<double> positive_quantity_of(const char* option, const std::optional<std::string>& text,
                                           const std::string& si_unit, std::vector<std::string>& errors) {
  return text ? taken(input::read_positive_option(option, *text, si_unit), errors) : std::nullopt;
}

void add_material_folder(CLI::App& app, std::string& folder) {
  add_option(app, "--materials DIR", folder,
             "Folder of material cards (default: $DASHPAD_MATERIALS, or the cards supplied)");
}

void add_standard_folder(CLI::App& app, std::string& folder) {
  add_option(app, "--standards DIR", folder,
             "Folder of presets (default: $DASHPAD_STANDARDS, or the presets supplied)");
}

void add_settings(CLI::App& app, std::vector<std::string>& settings) {
  add_option(app, "--set KEY=VALUE", settings,
             "Replace a value in the case, as in pad.thickness=\"30 mm\"; may be repeated");
}

CLI::Option* add_case(CLI::App& app, GivenCase& given) {
  add_settings(app, given.settings);
  return add_option(app, "CASE", given.file, "Case file (TOML)")->required();
}

std::optional<input::CaseFile> read_case(const GivenCase& given, std::vector<std::string>& errors) {
  return taken(input::read_case(given.file, chosen_folder(given.materials), given.settings), errors);
}

input::CaseFile case_to_solve(
    const GivenCase& given, const std::optional<std::string>& tolerance, std::vector<std::string> errors,
    const std::function<void(const std::vector<input::InputFile>&, std::vector<std::string>&)>& judge) {
  const std::optional<double> chosen = tolerance_of(tolerance, errors);
  std::optional<input::CaseFile> input = read_case(given, errors);
  judge(files_of(given.file, input), errors);
  if (!errors.empty()) throw Refused(std::move(errors));
  if (chosen) input->options.tolerance = *chosen;
  return *std::move(input);
}

std::vector<input::InputFile> files_of(const std::string& file, const std::optional<input::CaseFile>& input) {
  return input ? input->files : std::vector<input::InputFile>{{"the case file", file}};
}

Solution solve_with_progress(const ImpactCase& impact, const Options& options) {
  const ProgressLine line{"Solving"};
  return solve(impact, options);
}

std::vector<Blow> solve_blows_with_progress(const ImpactCase& impact, const Options& options) {
  const ProgressLine line{"Solving"};
  return solve_blows(impact, options);
}

void add_no_intervals(CLI::App& app, bool& no_intervals) {
  add_flag(app, "--no-intervals", no_intervals,
           "Omit the uncertainty intervals, which require solving further impacts");
}

void add_intervals_with_progress(const ImpactCase& impact, const Options& options, Solution& solution,
                                 std::span<const double> dwell_levels) {
  const ProgressLine line{"Computing the intervals"};
  uncertainty::add_intervals(impact, options, solution, dwell_levels);
}

std::string version_text() {
  const BuildFacts& facts = build_facts();
  std::error_code ignored;
  const bool has_mpi = std::filesystem::exists(running_executable().replace_filename("dashpad-mpi"), ignored);
  return fmt::format(
      "dashpad {}\n"
      "  commit      {}\n"
      "  compiler    {}\n"
      "  flags       {}\n"
      "  build type  {}\n"
      "  system      {}\n"
      "  libraries   CLI11 {}, fmt {}.{}.{}, nlohmann-json {}.{}.{}\n"
      "  MPI         {}",
      facts.version, facts.git_commit, facts.compiler, facts.compiler_flags, facts.build_type, facts.system,
      CLI11_VERSION, FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100,
      NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH,
      has_mpi ? "supported" : "not supported by this build");
}

std::vector<std::string> lines(const std::vector<input::Fault>& faults) {
  std::vector<std::string> text;
  add_lines(faults, text);
  return text;
}

void add_lines(const std::vector<input::Fault>& faults, std::vector<std::string>& errors) {
  for (const input::Fault& fault : faults) errors.push_back(with_excerpt(fault));
}

}  // namespace dashpad::app
