#pragma once
/// The options of `dashpad pulse`, and the processing of a pulse for it and for `dashpad compare --pulse`.

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "dashpad/injury/pulse_report.hpp"
#include "dashpad/injury/standard.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "dashpad/input/reading.hpp"

namespace dashpad::app {

struct PulseRequest {
  std::string file;
  /// As given; values with units are those of PulseSettings.
  input::PulseOptions source;
  bool list = false;
  std::optional<std::string> filter;
  std::optional<std::string> corner;
  std::optional<std::string> ends;
  std::optional<std::string> resample;
  std::optional<std::string> zero;
  std::optional<std::string> interval, from, to;
  std::vector<std::string> sensitivities;
  std::optional<std::string> speed;
  std::optional<std::string> drop_height;
  /// The impact of a case compared with the pulse, used without --speed and --drop-height.
  std::optional<injury::MeasuredImpact> case_impact = {};
  std::optional<std::string> calibration;
  /// Remarks of the user.
  std::string position, date, note;
  /// The standard whose limits apply.
  std::optional<injury::Standard> standard = {};
  std::vector<double> windows_ms;
  std::vector<std::string> dwells;
};

/// The values of the options.
struct PulseSettings {
  std::optional<double> interval;                          ///< s
  std::vector<double> windows, levels;                     ///< s, m/s2
  std::optional<std::pair<double, double>> zero_interval;  ///< s; absent for the quiet part
  input::PulseOptions source;
  std::optional<injury::MeasuredImpact> impact;  ///< with a known speed
};

/// Adds to `errors` all invalid values.
PulseSettings settings_of(const PulseRequest& request, std::vector<std::string>& errors);

/// The value of --calibration: relative, k = 2.
std::optional<double> calibration_of(const PulseRequest& request, std::vector<std::string>& errors);

std::optional<injury::PulseFilter> filter_of(const PulseRequest& request);

/// Errors for options that do not apply to this kind of file.
std::vector<std::string> out_of_place(const PulseRequest& request, bool is_test);

/// Adds the options for columns or channels.
void add_source_options(CLI::App& sub, PulseRequest& request);
/// Adds the options for processing.
void add_processing_options(CLI::App& sub, PulseRequest& request);
/// Adds the options for the impact speed.
void add_impact_options(CLI::App& sub, PulseRequest& request);
void add_calibration(CLI::App& sub, PulseRequest& request);
/// Adds the options for further figures.
void add_figure_options(CLI::App& sub, PulseRequest& request);

/// Reads and processes the pulse of the request, with its figures and flags. `judge` receives the files that
/// it was read from. Throws Refused with all errors.
injury::PulseReport pulse_report(
    const PulseRequest& request, std::vector<std::string> errors,
    const std::function<void(const std::vector<input::InputFile>&, std::vector<std::string>&)>& judge);

}  // namespace dashpad::app
