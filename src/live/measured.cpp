#include "live/measured.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/fit/proposal.hpp"
#include "dashpad/injury/pulse_comparison.hpp"
#include "dashpad/injury/pulse_report.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "dashpad/output/card_toml.hpp"
#include "dashpad/output/proposal.hpp"
#include "dashpad/output/pulse.hpp"
#include "live/request.hpp"

namespace dashpad::live {

Json fit_tests(const Json& request) {
  const std::vector<std::string> names = texts_of(request, "files");
  std::vector<input::Fault> faults;
  const auto rate = value_of(request, "rate", "--rate", "1/s", faults);
  input::StressStrainColumns columns;
  columns.thickness = value_of(request, "thickness", "--thickness", "m", faults);
  columns.area = value_of(request, "area", "--area", "m2", faults);
  if (names.empty())
    add(input::fault_of_file("fit", "needs the table of at least one compression test"), faults);
  if (!faults.empty()) return faults_json(faults);
  const std::vector<double> rates(rate ? names.size() : 0, rate.value_or(0));
  auto proposal = fit::propose({names.begin(), names.end()}, rates, columns);
  if (!proposal) return faults_json(proposal.faults());
  const fit::AutoFit result = fit::run_proposal(*std::move(proposal));
  Json answer;
  if (result.report.converged) answer["card"] = output::card_toml(result.report.material);
  add_page(answer, output::proposal_document(result, units_of(request), output::Pictures::drawn),
           units_of(request));
  return answer;
}

Json show_pulse(const Json& request, const Folders& folders) {
  const auto asked = read_asked(request, folders);
  if (!asked) return faults_json(asked.faults());
  const std::string file = text_of(request, "pulse");
  auto pulse = input::read_pulse_csv(file, {});
  if (!pulse) return faults_json(pulse.faults());
  const UnitSystem& units = units_of(request);
  const Impactor& impactor = asked->impact.impactor;
  injury::PulseTreatment treatment{
      .impact = injury::MeasuredImpact{.speed = impactor.speed, .gravity = impactor.gravity}};
  if (asked->standard) treatment.standard = &*asked->standard;
  treatment.offset = injury::find_offset(pulse->measured, std::nullopt, false);
  injury::PulseReport report = injury::evaluate_pulse(file, std::move(pulse->measured), treatment);
  report.uncertainty = injury::measurement_uncertainty(report, std::nullopt);
  if (asked->standard) report.limits = injury::within_limits(report, *asked->standard);
  Json answer;
  const injury::PulseShape shape = injury::pulse_shape(report.pulse, std::nullopt);
  if (shape.onset) {
    const std::vector<Blow> blows = solved_blows(request, *asked, asked->given.options);
    const Solution& solution = blows.back().solution;
    const injury::PulseComparison comparison =
        injury::compare_pulses(report, solution, *treatment.impact, injury::Alignment::onset);
    const output::PulseComparisonReport both{name_of_case, asked->impact, solution, report, comparison};
    add_page(answer, output::pulse_comparison_document(both, units, output::Pictures::drawn), units);
    answer["comparison"] = answer["html"];
  }
  add_page(answer, output::pulse_document(report, units, output::Pictures::drawn), units);
  return answer;
}

}  // namespace dashpad::live
