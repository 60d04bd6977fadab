#pragma once
/// A pad material: a law with its parameters, where they come from, and where they were fitted.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/model/pad/law.hpp"

namespace dashpad {

/// The strains and strain rates for which a law was fitted to tests. Outside it a result is extrapolated.
struct FittedRange {
  double highest_strain = 1;  ///< (0, 1]
  double lowest_rate = 0;     ///< lowest peak strain rate of an impact for which the fit holds, 1/s
  double highest_rate = 0;    ///< 1/s
};

struct Material {
  std::string name;    ///< as cards and cases name it; "in line" where the case gives the law itself
  std::string title;   ///< for people
  std::string source;  ///< where the parameters come from
  PadLaw law;
  std::optional<FittedRange> fitted;
  /// Published values that the law does not use: name and value as the card has them.
  std::vector<std::pair<std::string, std::string>> also_published;
};

/// Every rule that the law or its fitted range breaks. Keys are those of cards: `parameters.modulus`,
/// `fitted.highest_rate`.
std::vector<Violation> violations(const Material& material);

/// Why a result with these largest strain and strain rate (1/s) is extrapolated, a reason each: beyond the
/// fitted range, or where the law is not defined. Empty if it is not.
std::vector<std::string> extrapolations(const Material& material, double largest_strain, double largest_rate);

}  // namespace dashpad
