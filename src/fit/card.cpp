#include "fit/card.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/impact/solve.hpp"
#include "fit/problem.hpp"
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
  if (!impact.figures.empty()) words = plural(impact.figures.size(), "figure");
  if (!impact.pulse) return words;
  words += fmt::format("{}pulse {}", words.empty() ? "" : "; ", impact.pulse->file);
  for (const MetPulse& met : report.pulses)
    if (met.file == impact.file && met.pulse_file == impact.pulse->file && met.rms) {
      words += fmt::format(", rms deviation {:.2g} % of its peak", 100 * *met.rms / met.measured_peak);
      break;
    }
  return words;
}

std::string origin_of(const Fit& fit, const FitReport& report) {
  std::vector<std::string> parts;
  for (const MetTest& test : fitted(report.tests))
    parts.push_back(fmt::format("{} ({} points; rms relative to the largest stress: {})", test.file,
                                test.points, rms_words(test)));
  for (const ImpactMeasurement& impact : fitted(fit.impacts))
    parts.push_back(fmt::format("{} ({})", impact.file, impact_words(impact, report)));
  std::string origin =
      fmt::format("dashpad fit to {}; misfit {:.3g} per degree of freedom{}", fmt::join(parts, "; "),
                  report.misfit_per_degree(),
                  report.noise_is_stated ? "" : " by construction, since the noise was not stated");
  const Material& base = fit.base.pad.material;
  if (is_stated(base) && !base.source.empty() && !base.name.empty())
    origin += fmt::format("; all other values from {}: {}", base.name, base.source);
  return origin;
}

/// Rounded so that the value stays within, but for the dust of computed numbers.
double rounded_outwards(double value, double side) {
  constexpr double dust = 1e-9;
  const double near = rounded_to(value, card_digits);
  if (side * (value - near) <= dust * value) return near;
  return rounded_to(near + side * value * std::pow(10, 1 - card_digits), card_digits);
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

/// The tested range, never what the model reached. Tests give the strains; impacts, whose forces were
/// measured, give rates. Without tests the strain is that of the card from which the fit started, else that
/// of a curve in the fit file. A single rate covers half a decade on either side. Absent without a strain.
std::optional<FittedRange> range_of_data(const Fit& fit, std::span<const double> values,
                                         const Material& material) {
  FittedRange range = range_of_tests(fit);
  const bool is_tested = range.highest_strain > 0;
  const Material& base = fit.base.pad.material;
  // The range of the card belongs to its curve.
  const bool keeps_own = !is_tested || std::ranges::none_of(fit.unknowns, [](const Unknown& unknown) {
    return unknown.key.starts_with("pad.curve.");
  });
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

/// The law with stresses rounded to card_digits; unchanged if that would break a rule.
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
         std::ranges::all_of(
             fit.impacts, [](const ImpactMeasurement& impact) { return impact.impact.pad.neighbours == 0; });
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
        fit.impacts, [](const ImpactMeasurement& impact) { return !impact.is_held_out; });
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

}  // namespace dashpad::fit
