#pragma once
/// What the tests of a proposal leave open.

#include "dashpad/fit/proposal.hpp"

namespace dashpad::fit {

/// Fills `open` and `next` by the tests and by the unknowns that the data do not determine.
void say_what_is_open(AutoFit& result);

/// Reservations about the card beside those of its fit.
std::vector<std::string> doubts_of(const AutoFit& result);

}  // namespace dashpad::fit
