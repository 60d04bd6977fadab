#include "work_precision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "machine.hpp"

namespace dashpad::bench {

double deviation(const Outcome& outcome, const Outcome& reference) {
  const auto relative = [](double value, double expected) { return std::abs(value / expected - 1); };
  return std::max({relative(outcome.peak_force, reference.peak_force),
                   relative(outcome.peak_penetration, reference.peak_penetration),
                   relative(outcome.rebound_speed, reference.rebound_speed)});
}

double Measurement::quantile(double share) const {
  std::vector<double> sorted = times;
  std::sort(sorted.begin(), sorted.end());
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
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

void mark_fronts(std::vector<Measurement>& measurements) {
  for (Measurement& m : measurements)
    m.on_front = std::none_of(measurements.begin(), measurements.end(), [&](const Measurement& other) {
      return other.solver == m.solver && other.error <= m.error && other.median() <= m.median() &&
             (other.error < m.error || other.median() < m.median());
    });
}

FrontTime time_on_front(const std::vector<Measurement>& measurements, const std::string& solver,
                        double error) {
  std::vector<const Measurement*> front;
  for (const Measurement& m : measurements)
    if (m.solver == solver && m.on_front) front.push_back(&m);
  std::sort(front.begin(), front.end(), [](const auto* a, const auto* b) { return a->error < b->error; });
  if (front.empty()) return {std::numeric_limits<double>::quiet_NaN(), '='};
  if (error < front.front()->error) return {front.front()->median(), '>'};
  if (error > front.back()->error) return {front.back()->median(), '<'};
  for (std::size_t i = 1; i < front.size(); ++i) {
    const Measurement& fine = *front[i - 1];
    const Measurement& coarse = *front[i];
    if (error > coarse.error) continue;
    const double share = std::log(error / fine.error) / std::log(coarse.error / fine.error);
    return {fine.median() * std::pow(coarse.median() / fine.median(), share), '='};
  }
  return {front.back()->median(), '='};
}

}  // namespace dashpad::bench
