#include "fit/card.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/study/study.hpp"
#include "fit/determine.hpp"
#include "fit/problem.hpp"
#include "quantities/text.hpp"

namespace dashpad::fit {
namespace {

const std::string pad_prefix = "pad.";
const std::string scale_of_pad = "pad.scale";

/// The ends of a principal axis: coordinates one standard deviation down and up, within the bounds.
struct Axis {
  std::vector<double> minus, plus;
  double effect = 0;  ///< squared effect on the fitted figures
};

/// The coordinates that go into the card and are not at a bound.
std::vector<std::size_t> card_coordinates(const Fit& fit, const Solved& solved) {
  std::vector<std::size_t> of;
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i)
    if (is_of_card(fit.unknowns[i].key) && !is_at_bound(solved.minimum.x[i])) of.push_back(i);
  return of;
}

std::vector<Axis> axes_of(const Solved& solved, const std::vector<std::size_t>& coordinates) {
  const std::vector<double>& x = solved.minimum.x;
  std::vector<double> covariance;
  for (const std::size_t i : coordinates)
    for (const std::size_t j : coordinates)
      covariance.push_back(solved.uncertainty.covariance[i * x.size() + j]);
  const PrincipalAxes found = principal_axes(covariance, coordinates.size());
  std::vector<Axis> axes;
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    const double deviation = deviation_along(found, k);
    const auto end = [&](double side) {
      std::vector<double> place = x;
      for (std::size_t i = 0; i < coordinates.size(); ++i) {
        double& at = place[coordinates[i]];
        at = std::clamp(at + side * deviation * found.direction(k)[i], 0.0, 1.0);
      }
      return place;
    };
    if (deviation > 0) axes.push_back({end(-1), end(1)});
  }
  return axes;
}

/// Peak, HIC and rebound of fitted impacts, or else stresses of fitted tests, each over its size.
std::vector<double> fitted_figures(const Fit& fit, std::span<const double> values) {
  std::vector<double> all;
  for (const ImpactMeasurement& impact : fitted(fit.impacts)) {
    ImpactMeasurement asked = impact;
    asked.pulse.reset();
    asked.figures = {{ImpactFigure::peak_acceleration, 1, 1},
                     {ImpactFigure::hic_unlimited, 1, 1},
                     {ImpactFigure::rebound_speed, 1, 1}};
    std::vector<double> computed(asked.figures.size());
    if (!prediction_of(fit, asked, 4)(values, computed)) return {};
    all.insert(all.end(), computed.begin(), computed.end());
  }
  if (!all.empty()) return all;
  for (const MaterialMeasurement& test : fitted(fit.tests)) {
    const MetTest met = met_test(fit, test, values, 0);
    for (const double stress : met.computed) all.push_back(1 + stress / met.largest_stress);
  }
  return all;
}

/// The axes that move what was fitted most, the first ones.
void keep_largest(const Fit& fit, const Problem& problem, const Solved& solved, std::vector<Axis>& axes) {
  const std::vector<double> here = fitted_figures(fit, problem.values(solved.minimum.x));
  for (Axis& axis : axes) {
    const std::vector<double> down = fitted_figures(fit, problem.values(axis.minus)),
                              up = fitted_figures(fit, problem.values(axis.plus));
    for (std::size_t i = 0; i < here.size() && down.size() == here.size() && up.size() == here.size(); ++i) {
      const double change = (up[i] - down[i]) / (2 * here[i]);
      if (std::isfinite(change)) axis.effect += change * change;
    }
  }
  std::ranges::stable_sort(axes, std::greater{}, &Axis::effect);
  axes.resize(std::min(axes.size(), max_posterior_axes));
}

/// Numbers of the law that the unknowns move: their own, and all stresses with the scale of the pad.
std::vector<CaseQuantity> moved_numbers(const Fit& fit, const std::vector<std::size_t>& coordinates) {
  const bool scales =
      std::ranges::any_of(coordinates, [&](std::size_t i) { return fit.unknowns[i].key == scale_of_pad; });
  std::vector<CaseQuantity> moved;
  for (const CaseQuantity& quantity : quantities_of(fit.base)) {
    const bool is_own =
        std::ranges::any_of(coordinates, [&](std::size_t i) { return fit.unknowns[i].key == quantity.key; });
    if (study::is_of_law(quantity.key) && (is_own || (scales && quantity.unit == "Pa")))
      moved.push_back(quantity);
  }
  return moved;
}

