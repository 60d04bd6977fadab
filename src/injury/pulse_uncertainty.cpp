#include "dashpad/injury/pulse_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "dashpad/impact/solution.hpp"
#include "injury/pulse_line.hpp"

namespace dashpad::injury {
namespace {

constexpr double expanded = 2 * std::numbers::inv_sqrt3;  // k = 2, of a bound
constexpr double of_finer = 4.0 / 3;   // halving the interval removes three quarters of the error of lines
constexpr double margin = 20e-3;       // s beyond all windows: longer than the memory of a class 60 filter
constexpr std::size_t of_a_cubic = 4;  // samples

constexpr std::array known{"peak_acceleration", "hic15",          "hic36",          "hic_unlimited",
                           "clip_3ms",          "cumulative_3ms", "velocity_change"};
using Values = std::array<double, known.size()>;

/// Integral from `begin` to `end`, s, of the pulse linear between its samples.
double gained(const Pulse& pulse, double begin, double end) {
  double sum = 0;
  for (std::size_t i = 1; i < pulse.time.size(); ++i) {
    const double from = std::max(begin, pulse.time[i - 1]), to = std::min(end, pulse.time[i]);
    if (!(from < to)) continue;
    const auto at = [&](double time) {
      return std::lerp(pulse.acceleration[i - 1], pulse.acceleration[i],
                       (time - pulse.time[i - 1]) / (pulse.time[i] - pulse.time[i - 1]));
    };
    sum += (at(from) + at(to)) / 2 * (to - from);
  }
  return sum;
}

/// The value of HIC in its best window, to which small shifts make no difference.
double hic_within(const Pulse& pulse, const Hic& hic) {
  const double duration = hic.end - hic.begin;
  if (!(duration > 0)) return 0;
  return duration *
         std::pow(std::abs(gained(pulse, hic.begin, hic.end)) / duration / standard_gravity, hic_power);
}

/// The figures of another version of the pulse of `report`, in its windows.
Values values_of(const ProcessedPulse& processed, const PulseReport& report) {
  const Pulse& pulse = processed.pulse;
  const InjuryFigures& injury_figures = report.figures;
  return {peak(pulse).magnitude,
          hic_within(pulse, injury_figures.hic15),
          hic_within(pulse, injury_figures.hic36),
          hic_within(pulse, injury_figures.hic_unlimited),
          injury_figures.clip_3ms.level > 0 ? contiguous_clip(pulse, usual_clip).level : 0,
          injury_figures.cumulative_3ms.level > 0 ? cumulative_clip(pulse, usual_clip).level : 0,
          std::abs(gained(processed.along(), report.contact.begin, report.contact.end))};
}

/// The measured samples around all windows of the figures, zeroed as in `report`.
MeasuredPulse around_the_figures(const PulseReport& report) {
  const InjuryFigures& injury_figures = report.figures;
  double begin = std::min(injury_figures.peak.time, report.contact.begin);
  double end = std::max(injury_figures.peak.time, report.contact.end);
  for (const InjuryValue& value : injury_values(injury_figures))
    if (value.begin && value.end && *value.begin < *value.end) {
      begin = std::min(begin, *value.begin);
      end = std::max(end, *value.end);
    }
  const double beyond = std::max(margin, 4 * report.resampled_to.value_or(0));
  const std::vector<double>& time = report.measured.pulse.time;
  const auto count = static_cast<std::ptrdiff_t>(time.size());
  const auto first =
      std::max(std::ranges::lower_bound(time, begin - beyond) - time.begin() - 2, std::ptrdiff_t{0});
  const auto last = std::min(std::ranges::upper_bound(time, end + beyond) - time.begin() + 2, count);
  const auto cut = [&](const std::vector<double>& values) {
    return std::vector<double>(values.begin() + first, values.begin() + last);
  };
  MeasuredPulse part;
  part.pulse = {cut(time), cut(report.measured.pulse.acceleration)};
  for (const std::vector<double>& component : report.measured.components)
    part.components.push_back(cut(component));
  if (report.filter && !report.resampled_to) {  // they count as even, up to the rounding of the file
    const auto steps = static_cast<double>(part.pulse.time.size() - 1);
    const double start = part.pulse.time.front(), stop = part.pulse.time.back();
    for (std::size_t i = 0; i < part.pulse.time.size(); ++i)
      part.pulse.time[i] = std::lerp(start, stop, static_cast<double>(i) / steps);
  }
  if (report.offset && report.offset->taken_off) return zeroed(std::move(part), report.offset->offset);
  return part;
}

/// The value at `x` of the polynomial through the samples [first, last).
double interpolated(const std::vector<double>& time, const std::vector<double>& values, std::size_t first,
                    std::size_t last, double x) {
  double sum = 0;
  for (std::size_t i = first; i < last; ++i) {
    double term = values[i];
    for (std::size_t k = first; k < last; ++k)
      if (k != i) term *= (x - time[k]) / (time[i] - time[k]);
    sum += term;
  }
  return sum;
}

/// The pulse with an interpolated sample in the middle of each interval.
MeasuredPulse finer(const MeasuredPulse& measured) {
  const std::vector<double>& time = measured.pulse.time;
  const auto between = [&](const std::vector<double>& values) {
    std::vector<double> all;
    for (std::size_t i = 0; i < time.size(); ++i) {
      all.push_back(values[i]);
      if (i + 1 == time.size()) break;
      all.push_back(interpolated(time, values, i > 0 ? i - 1 : 0, std::min(i + 3, time.size()),
                                 std::midpoint(time[i], time[i + 1])));
    }
    return all;
  };
  MeasuredPulse result;
  for (std::size_t i = 0; i < time.size(); ++i) {
    result.pulse.time.push_back(time[i]);
    if (i + 1 < time.size()) result.pulse.time.push_back(std::midpoint(time[i], time[i + 1]));
  }
  for (const std::vector<double>& component : measured.components)
    result.components.push_back(between(component));
  result.pulse.acceleration =
      measured.components.empty() ? between(measured.pulse.acceleration) : resultant_of(result.components);
  return result;
}

/// The largest height of a parabola above the largest sample, m/s2. Absent at an end of the pulse, which may
/// have continued to grow.
std::optional<double> hidden_peak(const Pulse& pulse) {
  const std::size_t at = peak_sample(pulse);
  if (at == 0 || at + 1 >= pulse.time.size()) return std::nullopt;
  const double before = pulse.time[at] - pulse.time[at - 1], after = pulse.time[at + 1] - pulse.time[at];
  const double falls = (pulse.acceleration[at] - pulse.acceleration[at - 1]) / before -
                       (pulse.acceleration[at + 1] - pulse.acceleration[at]) / after;
  const double longer = std::max(before, after);
  return std::abs(falls) / (before + after) * longer * longer / 4;
}

/// The filter with whose figures those of `filter` are compared: the next higher class, or none.
std::optional<PulseFilter> next_filter(const PulseFilter& filter, const Pulse& pulse) {
  for (const int higher : channel_frequency_classes)
    if (higher > filter.channel_frequency_class)
      return samples_suffice(higher, interval_of(pulse))
                 ? std::optional{PulseFilter{higher, filter.corner, filter.ends}}
                 : std::nullopt;
  return std::nullopt;
}

std::optional<double> figure(const PulseReport& report, const Criterion& criterion) {
  if (criterion.has_level()) {
    const auto dwell = std::ranges::find(report.dwells, criterion.level, &DwellTime::level);
    return dwell == report.dwells.end() ? std::nullopt : std::optional{dwell->cumulative};
  }
  const std::optional<InjuryValue> of = injury_value(report.figures, *criterion.quantity);
  return of ? std::optional{of->value} : std::nullopt;
}

/// The absolute uncertainty; absent if unknown.
std::optional<double> uncertainty_of(const PulseReport& report, const Criterion& criterion) {
  // HIC(d) is linear in HIC36, so its uncertainty is that of HIC36 times the slope.
  const bool is_hic_d = criterion.limits("hic_d");
  const ResultQuantity& quantity = is_hic_d ? result_quantity("hic36") : *criterion.quantity;
  const auto of = std::ranges::find(report.uncertainty.figures, &quantity, &FigureUncertainty::quantity);
  if (of == report.uncertainty.figures.end()) return std::nullopt;
  if (is_hic_d) return of->combined() * (report.figures.hic_d - hic_d(0));
  const std::optional<InjuryValue> value = injury_value(report.figures, quantity);
  return value ? std::optional{of->combined() * std::abs(value->value)} : std::nullopt;
}

}  // namespace

double FigureUncertainty::combined() const {
  return std::hypot(sampling.value_or(0), filter.value_or(0), calibration.value_or(0));
}

MeasurementUncertainty measurement_uncertainty(const PulseReport& report, std::optional<double> calibration) {
  MeasurementUncertainty result{.calibration = calibration, .figures = {}};
  const MeasuredPulse part = around_the_figures(report);
  const auto values_with = [&](const MeasuredPulse& measured, const std::optional<PulseFilter>& filter) {
    return values_of(processed_pulse(measured, report.resampled_to, filter), report);
  };
  const Values values = values_with(part, report.filter),
               of_finer_samples = values_with(finer(part), report.filter);
  std::optional<Values> unfiltered;
  if (report.filter) {
    const std::optional<PulseFilter> next = next_filter(*report.filter, report.pulse);
    unfiltered = values_with(part, next);
    result.compared_with = next ? "CFC" + std::to_string(next->channel_frequency_class) : "no filter";
  }
  for (std::size_t i = 0; i < known.size(); ++i) {
    const double value = values[i];
    if (!(value > 0)) continue;
    FigureUncertainty figure{.quantity = &result_quantity(known[i])};
    std::optional<double> hidden = of_finer * std::abs(of_finer_samples[i] - value);
    if (i == 0) {
      const std::optional<double> above = hidden_peak(report.pulse);
      hidden = above ? std::optional{std::max(*hidden, *above)} : std::nullopt;
    }
    if (hidden && part.pulse.time.size() >= of_a_cubic) figure.sampling = expanded * *hidden / value;
    if (unfiltered) figure.filter = expanded * std::abs((*unfiltered)[i] - value) / value;
    if (calibration) figure.calibration = std::pow(1 + *calibration, acceleration_power(known[i])) - 1;
    if (figure.sampling || figure.filter || figure.calibration) result.figures.push_back(figure);
  }
  return result;
}

PulseLimits within_limits(const PulseReport& report, const Standard& standard) {
  PulseLimits limits{
      .standard = standard.title, .results = {}, .reservations = reservations_about_limits(standard)};
  for (const Criterion& criterion : standard.criteria) {
    CriterionResult result;
    result.criterion = criterion;
    result.value = figure(report, criterion);
    result.lower_bound = std::ranges::find(report.flags, "PULSE CUT", &Flag::name) != report.flags.end();
    const std::optional<double> uncertainty = uncertainty_of(report, criterion);
    result.error = uncertainty.value_or(0);
    if (result.value) decide(result);
    if (!result.value)
      result.reason = "the pulse does not give it";
    else if (result.verdict == Verdict::undecided && result.lower_bound)
      result.reason = "the pulse is cut, so the value is a lower bound";
    else if (!uncertainty)
      result.reason = "the verdict is based on the value alone, since its uncertainty is not known";
    else if (result.verdict == Verdict::undecided)
      result.reason = "the limit lies within the uncertainty of the measurement";
    limits.results.push_back(std::move(result));
  }
  return limits;
}

}  // namespace dashpad::injury
