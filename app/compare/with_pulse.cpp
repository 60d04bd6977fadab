// dashpad compare --pulse: a measured pulse over the computed one.

#include "compare/with_pulse.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/output/pulse.hpp"
#include "pulse/report.hpp"

namespace dashpad::app {

namespace {

injury::Alignment alignment_of(const std::string& name) {
  for (const injury::Alignment alignment : injury::all_alignments)
    if (name == injury::to_string(alignment)) return alignment;
  return injury::Alignment::onset;
}

/// Refuses a pulse that cannot be aligned, before anything is solved.
void judge_pulse(const injury::PulseReport& pulse, injury::Alignment alignment) {
  try {
    injury::check_alignment(injury::pulse_shape(pulse.pulse, std::nullopt), alignment);
  } catch (const std::invalid_argument& error) {
    throw Refused({fmt::format("--pulse {}: {}", pulse.file, error.what())});
  }
}

}  // namespace

std::vector<Target> targets(const CompareRequest& request) {
  std::vector<Target> wanted;
  if (request.picture) wanted.push_back({"--picture", *request.picture});
  if (request.json) wanted.push_back({"--json", *request.json});
  add_targets(request.documents, wanted);
  return wanted;
}

int compare_with_pulse(const CompareRequest& request, const std::filesystem::path& materials) {
  std::vector<std::string> wrong;
  judge_picture(request.picture, wrong);
  const std::optional<input::CaseFile> input = read_case(request.given, materials, wrong);
  PulseRequest asked = request.pulse;
  injury::MeasuredImpact impact;
  if (input) {
    impact = {.speed = input->impact.impactor.speed, .gravity = input->impact.impactor.gravity};
    asked.case_impact = impact;
  }
  const injury::PulseReport pulse = pulse_report(asked, std::move(wrong), [&](auto files, auto& faults) {
    std::ranges::move(files_of(request.given.file, input), std::back_inserter(files));
    judge_targets(targets(request), files, request.force, faults);
  });
  const injury::Alignment alignment = alignment_of(request.align);
  judge_pulse(pulse, alignment);
  Solution solution = solve_with_progress(input->impact, input->options);
  add_intervals_with_progress(input->impact, input->options, solution);
  const injury::PulseComparison comparison = injury::compare_pulses(pulse, solution, impact, alignment);
  const output::PulseComparisonReport report{request.given.file, input->impact, solution, pulse, comparison};
  const UnitSystem& units = unit_system(request.units);
  const auto text_of = [&](const Target& target) {
    if (target.option == "--json") return output::pulse_comparison_json(report);
    if (is_document(target))
      return document_text(target, [&](output::Pictures pictures) {
        return output::pulse_comparison_document(report, units, pictures);
      });
    return output::picture(output::pulse_comparison_plot(report, units),
                           *output::picture_format(target.file));
  };
  publish(targets(request), request.force, text_of,
          output::to_terminal(output::pulse_comparison_document(report, units), output::Detail::main));
  return exit_code(solution.summary);
}

void add_pulse_options(CLI::App& sub, CompareRequest& request, CLI::Option* time_step) {
  CLI::Option* pulse =
      sub.add_option("--pulse", request.pulse.file,
                     "A measured pulse to lay over the computed one: a table, or a test in ISO-MME")
          ->excludes(time_step)
          ->type_name("FILE");
  const std::vector<CLI::Option*> before = sub.get_options();
  std::vector<std::string> names;
  for (const injury::Alignment alignment : injury::all_alignments)
    names.emplace_back(injury::to_string(alignment));
  sub.add_option("--align", request.align, "In time: onset (default), peak or none")
      ->check(CLI::IsMember(names))
      ->type_name("NAME");
  add_documents(sub, request.documents);
  add_source_options(sub, request.pulse);
  add_processing_options(sub, request.pulse);
  for (CLI::Option* option : sub.get_options())
    if (std::ranges::find(before, option) == before.end()) option->needs(pulse)->group("With --pulse");
}

}  // namespace dashpad::app
