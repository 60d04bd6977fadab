#include "study/pulse_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dashpad/injury/clip.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/injury/peak.hpp"
#include "dashpad/injury/severity_index.hpp"
#include "injury/thinned.hpp"

namespace dashpad::study {
namespace {

constexpr double three_milliseconds = 3e-3;
constexpr double hic_power = 2.5;

}  // namespace

PulseFigures::PulseFigures(const Solution& solution) : force_error_(solution.summary.errors.peak_force) {
  const auto finite = [](double value) { return std::isfinite(value); };
  whole_ = solution.summary.release && solution.history.size() >= 2 &&
           std::ranges::all_of(solution.history.acceleration, finite);
  if (!whole_) return;
  pulse_ = pulse_of(solution.history);
  if (pulse_.time.size() >= fewest_to_compare) coarser_ = thinned(pulse_);
}

/// The difference from every second sample, and the error of the force to the power that it has in the
/// figure.
template <class Figure>
FigureWithError PulseFigures::with_error(Figure figure, double power) {
  const double value = figure(pulse_);
  if (coarser_.time.empty()) return {value, std::numeric_limits<double>::infinity()};
  const double coarse = figure(coarser_);
  return {value, (value == 0 ? std::abs(coarse) : std::abs(coarse / value - 1)) + power * force_error_};
}

/// A window longer than the pulse is none: HIC15 of a short pulse is its HIC36, and computed once.
FigureWithError PulseFigures::hic(double longest_window) {
  const auto figure = [](double window) {
    return [window](const Pulse& pulse) { return dashpad::hic(pulse, window).value; };
  };
  if (pulse_.time.back() - pulse_.time.front() > longest_window)
    return with_error(figure(longest_window), hic_power);
  if (!whole_window_) whole_window_ = with_error(figure(unlimited_window), hic_power);
  return *whole_window_;
}

FigureWithError PulseFigures::hic_d() {
  const FigureWithError hic36 = hic(36e-3);
  const double value = dashpad::hic_d(hic36.value);
  // The offset of HIC(d) has no error; that of the samples shrinks with it, that of the force is kept, as
  // there.
  const double of_samples = (hic36.error - hic_power * force_error_) * (value - dashpad::hic_d(0)) / value;
  return {value, of_samples + hic_power * force_error_};
}

FigureWithError PulseFigures::contiguous_3ms() {
  return with_error([](const Pulse& pulse) { return contiguous_clip(pulse, three_milliseconds).level; }, 1);
}

FigureWithError PulseFigures::cumulative_3ms() {
  return with_error([](const Pulse& pulse) { return cumulative_clip(pulse, three_milliseconds).level; }, 1);
}

FigureWithError PulseFigures::severity_index() {
  return with_error([](const Pulse& pulse) { return dashpad::severity_index(pulse); }, hic_power);
}

FigureWithError PulseFigures::velocity_change() {
  return with_error([](const Pulse& pulse) { return dashpad::velocity_change(pulse); }, 1);
}

}  // namespace dashpad::study
