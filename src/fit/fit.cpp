#include "dashpad/fit/fit.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/study/study.hpp"
#include "fit/card.hpp"
#include "fit/problem.hpp"

namespace dashpad::fit {

namespace {

using Broken = std::vector<Violation>;

/// Tests whose rates differ by less than this factor have one rate.
constexpr double one_rate = 2;

void check_key_of(const Fit& fit, const Unknown& unknown, Broken& broken) {
  const std::string key = "unknowns." + unknown.key;
  const auto has = [&](const ImpactCase& impact) {
    return quantities_of(impact).find(unknown.key) != nullptr;
  };
  if (!has(fit.base)) {
    broken.push_back({key, no_value,
                      unknown.key == "pad.material"
                          ? "is not a number; fit one of its entries, such as pad.curve.modulus"
                          : study::rule_for_unknown(unknown.key, fit.base, study::factor_keys(fit.base))});
    return;
  }
  if (&*std::ranges::find(fit.unknowns, unknown.key, &Unknown::key) != &unknown)
    broken.push_back({key, no_value, "is given twice"});
  if (!study::is_of_law(unknown.key) && !has_fitted(fit.impacts))
    broken.push_back({key, no_value,
                      "is not a parameter of the pad's law, and material tests determine only those; it "
                      "needs [[impacts]]"});
  for (const ImpactMeasurement& impact : fit.impacts) {
    ImpactCase impact_case = impact.impact;
    impact_case.pad.material = fit.base.pad.material;
    if (!has(impact_case))
      broken.push_back({key, no_value,
                        study::rule_for_unknown(unknown.key, impact_case, study::factor_keys(impact_case)) +
                            " (in " + impact.file + ")"});
  }
}

/// The rule that the base case breaks with this value of the unknown.
std::string rule_at(const Fit& fit, const Unknown& unknown, double value) {
  const CaseQuantities quantities = quantities_of(fit.base);
  const CaseQuantity* const quantity = quantities.find(unknown.key);
  if (quantity == nullptr) return "";
  ImpactCase impact = fit.base;
  quantity->set(impact, value);
  for (const Violation& violation : violations(impact))
    if (violation.key == unknown.key && !violation.rule.starts_with("the curve must rise"))
      return violation.rule;
  return "";
}

void check_numbers_of(const Fit& fit, const Unknown& unknown, Broken& broken) {
  const std::string key = "unknowns." + unknown.key;
  const auto add = [&](const char* part, double value, std::string rule) {
    broken.push_back({key + part, value, std::move(rule)});
  };
  if (!(std::isfinite(unknown.lowest) && std::isfinite(unknown.highest) && unknown.lowest < unknown.highest))
    return add(".bounds", unknown.lowest, "must be two values, the lower one first");
  if (unknown.is_logarithmic && !(unknown.lowest > 0))
    return add(".scale", no_value, "\"log\" needs bounds above 0");
  for (const double bound : {unknown.lowest, unknown.highest})
    if (const std::string rule = rule_at(fit, unknown, bound); !rule.empty())
      add(".bounds", bound,
          fmt::format("the {} bound, {:.6g}, is not allowed: {}", bound == unknown.lowest ? "lower" : "upper",
                      bound, rule));
  const auto inside = [&](double value) { return value >= unknown.lowest && value <= unknown.highest; };
  if (!inside(unknown.start))
    add(".start", unknown.start,
        fmt::format("the starting value, {:.6g}, must lie within the bounds, {:.6g} to {:.6g}", unknown.start,
                    unknown.lowest, unknown.highest));
  if (!unknown.prior) return;
  if (!(unknown.prior->deviation > 0)) add(".prior", unknown.prior->deviation, "needs a deviation above 0");
  if (!inside(unknown.prior->mean))
    add(".prior", unknown.prior->mean,
        fmt::format("its mean, {:.6g}, must lie within the bounds, {:.6g} to {:.6g}", unknown.prior->mean,
                    unknown.lowest, unknown.highest));
}

std::size_t points_of(const MaterialMeasurement& test) {
  std::size_t points = 0;
  for (std::size_t i = 0; i < test.strain.size(); ++i) points += counts(test, i) ? 1 : 0;
  return points;
}

void check_amount(const Fit& fit, Broken& broken) {
  std::size_t data = 0;
  const std::size_t unknowns = coordinate_count(fit);
  for (const MaterialMeasurement& test : fit.tests) data += test.is_held_out ? 0 : points_of(test);
  for (const ImpactMeasurement& impact : fit.impacts)
    if (!impact.is_held_out) data += impact.figures.size() + (impact.pulse ? impact.pulse->time.size() : 0);
  if (data == 0) {
    broken.push_back(
        {"tests", no_value, "there are no data to fit: give [[tests]] or [[impacts]] that are not held out"});
    return;
  }
  for (const Unknown& unknown : fit.unknowns) data += unknown.prior ? 1 : 0;
  if (data < unknowns)
    broken.push_back({"unknowns", no_value,
                      fmt::format("the number of measured values and priors, {}, must be at least the number "
                                  "of unknowns, {}, offsets and shifts included",
                                  data, unknowns)});
}

bool is_of_the_rate(const std::string& key) {
  return key.starts_with("pad.rate.") || key == "pad.parameters.rate_modulus" ||
         key == "pad.parameters.rate_exponent";
}

/// Tests at a single rate do not determine a rate effect.
void check_rates(const Fit& fit, Broken& broken) {
  double lowest = infinite;
  double highest = 0;
  if (has_fitted(fit.impacts)) return;
  for (const MaterialMeasurement& test : fitted(fit.tests)) {
    const RateRange rates = rates_of(test);
    lowest = std::min(lowest, rates.lowest);
    highest = std::max(highest, rates.highest);
  }
  if (!(highest < one_rate * lowest)) return;
  for (const Unknown& unknown : fit.unknowns)
    if (is_of_the_rate(unknown.key) && !unknown.prior)
      broken.push_back(
          {"unknowns." + unknown.key, no_value,
           fmt::format("all tests have the same strain rate, {:.3g} 1/s, and do not show its effect; keep "
                       "the value fixed, give a prior, or add a test at a different rate",
                       highest)});
}

/// A deviation far from what it is of would drown all other data, or say nothing.
void check_deviation(const std::string& key, double deviation, double whole, Broken& broken) {
  constexpr double least = 1e-9, most = 1e6;
  const double share = deviation / std::abs(whole);
  if (whole != 0 && deviation > 0 && !(share >= least && share <= most))
    broken.push_back({key, deviation,
                      fmt::format("must be between {:g} and {:g} times the largest measured value, {:.3g}",
                                  least, most, std::abs(whole))});
}

void check_test(const MaterialMeasurement& test, std::size_t i, Broken& broken) {
  const std::string key = fmt::format("tests[{}]", i + 1);
  if (test.noise && !test.stress.empty())
    check_deviation(key + ".noise", *test.noise, std::ranges::max(test.stress), broken);
  if (test.noise && !(*test.noise > 0))
    broken.push_back({key + ".noise", *test.noise, "must be more than 0"});
  if (test.strain.size() < 2 || test.strain.size() != test.stress.size() ||
      test.strain.size() != test.time.size())
    broken.push_back({key + ".file", no_value, "needs at least two points, each with a time"});
  else if (points_of(test) < 2)
    broken.push_back({key + ".range", no_value,
                      fmt::format("fewer than two points have a strain from {:g} to {:g}", test.lowest_strain,
                                  test.highest_strain)});
}

void check_pulse(const MeasuredDeceleration& pulse, const std::string& key, Broken& broken) {
  if (!(pulse.deviation > 0 && std::isfinite(pulse.deviation)))
    broken.push_back({key + ".deviation", pulse.deviation, "must be more than 0"});
  check_deviation(key + ".deviation", pulse.deviation, pulse.peak, broken);
  if (pulse.time.size() < 2 || pulse.time.size() != pulse.deceleration.size() ||
      !(pulse.half_peak_width > 0) || !(pulse.peak > 0))
    broken.push_back({key, no_value, "needs samples with times, a peak and a width"});
}

}  // namespace

bool is_of_card(const std::string& key) { return study::is_of_law(key) || key == "pad.scale"; }

bool finds_more_than_a_card(const Fit& fit) {
  return !std::ranges::all_of(fit.unknowns, [](const Unknown& unknown) { return is_of_card(unknown.key); });
}

bool is_natural_bound(const Fit& fit, const Unknown& unknown, double bound) {
  const double step = 1e-6 * (unknown.highest - unknown.lowest);
  try {
    return !rule_at(fit, unknown, bound == unknown.lowest ? bound - step : bound + step).empty();
  } catch (const std::invalid_argument&) {
    return true;  // a support that cannot exist
  }
}

std::vector<Violation> violations(const Fit& fit) {
  Broken broken;
  if (fit.unknowns.empty()) broken.push_back({"unknowns", no_value, "a fit needs at least one unknown"});
  for (const Unknown& unknown : fit.unknowns) {
    check_key_of(fit, unknown, broken);
    check_numbers_of(fit, unknown, broken);
  }
  for (std::size_t i = 0; i < fit.tests.size(); ++i) check_test(fit.tests[i], i, broken);
  for (std::size_t i = 0; i < fit.impacts.size(); ++i) {
    const std::string key = fmt::format("impacts[{}]", i + 1);
    if (fit.impacts[i].figures.empty() && !fit.impacts[i].pulse)
      broken.push_back({key, no_value, "needs a measured figure, such as peak_force, or a pulse"});
    if (fit.impacts[i].pulse) check_pulse(*fit.impacts[i].pulse, key + ".pulse", broken);
    for (const MeasuredFigure& figure : fit.impacts[i].figures) {
      check_deviation(key, figure.deviation, figure.value, broken);
      if (!(figure.deviation > 0 && std::isfinite(figure.deviation) && std::isfinite(figure.value)))
        broken.push_back({key, figure.deviation, "a figure needs a value and a deviation above 0"});
    }
  }
  if (fit.starts < 1 || fit.starts > 1000)
    broken.push_back({"fit.starts", double(fit.starts), "must be from 1 to 1000"});
  if (!broken.empty()) return broken;
  check_amount(fit, broken);
  check_rates(fit, broken);
  return broken;
}

}  // namespace dashpad::fit
