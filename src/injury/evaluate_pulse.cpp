#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/injury/metrics.hpp"
#include "dashpad/injury/pulse_report.hpp"

namespace dashpad::injury {

namespace {

void remark_on(PulseReport& report) {
  std::vector<std::string>& remarks = report.measured.remarks;
  if (report.filter)
    for (std::string& remark : filter_remarks(report.measured, report.resampled_to, *report.filter))
      remarks.push_back(std::move(remark));
  if (report.offset)
    for (std::string& remark : offset_remarks(*report.offset, report.figures.peak.magnitude))
      remarks.push_back(std::move(remark));
}

}  // namespace

PulseReport evaluate_pulse(std::string file, MeasuredPulse measured, const PulseTreatment& treatment) {
  PulseReport report;
  report.file = std::move(file);
  report.measured = std::move(measured);
  report.filter = treatment.filter;
  report.impact = treatment.impact;
  report.resampled_to = treatment.resample_to;
  if (report.filter && !report.resampled_to) report.resampled_to = resampling_for_filter(report.measured);
  const auto processed = [&](const MeasuredPulse& each) {
    return processed_pulse(each, report.resampled_to, report.filter);
  };
  const std::optional<SensorOffset>& offset = treatment.offset;
  ProcessedPulse pulse = processed(report.measured);
  ProcessedPulse zero = offset ? processed(zeroed(report.measured, *offset)) : pulse;
  if (treatment.subtracts_offset) std::swap(pulse, zero);
  const double hic15_of_other = offset ? hic(zero.pulse, hic15_window).value : 0;
  report.contact =
      contact_of(pulse.along(), offset ? std::optional{Stretch{offset->begin, offset->end}} : std::nullopt);
  report.pulse = std::move(pulse.pulse);
  report.figures = injury_figures(report.pulse);
  report.figures.velocity_change = report.contact.velocity_change;
  if (offset) {
    report.offset = {*offset, treatment.offset_is_given, treatment.subtracts_offset,
                     report.figures.hic15.value, hic15_of_other};
    if (treatment.subtracts_offset) std::swap(report.offset->hic15_with, report.offset->hic15_without);
  }
  for (const double window : treatment.windows) report.windows.push_back({window, hic(report.pulse, window)});
  std::vector<double> levels = treatment.levels;
  if (treatment.standard != nullptr)
    for (const double level : dwell_levels(*treatment.standard))
      if (std::ranges::find(levels, level) == levels.end()) levels.push_back(level);
  for (const double level : levels)
    report.dwells.push_back(
        {level, cumulative_dwell(report.pulse, level), longest_dwell(report.pulse, level)});
  remark_on(report);
  report.flags = flags(report, treatment.subtracts_offset ? report.pulse : zero.pulse);
  if (report.impact && treatment.computed)
    if (auto flag = unlike_speeds(*report.impact, *treatment.computed))
      report.flags.insert(report.flags.begin(), *std::move(flag));
  return report;
}

}  // namespace dashpad::injury
