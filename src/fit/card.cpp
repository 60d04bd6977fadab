#include "fit/card.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/study/study.hpp"
#include "quantities/text.hpp"

namespace dashpad::fit {
namespace {

std::string rms_words(const MetTest& test) {
  const auto share = [&](const std::optional<double>& rms) { return 100 * *rms / test.largest_stress; };
  std::string words;
  if (test.rms_loading) words += fmt::format("{:.2g} % on loading", share(test.rms_loading));
  if (test.rms_unloading)
    words += fmt::format("{}{:.2g} % on unloading", words.empty() ? "" : ", ", share(test.rms_unloading));
  return words;
}

/// "3 figures; pulse drop.csv, rms 2.1 % of its peak".
std::string impact_words(const ImpactMeasurement& impact, const FitReport& report) {
  std::string words;
  if (!impact.figures.empty())
    words = fmt::format("{} figure{}", impact.figures.size(), impact.figures.size() == 1 ? "" : "s");
  if (!impact.pulse) return words;
  words += fmt::format("{}pulse {}", words.empty() ? "" : "; ", impact.pulse->file);
  for (const MetPulse& met : report.pulses)
    if (met.file == impact.file && met.pulse_file == impact.pulse->file && met.rms) {
      words += fmt::format(", rms {:.2g} % of its peak", 100 * *met.rms / met.measured_peak);
      break;
    }
  return words;
}

std::string origin_of(const Fit& fit, const FitReport& report) {
  std::string origin = "dashpad fit to ";
  std::string separator;
  for (const MetTest& test : report.tests) {
    if (test.is_held_out) continue;
    origin += fmt::format("{}{} ({} points; rms {} of the largest stress)", separator, test.file, test.points,
                          rms_words(test));
    separator = "; ";
  }
  for (const ImpactMeasurement& impact : fitted(fit.impacts)) {
    origin += fmt::format("{}{} ({})", separator, impact.file, impact_words(impact, report));
    separator = "; ";
  }
  origin += fmt::format("; misfit {:.3g} per degree of freedom{}", report.misfit_per_degree(),
                        report.noise_is_stated ? "" : ", by construction: the noise was not stated");
  const Material& base = fit.base.pad.material;
  if (is_stated(base) && !base.source.empty() && !base.name.empty())
    origin += fmt::format("; the rest from {}: {}", base.name, base.source);
  return origin;
}

/// Rounded so that the value stays within, but for the dust of computed numbers.
double rounded_outwards(double value, double side) {
  constexpr double dust = 1e-9;
  const double near = rounded_to(value, card_digits);
  if (side * (value - near) <= dust * value) return near;
  return rounded_to(near + side * value * std::pow(10, 1 - card_digits), card_digits);
}

/// Whether a fitted number is one of the base curve, whose tested range the old one was.
bool refits_curve(const Fit& fit) {
  return std::ranges::any_of(fit.unknowns,
                             [](const Unknown& unknown) { return unknown.key.starts_with("pad.curve."); });
}

void take_rate(FittedRange& range, double rate) {
  range.lowest_rate = std::min(range.lowest_rate, rate);
  range.highest_rate = std::max(range.highest_rate, rate);
}

constexpr FittedRange nothing{.highest_strain = 0, .lowest_rate = 1e300, .highest_rate = 0};

/// Strains and rates of the fitted tests; with the largest strain 0 where there are none.
FittedRange range_of_tests(const Fit& fit) {
  FittedRange range = nothing;
  for (const MaterialMeasurement& test : fitted(fit.tests)) {
    for (std::size_t i = 0; i < test.strain.size(); ++i)
      if (counts(test, i)) range.highest_strain = std::max(range.highest_strain, test.strain[i]);
    take_rate(range, mean_rate_of(test));
  }
  return range;
}

/// What was tested, never what the model reached: tests say up to which strain, and impacts, whose forces
/// were measured, at which rates. Without tests the strain is what the card says that the fit started from;
/// then that of a curve that the file gave. One rate counts for half a decade on either side. Absent where
/// nobody says a strain.
std::optional<FittedRange> range_of_data(const Fit& fit, std::span<const double> values,
                                         const Material& material) {
  FittedRange range = range_of_tests(fit);
  const bool is_tested = range.highest_strain > 0;
  const Material& base = fit.base.pad.material;
  const bool keeps_own = !is_tested || !refits_curve(fit);
  if (const auto own = range_of(base); own && is_stated(base) && keeps_own) {
    range.highest_strain = std::max(range.highest_strain, own->highest_strain);
    take_rate(range, own->lowest_rate);
    take_rate(range, own->highest_rate);
  } else if (!is_tested) {
    const auto of_curve = range_of(material);
    if (!of_curve) return std::nullopt;
    range.highest_strain = of_curve->highest_strain;
  }
  for (const ImpactMeasurement& impact : fit.impacts)
    if (!impact.is_held_out) take_rate(range, rate_of(fit, impact, values));
  if (range.highest_rate < 2 * range.lowest_rate) {
    range.lowest_rate /= std::sqrt(10.0);
    range.highest_rate *= std::sqrt(10.0);
  }
  return FittedRange{.highest_strain = rounded_outwards(range.highest_strain, 1),
                     .lowest_rate = rounded_outwards(range.lowest_rate, -1),
                     .highest_rate = rounded_outwards(range.highest_rate, 1)};
}

/// Stresses that were multiplied have as many card_digits as others.
void round_stresses(TableCurve& table) {
  for (double& stress : table.stress) stress = rounded_to(stress, card_digits);
}
void round_stresses(CurvesRateEffect& effect) {
  for (CurvesRateEffect::AtRate& at : effect.curves) round_stresses(at.curve);
}
template <class Of>
void round_stresses(Of& owner) {
  if constexpr (requires { Of::parameters; })
    for (const Parameter<Of>& parameter : Of::parameters)
      if (std::string_view(parameter.unit) == "Pa")
        parameter.set(owner, rounded_to(parameter.of(owner), card_digits));
}

/// With the card_digits that are written; as it is where it then would break a rule, as a table whose
/// neighbours are nearly equal.
PadLaw rounded(const PadLaw& exact) {
  PadLaw result = exact;
  std::visit(
      []<class Law>(Law& law) {
        round_stresses(law);
        if constexpr (SharesSlip<Law>) {
          std::visit([](auto& form) { round_stresses(form); }, law.curves.base);
          std::visit([](auto& effect) { round_stresses(effect); }, law.curves.rate_effect);
          if constexpr (requires { law.unloading_curve; })
            if (law.unloading_curve) round_stresses(*law.unloading_curve);
        }
      },
      result);
  return violations(result).empty() ? result : exact;
}

/// Whether what neighbouring columns do in impacts is in the numbers of the law.
bool rests_on_strikes(const Fit& fit) {
  return rests_on_impacts_alone(fit) && !seeks(fit, "pad.neighbours") &&
         std::ranges::all_of(fit.impacts, [](const ImpactMeasurement& impact_measurement) {
           return impact_measurement.impact.pad.neighbours == 0;
         });
}

const std::string pad_prefix = "pad.";
const std::string scale_of_pad = "pad.scale";

/// Both ends of a principal axis: coordinates one standard deviation down and up it, as far as the bounds
/// let.
struct Axis {
  std::vector<double> minus, plus;
  double effect = 0;  ///< on what was fitted, squared
};

/// The coordinates that go into the card and are not at a bound.
std::vector<std::size_t> card_coordinates(const Fit& fit, const Solved& solved) {
  std::vector<std::size_t> of;
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i)
    if (is_of_card(fit.unknowns[i].key) && !is_at_bound(solved.minimum.x[i])) of.push_back(i);
  return of;
}

std::vector<Axis> axes_of(const Solved& solved, const std::vector<std::size_t>& size_ts) {
  const std::vector<double>& x = solved.minimum.x;
  std::vector<double> covariance;
  for (const std::size_t i : size_ts)
    for (const std::size_t j : size_ts) covariance.push_back(solved.uncertainty.covariance[i * x.size() + j]);
  const PrincipalAxes found = principal_axes(covariance, size_ts.size());
  std::vector<Axis> axes;
  for (std::size_t k = 0; k < size_ts.size(); ++k) {
    const double deviation = deviation_along(found, k);
    const auto end = [&](double side) {
      std::vector<double> place = x;
      for (std::size_t i = 0; i < size_ts.size(); ++i) {
        double& at = place[size_ts[i]];
        at = std::clamp(at + side * deviation * found.direction(k)[i], 0.0, 1.0);
      }
      return place;
    };
    if (deviation > 0) axes.push_back({end(-1), end(1)});
  }
  return axes;
}

/// Peak, HIC and rebound of the fitted impacts, or without impacts the stresses of the fitted tests; each
/// over its size. Empty where they cannot be computed.
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
std::vector<CaseQuantity> moved_numbers(const Fit& fit, const std::vector<std::size_t>& size_ts) {
  const bool scales =
      std::ranges::any_of(size_ts, [&](std::size_t i) { return fit.unknowns[i].key == scale_of_pad; });
  std::vector<CaseQuantity> moved;
  for (const CaseQuantity& quantity : quantities_of(fit.base)) {
    const bool is_own =
        std::ranges::any_of(size_ts, [&](std::size_t i) { return fit.unknowns[i].key == quantity.key; });
    if (study::is_of_law(quantity.key) && (is_own || (scales && quantity.unit == "Pa")))
      moved.push_back(quantity);
  }
  return moved;
}

PosteriorAxes posterior_of(const Fit& fit, const Problem& problem, const Solved& solved) {
  const std::vector<std::size_t> size_ts = card_coordinates(fit, solved);
  const std::vector<CaseQuantity> moved = moved_numbers(fit, size_ts);
  if (size_ts.empty() || moved.empty() || moved.size() > max_posterior_keys) return {};
  std::vector<Axis> axes = axes_of(solved, size_ts);
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

/// Of a parameter of a foam that lies between 0 and 1.
std::optional<ValueRange> share_range(const FitReport& report, const std::string& key, double value) {
  const auto found =
      std::ranges::find(report.unknowns, pad_prefix + "parameters." + key, &FittedUnknown::key);
  if (found == report.unknowns.end()) return std::nullopt;
  return ValueRange{std::min(rounded_to(found->low.value_or(0), card_digits), value),
                    std::max(rounded_to(found->high.value_or(1), card_digits), value)};
}

bool has_table(const PadLaw& law) {
  return std::visit(
      []<class Law>(const Law& held) {
        if constexpr (SharesSlip<Law>) return std::holds_alternative<TableCurve>(held.curves.base);
        return false;
      },
      law);
}

}  // namespace

bool is_stated(const Material& material) {
  return material.fitted || (material.name != foam_of_the_case && !material.name.empty());
}

double rate_of(const Fit& fit, const ImpactMeasurement& impact, std::span<const double> values) {
  return solve(impact_with(fit, impact, values), impact.options).summary.peak_strain_rate;
}

std::vector<double> written_values(const Fit& fit, std::span<const double> values) {
  std::vector<double> written(values.begin(), values.end());
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i)
    written[i] =
        std::clamp(rounded_to(values[i], card_digits), fit.unknowns[i].lowest, fit.unknowns[i].highest);
  return written;
}

