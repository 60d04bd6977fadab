// The error of columns that do not help each other, or help by Eq. 57, against finite elements of our own
// (theory.md, section 6): impacts of a headform on 50 pads of hyperelastic foam with R = 2 L and 3.3 L, and
// on 10 pads each with R = L and 6.6 L. The error is proportional to L / R and grows with the strain.

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "dashpad/uncertainty/intervals.hpp"
#include "impact/neighbours.hpp"
#include "uncertainty/open_sources.hpp"

namespace dashpad::uncertainty {
namespace {

/// Standard deviations as shares of the figure and, for depths, of the thickness.
struct Error {
  double peak = 0, hic = 0;
  double depth_bias = 0, depth_scatter = 0;
};

/// Range of R / L of the impacts, and the error of columns alone in them.
constexpr double nearest = 2, farthest = 3.3;
constexpr Error of_columns{.peak = 0.06, .hic = 0.08, .depth_bias = 0.030, .depth_scatter = 0.016};
/// The error of a disc's force at half the thickness is 0.5 L / a, with Eq. 57 half of that; of such an error
/// of a sphere's force, 15 to 21 %, a third remains in the peak.
constexpr double of_disc = 0.5, left_with_factor = 0.5, left_in_peak = 1.0 / 3;

/// The error of columns alone.
Error error_of_columns(const Tip& tip) {
  Error error = of_columns;
  if (tip.is_flat)
    error.peak = left_in_peak * of_disc / tip.over_pad;
  else
    error.peak *= tip.over_pad < nearest ? nearest / tip.over_pad : std::min(1.0, farthest / tip.over_pad);
  error.hic = of_columns.hic / of_columns.peak * error.peak;
  return error;
}

/// The error with Eq. 57: 2.9 and 3.5 % in the peak at strains of 0.5 and 0.65 on bonded pads of R = 2 L, 1.7
/// and 2.1 % at 3.3 L; on frictionless floors 4 % more at any L / R, as foams slip differently.
Error error_with_neighbours(const Tip& tip, Floor floor, double strain) {
  Error error;
  if (tip.is_flat) {
    error.peak = left_with_factor * error_of_columns(tip).peak;
    error.depth_scatter = of_columns.depth_scatter;
  } else {
    error.peak = (0.02 + 0.08 * std::clamp(strain, 0.0, 1.0)) / tip.over_pad;
    error.depth_scatter = 0.016 / tip.over_pad;
  }
  if (floor == Floor::frictionless) {
    error.peak = std::hypot(error.peak, 0.04);
    error.depth_scatter = std::hypot(error.depth_scatter, 0.011);
  }
  error.hic = 1.25 * error.peak;
  return error;
}

/// Whether the misfit of the card includes this error, as it was found with a similar nose and pad.
bool is_in_misfit(const ImpactCase& impact, const Tip& tip) {
  const auto& misfit = impact.pad.material.uncertainty.misfit;
  if (!impact.pad.layers.empty() || !misfit || !misfit->nose_over_pad) return false;
  constexpr double alike = 1.25;
  const double ratio = tip.over_pad / *misfit->nose_over_pad;
  return ratio < alike && ratio > 1 / alike;
}

}  // namespace

void add_neighbours(const ImpactCase& impact, const Summary& summary, Open& open) {
  if (covers_pad(impact)) return;
  const bool is_helped = !factor_of_columns(impact).is_one();
  const std::string words =
      is_helped ? "the effect of neighbouring columns" : "the neglected effect of neighbouring columns";
  const std::optional<Tip> tip = tip_of(impact);
  if (!tip) {
    ImpactCase without_rim = impact;
    without_rim.pad.area.reset();
    const std::string what = tip_of(without_rim) ? "block in contact up to its edge"
                             : std::holds_alternative<Ellipsoid>(impact.impactor.nose)
                                 ? "long ellipsoid"
                                 : name_of(impact.impactor.nose);
    open.sources.push_back({Source::neighbours, words, fmt::format("its size is not known for a {}", what)});
    return;
  }
  if (is_in_misfit(impact, *tip)) return;
  const Error error =
      is_helped ? error_with_neighbours(*tip, impact.pad.floor, summary.peak_strain) : error_of_columns(*tip);
  const double thickness = impact.pad.thickness;
  open.shares.push_back({.source = Source::neighbours,
                         .key = "foam.neighbours",
                         .acceleration = error.peak,
                         .hic = error.hic,
                         .shallower = (error.depth_bias + 1.96 * error.depth_scatter) * thickness,
                         .deeper = is_helped ? 1.96 * error.depth_scatter * thickness : 0});
  open.sources.push_back(
      {Source::neighbours,
       fmt::format("{} ({:.2g} % rms in the peak for a {} radius of {:.2g} times the pad thickness)", words,
                   100 * error.peak, tip->is_flat ? "flat-face" : "nose", tip->over_pad),
       ""});
}

std::string warning_of_model(const ImpactCase& impact) {
  if (covers_pad(impact)) return "";
  const std::optional<Tip> tip = tip_of(impact);
  if (!tip || tip->over_pad >= (tip->is_flat ? nearest : 1)) return "";
  const bool is_helped = !factor_of_columns(impact).is_one();
  const double r = tip->over_pad;
  // The ratio of the forces of finite elements and of columns at half the thickness.
  const double least = 1 + (tip->is_flat ? 0.2 : 0.3) / r, most = 1 + (tip->is_flat ? 1.2 : 0.9) / r;
  const std::string text = fmt::format(
      "SMALL NOSE: the {} radius is {:.2g} times the pad thickness; at a penetration of half the thickness, "
      "the force is about {:.2g} to {:.2g} times that of independent columns",
      tip->is_flat ? "flat-face" : "nose", r, least, most);
  if (!is_helped) return text + "; this effect of neighbouring columns is neglected";
  return text + fmt::format(", depending on the foam; a factor of {:.2g} is used",
                            factor_of_columns(impact)(impact.pad.thickness / 2));
}

}  // namespace dashpad::uncertainty
