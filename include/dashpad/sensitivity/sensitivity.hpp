#pragma once
/// The derivative of every figure of an impact with respect to every number of its case.
///
/// Central differences at steps h, h/2 and h/4, all with one number of runs of the solver, at which figures
/// are smooth functions of the case (Options::fixed_runs), are extrapolated to h = 0 (Richardson). The error
/// is estimated from what the last halving changes and from the same difference with a run less.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/interval.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/result/result_quantity.hpp"

namespace dashpad::sensitivity {

/// How a figure goes through the value of the case.
enum class Course {
  smooth,
  kink,     ///< differently steep on its two sides; the derivative is the mean of both
  jump,     ///< it leaps near the value: there is no derivative
  unknown,  ///< the figure does not exist there, or no longer beside it
};
/// "smooth", "kink", "jump", "unknown".
const char* to_string(Course course);

/// d ln f / d ln p for a figure f and a number p: what 1 % of p does to f, in per cent.
struct Elasticity {
  double value = 0;  ///< NaN if unknown or a jump
  double error = 0;  ///< estimated, absolute
  Course course = Course::unknown;
};

/// A number of the case, and the steps that were possible.
struct Input {
  std::string key;
  std::string unit;  ///< SI
  double value = 0;
  bool is_one_sided = false;                  ///< its bound lies next to it on the other side
  std::vector<Elasticity> elasticities = {};  ///< of each figure
};

struct Answer {
  ImpactCase impact;
  std::vector<const ResultQuantity*> figures;  ///< those that the impact has, other than 0
  std::vector<double> values;                  ///< of the figures, SI
  std::vector<Input> inputs;                   ///< other than 0, in the order of case files
  std::vector<std::string> left_out;           ///< keys of numbers that are 0, or can move to no side
  std::optional<Intervals> intervals = {};     ///< by what is uncertain of foam and model
  std::vector<Flag> flags;                     ///< of the impact
  int runs = 0;                                ///< of the solver, for all differences
  std::uint64_t impacts = 0;
  double seconds = 0;
};

/// The derivative of a figure, SI: elasticity * f / p.
double derivative(const Answer& answer, std::size_t input, std::size_t figure);

/// Called now and then with the share of the work that is done.
using Progress = std::function<void(double share)>;

/// Answers for a valid case; of a series of blows for the last. `intervals`: also what is uncertain of the
/// foam. Throws as solve() does.
///
/// Example:
/// \code
/// const auto answer = dashpad::sensitivity::sensitivities(impact, options, false);
/// for (const dashpad::sensitivity::Input& input : answer.inputs)  // 1 % more of each number
///   std::printf("%s: %s %+.2f %%\n", input.key.c_str(), answer.figures.front()->key,
///               input.elasticities.front().value);
/// \endcode
Answer sensitivities(const ImpactCase& impact, const Options& options, bool intervals,
                     const Progress& progress = {});

}  // namespace dashpad::sensitivity
