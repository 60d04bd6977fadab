#include "fit/problem.hpp"

#include <algorithm>
#include <atomic>
#include <memory>

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/study/study.hpp"
#include "model/pad/foam/foam_memo.hpp"

namespace dashpad::fit {
namespace {

/// Share of the largest stress that an unstated noise is taken to be, until the misfit tells.
constexpr double first_guess_of_noise = 0.01;
/// Steps of coordinates for derivatives. Material tests are exact to 1e-9 or better; figures of impacts with
/// a fixed number of runs are exact to some 5e-5, since the number of steps varies.
constexpr double step_with_tests = 1e-4;
constexpr double step_with_impacts = 1e-2;

Block block_of(const Fit& fit, const MaterialMeasurement& test) {
  Block block;
  for (std::size_t i = 0; i < test.strain.size(); ++i)
    if (counts(test, i)) block.measured.push_back(test.stress[i]);
  const double largest = std::ranges::max(block.measured);
  block.deviation.assign(block.size(), test.noise.value_or(first_guess_of_noise * largest));
  block.noise_is_stated = test.noise.has_value();
  if (test.is_base) {
    const auto top = static_cast<std::size_t>(std::ranges::max_element(test.strain) - test.strain.begin());
    for (std::size_t i = 0; i <= top; ++i) block.idle += counts(test, i) ? 1 : 0;
  }
  block.curve = 0;
  block.predict = prediction_of(fit, test);
  return block;
}

/// `shift`, where there is one: the coordinate and what it is.
Block block_of(const Fit& fit, const ImpactMeasurement& impact, int runs, std::optional<std::size_t> shift,
               const Coordinate* of_shift) {
  Block block;
  if (shift) block.settle = settling_of(fit, impact, runs, *shift, of_shift->lowest, of_shift->highest);
  block.is_impact = true;
  block.shift = shift;
  for (const MeasuredFigure& figure : impact.figures) {
    block.measured.push_back(figure.value);
    block.deviation.push_back(figure.deviation);
  }
  if (impact.pulse) {
    block.curve = block.size();
    const std::vector<double>& measured = impact.pulse->deceleration;
    block.measured.insert(block.measured.end(), measured.begin(), measured.end());
    block.deviation.insert(block.deviation.end(), measured.size(), impact.pulse->deviation);
  }
  block.predict = prediction_of(fit, impact, runs, shift);
  return block;
}

/// The largest shift of a pulse, as a share of the time above half its peak: its trigger is inexact.
constexpr double max_shift = 0.25;

/// A coordinate of a measurement, from -`most` to `most`.
Coordinate nuisance(const std::string& key, const char* unit, double most) {
  Coordinate coordinate;
  coordinate.key = key;
  coordinate.unit = unit;
  coordinate.lowest = -most;
  coordinate.highest = most;
  coordinate.is_nuisance = true;
  return coordinate;
}

/// The base curve has to rise by this share of its mean rise, with a deviation that no data outweigh.
constexpr std::size_t places_of_rule = 100;
constexpr double min_rise = 0.01;
constexpr double deviation_of_rule = 1e-4;

/// The index of an unknown of the law, and a function that sets it in a case.
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

Material material_of(ImpactCase base, const std::vector<LawSetter>& setters, std::span<const double> values) {
  for (const LawSetter& setter : setters) setter.set(base, values[setter.place]);
  return std::move(base.pad.material);
}

struct TestPath {
  laboratory::StrainHistory history;
  /// The number of pieces that lead to each point of the test; 0 for the start, at stress 0.
  std::vector<std::size_t> pieces_to;
};

/// A path straight through the points, with strains below 0 as 0. If the first strain is above 0, it leads
/// there at the mean rate of the test.
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

/// A block that keeps the base curve of a foam rising; none for a law whose curves are not formulas.
std::optional<Block> rule_of_rising(const Fit& fit) {
  const FoamCurves* const curves = foam_curves(fit.base.pad.material.law);
  if (curves == nullptr || std::holds_alternative<TableCurve>(curves->base)) return std::nullopt;
  Block block;
  block.is_rule = true;
  block.measured.assign(places_of_rule, 0);
  block.deviation.assign(places_of_rule, deviation_of_rule);
  block.predict = [base = fit.base, setters = law_setters(fit)](std::span<const double> values,
                                                                std::span<double> predicted) {
    const Material material = material_of(base, setters, values);
    std::visit(
        [&]<class Form>(const Form& form) {
          if constexpr (!std::is_same_v<Form, TableCurve>) {
            const auto count = static_cast<double>(predicted.size());
            const double mean_rise = form.stress(form.highest_strain) / count;
            double before = 0;
            for (std::size_t i = 0; i < predicted.size(); ++i) {
              const double stress = form.stress(form.highest_strain * static_cast<double>(i + 1) / count);
              predicted[i] = std::max(min_rise - (stress - before) / mean_rise, 0.0);
              before = stress;
            }
          }
        },
        foam_curves(material.law)->base);
    return true;
  };
  return block;
}

}  // namespace

std::size_t Problem::points() const {
  std::size_t points = 0;
  for (const Block& block : blocks) points += block.is_rule ? 0 : block.size();
  return points;
}

std::size_t Problem::idle() const {
  std::size_t count = 0;
  for (const Block& block : blocks) count += block.idle;
  return count;
}

std::size_t Problem::priors() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      coordinates, [](const Coordinate& coordinate) { return coordinate.prior.has_value(); }));
}

std::size_t Problem::residuals() const {
  return priors() + (blocks.empty() ? 0 : blocks.back().first + blocks.back().size());
}

