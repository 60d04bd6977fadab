// dashpad compare: the accurate solver beside the program of 1984, or beside a measured pulse.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "command.hpp"
#include "dashpad/injury/pulse_comparison.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/output/pulse.hpp"
#include "dashpad/report1986/comparison.hpp"
#include "dashpad/spit1984/deck.hpp"
#include "output_files.hpp"
#include "progress_line.hpp"
#include "pulse/request.hpp"

namespace dashpad::app {

namespace {

constexpr const char* compare_footer = R"(Examples:
  dashpad compare examples/dashboard-20mph.toml --units us
  dashpad compare examples/dashboard-20mph.toml --picture comparison.svg
  dashpad compare examples/dashboard-20mph.toml --time-step 0.05 --json -
  dashpad compare examples/helmet-pad-10fps.toml --pulse examples/pulses/synthetic-helmet-pad.csv
  dashpad compare examples/helmet-pad-10fps.toml --pulse my-drop.csv --zero auto --filter CFC1000
  dashpad compare examples/helmet-pad-10fps.toml --pulse my-drop.csv --report comparison.html

Without --pulse, the table has rows for the accurate solver (with exact unit conversions, and with the constants
of 1984) and for the 1984 program (in the arithmetic of its machine, in single precision, in double precision,
and with its defects corrected). docs/spit1984.md explains how far to trust each. --picture draws force and
penetration against time; the extension of FILE sets the format: .svg, .png or .pdf.

With --pulse FILE, the computed deceleration is compared with a measured pulse in terms of peak, time to peak,
width (total time above half the peak), velocity change during contact, HIC15 and restitution. FILE can be any file
that dashpad pulse reads, with the same options for reading and processing. --align selects where the two pulses
coincide: at their onsets (default; where each first reaches 5 % of its own peak), at their peaks, or nowhere.
--filter also applies to the computed pulse. The restitution of the measured pulse is based on the speed of the
case unless --speed or --drop-height is given. A pulse without acceleration is rejected, as is one that has no
onset to align because its first sample is already above 5 % of its peak. docs/pulses.md explains the rules and flags.

Exit codes: 0 success (whatever the outcome of the 1984 runs), 1 a result could not be written, 2 invalid
input (nothing was run), 3 the accurate solver did not meet the tolerance.)";

struct CompareRequest {
  GivenCase given;
  OutputFiles files;
  double time_step_ms = 0.1;
  PulseRequest pulse;
  std::string align = injury::to_string(injury::Alignment::onset);
};

input::CaseFile read_and_check(const CompareRequest& request) {
  std::vector<std::string> errors;
  judge_picture(request.files, errors);
  if (std::isnan(request.time_step_ms)) errors.emplace_back("--time-step nan: must be a number");
  std::optional<input::CaseFile> input = read_case(request.given, errors);
  judge_files(request.files, files_of(request.given.file, input), errors);
  if (input)
    for (const Violation& violation : spit1984::what_a_deck_cannot_say(input->impact))
      errors.push_back(fmt::format("{}: {}: {}", request.given.file, violation.key, violation.rule));
  if (!errors.empty()) throw Refused(std::move(errors));
  return *std::move(input);
}

int compare_with_1984(const CompareRequest& request) {
  const input::CaseFile input = read_and_check(request);
  const UnitSystem& units = unit_system(request.files.units);
  const report1986::Comparison comparison = [&] {
    ProgressLine line{"Running the 1984 program"};
    return report1986::compare(input.impact, input.options, 1e-3 * request.time_step_ms,
                               [&](std::size_t done, std::size_t all) { line.show(done, all); });
  }();

  publish(request.files,
          [&](output::Pictures pictures) {
            return report1986::comparison_document(comparison, input.impact, units, pictures);
          },
          {{"--json", [&](const Target&) { return report1986::comparison_json(comparison); }},
           {"--picture", [&](const Target& target) {
              return picture_text(report1986::comparison_plot(comparison, input.impact, units), target);
            }}});
  return comparison.runs.front().trustworthy && comparison.runs[report1986::Comparison::reference].trustworthy
             ? exit_done
             : exit_not_trusted;
}

/// Refuses a pulse that cannot be aligned, before anything is solved.
void judge_pulse(const injury::PulseReport& pulse, injury::Alignment alignment) {
  try {
    injury::check_alignment(injury::pulse_shape(pulse.pulse, std::nullopt), alignment);
  } catch (const std::invalid_argument& error) {
    throw Refused({fmt::format("--pulse {}: {}", pulse.file, error.what())});
  }
}

int compare_with_pulse(const CompareRequest& request) {
  std::vector<std::string> errors;
  judge_picture(request.files, errors);
  const std::optional<input::CaseFile> input = read_case(request.given, errors);
  PulseRequest asked = request.pulse;
  injury::MeasuredImpact impact;
  if (input) {
    impact = {.speed = input->impact.impactor.speed, .gravity = input->impact.impactor.gravity};
    asked.case_impact = impact;
  }
  const injury::PulseReport pulse = pulse_report(asked, std::move(errors), [&](auto files, auto& faults) {
    std::ranges::move(files_of(request.given.file, input), std::back_inserter(files));
    judge_files(request.files, files, faults);
  });
  const injury::Alignment alignment = *std::ranges::find_if(
      injury::all_alignments, [&](injury::Alignment each) { return request.align == to_string(each); });
  judge_pulse(pulse, alignment);
  Solution solution = solve_with_progress(input->impact, input->options);
  add_intervals_with_progress(input->impact, input->options, solution);
  const injury::PulseComparison comparison = injury::compare_pulses(pulse, solution, impact, alignment);
  const output::PulseComparisonReport report{request.given.file, input->impact, solution, pulse, comparison};
  const UnitSystem& units = unit_system(request.files.units);
  publish(
      request.files,
      [&](output::Pictures pictures) { return output::pulse_comparison_document(report, units, pictures); },
      {{"--json", [&](const Target&) { return output::pulse_comparison_json(report); }},
       {"--picture", [&](const Target& target) {
          return picture_text(output::pulse_comparison_plot(report, units), target);
        }}});
  return exit_code(solution.summary);
}

int compare(const CompareRequest& request) {
  return request.pulse.file.empty() ? compare_with_1984(request) : compare_with_pulse(request);
}

/// Adds --pulse and its options as a group of the help.
void add_pulse_options(CLI::App& sub, CompareRequest& request, CLI::Option* time_step) {
  CLI::Option* pulse = add_option(sub, "--pulse FILE", request.pulse.file,
                                  "Measured pulse to compare with: a table or an ISO-MME test")
                           ->excludes(time_step);
  const std::vector<CLI::Option*> before = sub.get_options();
  std::vector<std::string> names;
  for (const injury::Alignment alignment : injury::all_alignments)
    names.emplace_back(injury::to_string(alignment));
  add_option(sub, "--align NAME", request.align, "Alignment in time: onset (default), peak or none")
      ->check(CLI::IsMember(names));
  add_source_options(sub, request.pulse);
  add_processing_options(sub, request.pulse);
  add_impact_options(sub, request.pulse);
  for (CLI::Option* option : sub.get_options())
    if (std::ranges::find(before, option) == before.end()) option->needs(pulse)->group("With --pulse");
}

}  // namespace

void add_compare(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<CompareRequest>(
      app, action, "compare", "Compare a case with a measured pulse, or with the 1984 program",
      compare_footer, compare);
  add_case(sub, request.given);
  add_file(sub, request.files, "--picture", "Draw the curves against time (.svg, .png, .pdf)");
  add_file(sub, request.files, "--json", "Write the table as JSON, in SI units (- for standard output)");
  add_documents(sub, request.files);
  add_units(sub, request.files.units);
  CLI::Option* time_step = add_option(sub, "--time-step MS", request.time_step_ms,
                                      "Time step of the 1984 program, in ms (default: 0.1)")
                               ->check(CLI::Range(1e-6, 1e3));
  add_force(sub, request.files.force);
  add_material_folder(sub, request.given.materials);
  add_pulse_options(sub, request, time_step);
}

}  // namespace dashpad::app
