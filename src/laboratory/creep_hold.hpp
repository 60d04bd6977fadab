#pragma once
/// What creep tests of all laws have in common: where the strain is looked at, and how the hold is written.

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "dashpad/laboratory/column_test.hpp"

namespace dashpad::laboratory {

inline constexpr double farthest_strain = 0.999;

/// Times after the loading, geometric up to the end of the hold.
inline std::vector<double> hold_times(double hold, int places) {
  // Of the hold: the first place of output after the loading.
  constexpr double earliest_share = 1e-6;
  std::vector<double> times;
  for (int i = 1; i < places; ++i)
    times.push_back(hold * std::pow(earliest_share, 1 - (i - 1) / (places - 1.0)));
  times.push_back(hold);
  return times;
}

/// Root of an increasing function that is negative at `low` and not at `high`.
template <class F>
double root(F&& f, double low, double high) {
  const double f_high = f(high);
  if (f_high == 0) return high;
  std::uintmax_t most = 200;
  const auto [a, b] = boost::math::tools::toms748_solve(f, low, high, f(low), f_high,
                                                        boost::math::tools::eps_tolerance<double>(50), most);
  return a + (b - a) / 2;
}

struct HoldPlace {
  double strain = 0;
  double rate = 0;
};

/// The loading with the hold after it; `slope_at`: of the lasting stress at a strain, Pa. Nothing where the
/// hold ends too early.
template <class Slope>
std::optional<ColumnTest> with_hold(ColumnTest loading, const CreepTest& test,
                                    const std::vector<double>& times, const std::vector<HoldPlace>& held,
                                    const std::vector<HoldPlace>& coarse, Slope&& slope_at) {
  if (held.size() < times.size() || coarse.size() < times.size()) return std::nullopt;
  const double loaded_at = loading.time.back();
  const double work = loading.work.back();
  const double strain = loading.strain.back();
  for (std::size_t i = 0; i < times.size(); ++i) {
    loading.time.push_back(loaded_at + times[i]);
    loading.strain.push_back(held[i].strain);
    loading.rate.push_back(held[i].rate);
    loading.stress.push_back(test.stress);
    loading.work.push_back(work + test.stress * (held[i].strain - strain));
    const double error = std::abs(held[i].strain - coarse[i].strain) + 1e-15;
    loading.stress_error = std::max(loading.stress_error, error * slope_at(held[i].strain) / test.stress);
  }
  loading.largest_strain = *std::max_element(loading.strain.begin(), loading.strain.end());
  return loading;
}

}  // namespace dashpad::laboratory
