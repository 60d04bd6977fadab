#include "dashpad/injury/pulse_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/injury/figures.hpp"
#include "injury/pulse_line.hpp"

namespace dashpad::injury {

namespace {

constexpr double free_flight = 20e-3;  // s: longer than the memory of a class 60 filter

/// Finds the first time at that level, and the last one before the peak.
void find_onset(const Pulse& pulse, double level, PulseShape& shape) {
  const Magnitude line = magnitude_of(pulse);
  if (line.front().value >= level) return;
  for_each_stretch(line, level, Bound::reached, [&](double begin, double) {
    if (!shape.onset) shape.onset = begin;
    if (begin <= shape.peak.time) shape.last_onset = begin;
  });
}

/// The computed pulse with its peak, which the solver knows to lie at a sample or between two.
Pulse with_peak(Pulse pulse, const Summary& summary) {
  if (!summary.peak_acceleration || !summary.time_of_peak_force) return pulse;
  const double when = *summary.time_of_peak_force;
  const auto [first, last] = std::equal_range(pulse.time.begin(), pulse.time.end(), when);
  const auto place = pulse.acceleration.begin() + (first - pulse.time.begin());
  if (first != last) {
    *place = -*summary.peak_acceleration;
  } else {
    pulse.acceleration.insert(place, -*summary.peak_acceleration);
    pulse.time.insert(first, when);
  }
  return pulse;
}

/// The finite part of the history.
Pulse finite_pulse(const History& history) {
  Pulse pulse = pulse_of(history);
  const auto finite = [](double value) { return std::isfinite(value); };
  const auto end = std::ranges::find_if_not(pulse.acceleration, finite) - pulse.acceleration.begin();
  pulse.time.resize(static_cast<std::size_t>(end));
  pulse.acceleration.resize(static_cast<std::size_t>(end));
  return pulse;
}

std::optional<double> time_to_peak(const PulseShape& pulse_shape, Alignment alignment) {
  if (alignment == Alignment::none) return pulse_shape.peak.time;
  return pulse_shape.onset ? std::optional{pulse_shape.peak.time - *pulse_shape.onset} : std::nullopt;
}

double shift_of(const PulseShape& measured, const std::optional<PulseShape>& computed, Alignment alignment) {
  switch (alignment) {
    case Alignment::onset: return (computed ? computed->onset.value_or(0) : 0) - *measured.onset;
    case Alignment::peak: return (computed ? computed->peak.time : 0) - measured.peak.time;
    case Alignment::none: return 0;
  }
  return 0;
}

/// The solver's relative error of a figure: that of the force with its exponent, or those of its times.
double error_of_solver(std::string_view key, double value, const Summary& summary) {
  const ErrorEstimates& errors = summary.errors;
  const double contact_end = summary.contact_end ? summary.contact_end->time : 0;
  if (key == "time_to_peak") return (errors.time_of_peak_force + errors.contact_end) * contact_end / value;
  if (key == "half_peak_width") return errors.contact_end;
  if (key == "restitution") return (1 + 1 / value) * errors.peak_force;  // e = dV / v - 1
  return acceleration_power(key) * errors.peak_force;
}

/// Extrapolates the computed figures by the coarser run and sets their errors: those of the solver plus those
/// of the time steps.
void refine(std::array<ComparedFigure, 6>& figures, const std::array<ComparedFigure, 6>& coarser,
            const Summary& summary) {
  for (std::size_t i = 0; i < figures.size(); ++i) {
    std::optional<double>& computed = figures[i].computed;
    if (!computed) continue;
    figures[i].error = step_error(*computed, coarser[i].computed.value_or(0));
    computed = extrapolated(*computed, coarser[i].computed.value_or(*computed));
    figures[i].error += error_of_solver(figures[i].quantity->key, *computed, summary);
  }
}

}  // namespace

const char* to_string(Alignment alignment) {
  constexpr const char* names[]{"onset", "peak", "none"};
  return names[static_cast<std::size_t>(alignment)];
}

Pulse filtered_like(const std::optional<PulseFilter>& filter, double interval, const Pulse& pulse) {
  if (!filter) return pulse;
  const double begin = pulse.time.front(), end = pulse.time.back();
  Pulse flight{{begin - free_flight - interval, begin - interval}, {0, 0}};
  flight.time.insert(flight.time.end(), pulse.time.begin(), pulse.time.end());
  flight.acceleration.insert(flight.acceleration.end(), pulse.acceleration.begin(), pulse.acceleration.end());
  flight.time.insert(flight.time.end(), {end + interval, end + free_flight + interval});
  flight.acceleration.insert(flight.acceleration.end(), {0, 0});
  return cfc_filtered(resampled(flight, interval), filter->channel_frequency_class, filter->corner,
                      filter->ends);
}

PulseShape pulse_shape(const Pulse& pulse, const std::optional<MeasuredImpact>& impact,
                       const std::optional<Contact>& contact) {
  PulseShape shape;
  shape.peak = peak(pulse);
  if (!(shape.peak.magnitude > 0)) throw std::invalid_argument("its acceleration is 0 throughout");
  shape.side = pulse.acceleration[peak_sample(pulse)] < 0 ? -1 : 1;
  find_onset(pulse, onset_share * shape.peak.magnitude, shape);
  shape.width = cumulative_dwell(pulse, shape.peak.magnitude / 2);
  shape.contact = contact ? *contact : contact_of(pulse);
  shape.hic15 = hic(pulse, hic15_window).value;
  if (impact) shape.restitution = restitution(shape.contact, *impact);
  return shape;
}

void check_alignment(const PulseShape& measured, Alignment alignment) {
  if (alignment != Alignment::onset || measured.onset) return;
  throw std::invalid_argument(fmt::format(
      "its first sample is already above {:.0f} % of its peak, so the onset is not in the record; "
      "--align peak and --align none do not need it",
      100 * onset_share));
}

std::array<ComparedFigure, 6> compared_figures(const PulseShape& measured,
                                               const std::optional<PulseShape>& computed,
                                               Alignment alignment) {
  const auto figure = [&](const char* key, auto value) {
    return ComparedFigure{.quantity = &result_quantity(key),
                          .measured = value(measured),
                          .computed = computed ? value(*computed) : std::nullopt};
  };
  using Value = std::optional<double>;
  return {figure("peak_acceleration",
                 [](const PulseShape& pulse_shape) -> Value { return pulse_shape.peak.magnitude; }),
          figure("time_to_peak",
                 [&](const PulseShape& pulse_shape) { return time_to_peak(pulse_shape, alignment); }),
          figure("half_peak_width", [](const PulseShape& pulse_shape) -> Value { return pulse_shape.width; }),
          figure("velocity_change",
                 [](const PulseShape& pulse_shape) -> Value { return pulse_shape.contact.velocity_change; }),
          figure("hic15", [](const PulseShape& pulse_shape) -> Value { return pulse_shape.hic15; }),
          figure("restitution", [](const PulseShape& pulse_shape) { return pulse_shape.restitution; })};
}

PulseComparison compare_pulses(const PulseReport& report, const Solution& solution,
                               const MeasuredImpact& impact, Alignment alignment) {
  PulseComparison comparison;
  comparison.alignment = alignment;
  comparison.measured = pulse_shape(report.pulse, report.impact, report.contact);
  check_alignment(comparison.measured, alignment);
  const Pulse history = finite_pulse(solution.history);
  comparison.computed_pulse = history;
  const auto shape_of = [&](const Pulse& pulse) {
    PulseShape shape = pulse_shape(pulse, impact);
    if (!shape.onset) shape.onset = pulse.time.front();  // a foam that responds at first contact
    return shape;
  };
  const auto processed = [&](const Pulse& pulse) {
    return filtered_like(report.filter, interval_of(report.pulse), with_peak(pulse, solution.summary));
  };
  const bool is_whole = pulse_is_whole(solution.summary) && history.time.size() == solution.history.size() &&
                        has_coarser_run(solution);
  if (is_whole) {
    comparison.computed_pulse = processed(history);
    comparison.computed = shape_of(comparison.computed_pulse);
  }
  comparison.figures = compared_figures(comparison.measured, comparison.computed, alignment);
  if (is_whole)
    refine(comparison.figures,
           compared_figures(comparison.measured, shape_of(processed(solution.coarser)), alignment),
           solution.summary);
  comparison.shift = shift_of(comparison.measured, comparison.computed, alignment);
  return comparison;
}

}  // namespace dashpad::injury
