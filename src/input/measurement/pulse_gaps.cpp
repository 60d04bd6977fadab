#include "input/measurement/pulse_gaps.hpp"

#include <algorithm>
#include <cmath>

namespace dashpad::input {

namespace {

constexpr double rounding = 1e-6;  // of times that were written with few digits
constexpr double most_on_even_grid = 1.5 + rounding;
constexpr double evenness = 0.25 + rounding;
constexpr std::size_t few_gaps = 3;
constexpr double most_on_any_grid = 10;
constexpr double most_of_neighbours = 3;

double median_step(const std::vector<double>& times) {
  std::vector<double> steps(times.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = times[i + 1] - times[i];
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>((steps.size() - 1) / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

bool is_even_but_for_gaps(const std::vector<double>& times, double usual) {
  const std::size_t count = times.size() - 1;
  std::size_t longer = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double step = times[i + 1] - times[i];
    if (step > most_on_even_grid * usual)
      ++longer;
    else if (std::abs(step - usual) > evenness * usual)
      return false;
  }
  return 2 * longer < count && (longer <= few_gaps || 10 * longer <= count);
}

}  // namespace

PulseGaps find_gaps(const std::vector<double>& times) {
  if (times.size() < 4) return {};
  PulseGaps gaps{.usual_step = median_step(times)};
  const bool even = is_even_but_for_gaps(times, gaps.usual_step);
  const double longest = (even ? most_on_even_grid : most_on_any_grid) * gaps.usual_step;
  const std::size_t count = times.size() - 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double step = times[i + 1] - times[i];
    if (!(step > longest)) continue;
    const double before = i > 0 ? times[i] - times[i - 1] : 0;
    const double behind = i + 1 < count ? times[i + 2] - times[i + 1] : 0;
    if (even || step > most_of_neighbours * std::max(before, behind)) gaps.all.push_back({i, step});
  }
  return gaps;
}

}  // namespace dashpad::input
