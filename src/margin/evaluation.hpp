#pragma once
/// The excess of an impact over its limits at a value of the key: of one impact, or of many draws of it.

#include <cstdint>
#include <vector>

#include "dashpad/impact/solve.hpp"
#include "dashpad/margin/margin.hpp"
#include "dashpad/study/study.hpp"

namespace dashpad::margin {

/// asinh((f - L) / |L|), with the other sign for a least value: at most zero where the limit is kept; smooth,
/// straight near the limit and never so steep as the figure itself. NaN for NaN.
double excess_of(const Limit& limit, double figure);

/// Of a pulse that was cut a figure can only grow: it tells something if it is beyond the limit already; else
/// NaN.
double known_part(const Limit& limit, double value, bool is_lower_bound);

/// The reservation about a spike that no limit sees, of a place that keeps its limits; null without one.
const Flag* spike_unseen_at(const Place& place);

/// The study of an impact of the question, with the key as its first factor at these values.
study::Study study_of(const Question& question, const Judged& judged, std::vector<double> values);

/// Impacts without scatter, one for each of the question's.
class Impacts {
 public:
  explicit Impacts(const Question& question);

  /// Solves the impacts at a value of the key; with `intervals` also what is uncertain of foam and model.
  Place look(double value, bool intervals);
  /// Impacts solved so far.
  [[nodiscard]] std::uint64_t solved() const { return solved_; }

 private:
  const Question& question_;
  std::vector<Limit> limits_;
  std::vector<study::Study> studies_;  ///< one for each impact, in which its key is set
  std::vector<study::Application> applications_;
  std::uint64_t solved_ = 0;
};

/// The excess of the worst limit in each draw, and what was drawn.
struct Draws {
  std::vector<double> excess;                ///< infinite for a draw without a value, which keeps no limit
  std::vector<std::vector<double>> figures;  ///< of each limit, by draw
  std::vector<std::vector<double>> factors;  ///< of the first impact, by draw
};

/// All draws at a value of the key, the same draws at every value. On all cores.
Draws draws_at(const Question& question, double value);

/// How much each drawn factor explains of the scatter of the worst excess at a value of the key, largest
/// first.
std::vector<Contributor> contributors_of(const Question& question, double value, const Draws& draws);

/// The quantiles of draws at the probability of the question.
Place place_of(const Question& question, double value, const Draws& draws);

}  // namespace dashpad::margin
