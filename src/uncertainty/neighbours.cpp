// Columns that do not help each other: by how much their figures are off those of finite elements.
//
// Impacts of a headform of R = 2 L and 3.3 L on 39 pads of hyperelastic foam, columns against finite elements
// of our own (theory.md, section 6): peak 6 % rms, HIC 8 %, penetration 0.030 L too deep, with 0.016 L about
// that. The error of the force at a given depth goes as L / R (34, 21, 15, 9 % at R = 1, 2, 3.3, 6.6 L), and
// so does what is taken here.

#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "dashpad/uncertainty/intervals.hpp"
#include "uncertainty/line.hpp"

namespace dashpad::uncertainty {
namespace {

constexpr double nearest = 2, farthest = 3.3;  // R / L between which the impacts were
constexpr double of_peak = 0.06, of_hic = 0.08;
constexpr double depth_bias = 0.030, depth_scatter = 0.016;  // of L
/// A disc's force at half the thickness is off by 0.5 L / a; of such an error of a sphere's force, 15 to 21
/// %, a third is left in the peak.
constexpr double of_disc = 0.5, left_in_peak = 1.0 / 3;

/// Radius of the tip over the thickness, of a round one; that of the face, of a flat one.
struct Tip {
  double over_pad = 0;
  bool is_flat = false;
};

/// Nothing where the columns have no neighbours (a block below a nose that is wider), or where what they
/// leave out was not computed: cones, cylinders and profiles.
std::optional<Tip> tip_of(const ImpactCase& impact) {
  const double thickness = impact.pad.thickness;
  return std::visit(
      [&]<class Shape>(const Shape& nose) -> std::optional<Tip> {
        if constexpr (std::is_same_v<Shape, FlatDisc> || std::is_same_v<Shape, Platen>) {
          const Sections sections = sections_of(impact);
          if (impact.pad.area && sections.tip >= *impact.pad.area) return std::nullopt;
          return Tip{std::sqrt(sections.tip * std::numbers::inv_pi) / thickness, true};
        } else if constexpr (std::is_same_v<Shape, Sphere>) {
          return Tip{nose.radius / thickness, false};
        } else if constexpr (std::is_same_v<Shape, Ellipsoid> || std::is_same_v<Shape, Rod>) {
          return Tip{sections_of(impact).width / thickness, false};  // of the curvature at the tip, Eq. 3
        } else {
          return std::nullopt;
        }
      },
      impact.impactor.nose);
}

bool is_block_below_a_wider_nose(const ImpactCase& impact) {
  return impact.pad.area && sections_of(impact).tip >= *impact.pad.area;
}

/// One standard deviation of the peak, as a share.
double share_of_peak(const Tip& tip) {
  if (tip.is_flat) return left_in_peak * of_disc / tip.over_pad;
  if (tip.over_pad < nearest) return of_peak * nearest / tip.over_pad;
  return of_peak * std::min(1.0, farthest / tip.over_pad);
}

/// What impacts on a like nose and pad have shown is in the misfit.
bool is_in_misfit(const ImpactCase& impact, const Tip& tip) {
  const auto& misfit = impact.pad.material.uncertainty.misfit;
  if (!impact.pad.layers.empty() || !misfit || !misfit->nose_over_pad) return false;
  constexpr double alike = 1.25;
  const double ratio = tip.over_pad / *misfit->nose_over_pad;
  return ratio < alike && ratio > 1 / alike;
}

}  // namespace

void add_neighbours(const ImpactCase& impact, Open& open) {
  if (is_block_below_a_wider_nose(impact)) return;
  const std::string words = "what columns leave out that do not help each other";
  const std::optional<Tip> tip = tip_of(impact);
  if (!tip) {
    open.sources.push_back({Source::neighbours, words,
                            fmt::format("it was not computed for a {}", name_of(impact.impactor.nose))});
    return;
  }
  if (is_in_misfit(impact, *tip)) return;
  const double peak = share_of_peak(*tip);
  open.shares.push_back({.source = Source::neighbours,
                         .acceleration = peak,
                         .hic = of_hic / of_peak * peak,
                         .shallower = (depth_bias + 1.96 * depth_scatter) * impact.pad.thickness});
  open.sources.push_back(
      {Source::neighbours,
       fmt::format("{} ({} of {:.2g} times the thickness: {:.2g} % rms in the peak)", words,
                   tip->is_flat ? "a flat face with a radius" : "a radius", tip->over_pad, 100 * peak),
       ""});
}

std::string warning_of_model(const ImpactCase& impact) {
  if (is_block_below_a_wider_nose(impact)) return "";
  const std::optional<Tip> tip = tip_of(impact);
  if (!tip || tip->over_pad >= (tip->is_flat ? nearest : 1)) return "";
  if (tip->is_flat)
    return fmt::format(
        "SMALL NOSE: the flat face has a radius of {:.2g} times the thickness of the pad; at its edge "
        "columns leave "
        "out what their neighbours do, and the force is {:.2g} to {:.2g} times theirs at half the thickness",
        tip->over_pad, 1 + 0.2 / tip->over_pad, 1 + 1.2 / tip->over_pad);
  return fmt::format(
      "SMALL NOSE: the radius is {:.2g} times the thickness of the pad; columns leave out what their "
      "neighbours do, "
      "and the force is some {:.2g} to {:.2g} times theirs at half the thickness",
      tip->over_pad, 1 + 0.3 / tip->over_pad, 1 + 0.9 / tip->over_pad);
}

}  // namespace dashpad::uncertainty