Material card_of(const Fit& fit, std::span<const double> values, const FitReport& report) {
  const std::vector<double> written = written_values(fit, values);
  Material material = material_with(fit, written);
  if (seeks(fit, "pad.scale")) material.law = rounded(law_with(fit, written));
  material.source = origin_of(fit, report);
  material.reservations = reservations_of(fit, written, report);
  material.fitted = range_of_data(fit, written, material);
  if (rests_on_strikes(fit))
    material.nose_over_pad = nose_over_pad_of(fit, std::numeric_limits<double>::infinity());
  material.name = "fitted";
  material.title = fit.title.empty() ? "Fitted foam" : fit.title;
  material.basis = "test";
  return material;
}

std::optional<FittedCase> fitted_case_of(const Fit& fit, std::span<const double> values) {
  if (!finds_more_than_a_card(fit)) return std::nullopt;
  FittedCase found{fit.base, fit.options};
  if (!fit.has_case) {
    const ImpactMeasurement& first = *std::ranges::find_if(
        fit.impacts,
        [](const ImpactMeasurement& impact_measurement) { return !impact_measurement.is_held_out; });
    found = {first.impact, first.options};
  }
  const std::vector<double> written = written_values(fit, values);
  const CaseQuantities quantities = quantities_of(found.impact);
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i)
    if (!is_of_card(fit.unknowns[i].key)) quantities.find(fit.unknowns[i].key)->set(found.impact, written[i]);
  found.impact.pad.material = {};
  if (seeks(fit, "pad.scale")) found.impact.pad.condition.scale = 1;
  return found;
}

