// dashpad spit1984: runs a case through the program of 1984.

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/spit1984/run.hpp"
#include "output_files.hpp"
#include "progress_line.hpp"

namespace dashpad::app {

namespace {

using namespace spit1984;

constexpr const char* spit1984_footer = R"(Examples:
  dashpad spit1984 examples/dashboard-20mph-21-parameter.toml
  dashpad spit1984 examples/dashboard-20mph.toml --arithmetic binary32
  dashpad spit1984 examples/dashboard-20mph.toml --repair all --arithmetic binary64
  dashpad spit1984 --interactive --listing for21.txt

Runs the subroutines SPIT and PAD, Version 2 (December 1984), and prints what they printed: the terminal output or,
with --listing, the line-printer output, 132 columns wide. Lengths are in inches, forces in lbf, the impact speed
in mph; forces are negative in compression. Read docs/spit1984.md before relying on the results: for the published
example, the peak force is wrong by 1 to 6 %, and the numbers depend on the arithmetic.

Arithmetic: pdp10 (default) is that of the 36-bit computer that produced the results in the report; binary32 and
binary64 are today's single and double precision.

--interactive runs the 1984 main program ENSOL, which asks for all input at the terminal.

Exit codes: 0 success, 1 a result could not be written, 2 invalid input (nothing was run), 3 the run ended in an
ABEND (the output may have become meaningless some time before it).

Defects in the listing that --repair corrects (may be repeated; "all" for all of them):
)";

std::string footer_with_defects() {
  std::string text = spit1984_footer;
  for (const Defect& defect : defects) text += fmt::format("  {:15} {}\n", defect.name, defect.meaning);
  return text;
}

struct Spit1984Request {
  GivenCase given;
  bool interactive = false;
  std::string arithmetic = "pdp10";
  std::vector<std::string> repair;
  OutputFiles files;
  double time_step_ms = 0.1;
  int print_interval = 10;
  Settings settings;
};

Settings settings_of(const Spit1984Request& request) {
  Settings settings = request.settings;
  for (const Arithmetic arithmetic : {Arithmetic::binary32, Arithmetic::binary64, Arithmetic::pdp10})
    if (request.arithmetic == to_string(arithmetic)) settings.arithmetic = arithmetic;
  for (const std::string& name : request.repair)
    for (const Defect& defect : defects)
      if (name == defect.name || name == "all") settings.defects.*defect.present = false;
  return settings;
}

/// CLI11 accepts "nan" in any range.
std::vector<std::string> what_is_no_number(const Spit1984Request& request) {
  std::vector<std::string> errors;
  for (const auto& [option, value] :
       {std::pair{"--time-step", request.time_step_ms},
        std::pair{"--equilibrium-tolerance", request.settings.equilibrium_tolerance},
        std::pair{"--precision-tolerance", request.settings.precision_tolerance}})
    if (std::isnan(value)) errors.push_back(fmt::format("{} nan: must be a number", option));
  return errors;
}

/// The stream of the questions: standard output, unless that is for a result.
std::ostream& terminal(const Spit1984Request& request) {
  return std::ranges::any_of(request.files.options, &Target::is_standard_output) ? std::cerr : std::cout;
}

/// The deck of the case, or of the answers at the terminal. Throws Refused with all errors.
Deck deck_for(const Spit1984Request& request) {
  std::vector<std::string> errors;
  if (request.interactive == !request.given.file.empty())
    errors.emplace_back(request.interactive ? "--interactive: asks for all input; leave out CASE"
                                            : "CASE is missing; use --interactive to type the input");
  std::ranges::move(what_is_no_number(request), std::back_inserter(errors));
  std::optional<input::CaseFile> input;
  if (!request.given.file.empty()) input = read_case(request.given, errors);
  judge_files(request.files, files_of(request.given.file, input), errors);
  if (input)
    for (const Violation& violation : what_a_deck_cannot_say(input->impact))
      errors.push_back(fmt::format("{}: {}: {}", request.given.file, violation.key, violation.rule));
  if (!errors.empty()) throw Refused(std::move(errors));
  if (request.interactive) {
    const std::optional<Deck> answers = ensol(std::cin, terminal(request));
    if (!answers) {
      terminal(request) << std::endl;  // ends the line of the last question
      throw Refused({"the input ended before the last answer"});
    }
    for (const Violation& violation : violations(*answers))
      errors.push_back(fmt::format("{} = {}: {}", violation.key, violation.value, violation.rule));
    if (!errors.empty()) throw Refused(std::move(errors));
    return *answers;
  }
  Deck deck = deck_of(input->impact);
  deck.time_step_ms = request.time_step_ms;
  deck.print_interval = request.print_interval;
  return deck;
}

/// Remarks beyond the listing.
std::string remarks(const Deck& deck, const Settings& settings, const Run& run) {
  std::string text = fmt::format("1984 program in {} arithmetic", to_string(settings.arithmetic));
  for (const Defect& defect : defects)
    if (!(settings.defects.*defect.present)) text += fmt::format(", {} corrected", defect.name);
  text += "\n";
  if (deck.pad_parameters == std::array<double, 21>{})
    text += "NO PARAMETERS: ENSOL never asked for those of models 1 to 3, so they are 0; use a case file\n";
  if (const double longest = longest_time_step_ms(deck); deck.time_step_ms > longest)
    text += fmt::format("TIME STEP of {:.3g} ms: the report recommends at most {:.3g} ms for this support\n",
                        deck.time_step_ms, longest);
  if (!run.precision_stops.empty())
    text += fmt::format("PRECISION LIMIT: {} of {} steps miss equilibrium by more than {:.3g} of the force\n",
                        run.precision_stops.size(), run.history.size(), settings.equilibrium_tolerance);
  if (run.abend != Abend::none) {
    const AbendText abend = text_of(run.abend);
    text += fmt::format("ABEND {}, {}: {}\n", static_cast<int>(run.abend), abend.message, abend.advice);
  }
  return text;
}

Run run_with_progress(const Deck& deck, const Settings& settings) {
  // The number of steps is not known in advance.
  ProgressLine line{fmt::format("Running the 1984 program (at most {} time steps)", settings.max_steps)};
  return run(deck, settings, [&](int step) {
    line.show(static_cast<std::size_t>(step), static_cast<std::size_t>(settings.max_steps));
  });
}

int run_program(const Spit1984Request& request) {
  const Deck deck = deck_for(request);
  const Settings settings = settings_of(request);
  const Run result = run_with_progress(deck, settings);

  const std::string output = publish(request.files.targets(), request.files.force, [&](const Target& target) {
    if (target.option == "--json") return run_json(deck, settings, result);
    if (target.option == "--csv") return run_csv(result);
    return listing(deck, result, Device::printer);
  });
  write_error(remarks(deck, settings, result));
  // Unchanged, with form feeds.
  write_result(output.empty() ? listing(deck, result, Device::terminal) : output);
  return result.abend == Abend::none ? exit_done : exit_not_trusted;
}

}  // namespace