std::vector<double> Problem::values(std::span<const double> x) const {
  std::vector<double> values(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) values[i] = coordinates[i].value(x[i]);
  return values;
}

std::vector<bool> Problem::shifts() const {
  std::vector<bool> are(coordinates.size());
  for (const Block& block : blocks)
    if (block.shift) are[*block.shift] = true;
  return are;
}

bool Problem::evaluate(std::span<const double> x, std::span<double> residuals) const {
  std::vector<double> at(x.begin(), x.end());
  return settle(at, std::vector<bool>(x.size(), true), residuals);
}

bool Problem::settle(std::span<double> x, const std::vector<bool>& held, std::span<double> residuals) const {
  std::vector<double> at = values(x);
  std::atomic<bool> is_sound = true;
  const auto fill = [&](const Block& block) {
    const std::span<double> own = residuals.subspan(block.first, block.size());
    const bool moves = block.shift && !held[*block.shift];
    // A block changes no value but its own shift, which no other reads.
    if (!is_sound || !(moves ? block.settle(at, own) : block.predict(at, own))) {
      is_sound = false;
      return;
    }
    if (moves) x[*block.shift] = std::clamp(coordinates[*block.shift].place(at[*block.shift]), 0.0, 1.0);
    const double offset = block.offset ? at[*block.offset] : 0;
    for (std::size_t i = 0; i < own.size(); ++i) {
      own[i] = (own[i] + offset - block.measured[i]) / block.deviation[i];
      if (!std::isfinite(own[i])) is_sound = false;
    }
  };
  if (std::ranges::count_if(blocks, &Block::is_impact) > 1)
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) { fill(blocks[i]); });
  else
    std::ranges::for_each(blocks, fill);
  std::size_t next = residuals.size() - priors();
  for (std::size_t i = 0; i < coordinates.size(); ++i)
    if (const auto& prior = coordinates[i].prior)
      residuals[next++] = (at[i] - prior->mean) / prior->deviation;
  return is_sound;
}

std::size_t coordinate_count(const Fit& fit) {
  std::size_t count = fit.unknowns.size();
  for (const MaterialMeasurement& test : fit.tests) count += !test.is_held_out && test.has_offset ? 1 : 0;
  for (const ImpactMeasurement& impact : fit.impacts) count += !impact.is_held_out && impact.pulse ? 1 : 0;
  return count;
}

Problem problem_of(const Fit& fit, int runs) {
  Problem problem;
  for (const Unknown& unknown : fit.unknowns)
    problem.coordinates.push_back({unknown.key, unknown.unit, unknown.lowest, unknown.highest, unknown.start,
                                   unknown.is_logarithmic, false, unknown.prior});
  const auto add = [&](Block block) {
    block.first = problem.residuals() - problem.priors();
    problem.blocks.push_back(std::move(block));
  };
  for (std::size_t i = 0; i < fit.tests.size(); ++i) {
    if (fit.tests[i].is_held_out) continue;
    Block block = block_of(fit, fit.tests[i]);
    if (fit.tests[i].has_offset) {
      block.offset = problem.coordinates.size();
      problem.coordinates.push_back(
          nuisance(fmt::format("tests[{}].offset", i + 1), "Pa", std::ranges::max(block.measured) / 2));
    }
    add(std::move(block));
  }
  problem.derivative_step = step_with_tests;
  for (std::size_t i = 0; i < fit.impacts.size(); ++i) {
    const ImpactMeasurement& impact = fit.impacts[i];
    if (impact.is_held_out) continue;
    problem.derivative_step = step_with_impacts;
    std::optional<std::size_t> shift;
    if (impact.pulse) {
      shift = problem.coordinates.size();
      problem.coordinates.push_back(nuisance(fmt::format("impacts[{}].pulse.shift", i + 1), "s",
                                             max_shift * impact.pulse->half_peak_width));
    }
    add(block_of(fit, impact, runs, shift, shift ? &problem.coordinates.back() : nullptr));
  }
  if (auto rule = rule_of_rising(fit)) add(*std::move(rule));
  return problem;
}

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

Material material_with(const Fit& fit, std::span<const double> values) {
  return material_of(fit.base, law_setters(fit), values);
}

Predict prediction_of(const Fit& fit, const MaterialMeasurement& test) {
  std::vector<std::size_t> pieces;
  TestPath path = path_of(test);
  for (std::size_t i = 0; i < test.strain.size(); ++i)
    if (counts(test, i)) pieces.push_back(path.pieces_to[i]);
  using Memos = tbb::enumerable_thread_specific<FoamMemo>;
  return [base = fit.base, setters = law_setters(fit), history = std::move(path.history),
          pieces = std::move(pieces), temperature = test.temperature,
          memos = std::make_shared<Memos>()](std::span<const double> values, std::span<double> predicted) {
    const Material material = material_of(base, setters, values);
    const PadLaw& law = material.law;
    // A foam's numbers are within their bounds, and rule_of_rising() sees to its curve.
    if (!std::holds_alternative<Foam>(law) && !violations(law).empty()) return false;
    const std::vector<double> stress = laboratory::stress_at_ends(law, history, &memos->local());
    const double factor = stress_factor({.scale = 1, .density = {}, .temperature = temperature}, material);
    for (std::size_t i = 0; i < pieces.size(); ++i)
      predicted[i] = pieces[i] == 0 ? 0 : factor * stress[pieces[i] - 1];
    return true;
  };
}

}  // namespace dashpad::fit
