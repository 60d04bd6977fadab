// Reads and evaluates a measured pulse.

#include "pulse/request.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/injury/metrics.hpp"
#include "dashpad/input/iso_mme/iso_mme.hpp"
#include "progress_line.hpp"

namespace dashpad::app {

namespace {

constexpr double usual_speed = 15e6;  // bytes of a table per second, on one core of 2020

injury::ProcessedPulse processed(const injury::MeasuredPulse& measured, const PulseSettings& settings,
                                 const std::optional<injury::PulseFilter>& filter,
                                 std::vector<std::string>& errors) {
  try {
    return injury::processed_pulse(measured, settings.interval, filter);
  } catch (const std::invalid_argument& error) {
    errors.push_back(fmt::format("{}: {}", filter ? "--filter" : "--resample", error.what()));
    return {};
  }
}

/// The offset in the interval of --zero, or in the quiet part. Removes earlier samples at another level.
std::optional<injury::SensorOffset> offset_of(const PulseRequest& request, const PulseSettings& settings,
                                              injury::MeasuredPulse& measured,
                                              std::vector<std::string>& errors) {
  try {
    return injury::find_offset(measured, settings.zero_interval, request.zero.has_value());
  } catch (const std::invalid_argument& error) {
    errors.push_back(fmt::format("--zero {}: {}", *request.zero, error.what()));
    return std::nullopt;
  }
}

/// The expected time to read and evaluate a file, s.
double expected_time(const std::string& file) {
  std::error_code error;
  const auto bytes = static_cast<double>(std::filesystem::file_size(file, error));
  return error ? 0 : bytes / usual_speed;
}

void remark_on(injury::PulseReport& report) {
  std::vector<std::string>& remarks = report.measured.remarks;
  if (report.filter)
    for (std::string& remark : injury::filter_remarks(report.measured, report.resampled_to, *report.filter))
      remarks.push_back(std::move(remark));
  if (report.offset)
    for (std::string& remark : injury::offset_remarks(*report.offset, report.figures.peak.magnitude))
      remarks.push_back(std::move(remark));
}

}  // namespace

injury::PulseReport pulse_report(
    const PulseRequest& request, std::vector<std::string> errors,
    const std::function<void(const std::vector<input::InputFile>&, std::vector<std::string>&)>& judge) {
  const bool is_test = input::is_iso_mme(request.file);
  for (std::string& line : out_of_place(request, is_test)) errors.push_back(std::move(line));
  PulseSettings settings = settings_of(request, errors);
  injury::PulseReport report;
  report.file = request.file;
  report.resampled_to = settings.interval;
  report.filter = filter_of(request);
  report.impact = settings.impact;
  for (const auto& [what, words] :
       {std::pair{"Position", &request.position}, {"Date", &request.date}, {"Note", &request.note}})
    if (!words->empty()) report.about.emplace_back(what, *words);
  ProgressLine waiting("Reading " + request.file);
  if (errors.empty()) waiting.expect(expected_time(request.file));
  std::vector<input::InputFile> files{{"the measurement", request.file}};
  if (auto pulse = taken(input::read_pulse(request.file, settings.source), errors)) {
    report.measured = std::move(pulse->measured);
    files = std::move(pulse->files);
  }
  judge(files, errors);
  if (!errors.empty()) throw Refused(std::move(errors));
  waiting.now(fmt::format("Computing figures from {} samples", report.measured.pulse.time.size()));
  const std::optional<injury::SensorOffset> offset = offset_of(request, settings, report.measured, errors);
  if (report.filter && !settings.interval)
    report.resampled_to = settings.interval = injury::resampling_for_filter(report.measured);
  injury::ProcessedPulse pulse = processed(report.measured, settings, report.filter, errors);
  if (!errors.empty()) throw Refused(std::move(errors));
  injury::ProcessedPulse zero =
      offset ? processed(injury::zeroed(report.measured, *offset), settings, report.filter, errors) : pulse;
  if (request.zero) std::swap(pulse, zero);
  const double hic15_of_other = offset ? injury::hic(zero.pulse, injury::hic15_window).value : 0;
  report.contact = injury::contact_of(
      pulse.along(), offset ? std::optional{injury::Stretch{offset->begin, offset->end}} : std::nullopt);
  report.pulse = std::move(pulse.pulse);
  report.figures = injury::injury_figures(report.pulse);
  report.figures.velocity_change = report.contact.velocity_change;
  if (offset) {
    report.offset = {*offset, settings.zero_interval.has_value(), request.zero.has_value(),
                     report.figures.hic15.value, hic15_of_other};
    if (request.zero) std::swap(report.offset->hic15_with, report.offset->hic15_without);
  }
  for (const double window : settings.windows)
    report.windows.push_back({window, injury::hic(report.pulse, window)});
  std::vector<double> levels = settings.levels;
  if (request.standard)
    for (const double level : injury::dwell_levels(*request.standard))
      if (std::ranges::find(levels, level) == levels.end()) levels.push_back(level);
  for (const double level : levels)
    report.dwells.push_back(
        {level, injury::cumulative_dwell(report.pulse, level), injury::longest_dwell(report.pulse, level)});
  remark_on(report);
  report.flags = injury::flags(report, request.zero ? report.pulse : zero.pulse);
  if (report.impact && request.case_impact)
    if (auto flag = injury::unlike_speeds(*report.impact, *request.case_impact))
      report.flags.insert(report.flags.begin(), *std::move(flag));
  return report;
}

}  // namespace dashpad::app
