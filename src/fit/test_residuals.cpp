#include "fit/test_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dashpad/impact/case_quantity.hpp"
#include "dashpad/laboratory/column_test.hpp"
#include "fit/problem.hpp"

namespace dashpad::fit {

namespace {

/// How an unknown of the law gets into a case, by its place among the unknowns.
struct LawSetter {
  std::size_t place;
  std::function<void(ImpactCase&, double)> set;
};

std::vector<LawSetter> law_setters(const Fit& fit) {
  std::vector<LawSetter> setters;
  for (const CaseQuantity& quantity : quantities_of(fit.base)) {
    const bool is_of_law = quantity.key.starts_with("pad.parameters.") ||
                           quantity.key.starts_with("pad.curve.") || quantity.key.starts_with("pad.rate.");
    const auto found = std::ranges::find(fit.unknowns, quantity.key, &Unknown::key);
    if (is_of_law && found != fit.unknowns.end())
      setters.push_back({static_cast<std::size_t>(found - fit.unknowns.begin()), quantity.set});
  }
  return setters;
}

}  // namespace

double mean_rate_of(const MaterialMeasurement& test) {
  double way = 0;
  double time = 0;
  for (std::size_t i = 1; i < test.strain.size(); ++i)
    if (test.strain[i] != test.strain[i - 1]) {
      way += std::abs(test.strain[i] - test.strain[i - 1]);
      time += test.time[i] - test.time[i - 1];
    }
  return time > 0 ? way / time : 0;
}

TestPath path_of(const MaterialMeasurement& test) {
  TestPath path;
  double strain = 0;
  const auto go = [&](double to, double duration) {
    if (duration > 0) path.history.pieces.push_back({duration, strain, (to - strain) / duration, 0});
    if (duration > 0) strain = to;
    path.pieces_to.push_back(path.history.pieces.size());
  };
  const double first = std::max(test.strain.front(), 0.0);
  go(first, first > 0 ? first / mean_rate_of(test) : 0);
  for (std::size_t i = 1; i < test.strain.size(); ++i)
    go(std::max(test.strain[i], 0.0), test.time[i] - test.time[i - 1]);
  return path;
}

Material material_with(const Fit& fit, std::span<const double> values) {
  ImpactCase impact = fit.base;
  for (const LawSetter& setter : law_setters(fit)) setter.set(impact, values[setter.place]);
  return impact.pad.material;
}

Predict prediction_of(const Fit& fit, const MaterialMeasurement& test) {
  std::vector<std::size_t> pieces;
  TestPath path = path_of(test);
  for (std::size_t i = 0; i < test.strain.size(); ++i)
    if (counts(test, i)) pieces.push_back(path.pieces_to[i]);
  return [base = fit.base, setters = law_setters(fit), history = std::move(path.history),
          pieces = std::move(pieces)](std::span<const double> values, std::span<double> predicted) {
    ImpactCase impact = base;
    for (const LawSetter& setter : setters) setter.set(impact, values[setter.place]);
    try {
      const std::vector<double> stress = laboratory::stress_at_ends(impact.pad.material.law, history);
      for (std::size_t i = 0; i < pieces.size(); ++i)
        predicted[i] = pieces[i] == 0 ? 0 : stress[pieces[i] - 1];
      return true;
    } catch (const std::invalid_argument&) {
      return false;  // numbers that make no law
    }
  };
}

}  // namespace dashpad::fit
