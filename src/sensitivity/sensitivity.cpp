#include "dashpad/sensitivity/sensitivity.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>

#include <tbb/parallel_for.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/study/responses.hpp"
#include "dashpad/uncertainty/intervals.hpp"
#include "model/parameter_values.hpp"

namespace dashpad::sensitivity {

namespace {

/// The largest step, as a share of the number: large enough for the noise of the last digits of a figure,
/// small enough for the fourth order that extrapolation leaves.
constexpr double first_step = 1.2e-2;
/// Beyond the runs that the tolerance asks for; none for pads of layers, each impact of which takes a hundred
/// times as long.
constexpr int more_runs = 2;
constexpr int max_runs = 10;
/// Leaps of a figure below this share of the solver's tolerance are not told from its error.
constexpr double seen_of_tolerance = 0.25;

using Figures = std::vector<double>;

class Impacts {
 public:
  Impacts(const ImpactCase& impact, const Options& options, const std::vector<std::string>& names)
      : impact_(impact), options_(options), names_(names) {}

  /// The figures with a number at a multiple of its value; NaN for a case that breaks a rule.
  Figures at(const CaseQuantity& quantity, double multiple, int runs) {
    ImpactCase changed = impact_;
    quantity.set(changed, multiple * quantity.get(impact_));
    if (!violations(changed).empty()) return Figures(names_.size(), no_value);
    Options options = options_;
    options.fixed_runs = runs;
    ++solved_;
    return figures_of(dashpad::solve(changed, options));
  }
  Figures figures_of(const Solution& solution) {
    study::ResponseReader reader(names_);
    study::Outcome outcome;
    reader(solution, outcome);
    return outcome.values;
  }
  [[nodiscard]] std::uint64_t solved() const { return solved_; }

 private:
  const ImpactCase& impact_;
  const Options& options_;
  const std::vector<std::string>& names_;
  std::atomic<std::uint64_t> solved_ = 0;
};

/// The figures beside the value: [step][0: below, 1: above].
using Beside = std::array<std::array<Figures, 2>, 3>;

double step_of(std::size_t i) { return first_step / static_cast<double>(1u << i); }

/// The course by the difference of the slopes on both sides: it halves with the step where the figure is
/// smooth, stays at a kink, and doubles at a jump. What is within the solver's error is neither.
Course course_of(const std::array<double, 3>& bend, double tolerance) {
  const double last = std::abs(bend[2]), before = std::abs(bend[1]);
  if (!(last * step_of(2) > seen_of_tolerance * tolerance)) return Course::smooth;
  return last > 1.5 * before ? Course::jump : last > 0.75 * before ? Course::kink : Course::smooth;
}

/// Two-sided: differences of second order. `coarse` is the middle one with a run less.
Elasticity central(const std::array<double, 3>& slopes, const std::array<double, 3>& bend, double coarse,
                   double tolerance) {
  const double first = (4 * slopes[1] - slopes[0]) / 3, second = (4 * slopes[2] - slopes[1]) / 3;
  const Course course = course_of(bend, tolerance);
  if (course == Course::jump) return {no_value, no_value, course};
  // Where nothing but the solver's error bends, the bend is a part of the error.
  const double noise =
      std::abs(bend[2]) > 0.75 * std::abs(bend[1]) && course == Course::smooth ? std::abs(bend[2]) / 2 : 0;
  // The larger steps have the lesser noise, and what extrapolation leaves of them is of fourth order.
  return {first, std::abs(second - first) + std::abs(slopes[1] - coarse) + noise, course};
}

/// One-sided: differences of first order, extrapolated twice.
Elasticity one_sided(const std::array<double, 3>& slopes, double coarse) {
  const double first = 2 * slopes[1] - slopes[0], second = 2 * slopes[2] - slopes[1];
  const double value = (4 * second - first) / 3;
  return {value, std::abs(value - second) + std::abs(slopes[1] - coarse), Course::smooth};
}

bool all_finite(const std::array<double, 3>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

Elasticity elasticity_of(const Beside& beside, const std::array<Figures, 2>& coarse, const Figures& middle,
                         const Figures& coarse_middle, std::size_t figure, double tolerance) {
  std::array<double, 3> up{}, down{}, slopes{}, bend{};
  const double f = middle[figure];
  for (std::size_t i = 0; i < 3; ++i) {
    up[i] = (beside[i][1][figure] - f) / (step_of(i) * f);
    down[i] = (f - beside[i][0][figure]) / (step_of(i) * f);
    slopes[i] = (up[i] + down[i]) / 2;
    bend[i] = up[i] - down[i];
  }
  const double g = coarse_middle[figure];
  const double coarse_up = (coarse[1][figure] - g) / (step_of(1) * g);
  const double coarse_down = (g - coarse[0][figure]) / (step_of(1) * g);
  if (all_finite(slopes)) return central(slopes, bend, (coarse_up + coarse_down) / 2, tolerance);
  if (all_finite(up)) return one_sided(up, coarse_up);
  if (all_finite(down)) return one_sided(down, coarse_down);
  return {no_value, no_value, Course::unknown};
}

bool has_value(const Figures& figures) {
  return std::ranges::any_of(figures, [](double value) { return std::isfinite(value); });
}

}  // namespace

const char* to_string(Course course) {
  switch (course) {
    case Course::smooth: return "smooth";
    case Course::kink: return "kink";
    case Course::jump: return "jump";
    case Course::unknown: break;
  }
  return "unknown";
}

double derivative(const Answer& answer, std::size_t input, std::size_t figure) {
  return answer.inputs[input].elasticities[figure].value * answer.values[figure] / answer.inputs[input].value;
}

Answer sensitivities(const ImpactCase& impact, const Options& options, bool intervals,
                     const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  Answer answer{.impact = impact, .figures = {}, .values = {}, .inputs = {}, .left_out = {}, .flags = {}};
  Solution nominal = solve(impact, options);
  if (intervals) uncertainty::add_intervals(impact, options, nominal);
  answer.intervals = nominal.summary.intervals;
  answer.flags = flags(nominal.summary);
  answer.runs = std::min(nominal.summary.runs + (impact.pad.layers.empty() ? more_runs : 0), max_runs);

  std::vector<std::string> names;
  for (const ResultQuantity& kind : study::response_kinds()) names.emplace_back(kind.key);
  const Figures all = Impacts(impact, options, names).figures_of(nominal);
  std::vector<std::string> kept;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!std::isfinite(all[i]) || all[i] == 0) continue;
    answer.figures.push_back(&study::response_kinds()[i]);
    answer.values.push_back(all[i]);
    kept.push_back(names[i]);
  }
  Impacts impacts(impact, options, kept);
  std::vector<CaseQuantity> moved;
  for (const CaseQuantity& quantity : quantities_of(impact)) {
    const double value = quantity.get(impact);
    if (std::isnan(value)) continue;
    if (value == 0)
      answer.left_out.push_back(quantity.key);
    else
      moved.push_back(quantity);
  }
  if (moved.empty()) return answer;
  const Figures middle = impacts.at(moved.front(), 1, answer.runs);
  const Figures coarse_middle = impacts.at(moved.front(), 1, answer.runs - 1);

