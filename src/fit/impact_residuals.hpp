#pragma once
/// The impacts of a fit, solved.

#include <optional>
#include <span>

#include "dashpad/fit/fit.hpp"
#include "dashpad/impact/pulse.hpp"

namespace dashpad::fit {

/// The impact of a measurement with the material of the fit and these values of the unknowns. Throws
/// std::invalid_argument where it has no such quantity, or they make a support that cannot exist.
ImpactCase impact_with(const Fit& fit, const ImpactMeasurement& measured, std::span<const double> values);

/// The acceleration by a curve through the steps of the solver: a polyline through them would jump when their
/// number changes. Nothing where the pulse was cut off or is not finite.
std::optional<Pulse> smooth_pulse(const Solution& solution);

}  // namespace dashpad::fit
