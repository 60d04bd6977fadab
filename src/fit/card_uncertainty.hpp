#pragma once
/// What a fit leaves open of its foam, as data of the card.

#include <span>

#include "dashpad/fit/report.hpp"
#include "fit/determine.hpp"
#include "fit/problem.hpp"

namespace dashpad::fit {

/// Ranges of recoil and HU: intervals of the fit, to the ends of what the law admits where they are open or
/// nothing tests them; none of HU where the fit knows it to both sides, since it is in the axes then. Axes:
/// those of the covariance of what goes into the card, the others free; at most most_posterior_axes, those
/// that move the fitted figures most. A scale of the pad moves all stresses of a formula; with a table, which
/// has no numbers, its standard error counts as scatter from sample to sample. What the card that the fit
/// started from says of the rest stays. `card` is that of the fit.
dashpad::Uncertainty uncertainty_of(const Fit& fit, const Problem& problem, const Solved& solved,
                                    const FitReport& report, const Material& card);

/// The law with these values of the unknowns, and a fitted scale of the pad in its stresses.
PadLaw law_with(const Fit& fit, std::span<const double> values);

}  // namespace dashpad::fit