void add_spit1984(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<Spit1984Request>(
      app, action, "spit1984", "Run the 1984 program, digit for digit", footer_with_defects(), run_program);
  std::vector<std::string> repairs{"all"};
  for (const Defect& defect : defects) repairs.emplace_back(defect.name);
  add_case(sub, request.given)->required(false);
  CLI::Option* interactive =
      add_flag(sub, "--interactive", request.interactive, "Ask for the input at the terminal, as ENSOL did");
  add_option(sub, "--arithmetic A", request.arithmetic, "pdp10 (default), binary32 or binary64")
      ->check(CLI::IsMember({"pdp10", "binary32", "binary64"}));
  add_option(sub, "--repair DEFECT", request.repair, "Correct this defect in the listing (see below), or all")
      ->check(CLI::IsMember(repairs));
  add_file(sub, request.files, "--listing", "Write the line-printer output (- for standard output)");
  add_file(sub, request.files, "--json", "Write input and results as JSON (- for standard output)");
  add_file(sub, request.files, "--csv", "Write the history as CSV (in, lbf, ms; - for standard output)");
  add_option(sub, "--time-step MS", request.time_step_ms, "DELT: time step, in ms (default: 0.1)")
      ->check(CLI::Range(1e-6, 1e3))
      ->excludes(interactive);
  add_option(sub, "--print-interval N", request.print_interval,
             "NDEL: time steps per printed row (default: 10)")
      ->check(CLI::Range(1, 1'000'000))
      ->excludes(interactive);
  add_option(sub, "--equilibrium-tolerance X", request.settings.equilibrium_tolerance,
             "TOLMAX, as a fraction of the force (default: 0.02)")
      ->check(CLI::Range(0.0, 1.0));
  add_option(sub, "--precision-tolerance X", request.settings.precision_tolerance,
             "TOL, as a fraction of the penetration (default: 1e-5)")
      ->check(CLI::Range(0.0, 1.0));
  add_option(sub, "--most-steps N", request.settings.max_steps,
             "Dimension of the time-history arrays (default: 1000)")
      ->check(CLI::Range(4, 1'000'000));
  add_option(sub, "--most-stations N", request.settings.max_stations,
             "Dimension of the contact arrays (default: 1000)")
      ->check(CLI::Range(2, 1'000'000));
  add_option(sub, "--most-iterations N", request.settings.max_iterations,
             "Maximum number of trials per step (default: 100)")
      ->check(CLI::Range(1, 100'000));
  add_force(sub, request.files.force);
  add_material_folder(sub, request.given.materials);
}

}  // namespace dashpad::app
