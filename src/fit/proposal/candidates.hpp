#pragma once
/// Laws with base curves and unknowns that might fit tests.

#include "fit/proposal/evidence.hpp"

namespace dashpad::fit {

/// Tests whose rates differ by less than this factor count as of one rate.
inline constexpr double one_rate = 2;

/// How many tests there are at each rate, the slowest first.
std::vector<std::size_t> sizes_by_rate(const std::vector<Evidence>& tests);

/// Law, candidates and reasons for tests that were read; adds a fault if there is nothing to fit.
Proposal proposal_for(ReadTests tests, std::vector<input::Fault>& faults);

}  // namespace dashpad::fit
