#pragma once
/// Integrals by eight points of Gauss in each of a number of panels, for the second solvers.

#include <array>
#include <cstddef>

namespace dashpad::oracle {

/// `f` may return anything that can be added and multiplied by a number.
template <class Function>
auto gauss(double from, double to, int panels, const Function& f) {
  // Places on [-1, 1] and weights, of one half.
  constexpr std::array<double, 4> place{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                        0.9602898564975363};
  constexpr std::array<double, 4> weight{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                         0.1012285362903763};
  const double half = (to - from) / panels / 2;
  auto sum = 0 * f(from + half);
  for (int i = 0; i < panels; ++i) {
    const double middle = from + half * (2 * i + 1);
    for (std::size_t k = 0; k < place.size(); ++k)
      sum = sum + weight[k] * (f(middle - half * place[k]) + f(middle + half * place[k]));
  }
  return half * sum;
}

}  // namespace dashpad::oracle
