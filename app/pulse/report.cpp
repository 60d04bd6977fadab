// Reads and evaluates a measured pulse.

#include "pulse/request.hpp"

#include <filesystem>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/iso_mme/iso_mme.hpp"
#include "progress_line.hpp"

namespace dashpad::app {

namespace {

constexpr double usual_speed = 15e6;  // bytes of a table per second, on one core of 2020

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

}  // namespace

injury::PulseReport pulse_report(
    const PulseRequest& request, std::vector<std::string> errors,
    const std::function<void(const std::vector<input::InputFile>&, std::vector<std::string>&)>& judge) {
  const bool is_test = input::is_iso_mme(request.file);
  for (std::string& line : out_of_place(request, is_test)) errors.push_back(std::move(line));
  PulseSettings settings = settings_of(request, errors);
  ProgressLine waiting("Reading " + request.file);
  if (errors.empty()) waiting.expect(expected_time(request.file));
  std::vector<input::InputFile> files{{"the measurement", request.file}};
  injury::MeasuredPulse measured;
  if (auto pulse = taken(input::read_pulse(request.file, settings.source), errors)) {
    measured = std::move(pulse->measured);
    files = std::move(pulse->files);
  }
  judge(files, errors);
  if (!errors.empty()) throw Refused(std::move(errors));
  waiting.now(fmt::format("Computing figures from {} samples", measured.pulse.time.size()));
  injury::PulseTreatment treatment{.resample_to = settings.interval,
                                   .filter = filter_of(request),
                                   .offset = offset_of(request, settings, measured, errors),
                                   .offset_is_given = settings.zero_interval.has_value(),
                                   .subtracts_offset = request.zero.has_value(),
                                   .windows = settings.windows,
                                   .levels = settings.levels,
                                   .impact = settings.impact,
                                   .computed = request.case_impact};
  if (request.standard) treatment.standard = &*request.standard;
  injury::PulseReport report;
  try {
    report = injury::evaluate_pulse(request.file, std::move(measured), treatment);
  } catch (const std::invalid_argument& error) {
    errors.push_back(fmt::format("{}: {}", treatment.filter ? "--filter" : "--resample", error.what()));
  }
  if (!errors.empty()) throw Refused(std::move(errors));
  for (const auto& [what, words] :
       {std::pair{"Position", &request.position}, {"Date", &request.date}, {"Note", &request.note}})
    if (!words->empty()) report.about.emplace_back(what, *words);
  return report;
}

}  // namespace dashpad::app
