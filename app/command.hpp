#pragma once
/// The parts of the command: each subcommand adds itself to the command line and leaves what is to be done.

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

namespace dashpad::app {

enum ExitCode {
  exit_done = 0,         ///< results are there; also when the pad bottomed out or the time limit was reached
  exit_failed = 1,       ///< a result could not be written, or the program is at fault
  exit_refused = 2,      ///< input or command line refused; nothing was run and nothing written
  exit_not_trusted = 3,  ///< no verdict, or not reliable: results are there, but miss the tolerance
  exit_not_passed = 4,   ///< a standard's limit is exceeded, or a rule of the validation is missed
};

/// Of an impact that was solved. A pad that bottomed out on a rigid support is a result, also where the
/// tolerance is missed before it.
ExitCode exit_code(const Summary& summary);
/// Of a verdict about it: a limit that is exceeded outweighs whatever is missed elsewhere. Of several
/// verdicts the greatest counts.
ExitCode exit_code(injury::Verdict verdict, const Summary& summary);
/// Of a verdict about measured figures.
ExitCode exit_code(injury::Verdict verdict);

/// What a subcommand does once the command line is read; returns the exit code.
using Action = std::function<int()>;

/// A subcommand, and the request that its options fill.
template <class Request>
struct Subcommand {
  CLI::App& sub;
  Request& request;
};
/// Adds a subcommand. Where the command line names it, `action` calls `run` with the request.
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
void add_pulse(CLI::App& app, Action& action);
void add_export(CLI::App& app, Action& action);
void add_post_impact(CLI::App& app, Action& action);
void add_validate(CLI::App& app, Action& action);
void add_fit(CLI::App& app, Action& action);
void add_study(CLI::App& app, Action& action);

/// The subcommands of `dashpad material`.
void add_material_import(CLI::App& material, Action& action);
void add_material_export(CLI::App& material, Action& action);

/// Adds an option as the help shows it: "--mass M", or "CASE". Of one that may be given again each value
/// needs the name before it: what follows may be CASE.
template <class T>
CLI::Option* add_option(CLI::App& app, const std::string& shown, T& value, const std::string& help) {
  const std::size_t name = std::min(shown.find(' '), shown.size());
  CLI::Option* option = app.add_option(shown.substr(0, name), value, help);
  if (shown.starts_with('-')) option->allow_extra_args(false);
  return option->type_name(shown.substr(std::min(name + 1, shown.size())));
}
/// Adds an option without a value.
CLI::Option* add_flag(CLI::App& app, const std::string& name, bool& flag, const std::string& help);

/// Adds --units, a system of units for decks.
void add_deck_units(CLI::App& app, std::string& units);
/// The system of that name; absent where it is none, of which `wrong` is told.
std::optional<UnitSystem> deck_units_of(const std::string& name, std::vector<std::string>& errors);

/// Adds --units; the help names the systems on offer.
void add_units(CLI::App& app, std::string& units);
/// Adds --all: every figure, to five digits and with its error.
void add_all(CLI::App& app, output::Detail& detail);
/// Adds --tolerance.
void add_tolerance(CLI::App& app, std::optional<std::string>& tolerance);
/// The tolerance of --tolerance; absent where there is none, or where it is none and `wrong` is told so.
std::optional<double> tolerance_of(const std::optional<std::string>& text, std::vector<std::string>& errors);
/// Adds --force.
void add_force(CLI::App& app, bool& force);
/// An option's value in SI; absent where there is none, or where it is no such quantity and `wrong` is told
/// so.
std::optional<double> quantity_of(const char* option, const std::optional<std::string>& text,
                                  const std::string& si_unit, std::vector<std::string>& errors);
/// The same of a quantity that must be more than 0.
std::optional<double> positive_quantity_of(const char* option, const std::optional<std::string>& text,
                                           const std::string& si_unit, std::vector<std::string>& errors);
/// Adds --materials; the folder stays empty where the cards that came with the command are meant.
void add_material_folder(CLI::App& app, std::string& folder);
/// The folder that was chosen, or the first of:
///   1. $DASHPAD_MATERIALS, if set and not empty, whether or not it exists: a wrong path is to be noticed;
///   2. share/dashpad/materials of the installation that the program belongs to, if it exists;
///   3. materials/ of the source tree that the command was built from, if it exists.
/// If there is none, the second, so that a message can name the place where the cards were expected.
std::filesystem::path chosen_folder(const std::string& folder);
/// The same two for --standards: $DASHPAD_STANDARDS, share/dashpad/standards, standards/.
void add_standard_folder(CLI::App& app, std::string& folder);
std::filesystem::path chosen_standards(const std::string& folder);
/// The preset of --standard, with its variants in force; its file joins `files`. Absent where it is refused,
/// and `wrong` is told why.
std::optional<injury::Standard> standard_of(const std::string& name, const std::filesystem::path& folder,
                                            std::vector<input::InputFile>& files,
                                            std::vector<std::string>& errors);
/// The same for the measured tests of the validation: $DASHPAD_VALIDATION_DATA,
/// share/dashpad/data/validation, data/validation/.
std::filesystem::path chosen_measured_tests(const std::string& folder);
/// The file of the running program; the name that it was called by where the system does not tell.
std::filesystem::path running_executable();

/// The card of that name in a folder; a name that ends in .toml is a file. If there is no such card, nothing,
/// and a complaint that names the cards in the folder.
std::optional<std::filesystem::path> find_card(const std::string& name, const std::filesystem::path& folder,
                                               std::vector<std::string>& errors);

/// A case file, what is set in place of its values, and where its materials are.
struct GivenCase {
  std::string file = {};
  std::vector<std::string> settings = {};  ///< "KEY=VALUE"
  std::string materials = {};              ///< of --materials
};
/// Adds --set.
void add_settings(CLI::App& app, std::vector<std::string>& settings);
/// Adds CASE and --set; gives back CASE.
CLI::Option* add_case(CLI::App& app, GivenCase& given);

/// The case of that file; absent where it has faults, of which `wrong` is told.
std::optional<input::CaseFile> read_case(const GivenCase& given, std::vector<std::string>& errors);

/// The case to solve, with the tolerance of --tolerance in place of its own. `judge` sees the files that it
/// was read from, and may add to `wrong`. Throws Refused with all that is wrong then.
input::CaseFile case_to_solve(
    const GivenCase& given, const std::optional<std::string>& tolerance, std::vector<std::string> errors,
    const std::function<void(const std::vector<input::InputFile>&, std::vector<std::string>&)>& judge);

/// The files that the case was read from; of a case with faults at least its own.
std::vector<input::InputFile> files_of(const std::string& file, const std::optional<input::CaseFile>& input);

/// solve(), with a line on standard error where that takes long.
Solution solve_with_progress(const ImpactCase& impact, const Options& options);
/// The same with every blow of a series; of one blow there is one.
std::vector<Blow> solve_blows_with_progress(const ImpactCase& impact, const Options& options);

/// Adds --no-intervals.
void add_no_intervals(CLI::App& app, bool& no_intervals);
/// uncertainty::add_intervals(), likewise.
void add_intervals_with_progress(const ImpactCase& impact, const Options& options, Solution& solution,
                                 std::span<const double> dwell_levels = {});

/// One line for each fault.
std::vector<std::string> lines(const std::vector<input::Fault>& faults);
void add_lines(const std::vector<input::Fault>& faults, std::vector<std::string>& errors);
/// What was read; its faults are added to what is wrong.
template <class T>
std::optional<T> taken(input::Reading<T> reading, std::vector<std::string>& errors) {
  if (reading) return *std::move(reading);
  add_lines(reading.faults(), errors);
  return std::nullopt;
}

/// Facts about this build, for --version.
std::string version_text();

/// The command line or a case is refused; each complaint is one line that says what to mend.
class Refused : public std::runtime_error {
 public:
  explicit Refused(std::vector<std::string> complaints)
      : std::runtime_error("refused"), complaints_(std::move(complaints)) {}
  [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }

 private:
  std::vector<std::string> complaints_;
};

}  // namespace dashpad::app
