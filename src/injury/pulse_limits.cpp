// A measured pulse beside the limits of a standard.

#include <algorithm>
#include <cmath>
#include <optional>

#include "dashpad/injury/figures.hpp"
#include "dashpad/injury/pulse_report.hpp"
#include "dashpad/injury/standard.hpp"

namespace dashpad::injury {

namespace {

std::optional<double> figure(const PulseReport& report, const Criterion& criterion) {
  if (criterion.metric == Metric::dwell_time) {
    const auto dwell = std::ranges::find(report.dwells, criterion.level, &DwellTime::level);
    return dwell == report.dwells.end() ? std::nullopt : std::optional{dwell->cumulative};
  }
  const std::optional<InjuryValue> of = injury_value(report.figures, quantity_of(criterion.metric));
  return of ? std::optional{of->value} : std::nullopt;
}

/// Absolute; absent where it is not known.
std::optional<double> uncertainty_of(const PulseReport& report, Metric metric) {
  // HIC(d) is a line over HIC36: what HIC36 is uncertain by, times its slope.
  const bool is_hic_d = metric == Metric::hic_d;
  const ResultQuantity& quantity = quantity_of(is_hic_d ? Metric::hic36 : metric);
  const auto of = std::ranges::find(report.uncertainty.figures, &quantity, &FigureUncertainty::quantity);
  if (of == report.uncertainty.figures.end()) return std::nullopt;
  if (is_hic_d) return of->combined() * (report.figures.hic_d - hic_d(0));
  const std::optional<InjuryValue> value = injury_value(report.figures, quantity);
  return value ? std::optional{of->combined() * std::abs(value->value)} : std::nullopt;
}

}  // namespace

PulseLimits within_limits(const PulseReport& report, const Standard& standard) {
  PulseLimits limits{
      .standard = standard.title, .results = {}, .reservations = reservations_about_limits(standard)};
  for (const Criterion& criterion : standard.criteria) {
    CriterionResult result;
    result.criterion = criterion;
    result.value = figure(report, criterion);
    result.lower_bound = std::ranges::find(report.flags, "PULSE CUT", &Flag::name) != report.flags.end();
    const std::optional<double> uncertainty = uncertainty_of(report, criterion.metric);
    result.error = uncertainty.value_or(0);
    if (result.value) decide(result);
    if (result.verdict == Verdict::undecided && result.lower_bound)
      result.reason = "PULSE CUT: the value can only grow";
    else if (!uncertainty)
      result.reason = "by its value alone, whose uncertainty is not known";
    else if (result.verdict == Verdict::undecided)
      result.reason = "the limit lies within the uncertainty of the measurement";
    limits.results.push_back(std::move(result));
  }
  return limits;
}

}  // namespace dashpad::injury
