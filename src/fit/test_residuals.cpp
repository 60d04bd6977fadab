#include "fit/problem.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <tbb/enumerable_thread_specific.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/laboratory/column_test.hpp"
#include "dashpad/study/design.hpp"
#include "model/pad/foam/foam_memo.hpp"

namespace dashpad::fit {

namespace {

/// The base curve has to rise from place to place by this share of its mean rise, to within a deviation that
/// no data can move: a material whose curve falls is none.
constexpr std::size_t places_of_rule = 100;
constexpr double least_rise = 0.01;
constexpr double deviation_of_rule = 1e-4;

/// How an unknown of the law gets into a case, by its place among the unknowns.
struct LawSetter {
  std::size_t place;
  std::function<void(ImpactCase&, double)> set;
};

std::vector<LawSetter> law_setters(const Fit& fit) {
  std::vector<LawSetter> setters;
  for (const CaseQuantity& quantity : quantities_of(fit.base)) {
    const auto found = std::ranges::find(fit.unknowns, quantity.key, &Unknown::key);
    if (study::is_of_law(quantity.key) && found != fit.unknowns.end())
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

std::optional<Block> rule_of_rising(const Fit& fit) {
  const FoamCurves* const curves = std::visit(
      []<class Law>(const Law& law) -> const FoamCurves* {
        if constexpr (SharesSlip<Law>) return &law.curves;
        return nullptr;
      },
      fit.base.pad.material.law);
  if (curves == nullptr || std::holds_alternative<TableCurve>(curves->base)) return std::nullopt;
  Block block;
  block.is_rule = true;
  block.measured.assign(places_of_rule, 0);
  block.deviation.assign(places_of_rule, deviation_of_rule);
  block.predict = [base = fit.base, setters = law_setters(fit)](std::span<const double> values,
                                                                std::span<double> predicted) {
    ImpactCase impact = base;
    for (const LawSetter& setter : setters) setter.set(impact, values[setter.place]);
    std::visit(
        [&]<class Law>(const Law& law) {
          if constexpr (SharesSlip<Law>)
            std::visit(
                [&]<class Form>(const Form& form) {
                  if constexpr (!std::is_same_v<Form, TableCurve>) {
                    const auto count = static_cast<double>(predicted.size());
                    const double mean_rise = form.stress(form.highest_strain) / count;
                    double before = 0;
                    for (std::size_t i = 0; i < predicted.size(); ++i) {
                      const double stress =
                          form.stress(form.highest_strain * static_cast<double>(i + 1) / count);
                      predicted[i] = std::max(least_rise - (stress - before) / mean_rise, 0.0);
                      before = stress;
                    }
                  }
                },
                law.curves.base);
        },
        impact.pad.material.law);
    return true;
  };
  return block;
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
  using Memos = tbb::enumerable_thread_specific<FoamMemo>;
  return [base = fit.base, setters = law_setters(fit), history = std::move(path.history),
          pieces = std::move(pieces),
          memos = std::make_shared<Memos>()](std::span<const double> values, std::span<double> predicted) {
    ImpactCase impact = base;
    for (const LawSetter& setter : setters) setter.set(impact, values[setter.place]);
    const PadLaw& law = impact.pad.material.law;
    // A foam's numbers are within their bounds, and rule_of_rising() sees to its curve.
    if (!std::holds_alternative<Foam>(law) && !violations(law).empty()) return false;
    const std::vector<double> stress = laboratory::stress_at_ends(law, history, &memos->local());
    for (std::size_t i = 0; i < pieces.size(); ++i) predicted[i] = pieces[i] == 0 ? 0 : stress[pieces[i] - 1];
    return true;
  };
}

}  // namespace dashpad::fit
