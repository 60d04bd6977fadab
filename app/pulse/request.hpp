#pragma once
/// What `dashpad pulse` was asked for, and what it and `dashpad compare --pulse` do with a measured pulse
/// before they show it.

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
  input::PulseCsvOptions table;
  std::string channel;
  bool resultant = false;
  bool list = false;
  std::optional<std::string> filter;
  std::optional<std::string> corner;
  std::optional<std::string> ends;
  std::optional<std::string> resample;
  std::optional<std::string> zero;
  std::optional<std::string> interval;
  std::vector<std::string> sensitivities;
  std::optional<std::string> speed;
  std::optional<std::string> drop_height;
  /// Of a case beside which the pulse is laid: where neither --speed nor --drop-height is given.
  std::optional<injury::MeasuredImpact> case_impact = {};
  std::optional<std::string> calibration;
  /// What whoever measured says of it.
  std::string position, date, note;
  /// Beside whose limits it is laid.
  std::optional<injury::Standard> standard = {};
  std::vector<double> windows_ms;
  std::vector<std::string> dwells;
};

/// What the options say beside the file.
struct PulseSettings {
  std::optional<double> interval;                          ///< s
  std::vector<double> windows, levels;                     ///< s, m/s2
  std::optional<std::pair<double, double>> zero_interval;  ///< s; absent for that of the quiet part
  std::optional<double> interval_of_samples;               ///< s, of a table without times
  std::vector<input::Sensitivity> sensitivities;
  std::optional<injury::MeasuredImpact> impact;  ///< with its speed
};

/// Adds to `wrong` all that is wrong with them.
PulseSettings settings_of(const PulseRequest& request, std::vector<std::string>& errors);

/// Of --calibration: relative, k = 2.
std::optional<double> calibration_of(const PulseRequest& request, std::vector<std::string>& errors);

std::optional<injury::PulseFilter> filter_of(const PulseRequest& request);

/// Complaints about options that mean nothing for this kind of file.
std::vector<std::string> out_of_place(const PulseRequest& request, bool is_test);

/// Options for the choice of columns or channels.
void add_source_options(CLI::App& sub, PulseRequest& request);
/// Options for what is done to the pulse, and for its impact speed.
void add_processing_options(CLI::App& sub, PulseRequest& request);
/// Options for further figures.
void add_figure_options(CLI::App& sub, PulseRequest& request);

/// The pulse of the request, read, zeroed, resampled and filtered as asked for, with its figures and flags.
/// `judge` sees the files that it was read from, and may add to `wrong`. Throws Refused with all that is
/// wrong then.
injury::PulseReport pulse_report(
    const PulseRequest& request, std::vector<std::string> errors,
    const std::function<void(const std::vector<input::InputFile>&, std::vector<std::string>&)>& judge);

}  // namespace dashpad::app