PadLaw law_with(const Fit& fit, std::span<const double> values) {
  const Material material = material_with(fit, values);
  const auto scale = std::ranges::find(fit.unknowns, scale_of_pad, &Unknown::key);
  if (scale == fit.unknowns.end()) return material.law;
  return scaled(material.law, values[static_cast<std::size_t>(scale - fit.unknowns.begin())]);
}

dashpad::Uncertainty uncertainty_of(const Fit& fit, const Problem& problem, const Solved& solved,
                                    const FitReport& report, const Material& card) {
  dashpad::Uncertainty of = fit.base.pad.material.uncertainty;
  // They were those of other numbers.
  of.misfit.reset();
  of.posterior = posterior_of(fit, problem, solved);
  if (seeks(fit, scale_of_pad) && has_table(card.law)) {
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
  const bool has_way_back = std::ranges::any_of(report.tests,
                                                [](const MetTest& test) {
                                                  return !test.is_held_out && test.rms_unloading.has_value();
                                                }) ||
                            has_fitted(fit.impacts);
  // What is known to both sides is in the axes already.
  const auto sought =
      std::ranges::find(report.unknowns, "pad.parameters.unloading_factor", &FittedUnknown::key);
  const bool is_in_axes =
      sought != report.unknowns.end() && sought->is_identified() && sought->standard_error;
  if (foam->unloading_curve || is_in_axes)
    of.unloading_factor.reset();
  else if (const auto range = share_range(report, "unloading_factor", foam->unloading_factor))
    of.unloading_factor = range;
  else if (!has_way_back && !of.unloading_factor)
    of.unloading_factor = whole;
  return of;
}

}  // namespace dashpad::fit
