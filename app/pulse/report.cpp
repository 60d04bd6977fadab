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

input::Reading<input::PulseFile> read(const PulseRequest& request, const PulseSettings& settings,
                                      bool is_test) {
  if (is_test)
    return input::read_iso_mme(request.file, {request.channel, request.table.acceleration_unit,
                                              request.resultant, settings.sensitivities});
  input::PulseCsvOptions options = request.table;
  options.resultant = request.resultant;
  options.interval = settings.interval_of_samples;
  options.sensitivity = settings.sensitivities;
  return input::read_pulse_csv(request.file, options);
}

injury::ProcessedPulse processed(const injury::MeasuredPulse& measured, const PulseSettings& settings,
                                 const std::optional<injury::PulseFilter>& filter,
                                 std::vector<std::string>& errors) {
  try {
    return injury::processed_pulse(measured, settings.interval, filter);
  } catch (const std::invalid_argument& error) {
    const char* advice =
        filter && !settings.interval ? "; --resample INTERVAL resamples at a different interval" : "";
    errors.push_back(fmt::format("{}: {}{}", filter ? "--filter" : "--resample", error.what(), advice));
    return {};
  }
}

/// The offset in the interval of --zero, or in the quiet part. Removes earlier samples at another level.
std::optional<injury::SensorOffset> offset_of(const PulseRequest& request, const PulseSettings& settings,
                                              injury::MeasuredPulse& measured,
                                              std::vector<std::string>& errors) {
  std::optional<injury::SensorOffset> offset = injury::offset_before_impact(measured);
  std::optional<double> begin;
  if (offset && offset->rest) begin = offset->begin;
  if (!settings.zero_interval) {
    if (request.zero && !offset)
      errors.emplace_back(
          "--zero auto: there is no quiet part before the impact; give an interval with --zero BEGIN,END");
  } else {
    try {
      offset =
          injury::offset_between(measured, settings.zero_interval->first, settings.zero_interval->second);
    } catch (const std::invalid_argument& error) {
      const std::vector<double>& time = measured.pulse.time;
      errors.push_back(fmt::format("--zero {}: {}; the samples are from {:.6g} to {:.6g} ms", *request.zero,
                                   error.what(), 1e3 * time.front(), 1e3 * time.back()));
    }
  }
  if (begin) injury::leave_out_before(measured, *begin);
  return offset;
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
    if (auto remark = injury::sampled_too_slowly(report.measured, report.resampled_to, *report.filter))
      remarks.push_back(std::move(*remark));
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
  const PulseSettings settings = settings_of(request, errors);
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
  if (auto pulse = taken(read(request, settings, is_test), errors)) {
    report.measured = std::move(pulse->measured);
    files = std::move(pulse->files);
  }
  judge(files, errors);
  if (!errors.empty()) throw Refused(std::move(errors));
  waiting.now(fmt::format("Computing figures of {} samples", report.measured.pulse.time.size()));
  const std::optional<injury::SensorOffset> offset = offset_of(request, settings, report.measured, errors);
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
