#include "work_precision.hpp"

#include <algorithm>
#include <cmath>

#include "machine.hpp"

namespace dashpad::bench {

double Errors::largest() const { return std::max({peak_force, peak_penetration, rebound_speed}); }

Errors deviation(const Outcome& outcome, const Outcome& reference) {
  const auto relative = [](double value, double expected) { return std::abs(value / expected - 1); };
  return {relative(outcome.peak_force, reference.peak_force),
          relative(outcome.peak_penetration, reference.peak_penetration),
          relative(outcome.rebound_speed, reference.rebound_speed)};
}

Errors worse(const Errors& a, const Errors& b) {
  return {std::max(a.peak_force, b.peak_force), std::max(a.peak_penetration, b.peak_penetration),
          std::max(a.rebound_speed, b.rebound_speed)};
}

double Measurement::quantile(double share) const {
  std::vector<double> sorted = times;
  std::sort(sorted.begin(), sorted.end());
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

bool judge(const Contender& contender, double speed_share, const References& references, Measurement& into) {
  const auto outcome = contender.solve(speed_share);
  if (!outcome) {
    ++into.failures;
    return false;
  }
  Outcome expected = references.at(speed_share).released;
  if (contender.ends_at_weight) expected.rebound_speed = references.at(speed_share).speed_at_weight;
  into.errors = worse(into.errors, deviation(*outcome, expected));
  return true;
}

bool is_beaten(const Measurement& m, const std::vector<Measurement>& all, double margin) {
  return std::any_of(all.begin(), all.end(), [&](const Measurement& other) {
    return other.solver == m.solver && other.errors.largest() <= m.errors.largest() &&
           margin * other.median() < m.median();
  });
}

double time_of(const Contender& contender) {
  constexpr double enough = 1e-3;
  const double start = thread_time();
  double spent = 0;
  int count = 0;
  do {
    contender.solve(1);
    ++count;
    spent = thread_time() - start;
  } while (spent < enough);
  return spent / count;
}

}  // namespace dashpad::bench
