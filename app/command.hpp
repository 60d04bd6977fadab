#pragma once
/// The subcommands, each of which adds itself to the command line and leaves an action.
///
/// Functions with a parameter `errors` add a line to it for each thing that the user must correct; if they
/// return an optional, that is absent then.

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/standard.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/input/fault.hpp"
#include "dashpad/output/document.hpp"
#include "live/exit_code.hpp"

namespace dashpad::app {

using enum live::ExitCode;
using live::exit_code;
using live::ExitCode;

/// The action of a subcommand; returns the exit code.
using Action = std::function<int()>;

/// A subcommand, and the request that its options fill.
template <class Request>
struct Subcommand {
  CLI::App& sub;
  Request& request;
};
/// Adds a subcommand. If the command line names it, `action` calls `run` with the request.
template <class Request>
Subcommand<Request> add_subcommand(CLI::App& app, Action& action, const char* name, const char* help,
                                   std::string footer, int (*run)(const Request&)) {
  CLI::App* sub = app.add_subcommand(name, help)->footer(std::move(footer));
  const auto request = std::make_shared<Request>();
  sub->callback([&action, request, run] { action = [request, run] { return run(*request); }; });
  return {*sub, *request};
}

void add_run(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_materials(CLI::App& app, Action& action);
void add_material(CLI::App& app, Action& action);
void add_material_test(CLI::App& app, Action& action);
void add_spit1984(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_assess(CLI::App& app, Action& action);
void add_standards(CLI::App& app, Action& action);
void add_cite(CLI::App& app, Action& action);
void add_solve_for(CLI::App& app, Action& action);
void add_fall_height(CLI::App& app, Action& action);
void add_sensitivity(CLI::App& app, Action& action);
void add_explore(CLI::App& app, Action& action);
void add_pulse(CLI::App& app, Action& action);
void add_export(CLI::App& app, Action& action);
void add_post_impact(CLI::App& app, Action& action);
void add_validate(CLI::App& app, Action& action);
void add_fit(CLI::App& app, Action& action);
void add_study(CLI::App& app, Action& action);
void add_batch(CLI::App& app, Action& action);

/// The subcommands of `dashpad material`.
void add_material_import(CLI::App& material, Action& action);
void add_material_export(CLI::App& material, Action& action);

/// Adds an option as shown in the help: "--mass M", or "CASE". If it may be repeated, so must its name, since
/// CASE may follow a value.
template <class T>
CLI::Option* add_option(CLI::App& app, const std::string& shown, T& value, const std::string& help) {
  const std::size_t name = std::min(shown.find(' '), shown.size());
  CLI::Option* option = app.add_option(shown.substr(0, name), value, help);
  if (shown.starts_with('-')) option->allow_extra_args(false);
  return option->type_name(shown.substr(std::min(name + 1, shown.size())));
}
/// Adds an option without a value.
CLI::Option* add_flag(CLI::App& app, const std::string& name, bool& flag, const std::string& help);

/// Adds --units with the systems of units for decks, and returns the chosen one.
void add_deck_units(CLI::App& app, std::string& units);
std::optional<UnitSystem> deck_units_of(const std::string& name, std::vector<std::string>& errors);

/// The options of these names, and their values.
void add_units(CLI::App& app, std::string& units);
void add_all(CLI::App& app, output::Detail& detail);
void add_tolerance(CLI::App& app, std::optional<std::string>& tolerance);
std::optional<double> tolerance_of(const std::optional<std::string>& text, std::vector<std::string>& errors);
void add_force(CLI::App& app, bool& force);
/// The value of an option in SI; also absent without the option.
std::optional<double> quantity_of(const char* option, const std::optional<std::string>& text,
                                  const std::string& si_unit, std::vector<std::string>& errors);
/// A value that must be more than 0.
std::optional<double> positive_quantity_of(const char* option, const std::optional<std::string>& text,
                                           const std::string& si_unit, std::vector<std::string>& errors);
/// Adds --materials. An empty folder means the cards that came with the command.
void add_material_folder(CLI::App& app, std::string& folder);
/// The chosen folder, or the first of:
///   1. $DASHPAD_MATERIALS, if not empty, even if it does not exist, so that a wrong path is noticed;
///   2. share/dashpad/materials of the installation of the program, if it exists;
///   3. materials/ of the source tree of the program, if it exists.
/// Failing these, the second, for messages.
std::filesystem::path chosen_folder(const std::string& folder);
/// The same for --standards: $DASHPAD_STANDARDS, share/dashpad/standards, standards/.
void add_standard_folder(CLI::App& app, std::string& folder);
std::filesystem::path chosen_standards(const std::string& folder);
/// The preset of --standard with its variants in force. Adds its file to `files`.
std::optional<injury::Standard> standard_of(const std::string& name, const std::filesystem::path& folder,
                                            std::vector<input::InputFile>& files,
                                            std::vector<std::string>& errors);
/// The same for measured tests: $DASHPAD_VALIDATION_DATA, share/dashpad/data/validation, data/validation/.
std::filesystem::path chosen_measured_tests(const std::string& folder);
/// The engine of the live page: $DASHPAD_ENGINE, share/dashpad/engine.wasm.lzma, build/wasm/engine.wasm.lzma.
std::filesystem::path chosen_engine();

/// The card of that name in a folder; a name that ends in .toml is a file.
std::optional<std::filesystem::path> find_card(const std::string& name, const std::filesystem::path& folder,
                                               std::vector<std::string>& errors);

/// A case file, its settings, and the folder of its materials.
struct GivenCase {
  std::string file = {};
  std::vector<std::string> settings = {};  ///< of --set: "KEY=VALUE"
  std::string materials = {};              ///< of --materials
};
void add_settings(CLI::App& app, std::vector<std::string>& settings);
/// Adds CASE and --set; returns CASE.
CLI::Option* add_case(CLI::App& app, GivenCase& given);

std::optional<input::CaseFile> read_case(const GivenCase& given, std::vector<std::string>& errors);

/// The case to solve, with the tolerance of --tolerance. `judge` receives the files that it was read from.
/// Throws Refused with all errors.
input::CaseFile case_to_solve(
    const GivenCase& given, const std::optional<std::string>& tolerance, std::vector<std::string> errors,
    const std::function<void(const std::vector<input::InputFile>&, std::vector<std::string>&)>& judge);

/// The files of the case; if it has faults, at least its own.
std::vector<input::InputFile> files_of(const std::string& file, const std::optional<input::CaseFile>& input);

/// Calls solve() with a progress line on standard error.
Solution solve_with_progress(const ImpactCase& impact, const Options& options);
/// The same for all blows of a series, or the single one.
std::vector<Blow> solve_blows_with_progress(const ImpactCase& impact, const Options& options);

void add_no_intervals(CLI::App& app, bool& no_intervals);
/// Calls uncertainty::add_intervals() likewise.
void add_intervals_with_progress(const ImpactCase& impact, const Options& options, Solution& solution,
                                 std::span<const double> dwell_levels = {});

std::vector<std::string> lines(const std::vector<input::Fault>& faults);
void add_lines(const std::vector<input::Fault>& faults, std::vector<std::string>& errors);
/// The value read, or nothing after its faults were added.
template <class T>
std::optional<T> taken(input::Reading<T> reading, std::vector<std::string>& errors) {
  if (reading) return *std::move(reading);
  add_lines(reading.faults(), errors);
  return std::nullopt;
}

std::string version_text();

/// Thrown if the command line or the input is refused. Each complaint is a line that says what to correct.
class Refused : public std::runtime_error {
 public:
  explicit Refused(std::vector<std::string> complaints)
      : std::runtime_error("refused"), complaints_(std::move(complaints)) {}
  [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }

 private:
  std::vector<std::string> complaints_;
};

}  // namespace dashpad::app
