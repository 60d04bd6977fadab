#include "result/possible_range.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "dashpad/quantities/constants.hpp"

namespace dashpad {

namespace {

/// HIC(d) where HIC36 is 0.
constexpr double min_hic_d = 166.4;

/// Figures that are bounded by more than their sign. No pad is compressed by more than its thickness, and
/// none returns more energy than it received.
constexpr std::array bounded{
    PossibleRange{"peak_penetration", 0, Most::pad_thickness},
    PossibleRange{"peak_strain", 0, Most::one},
    PossibleRange{"rebound_speed", 0, Most::impact_speed},
    PossibleRange{"restitution", 0, Most::one},
    PossibleRange{"rebound_height", 0, Most::height_of_impact_speed},
    PossibleRange{"hic_d", min_hic_d},
};

}  // namespace

PossibleRange possible_range(const ResultQuantity& quantity) {
  const auto row = std::ranges::find(bounded, std::string_view(quantity.key),
                                     [](const PossibleRange& range) { return std::string_view(range.key); });
  if (row != bounded.end()) return *row;
  return {quantity.key, quantity.role.is_signed ? -infinite : 0};
}

double max_in(const ImpactCase& impact, Most most) {
  const double speed = impact.impactor.speed;
  switch (most) {
    case Most::one: return 1;
    case Most::pad_thickness: return impact.pad.thickness;
    case Most::impact_speed: return speed;
    case Most::height_of_impact_speed: return speed * speed / (2 * standard_gravity);
    case Most::unbounded: break;
  }
  return infinite;
}

}  // namespace dashpad