PosteriorAxes posterior_of(const Fit& fit, const Problem& problem, const Solved& solved) {
  const std::vector<std::size_t> coordinates = card_coordinates(fit, solved);
  const std::vector<CaseQuantity> moved = moved_numbers(fit, coordinates);
  if (coordinates.empty() || moved.empty() || moved.size() > max_posterior_keys) return {};
  std::vector<Axis> axes = axes_of(solved, coordinates);
  keep_largest(fit, problem, solved, axes);
  PosteriorAxes posterior;
  for (const CaseQuantity& number : moved) posterior.keys.push_back(number.key.substr(pad_prefix.size()));
  ImpactCase impact = fit.base;
  const auto row = [&](const std::vector<double>& place) {
    impact.pad.material.law = law_with(fit, problem.values(place));
    std::vector<double> numbers;
    for (const CaseQuantity& number : moved) numbers.push_back(rounded_to(number.get(impact), card_digits));
    return numbers;
  };
  for (const Axis& axis : axes) {
    posterior.minus.push_back(row(axis.minus));
    posterior.plus.push_back(row(axis.plus));
  }
  return posterior;
}

/// The result for a parameter of the foam; null if it is no unknown.
const FittedUnknown* find_parameter(const FitReport& report, const std::string& key) {
  const auto found =
      std::ranges::find(report.unknowns, pad_prefix + "parameters." + key, &FittedUnknown::key);
  return found == report.unknowns.end() ? nullptr : &*found;
}

/// The range of a foam parameter that lies between 0 and 1.
std::optional<ValueRange> share_range(const FitReport& report, const std::string& key, double value) {
  const FittedUnknown* const found = find_parameter(report, key);
  if (found == nullptr) return std::nullopt;
  return ValueRange{std::min(rounded_to(found->low.value_or(0), card_digits), value),
                    std::max(rounded_to(found->high.value_or(1), card_digits), value)};
}

}  // namespace

PadLaw law_with(const Fit& fit, std::span<const double> values) {
  const Material material = material_with(fit, values);
  const auto scale = std::ranges::find(fit.unknowns, scale_of_pad, &Unknown::key);
  if (scale == fit.unknowns.end()) return material.law;
  return scaled(material.law, values[static_cast<std::size_t>(scale - fit.unknowns.begin())]);
}

dashpad::Uncertainty uncertainty_of(const Fit& fit, const Problem& problem, const Solved& solved,
                                    const FitReport& report, const Material& card) {
  dashpad::Uncertainty of = fit.base.pad.material.uncertainty;
  // The old misfit belongs to other numbers.
  of.misfit.reset();
  of.posterior = posterior_of(fit, problem, solved);
  const FoamCurves* const curves = foam_curves(card.law);
  if (seeks(fit, scale_of_pad) && curves && std::holds_alternative<TableCurve>(curves->base)) {
    const auto scale = std::ranges::find(report.unknowns, scale_of_pad, &FittedUnknown::key);
    if (scale->standard_error)
      of.scatter = std::min(
          rounded_to(std::hypot(of.scatter.value_or(0), *scale->standard_error / scale->value), 3), 1.0);
  }
  const auto* const foam = std::get_if<Foam>(&card.law);
  if (foam == nullptr) return of;
  constexpr ValueRange whole{0, 1};
  if (const auto range = share_range(report, "recoil", foam->recoil))
    of.recoil = range;
  else if (assumes_recoil(fit))
    of.recoil = whole;
  // If the interval has both ends, the axes contain its uncertainty already.
  const FittedUnknown* const sought = find_parameter(report, "unloading_factor");
  const bool is_in_axes = sought && sought->is_identified() && sought->standard_error;
  if (foam->unloading_curve || is_in_axes)
    of.unloading_factor.reset();
  else if (const auto range = share_range(report, "unloading_factor", foam->unloading_factor))
    of.unloading_factor = range;
  else if (!shows_way_back(fit, report) && !of.unloading_factor)
    of.unloading_factor = whole;
  return of;
}

}  // namespace dashpad::fit