  std::vector<std::optional<Input>> inputs(moved.size());
  std::mutex reporting;
  std::size_t done = 0;
  tbb::parallel_for(std::size_t{0}, moved.size(), [&](std::size_t k) {
    const CaseQuantity& quantity = moved[k];
    Beside beside;
    std::array<Figures, 2> coarse;
    for (std::size_t i = 0; i < 3; ++i)
      for (const std::size_t side : {std::size_t{0}, std::size_t{1}})
        beside[i][side] = impacts.at(quantity, side == 1 ? 1 + step_of(i) : 1 - step_of(i), answer.runs);
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}})
      coarse[side] = impacts.at(quantity, side == 1 ? 1 + step_of(1) : 1 - step_of(1), answer.runs - 1);
    const bool has_below = has_value(beside[0][0]), has_above = has_value(beside[0][1]);
    if (has_below || has_above) {
      Input input{.key = quantity.key,
                  .unit = quantity.unit,
                  .value = quantity.get(impact),
                  .is_one_sided = !has_below || !has_above};
      for (std::size_t figure = 0; figure < kept.size(); ++figure)
        input.elasticities.push_back(
            elasticity_of(beside, coarse, middle, coarse_middle, figure, options.tolerance));
      inputs[k] = std::move(input);
    }
    const std::lock_guard lock(reporting);
    if (progress) progress(static_cast<double>(++done) / static_cast<double>(moved.size()));
  });
  for (std::size_t k = 0; k < moved.size(); ++k) {
    if (inputs[k])
      answer.inputs.push_back(*std::move(inputs[k]));
    else
      answer.left_out.push_back(moved[k].key);
  }
  answer.impacts =
      impacts.solved() + 1 + (answer.intervals ? static_cast<std::uint64_t>(answer.intervals->impacts) : 0);
  answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return answer;
}

}  // namespace dashpad::sensitivity
