// Uncertainty of the stress beyond the tested strain (the exponent of Eq. 37) and beyond the tested rates.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/quantities/portable_math.hpp"
#include "model/pad/foam/foam_curve.hpp"
#include "model/pad/foam/foam_rules.hpp"
#include "model/pad/foam/overstress.hpp"
#include "quantities/text.hpp"
#include "uncertainty/open_sources.hpp"

namespace dashpad::uncertainty {
namespace {

/// The base curve, cut at a strain.
BaseCurve cut_at(const BaseCurve& base, double strain) {
  if (strain >= last_strain_of(base)) return base;
  const double stress = FoamCurve(base, 2).at(strain_of(strain)).stress;
  return std::visit(
      [&]<class Form>(Form form) -> BaseCurve {
        if constexpr (std::is_same_v<Form, TableCurve>) {
          const auto first = std::ranges::lower_bound(form.strain, strain);
          const auto kept = static_cast<std::size_t>(first - form.strain.begin());
          form.strain.resize(kept);
          form.stress.resize(kept);
          form.strain.push_back(strain);
          form.stress.push_back(stress);
          if (form.strain.size() < TableCurve::fewest_points) return base;
        } else {
          form.highest_strain = strain;
        }
        return form;
      },
      base);
}

/// The strain up to which the foam was tested.
std::optional<double> tested_strain(const Material& material) {
  std::optional<double> strain;
  if (material.fitted) strain = material.fitted->highest_strain;
  if (const FoamCurves* const curves = foam_curves(material.law))
    strain = std::min(strain.value_or(1), last_strain_of(curves->base));
  return strain;
}

/// Sets the continuation beyond the tested strain, from the gentlest (place -1) to the steepest (1).
void continue_by(Material& material, double tested, double place) {
  std::visit(
      [&]<class Law>(Law& law) {
        if constexpr (SharesSlip<Law>) {
          const double n = law.continuation_exponent;
          law.continuation_exponent = place < 0 ? n + place * (n - law.gentlest_continuation)
                                                : n + place * (law.steepest_continuation - n);
          law.curves.base = cut_at(law.curves.base, tested);
        }
      },
      material.law);
}

/// Exponents of the rate for foams tested at one rate only. Those measured over all rates are 0.02 to 0.05
/// for EPS, 0.03 to 0.11 for VN600 at strains from 0.25 to 0.5, and 0.11 to 0.21 for the hard polyurethane.
constexpr double usual_exponent = 0.1, usual_exponent_of_crushable = 0.05;

/// The exponent between the two highest tested rates, at a strain of a third; nothing if one rate was tested.
std::optional<double> last_exponent(const FoamCurves& curves) {
  if (std::holds_alternative<NoRateEffect>(curves.rate_effect)) return std::nullopt;
  const FoamCurve base(curves.base, 2);
  const Overstress over(curves, base, 0, 1, curves.slowest_rate / 1000);
  const double strain = std::min(1.0 / 3, 0.9 * base.last_strain());
  const Overstress::Value at = over.of(over.at((1 - 1e-6) * tested_rates(curves).back()), strain,
                                       base.cells().place(std::sqrt(strain)));
  return std::max(at.rise / (1 + at.stress), 0.0);
}

/// Lets the curves of a foam grow with the rate by the power `exponent` up to `reached`, 1/s.
void grow_beyond(FoamCurves& curves, double reached, double exponent) {
  const double tested = tested_rates(curves).back();
  std::visit(
      [&]<class Effect>(Effect& effect) {
        const double factor = portable::pow(reached / tested, exponent);
        if constexpr (std::is_same_v<Effect, PowerRateEffect>) {
          // The card's own power, up to the rate at which it has grown by that factor.
          const double own = std::max(effect.exponent + effect.exponent_slope / 3, 1e-6);
          effect.highest_rate = tested * portable::pow(reached / tested, std::min(exponent / own, 1.0));
        } else if constexpr (std::is_same_v<Effect, FactorRateEffect>) {
          effect.rate.push_back(reached);
          effect.factor.push_back(factor * effect.factor.back());
        } else if constexpr (std::is_same_v<Effect, CurvesRateEffect>) {
          CurvesRateEffect::AtRate next{reached, effect.curves.back().curve};
          for (double& stress : next.curve.stress) stress *= factor;
          effect.curves.push_back(std::move(next));
        }
      },
      curves.rate_effect);
  if (std::holds_alternative<NoRateEffect>(curves.rate_effect))
    curves.rate_effect = PowerRateEffect{.exponent = exponent, .exponent_slope = 0, .highest_rate = reached};
}

/// The range of a part beyond its tested rates.
struct Growth {
  double tested = 0;    ///< highest tested rate, or the lowest for an impact slower than all tests, 1/s
  double reached = 0;   ///< rate in the impact, 1/s
  double exponent = 0;  ///< largest exponent of the rate
};

void grow(Material& material, PadCondition& condition, const Growth& by, double place) {
  if (by.reached < by.tested) {
    condition.scale *= portable::pow(by.reached / by.tested, place * by.exponent);
    return;
  }
  std::visit(
      [&]<class Law>(Law& law) {
        if constexpr (SharesSlip<Law>) grow_beyond(law.curves, by.reached, place * by.exponent);
        // The power of laws 4 and 5 continues anyway; the other end is that it stops.
        if constexpr (std::is_same_v<Law, NineParameter>)
          law.rate_modulus *= portable::pow(by.tested / by.reached, place * by.exponent);
        if constexpr (std::is_same_v<Law, TwentyOneParameter>)
          law.rate_stress *= portable::pow(by.tested / by.reached, place * by.exponent);
      },
      material.law);
}

/// The largest exponent of the rate beyond the tests; nothing for a law without a power of the rate.
std::optional<double> exponent_of(const Material& material) {
  if (const auto& stated = material.uncertainty.rate_exponent) return stated->high;
  return std::visit(
      []<class Law>(const Law& law) -> std::optional<double> {
        if constexpr (SharesSlip<Law>) {
          if (const auto last = last_exponent(law.curves)) return last;
          return std::is_same_v<Law, CrushableFoam> ? usual_exponent_of_crushable : usual_exponent;
        } else if constexpr (std::is_same_v<Law, NineParameter> || std::is_same_v<Law, TwentyOneParameter>) {
          return law.rate_exponent;
        } else {
          return std::nullopt;
        }
      },
      material.law);
}

}  // namespace

void add_continuation(const ImpactCase& impact, const Summary& summary, Open& open) {
  std::vector<std::optional<double>> beyond;  // tested strain of the parts that exceeded it
  double first = 1;
  bool by_curves = false;
  for (const Part& part : parts_of(impact.pad, summary)) {
    const std::optional<double> tested = tested_strain(*part.material);
    const bool is_beyond = tested && part.strain > (1 + 1e-9) * *tested;
    beyond.push_back(is_beyond ? tested : std::nullopt);
    if (!is_beyond) continue;
    first = std::min(first, *tested);
    if (has_curves(part.material->law)) {
      by_curves = true;
    } else {
      open.sources.push_back({Source::continuation,
                              fmt::format("the validity of the law above a strain of {:.3g}", *tested),
                              fmt::format("the {} law has no parameter for strains above the fitted range",
                                          name_of(part.material->law))});
    }
  }
  if (!by_curves) return;
  open.sources.push_back(
      {Source::continuation, fmt::format("the stress beyond a strain of {:.3g}", first), ""});
  open.lines.push_back({.source = Source::continuation,
                        .key = "foam.continuation",
                        .ends = {-1, 1},
                        .move = [beyond](ImpactCase& moved_case, double place) {
                          change_parts(moved_case, [&](Material& material, PadCondition&, std::size_t i) {
                            if (beyond[i]) continue_by(material, *beyond[i], place);
                          });
                        }});
}

void add_rate(const ImpactCase& impact, const Summary& summary, Open& open) {
  std::vector<std::optional<Growth>> growths;
  std::string words;
  for (const Part& part : parts_of(impact.pad, summary)) {
    growths.emplace_back();
    const std::optional<FittedRange> range = range_of(*part.material);
    if (!range || (part.rate <= range->highest_rate && part.rate >= range->lowest_rate)) continue;
    const bool is_above = part.rate > range->highest_rate;
    const double tested = is_above ? range->highest_rate : range->lowest_rate;
    const bool at_one = range->highest_rate <= 10 * range->lowest_rate;
    const char* const how = at_one ? "at" : is_above ? "up to" : "down to";
    const std::string what = fmt::format("the stress at a strain rate of {} per second, tested only {} {}",
                                         plain_number(part.rate), how, plain_number(tested));
    const std::optional<double> exponent = exponent_of(*part.material);
    if (!exponent) {
      open.sources.push_back(
          {Source::rate, what, fmt::format("the {} law has no rate exponent", name_of(part.material->law))});
      continue;
    }
    growths.back() = Growth{tested, part.rate, *exponent};
    if (words.empty()) words = fmt::format("{} (rate exponent from 0 to {:.2g})", what, *exponent);
  }
  if (words.empty()) return;
  open.sources.push_back({Source::rate, words, ""});
  open.lines.push_back({.source = Source::rate,
                        .key = "foam.rate",
                        .ends = {1},
                        .move = [growths](ImpactCase& moved_case, double place) {
                          change_parts(moved_case,
                                       [&](Material& material, PadCondition& condition, std::size_t i) {
                                         if (growths[i]) grow(material, condition, *growths[i], place);
                                       });
                        }});
}

}  // namespace dashpad::uncertainty
