#pragma once
/// Which quantities of a case can vary, and how the values of a row get into a case.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "dashpad/study/study.hpp"

namespace dashpad::study {

/// A quantity that can be a factor.
struct FactorKey {
  std::string key;
  std::string unit;  ///< SI; "1" for a pure number, "" for a material
};

/// All that a case with this law and this support offers: its quantities (dashpad/impact/case_quantity.hpp)
/// and its material.
std::vector<FactorKey> factor_keys(const ImpactCase& base);

/// What is said about a factor whose key is none of factor_keys(): what was meant, or what there is instead.
std::string rule_for_unknown(const std::string& key, const ImpactCase& base);

/// Whether a key is that of a number of the pad's law or of the curves it is made of. Which of them there are
/// depends on the material.
bool is_of_law(const std::string& key);

/// Knows where each factor goes. Made once, used for many rows, by several threads at once if need be.
class Application {
 public:
  /// `study` must outlive it. Throws std::invalid_argument for a key that is none of factor_keys().
  explicit Application(const Study& study);

  /// Writes SI values, in the order of Study::factors, into a copy of Study::base that may have been used for
  /// other rows. Memory is taken only where the material changes and for a support that varies.
  void operator()(std::span<const double> values, ImpactCase& into) const;

 private:
  std::vector<std::function<void(ImpactCase&, double)>> steps_;
};

}  // namespace dashpad::study
