#pragma once
/// Where a standard and a case have different noses or speeds, one of the two is assessed. What the other
/// would have said.

#include <functional>
#include <vector>

#include "dashpad/injury/standard.hpp"

namespace dashpad::injury {

/// What of the case stays although the standard has a value for it.
struct Kept {
  bool nose = false;
  bool speed = false;
};

/// The standard with the nose and the speed left to the case, where they are to be kept and differ from its
/// own.
Standard with_kept(const Standard& standard, const Impactor& of_case, Kept kept);

/// A verdict that another choice of nose, speed or both would have given.
struct OtherChoice {
  Kept other;  ///< what is chosen the other way
  Kept kept;   ///< what of the case is kept then
  Assessment assessment;
};

/// The choices that turn a verdict into a pass or a fail; both together only where neither does alone. What
/// the user has given by a number is no choice. `standard` is not yet with_kept(). `judged` solves the case
/// with that impactor and assesses it.
std::vector<OtherChoice> turning_choices(
    const Standard& standard, const ImpactCase& given, Kept kept, Verdict verdict,
    const std::function<Assessment(const Standard&, const ImpactCase&)>& judged);

}  // namespace dashpad::injury
