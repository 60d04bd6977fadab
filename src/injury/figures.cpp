#include "dashpad/injury/figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "dashpad/impact/flags.hpp"
#include "dashpad/quantities/constants.hpp"
#include "injury/pulse_line.hpp"

namespace dashpad::injury {
namespace {

constexpr InjuryFigures::Errors all_unknown{infinite, infinite, infinite, infinite, infinite,
                                            infinite, infinite, infinite, infinite};
static_assert(sizeof(all_unknown) == 9 * sizeof(double), "an infinity for each error");

}  // namespace

InjuryFigures injury_figures(const Pulse& pulse) {
  check(pulse);
  InjuryFigures figures;
  figures.peak = peak(pulse);
  figures.hic15 = hic(pulse, hic15_window);
  figures.hic36 = hic(pulse, hic36_window);
  figures.hic_unlimited = hic(pulse, unlimited_window);
  figures.hic_d = hic_d(figures.hic36.value);
  figures.clip_3ms = contiguous_clip(pulse, usual_clip);
  figures.cumulative_3ms = cumulative_clip(pulse, usual_clip);
  figures.severity_index = severity_index(pulse);
  figures.velocity_change = velocity_change(pulse);
  return figures;
}

std::array<InjuryValue, 9> injury_values(const InjuryFigures& figures) {
  const InjuryFigures::Errors& errors = figures.errors;
  const auto value = [](const char* key, double size, double error) {
    return InjuryValue{.quantity = &result_quantity(key), .value = size, .error = error};
  };
  const auto within = [&](const char* key, const auto& window, double size, double error) {
    InjuryValue result = value(key, size, error);
    result.begin = window.begin;
    result.end = window.end;
    return result;
  };
  InjuryValue peak = value("peak_acceleration", figures.peak.magnitude, errors.peak);
  peak.time = figures.peak.time;
  return {
      peak,
      within("hic15", figures.hic15, figures.hic15.value, errors.hic15),
      within("hic36", figures.hic36, figures.hic36.value, errors.hic36),
      within("hic_unlimited", figures.hic_unlimited, figures.hic_unlimited.value, errors.hic_unlimited),
      value("hic_d", figures.hic_d, errors.hic_d),
      within("clip_3ms", figures.clip_3ms, figures.clip_3ms.level, errors.clip_3ms),
      within("cumulative_3ms", figures.cumulative_3ms, figures.cumulative_3ms.level, errors.cumulative_3ms),
      value("severity_index", figures.severity_index, errors.severity_index),
      value("velocity_change", figures.velocity_change, errors.velocity_change)};
}

std::optional<InjuryValue> injury_value(const InjuryFigures& injury_figures, const ResultQuantity& quantity) {
  for (const InjuryValue& value : injury_values(injury_figures))
    if (value.quantity == &quantity) return value;
  return std::nullopt;
}

Pulse pulse_of(const History& history) { return {history.time, history.acceleration}; }

/// The error is that of the time steps plus the solver's error of the force times the exponent of the
/// acceleration. Without a coarser run only the error of the peak is known.
InjuryFigures injury_figures(const Solution& solution) {
  const Pulse pulse = pulse_of(solution.history);
  InjuryFigures figures = injury_figures(pulse);
  // The solver's peak may lie between two samples of the history.
  const Summary& summary = solution.summary;
  if (summary.peak_acceleration && summary.time_of_peak_force)
    figures.peak = {*summary.peak_acceleration, *summary.time_of_peak_force};
  const double force = summary.errors.peak_force;
  if (!has_coarser_run(solution)) {
    figures.errors = all_unknown;
    figures.errors.peak = force;
    return figures;
  }
  const InjuryFigures coarser = injury_figures(solution.coarser);
  figures.errors.peak = force;
  figures.errors.clip_3ms = step_error(pulse, figures.clip_3ms, coarser.clip_3ms) + force;
  figures.errors.cumulative_3ms = step_error(pulse, figures.cumulative_3ms, coarser.cumulative_3ms) + force;
  figures.clip_3ms.level = extrapolated(figures.clip_3ms.level, coarser.clip_3ms.level);
  figures.cumulative_3ms.level = extrapolated(figures.cumulative_3ms.level, coarser.cumulative_3ms.level);
  const auto refine = [force](const char* key, double& value, double coarse, double& error) {
    error = step_error(value, coarse) + acceleration_power(key) * force;
    value = extrapolated(value, coarse);
  };
  InjuryFigures::Errors& errors = figures.errors;
  refine("hic15", figures.hic15.value, coarser.hic15.value, errors.hic15);
  refine("hic36", figures.hic36.value, coarser.hic36.value, errors.hic36);
  refine("hic_unlimited", figures.hic_unlimited.value, coarser.hic_unlimited.value, errors.hic_unlimited);
  figures.hic_d = hic_d(figures.hic36.value);
  errors.hic_d = hic_d_error(errors.hic36, figures.hic_d, force);
  refine("severity_index", figures.severity_index, coarser.severity_index, errors.severity_index);
  refine("velocity_change", figures.velocity_change, coarser.velocity_change, errors.velocity_change);
  return figures;
}

bool has_whole_pulse(const Solution& solution) {
  return pulse_is_whole(solution.summary) && solution.history.size() >= 2 &&
         std::ranges::all_of(solution.history.acceleration,
                             [](double value) { return std::isfinite(value); });
}

std::optional<InjuryFigures> whole_pulse_figures(const Solution& solution) {
  return has_whole_pulse(solution) ? std::optional(injury_figures(solution)) : std::nullopt;
}

double chord_error(const Pulse& pulse, const Clip& clip) {
  if (!(clip.level > 0)) return 0;
  const std::vector<double>&t = pulse.time, &a = pulse.acceleration;
  const auto bend = [&](std::size_t i) {
    if (i == 0 || i + 1 >= t.size()) return 0.0;
    const double before = t[i] - t[i - 1], after = t[i + 1] - t[i];
    if (!(before > 0 && after > 0)) return 0.0;
    return 2 * std::abs((a[i + 1] - a[i]) / after - (a[i] - a[i - 1]) / before) / (before + after);
  };
  const auto first = std::ranges::upper_bound(t, clip.begin);
  double error = 0;
  for (auto i = std::size_t(std::max(first - t.begin(), std::ptrdiff_t{1})); i < t.size(); ++i) {
    const double from = std::abs(a[i - 1]), to = std::abs(a[i]), length = t[i] - t[i - 1];
    if (std::min(from, to) <= clip.level && clip.level <= std::max(from, to))
      error = std::max(error, length * length * std::max(bend(i - 1), bend(i)) / 8);
    if (t[i] >= clip.end) break;
  }
  return error / clip.level;
}

Peak peak(const Pulse& pulse) {
  check(pulse);
  const std::size_t top = peak_sample(pulse);
  return {std::abs(pulse.acceleration[top]), pulse.time[top]};
}

double velocity_change(const Pulse& pulse) {
  check(pulse);
  AccurateSum sum;
  for (std::size_t i = 1; i < pulse.time.size(); ++i) {
    const double mean = pulse.acceleration[i - 1] / 2 + pulse.acceleration[i] / 2;
    sum.add(mean * (pulse.time[i] - pulse.time[i - 1]));
  }
  return std::abs(sum.value());
}

}  // namespace dashpad::injury
