#pragma once
/// The quantities of an impact case by name, to be read and set: what studies vary.

#include <functional>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"

namespace dashpad {

/// A number of a case, in SI.
struct CaseQuantity {
  std::string key;   ///< as in case files: "impactor.speed", "pad.parameters.friction", "pad.curve.modulus"
  std::string unit;  ///< SI; "1" for a pure number
  /// NaN where the case does not give it, as a density that is the card's.
  std::function<double(const ImpactCase&)> get;
  /// Takes any value, which violations(ImpactCase) then judges, under the same key. Only a support that
  /// cannot exist is refused at once, with std::invalid_argument.
  std::function<void(ImpactCase&, double)> set;
};

/// All that a case with this nose, this law with these forms of its curves, and this support has. They serve
/// every such case; another law throws std::bad_variant_access. `support.scale` counts from the support of
/// `base`.
std::vector<CaseQuantity> quantities_of(const ImpactCase& base);

}  // namespace dashpad
