#pragma once
/// What creep tests of all laws have in common: where the strain is looked at, and how the hold is written.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "dashpad/laboratory/column_test.hpp"
#include "laboratory/maxwell_column.hpp"
#include "model/pad/foam/foam_stress.hpp"
#include "model/root.hpp"

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

// Creep of foams by their curves and of slow foam: the strain at which a stress stays.

/// Of the strains that are searched: the least stress that can be stated on the stiffest foam.
inline constexpr double least_part = 1e-30;

/// Slow foam: under a constant stress p and the branches obey linear equations, which steps in which p goes
/// evenly solve to second order. The error is estimated by steps of twice the length.
inline std::vector<HoldPlace> crept(const ViscoelasticFoam& law, const MaxwellColumn& column, double stress,
                                    double loaded_for, double strain, const std::vector<double>& times,
                                    int steps) {
  double p = column.lasting(strain);
  double first = column.branch(0, loaded_for).value;
  double second = column.branch(1, loaded_for).value;
  std::vector<HoldPlace> result;
  double last = 0;
  for (const double time : times) {
    const double step = (time - last) / steps;
    const double before = strain;
    const auto kept = [&](double relaxation_time) { return std::exp(-step / relaxation_time); };
    const auto mean = [&](double relaxation_time) {
      return -std::expm1(-step / relaxation_time) * relaxation_time / step;
    };
    const double rise_first = law.first_share * mean(law.first_time);
    const double rise_second = law.second_share * mean(law.second_time);
    for (int i = 0; i < steps; ++i) {
      first *= kept(law.first_time);
      second *= kept(law.second_time);
      const double rise = (stress - p - first - second) / (1 + rise_first + rise_second);
      p += rise;
      first += rise_first * rise;
      second += rise_second * rise;
    }
    const auto missing = [&](double e) { return column.lasting(e) - p; };
    if (missing(farthest_strain) < 0) return result;
    if (missing(strain) < 0) strain = root_between(missing, strain, farthest_strain);
    result.push_back({strain, (strain - before) / (time - last)});
    last = time;
  }
  return result;
}

inline std::optional<ColumnTest> creep_of(const ViscoelasticFoam& law, const CreepTest& test, int places) {
  MaxwellColumn column(law);
  Arc loading;
  loading.duration = farthest_strain / test.loading_rate;
  loading.start = {0, test.loading_rate};
  loading.end = {farthest_strain, test.loading_rate};
  column.enter(loading);
  const auto missing = [&](double time) { return column.at(time).value - test.stress; };
  if (missing(loading.duration) < 0) return std::nullopt;
  const double loaded_for = root_between(missing, least_part * loading.duration, loading.duration);
  const double strain = loaded_for * test.loading_rate;
  ColumnTest loaded = drive(law, {{{loaded_for, 0, test.loading_rate, 0}}}, places);
  const std::vector<double> times = hold_times(test.hold, places);
  constexpr int steps = 16;
  const auto held = crept(law, column, test.stress, loaded_for, strain, times, steps);
  const auto coarse = crept(law, column, test.stress, loaded_for, strain, times, steps / 2);
  return with_hold(std::move(loaded), test, times, held, coarse,
                   [&](double e) { return column.lasting(e) / e; });
}

/// Foams: the strain at which the stress stays, step by step, in which it goes evenly. The error is estimated
/// by steps of twice the length.
inline std::vector<HoldPlace> crept(const FoamStress& law, double stress, double strain, double slip,
                                    const std::vector<double>& times, int steps) {
  std::vector<HoldPlace> result;
  double last = 0;
  for (const double time : times) {
    double rate = 0;
    for (int i = 0; i < steps; ++i) {
      const double step = (time - last) / steps;
      const auto missing = [&](double e) {
        return law.stress(strain_of(e), 0, law.slip().after(slip, (e - strain) / step, step)) - stress;
      };
      if (missing(farthest_strain) < 0) return result;
      const double next = missing(strain) >= 0 ? strain : root_between(missing, strain, farthest_strain);
      rate = (next - strain) / step;
      slip = law.slip().after(slip, rate, step);
      strain = next;
    }
    result.push_back({strain, rate});
    last = time;
  }
  return result;
}

template <SharesSlip Law>
std::optional<ColumnTest> creep_of(const Law& law, const CreepTest& test, int places) {
  const FoamStress column(law);
  const auto slip_at = [&](double strain) {
    return column.slip().after(0, test.loading_rate, strain / test.loading_rate);
  };
  const auto missing = [&](double strain) {
    return column.stress(strain_of(strain), 0, slip_at(strain)) - test.stress;
  };
  if (missing(farthest_strain) < 0) return std::nullopt;
  const double strain = root_between(missing, least_part, farthest_strain);
  ColumnTest loaded = drive(law, {{{strain / test.loading_rate, 0, test.loading_rate, 0}}}, places);
  const std::vector<double> times = hold_times(test.hold, places);
  constexpr int steps = 8;
  const auto held = crept(column, test.stress, strain, slip_at(strain), times, steps);
  const auto coarse = crept(column, test.stress, strain, slip_at(strain), times, steps / 2);
  return with_hold(std::move(loaded), test, times, held, coarse,
                   [&](double e) { return column.at(strain_of(e)).base.stress / e; });
}

}  // namespace dashpad::laboratory
