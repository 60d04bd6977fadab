#pragma once
/// Laws with base curves and unknowns that might fit tests.

#include "fit/proposal/evidence.hpp"

namespace dashpad::fit {

/// Tests whose rates differ by less than this factor count as of one rate.
inline constexpr double one_rate = 2;

/// Law, candidates and reasons for tests that were read; adds a fault if there is nothing to fit.
Proposal proposal_for(ReadTests tests, std::vector<input::Fault>& faults);

}  // namespace dashpad::fit
