#pragma once
/// How a material meets the measurements.

#include <optional>
#include <span>
#include <vector>

#include "dashpad/fit/report.hpp"

namespace dashpad::fit {

/// Of the points of a test that count; `values` of the unknowns, `offset` in Pa.
MetTest met_test(const Fit& fit, const MaterialMeasurement& test, std::span<const double> values,
                 double offset);

/// The figures of an impact, to the tolerance of its case.
std::vector<MetFigure> met_figures(const Fit& fit, const ImpactMeasurement& impact,
                                   std::span<const double> values);

/// The pulse of an impact that has one, to the tolerance of its case; `shift` is the coordinate of its shift.
MetPulse met_pulse(const Fit& fit, const ImpactMeasurement& impact, std::span<const double> values,
                   std::optional<std::size_t> shift);

/// Rates of the pieces between points that count, 1/s: the 5th and the 95th percentile of their magnitudes
/// by the way that they go.
struct RateRange {
  double lowest = 0, highest = 0;
};
RateRange rates_of(const MaterialMeasurement& test);

}  // namespace dashpad::fit
