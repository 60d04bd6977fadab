#include "impact/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "dashpad/quantities/constants.hpp"

namespace dashpad {
namespace {

// Factors of c by our own finite elements: fitted to two foams, tested on a third (theory.md, section 6.1).
constexpr double of_disc = 0.625;
constexpr double of_slip = 0.375;
/// Smallest computed radius over thickness; smaller noses have the factor of this one.
constexpr double smallest = 0.5;
/// Largest ratio of the axes of an ellipsoid across the motion for which it counts as round.
constexpr double longest = 1.5;

constexpr double never = infinite;

/// A flat tip as a disc of the radius a, where 2 / a is the perimeter over the area.
Tip flat_tip(double perimeter, double area, double thickness) {
  return {.over_pad = 2 * area / perimeter / thickness, .is_flat = true, .until = never};
}

std::optional<Tip> tip_of(const FlatDisc& nose, double thickness) {
  return flat_tip(2 * std::numbers::pi * nose.radius, std::numbers::pi * nose.radius * nose.radius,
                  thickness);
}
std::optional<Tip> tip_of(const Platen& nose, double thickness) {
  return flat_tip(2 * (nose.length + nose.width), nose.length * nose.width, thickness);
}
std::optional<Tip> tip_of(const Sphere& nose, double thickness) {
  return Tip{nose.radius / thickness, false, never};
}
std::optional<Tip> tip_of(const Rod& nose, double thickness) {
  return Tip{nose.tip_radius / thickness, false, nose.sections().depth};
}
std::optional<Tip> tip_of(const Ellipsoid& nose, double thickness) {
  const auto [narrow, wide] = std::minmax(nose.half_length, nose.half_width);
  if (wide > longest * narrow) return std::nullopt;
  return Tip{nose.sections().width / thickness, false, never};
}
template <class Nose>
std::optional<Tip> tip_of(const Nose&, double) {
  return std::nullopt;
}

/// Whether the contact reaches the rim of a block before the pad is closed.
bool reaches_rim(const ImpactCase& impact) {
  return impact.pad.area && sections_of(impact).area(impact.pad.thickness) >= *impact.pad.area;
}

/// Nominal c; the error of the force on bonded pads, R of 2 to 6.6 L, has a flat minimum at 0.93.
constexpr double of_uniaxial_tests = 0.8;

bool is_by_uniaxial_tests(const Material& material) {
  const bool is_foam = has_curves(material.law) || std::holds_alternative<ViscoelasticFoam>(material.law);
  return is_foam && !material.nose_over_pad;
}

}  // namespace

std::string name_of(Floor floor) {
  constexpr const char* names[]{"bonded", "resting", "frictionless"};
  return names[static_cast<std::size_t>(floor)];
}

std::optional<Floor> floor_named(std::string_view name) {
  for (const Floor floor : floors)
    if (name == name_of(floor)) return floor;
  return std::nullopt;
}

double nominal_neighbours(const Pad& pad) {
  const bool is_known = pad.layers.empty() ? is_by_uniaxial_tests(pad.material)
                                           : std::ranges::all_of(pad.layers, [](const PadLayer& layer) {
                                               return is_by_uniaxial_tests(layer.material);
                                             });
  return is_known ? of_uniaxial_tests : 0;
}

bool covers_pad(const ImpactCase& impact) {
  return impact.pad.area && sections_of(impact).tip >= *impact.pad.area;
}

std::optional<Tip> tip_of(const ImpactCase& impact) {
  if (reaches_rim(impact)) return std::nullopt;
  return std::visit([&](const auto& nose) { return tip_of(nose, impact.pad.thickness); },
                    impact.impactor.nose);
}

ColumnFactor factor_of_columns(const ImpactCase& impact) {
  const double c = impact.pad.neighbours;
  const double thickness = impact.pad.thickness;
  const std::optional<Tip> tip = c > 0 ? tip_of(impact) : std::nullopt;
  if (!tip) return {};
  const double over_pad = std::max(tip->over_pad, smallest);
  if (tip->is_flat) return {.first = 1 + of_disc * c / over_pad};
  ColumnFactor factor{
      .first = 1 + c / over_pad, .slope = -c / (over_pad * thickness), .bend = 0, .until = tip->until};
  if (impact.pad.floor == Floor::frictionless) factor.bend = -of_slip * c / (thickness * thickness);
  return factor;
}

}  // namespace dashpad
