#pragma once
/// How a blow follows from the one before it.

#include <optional>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad {

/// The first blow of a series, or the case itself.
ImpactCase first_blow(const ImpactCase& series);

/// What the next blow meets (theory.md, Eq. 47): the only place where a state is carried from one blow to the
/// next. Nothing after the last blow, and after one whose outcome does not say what it leaves behind; with a
/// fixed number of runs its accuracy does not count.
std::optional<ImpactCase> next_blow(const ImpactCase& series, const ImpactCase& blow, const Summary& summary,
                                    const Options& options);

}  // namespace dashpad
