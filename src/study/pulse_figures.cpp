#include "study/pulse_figures.hpp"

#include <cmath>
#include <limits>

#include "dashpad/impact/flags.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/injury/metrics.hpp"
#include "injury/coarser_run.hpp"

namespace dashpad::study {

using injury::hic_power;

namespace {

constexpr double three_milliseconds = 3e-3;

}  // namespace

void PulseFigures::take(const Solution& solution) {
  const History& history = solution.history;
  force_error_ = solution.summary.errors.peak_force;
  whole_window_.reset();
  clip_.reset();
  whole_ = pulse_is_whole(solution.summary) && history.size() >= 2;
  if (!whole_) return;
  double doubt = 0;  // a number less itself is 0 where it is finite
  for (const double value : history.acceleration) doubt += value - value;
  whole_ = doubt == 0;
  if (!whole_) return;
  fine_.pulse.time = history.time;
  fine_.pulse.acceleration = history.acceleration;
  check(fine_.pulse);
  fine_.prepare();
  has_coarse_ = injury::has_coarser_run(solution);
  if (!has_coarse_) return;
  coarse_.pulse = solution.coarser;
  coarse_.prepare();
}

void PulseFigures::Sampled::prepare() {
  hump = injury::hump_of(pulse);
  scale.reset();
}

double PulseFigures::Sampled::hic(double longest_window) {
  if (!hump) return injury::hic(pulse, longest_window).value;
  if (!scale) {
    scale = injury::scale_for(std::abs(pulse.acceleration[hump->peak]));
    curve.assign(pulse, hump->sign * *scale);
  }
  return injury::hic_of(*hump, curve, *scale, longest_window).value;
}

/// What the steps leave, and the error of the force to the power that it has in the figure.
template <class Figure>
EstimatedValue PulseFigures::with_error(Figure figure, double power) {
  const double value = figure(fine_);
  if (!has_coarse_) return {value, std::numeric_limits<double>::infinity()};
  const double coarse = figure(coarse_);
  return {value, injury::step_error(value, coarse) + power * force_error_};
}

template <class ClipOf>
EstimatedValue PulseFigures::level_of(ClipOf clip_of) {
  const injury::Clip clip = clip_of(fine_);
  if (!has_coarse_) return {clip.level, std::numeric_limits<double>::infinity()};
  return {clip.level, injury::step_error(fine_.pulse, clip, clip_of(coarse_)) + force_error_};
}

/// A window longer than the pulse is none: HIC15 of a short pulse is its HIC36, and computed once.
EstimatedValue PulseFigures::hic(double longest_window) {
  const auto figure = [](double window) { return [window](Sampled& of) { return of.hic(window); }; };
  if (fine_.pulse.time.back() - fine_.pulse.time.front() > longest_window)
    return with_error(figure(longest_window), hic_power);
  if (!whole_window_) whole_window_ = with_error(figure(injury::unlimited_window), hic_power);
  return *whole_window_;
}

EstimatedValue PulseFigures::hic_d() {
  const EstimatedValue hic36 = hic(36e-3);
  const double value = injury::hic_d(hic36.value);
  // The offset of HIC(d) has no error; that of the samples shrinks with it, that of the force is kept, as
  // there.
  const double of_samples = (hic36.error - hic_power * force_error_) * (value - injury::hic_d(0)) / value;
  return {value, of_samples + hic_power * force_error_};
}

EstimatedValue PulseFigures::clip_3ms() {
  const auto clip = [](const Sampled& of) {
    return of.hump ? injury::clip_of(*of.hump, of.pulse, three_milliseconds)
                   : injury::contiguous_clip(of.pulse, three_milliseconds);
  };
  const bool humps = fine_.hump && (coarse_.hump || !has_coarse_);
  if (!humps) return level_of(clip);
  if (!clip_) clip_ = level_of(clip);
  return *clip_;
}

EstimatedValue PulseFigures::cumulative_3ms() {
  if (fine_.hump && (coarse_.hump || !has_coarse_)) return clip_3ms();
  return level_of([](const Sampled& of) { return injury::cumulative_clip(of.pulse, three_milliseconds); });
}

EstimatedValue PulseFigures::severity_index() {
  return with_error([](const Sampled& of) { return injury::severity_index(of.pulse); }, hic_power);
}

EstimatedValue PulseFigures::velocity_change() {
  return with_error([](const Sampled& of) { return injury::velocity_change(of.pulse); }, 1);
}

}  // namespace dashpad::study
