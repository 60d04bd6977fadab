// The options of dashpad pulse.

#include "pulse/request.hpp"

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::app {

namespace {

/// "150" and "150 g" are 150 times gravity.
double level_of(std::string text) {
  while (text.ends_with(' ')) text.pop_back();
  const bool ends_in_g = text.ends_with('g') || text.ends_with('G');
  if (ends_in_g) text.pop_back();
  if (!ends_in_g && text.find_first_not_of("0123456789.eE+- ") != std::string::npos)
    return stated_si(text, "m/s2");
  return stated_si(text, "1") * standard_gravity;
}

/// The impact by --speed, --drop-height or a case.
std::optional<injury::MeasuredImpact> impact_of(const PulseRequest& request,
                                                std::vector<std::string>& errors) {
  const std::optional<double> speed = positive_quantity_of("--speed", request.speed, "m/s", errors);
  const std::optional<double> height =
      positive_quantity_of("--drop-height", request.drop_height, "m", errors);
  if (request.speed && request.drop_height)
    errors.emplace_back("--drop-height: give --speed or --drop-height, not both");
  if (height) return injury::after_fall(*height);
  if (!request.speed && !request.drop_height && request.case_impact) return request.case_impact;
  return speed ? std::optional{injury::MeasuredImpact{.speed = *speed}} : std::nullopt;
}

}  // namespace

std::optional<double> calibration_of(const PulseRequest& request, std::vector<std::string>& errors) {
  const std::optional<double> share = quantity_of("--calibration", request.calibration, "1", errors);
  if (share && !(*share > 0 && *share < injury::max_calibration))
    errors.push_back(fmt::format("--calibration {}: must be more than 0 and less than {:.0f} %",
                                 *request.calibration, 100 * injury::max_calibration));
  return share;
}

std::optional<injury::PulseFilter> filter_of(const PulseRequest& request) {
  if (!request.filter) return std::nullopt;
  injury::PulseFilter filter{std::stoi(request.filter->substr(3)),
                             request.corner == "iso" ? injury::Corner::iso_6487 : injury::Corner::sae_j211,
                             injury::Ends::mirrored};
  for (const injury::Ends ends : injury::all_ends)
    if (request.ends == to_string(ends)) filter.ends = ends;
  return filter;
}

PulseSettings settings_of(const PulseRequest& request, std::vector<std::string>& errors) {
  PulseSettings settings;
  settings.interval = positive_quantity_of("--resample", request.resample, "s", errors);
  settings.source = request.source;
  settings.source.interval = quantity_of("--interval", request.interval, "s", errors);
  if (settings.source.interval && !(*settings.source.interval > 0))
    errors.push_back(fmt::format("--interval {}: must be more than 0", *request.interval));
  input::CutTimes& cut = settings.source.cut;
  cut = {quantity_of("--from", request.from, "s", errors), quantity_of("--to", request.to, "s", errors)};
  if (cut.from && cut.to && !(*cut.from < *cut.to))
    errors.push_back(fmt::format("--to {}: must be later than --from {}", *request.to, *request.from));
  if (request.zero) try {
      settings.zero_interval = input::interval_of_zero(*request.zero);
    } catch (const UnitError& error) {
      errors.push_back(fmt::format("--zero {}: {}", *request.zero, error.what()));
    }
  for (const std::string& text : request.sensitivities) {
    try {
      settings.source.sensitivity.push_back(input::sensitivity_of(text));
    } catch (const UnitError& error) {
      errors.push_back(fmt::format("--sensitivity {}: {}", text, error.what()));
    }
  }
  settings.impact = impact_of(request, errors);
  for (const double window : request.windows_ms) {
    const Magnitudes times = measured_magnitudes("s");
    if (!(window > 0))
      errors.push_back(fmt::format("--window {}: must be more than 0 ms", window));
    else if (!times.admit(1e-3 * window))
      errors.push_back(fmt::format("--window {}: must be between {:g} and {:g} ms", window, 1e3 * times.least,
                                   1e3 * times.most));
    settings.windows.push_back(1e-3 * window);
  }
  for (const std::string& text : request.dwells) {
    try {
      settings.levels.push_back(level_of(text));
      if (!(settings.levels.back() >= 0))
        errors.push_back(fmt::format("--dwell {}: must be at least 0", text));
    } catch (const UnitError& error) {
      errors.push_back(fmt::format("--dwell {}: {}; a number without a unit is in g", text, error.what()));
    }
  }
  if (request.dwells.empty())
    for (const double level : {80, 150, 200}) settings.levels.push_back(level * standard_gravity);
  return settings;
}

std::vector<std::string> out_of_place(const PulseRequest& request, bool is_test) {
  std::vector<std::string> errors;
  const auto say = [&](bool given, const std::string& option, const std::string& rule) {
    if (given) errors.push_back(option + ": " + rule);
  };
  if (is_test) {
    const std::string rule = "applies only to tables; an ISO-MME test has channels: see --list and --channel";
    say(!request.source.time.empty(), "--time", rule);
    say(!request.source.acceleration.empty(), "--acceleration", rule);
    say(!request.source.time_unit.empty(), "--time-unit",
        "applies only to tables; in ISO-MME, times are in s");
    say(request.interval.has_value(), "--interval",
        "applies only to tables; an ISO-MME test states its times");
  } else {
    const std::string only_tests = "applies only to ISO-MME; a table has columns: see --acceleration";
    say(!request.source.channel.empty(), "--channel", only_tests);
    say(!request.source.test.empty(), "--test", only_tests);
    const std::string rule = "applies only to a table with times; with --interval, no times are read";
    say(request.interval && !request.source.time.empty(), "--time", rule);
    say(request.interval && !request.source.time_unit.empty(), "--time-unit", rule);
    say(request.interval && request.source.bridge_gaps, "--bridge-gaps", rule);
  }
  say(request.corner && !request.filter, "--corner", "applies only with --filter");
  say(request.ends && !request.filter, "--ends", "applies only with --filter");
  return errors;
}

void add_source_options(CLI::App& sub, PulseRequest& request) {
  add_option(sub, "--time COLUMN", request.source.time,
             "Time column: its name, or its number, counting from 1");
  add_option(sub, "--acceleration COLUMN", request.source.acceleration,
             "Acceleration column: its name or number; up to three with --resultant");
  add_option(sub, "--time-unit UNIT", request.source.time_unit, "Unit of the times, such as ms");
  add_option(sub, "--acceleration-unit UNIT", request.source.acceleration_unit,
             "Unit of the acceleration, such as g or m/s2");
  add_flag(sub, "--resultant", request.source.resultant,
           "Combine two or three directions, each filtered first: sqrt(x^2 + y^2 + z^2)");
  add_flag(sub, "--bridge-gaps", request.source.bridge_gaps,
           "Interpolate linearly where the times show that samples are missing");
  add_option(sub, "--interval TIME", request.interval,
             "Time between samples, such as \"0.1 ms\", for a table without times");
  add_option(sub, "--sensitivity VALUE", request.sensitivities,
             "Sensor sensitivity, such as \"10 mV/g\", for columns in V or mV; one for all directions, or "
             "one for each");
  add_option(sub, "--from TIME", request.from, "First time to use, such as \"300 ms\"");
  add_option(sub, "--to TIME", request.to, "Last time to use");
  add_option(sub, "--test NAME", request.source.test,
             "Name of the test, if a folder or archive contains several ISO-MME tests");
  add_option(sub, "--channel CODE", request.source.channel,
             "Channel of an ISO-MME test: its number, or its code with ? for any character");
}

void add_processing_options(CLI::App& sub, PulseRequest& request) {
  add_option(sub, "--zero BEGIN,END", request.zero,
             "Subtract the sensor's offset first: its mean over an interval, such as \"0 ms,5 ms\", or "
             "\"auto\" for the mean over the quiet part before the impact");
  add_option(sub, "--filter CLASS", request.filter, "CFC60, CFC180, CFC600 or CFC1000 (default: none)")
      ->check(CLI::IsMember({"CFC60", "CFC180", "CFC600", "CFC1000"}));
  add_option(sub, "--corner NAME", request.corner,
             "Corner frequency of the filter: sae (SAE J211, default) or iso (ISO 6487)")
      ->check(CLI::IsMember({"sae", "iso"}));
  add_option(
      sub, "--ends NAME", request.ends,
      "Extension of the pulse for the filter: mirrored (default), held, mirrored-from-mean, negated-before")
      ->check(CLI::IsMember({"mirrored", "held", "mirrored-from-mean", "negated-before"}));
  add_option(sub, "--resample INTERVAL", request.resample,
             "Interval, such as \"0.1 ms\", at which the pulse is first resampled");
}

void add_impact_options(CLI::App& sub, PulseRequest& request) {
  add_option(sub, "--speed SPEED", request.speed,
             "Impact speed, such as \"5 m/s\", for the restitution and a check of the pulse");
  add_option(sub, "--drop-height LENGTH", request.drop_height,
             "Free-fall height, such as \"1.5 m\", instead of the speed");
}

void add_calibration(CLI::App& sub, PulseRequest& request) {
  add_option(sub, "--calibration SHARE", request.calibration,
             "Calibration uncertainty of the sensor (k = 2), such as \"2 %\"; included in the uncertainty of "
             "the figures");
}

void add_figure_options(CLI::App& sub, PulseRequest& request) {
  add_calibration(sub, request);
  add_option(sub, "--position TEXT", request.position, "Location of the impact on the pad, as free text");
  add_option(sub, "--date TEXT", request.date, "Date of the measurement, as free text");
  add_option(sub, "--note TEXT", request.note,
             "Further remarks for the page, such as surface, temperature or operator");
  add_option(sub, "--window MS", request.windows_ms, "Add the HIC for windows of at most MS milliseconds");
  add_option(sub, "--dwell LEVEL", request.dwells,
             "Give the time above LEVEL, in g (default: 80, 150 and 200)");
}

}  // namespace dashpad::app
