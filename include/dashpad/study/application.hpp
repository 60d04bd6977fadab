#pragma once
/// Which quantities of a case can vary, and how the values of a row get into a case.

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

/// All that a case with this law and this support offers.
std::vector<FactorKey> factor_keys(const ImpactCase& base);

/// Knows where each factor goes. Made once, used for many rows, by several threads at once if need be.
class Application {
 public:
  /// `study` must outlive it. Throws std::invalid_argument for a key that is none of factor_keys().
  explicit Application(const Study& study);

  /// Writes SI values, in the order of Study::factors, into a copy of Study::base that may have been used for
  /// other rows. Memory is taken only where the material changes and for a support that varies.
  void operator()(std::span<const double> values, ImpactCase& into) const;

 private:
  enum class Place {
    mass,
    weight,
    nose,
    speed,
    thickness,
    parameter,
    material,
    scale,
    density,
    temperature,
    stiffness,
    support_scale
  };
  struct Step {
    Place place = Place::mass;
    std::size_t parameter = 0;  ///< of the law or the nose
  };
  Step step_for(const std::string& key) const;

  const Study* study_;
  std::vector<Step> steps_;
};

}  // namespace dashpad::study
