#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <boost/numeric/odeint.hpp>

#include "laboratory/arc.hpp"
#include "laboratory/columns.hpp"
#include "laboratory/viscous_stress.hpp"
#include "model/pad/foam/foam_stress.hpp"
#include "model/root.hpp"

namespace dashpad::laboratory {
namespace {

constexpr double farthest_strain = 0.999;

/// Times of output after the loading, s, in geometric sequence up to the end of the hold.
std::vector<double> hold_times(double hold, int places) {
  constexpr double earliest_share = 1e-6;  // of the hold
  std::vector<double> times;
  for (int i = 1; i < places; ++i)
    times.push_back(hold * std::pow(earliest_share, 1 - (i - 1) / (places - 1.0)));
  times.push_back(hold);
  return times;
}

/// The loading of a test over a time, s.
ColumnTest loading_of(const PadLaw& law, const CreepTest& test, double duration, int places) {
  return drive(law, {{{duration, 0, test.loading_rate, 0}}}, places);
}

/// The test with a loading of that duration, s. `crept_at` returns the motion at times after it, fine or
/// coarse, `slope_at` the slope of the lasting stress at a strain, Pa. Nothing if the hold ends too early.
template <class Crept, class Slope>
std::optional<ColumnTest> with_hold(const PadLaw& law, const CreepTest& test, double duration, int places,
                                    Crept&& crept_at, Slope&& slope_at) {
  ColumnTest loading = loading_of(law, test, duration, places);
  const std::vector<double> times = hold_times(test.hold, places);
  const std::vector<Motion> held = crept_at(times, false), coarse = crept_at(times, true);
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

/// Lower end of the searches for a strain, below that of the least stress on the stiffest foam.
constexpr double min_part = 1e-30;

/// Creep of slow foam. Under a constant stress p and the branches obey linear equations, which steps with an
/// even change of p solve to second order. The error is estimated with steps of twice the length.
std::vector<Motion> crept(const ViscoelasticFoam& law, const MaxwellColumn& column, double stress,
                          double loaded_for, double strain, const std::vector<double>& times, int steps) {
  double p = column.lasting(strain);
  double first = column.branch(0, loaded_for).value;
  double second = column.branch(1, loaded_for).value;
  std::vector<Motion> result;
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

std::optional<ColumnTest> creep_of(const ViscoelasticFoam& law, const CreepTest& test, int places) {
  MaxwellColumn column(law);
  Arc loading;
  loading.duration = farthest_strain / test.loading_rate;
  loading.start = {0, test.loading_rate};
  loading.end = {farthest_strain, test.loading_rate};
  column.enter(loading);
  const auto missing = [&](double time) { return column.at(time).value - test.stress; };
  if (missing(loading.duration) < 0) return std::nullopt;
  const double loaded_for = root_between(missing, min_part * loading.duration, loading.duration);
  const double strain = loaded_for * test.loading_rate;
  const auto crept_at = [&](const std::vector<double>& times, bool is_coarse) {
    return crept(law, column, test.stress, loaded_for, strain, times, is_coarse ? 8 : 16);
  };
  return with_hold(law, test, loaded_for, places, crept_at, [&](double e) { return column.lasting(e) / e; });
}

/// Creep of foams by their curves: steps with an even change of the strain, each to the strain at which the
/// stress is kept. The error is estimated with steps of twice the length.
std::vector<Motion> crept(const FoamStress& law, double stress, double strain, double slip,
                          const std::vector<double>& times, int steps) {
  std::vector<Motion> result;
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
  const double strain = root_between(missing, min_part, farthest_strain);
  const auto crept_at = [&](const std::vector<double>& times, bool is_coarse) {
    return crept(column, test.stress, strain, slip_at(strain), times, is_coarse ? 4 : 8);
  };
  return with_hold(law, test, strain / test.loading_rate, places, crept_at,
                   [&](double e) { return column.at(strain_of(e)).base.stress / e; });
}

/// Relative tolerance of the integration.
constexpr double tolerance = 1e-12;

void check(const PadLaw& law, const CreepTest& test, int places) {
  Rules()
      .none_of(violations(law))
      .positive("stress", test.stress, "Pa")
      .positive("loading_rate", test.loading_rate, "1/s")
      .positive("hold", test.hold, "s")
      .require(places >= 2 && places <= 100000, "places", places, "must be from 2 to 100000")
      .done();
}

/// The creep of a law with memory under a constant stress.
template <HasMemory Law>
class Creep {
 public:
  Creep(const Law& law, double stress) : law_(law), power_(law.exponents()), stress_(stress) {}

  /// The strain rate that keeps the stress: the root of (dG/de) rate + h (G - stress), which grows with the
  /// rate; 0 once the lasting stress has reached the stress.
  [[nodiscard]] double rate(double time, double strain) {
    if (balance(time, strain, 0) >= 0) return last_rate_ = 0;
    const auto of_logarithm = [&](double log_rate) { return balance(time, strain, std::exp(log_rate)); };
    double low = std::log(last_rate_ > 0 ? last_rate_ : 1.0);
    double high = low;
    double stride = last_rate_ > 0 ? 0.01 : 1;
    for (; low > -700 && of_logarithm(low) >= 0; stride *= 2) low = std::max(low - stride, -700.0);
    if (low <= -700) return last_rate_ = 0;
    for (; high < 700 && of_logarithm(high) < 0; stride *= 2) high = std::min(high + stride, 700.0);
    return last_rate_ = std::exp(high > low ? root_between(of_logarithm, low, high) : low);
  }

  /// Whether the lasting stress has reached the stress, but for rounding.
  [[nodiscard]] bool settled(double strain) const {
    return stress_ - envelope(strain, law_.rate_part(0)) <= 1e-13 * stress_;
  }
  /// Slope of the lasting stress, Pa.
  [[nodiscard]] double lasting_slope(double strain) const {
    return envelope_slope(law_, power_, strain_of(strain), law_.rate_part(0), strain);
  }

 private:
  [[nodiscard]] double envelope(double at, typename Law::RatePart rate) const {
    return dashpad::envelope(law_, power_, strain_of(at), rate, at);
  }
  [[nodiscard]] double balance(double time, double strain, double rate) const {
    const auto part = law_.rate_part(rate);
    return envelope_slope(law_, power_, strain_of(strain), part, strain) * rate +
           relaxation_rate(law_, power_, time, strain) * (envelope(strain, part) - stress_);
  }

  Law law_;
  PowerShape power_;
  double stress_;
  double last_rate_ = 0;  ///< the guess for the next search
};

/// Creep by integration of the rate. The result ends where the strain passes 0.999.
template <HasMemory Law>
std::vector<Motion> crept(const Law& law, double stress, double loaded_at, double strain,
                          const std::vector<double>& times, double accuracy) {
  namespace odeint = boost::numeric::odeint;
  Creep creep(law, stress);
  const double loaded_strain = strain;
  const auto slope = [&](const double& e, double& rate, double t) {
    // A step that is too long and will be rejected may try impossible strains.
    rate = e < farthest_strain ? creep.rate(loaded_at + t, std::max(e, loaded_strain)) : 0;
  };
  auto stepper = odeint::make_controlled(accuracy, accuracy, odeint::runge_kutta_fehlberg78<double>());
  std::vector<Motion> result;
  double last = 0;
  for (const double time : times) {
    // The stretches are bounded, so that a settled strain is noticed before the steps become many.
    while (last < time && !creep.settled(strain)) {
      const double next = std::min(time, std::max(1.2 * last, times.front()));
      odeint::integrate_adaptive(stepper, slope, strain, last, next, (next - last) / 100);
      last = next;
    }
    if (strain >= farthest_strain) break;
    result.push_back({strain, creep.rate(loaded_at + time, strain)});
  }
  return result;
}

/// Law 2: E_0 de/dt = (stress - E_inf e) / tau.
std::vector<Motion> crept(const LinearViscoelastic& law, double stress, double, double strain,
                          const std::vector<double>& times, double) {
  const double lasting = stress / law.asymptotic_modulus;
  const double time_constant = law.relaxation_time * law.initial_modulus / law.asymptotic_modulus;
  std::vector<Motion> result;
  for (const double time : times) {
    const double left = (strain - lasting) * std::exp(-time / time_constant);
    if (lasting + left >= farthest_strain) break;
    result.push_back({lasting + left, -left / time_constant});
  }
  return result;
}

/// The strain at which the loading reaches the stress; nothing if it does not.
template <HasMemory Law>
std::optional<double> strain_at(const Law& law, const CreepTest& test) {
  const ViscousStress<Law> column(law);
  const auto missing = [&](double strain) {
    const Motion end{strain, test.loading_rate};
    const Stretch loading{0, strain / test.loading_rate, {0, test.loading_rate}, end, 0};
    return column.after(loading, {}, 0).value - test.stress;
  };
  if (missing(farthest_strain) < 0) return std::nullopt;
  const auto of_logarithm = [&](double log_strain) { return missing(std::exp(log_strain)); };
  if (of_logarithm(-700) >= 0) return std::nullopt;
  return std::exp(root_between(of_logarithm, -700, std::log(farthest_strain)));
}

template <HasMemory Law>
std::optional<ColumnTest> creep_of(const Law& law, const CreepTest& test, int places) {
  const std::optional<double> strain = strain_at(law, test);
  if (!strain) return std::nullopt;
  const double duration = *strain / test.loading_rate;
  const auto crept_at = [&](const std::vector<double>& times, bool is_coarse) {
    return crept(law, test.stress, duration, *strain, times, is_coarse ? 100 * tolerance : tolerance);
  };
  const Creep creep(law, test.stress);
  return with_hold(law, test, duration, places, crept_at, [&](double e) { return creep.lasting_slope(e); });
}

/// Laws 1 and 3 do not creep: the strain is that of the curve.
template <IsMemoryless Law>
std::optional<ColumnTest> creep_of(const Law& law, const CreepTest& test, int places) {
  const StressCurve curve = law.curve();
  const double first = curve.initial_stress;
  double strain = 0;
  if (test.stress > first) {
    const auto missing = [&](double e) { return (e > 0 ? curve.at(e) : first) - test.stress; };
    if (missing(farthest_strain) < 0) return std::nullopt;
    strain = root_between(missing, 0, farthest_strain);
  }
  ColumnTest result;
  if (strain > 0) {
    result = loading_of(law, test, strain / test.loading_rate, places);
  } else {
    Record record;
    record.add(0, {0, test.loading_rate}, {});
    record.add(0, {0, test.loading_rate}, {test.stress, 0});
    result = record.finished();
  }
  const double loaded_at = result.time.back();
  const double work = result.work.back();
  for (const double time : hold_times(test.hold, places)) {
    result.time.push_back(loaded_at + time);
    result.strain.push_back(strain);
    result.rate.push_back(0);
    result.stress.push_back(test.stress);
    result.work.push_back(work);
  }
  return result;
}

}  // namespace

std::optional<ColumnTest> creep(const PadLaw& law, const CreepTest& test, int places) {
  check(law, test, places);
  return std::visit([&](const auto& alternative) { return creep_of(alternative, test, places); }, law);
}

}  // namespace dashpad::laboratory
