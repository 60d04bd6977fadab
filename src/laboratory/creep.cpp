#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

#include "dashpad/laboratory/column_test.hpp"
#include "laboratory/creep_hold.hpp"
#include "laboratory/record.hpp"
#include "laboratory/rules.hpp"
#include "laboratory/viscous_stress.hpp"

namespace dashpad::laboratory {
namespace {

constexpr double tolerance = 1e-12;  ///< of the integration, relative

void check(const PadLaw& law, const CreepTest& test, int places) {
  Rules()
      .none_of(violations(law))
      .positive("stress", test.stress, "Pa")
      .positive("loading_rate", test.loading_rate, "1/s")
      .positive("hold", test.hold, "s")
      .require(places >= 2 && places <= 100000, "places", places, "must be 2 to 100000")
      .done();
}

/// How a law that has been loaded to its stress goes on under it.
template <HasMemory Law>
class Creep {
 public:
  Creep(const Law& law, double stress) : law_(law), power_(law.exponents()), stress_(stress) {}

  /// The rate at which the stress stands still: the root of (dG/de) rate + h (G - stress), which grows with
  /// the rate. 0 where the lasting stress has come up to the stress.
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

  /// The lasting stress has come up to the stress, as far as numbers tell.
  [[nodiscard]] bool settled(double strain) const {
    return stress_ - envelope(strain, law_.rate_part(0)) <= 1e-13 * stress_;
  }
  /// Of the lasting stress, Pa.
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
  double last_rate_ = 0;  ///< a good guess of the next
};

/// The strain at times after the loading; fewer where it passes 0.999.
template <HasMemory Law>
std::vector<HoldPlace> crept(const Law& law, double stress, double loaded_at, double strain,
                             const std::vector<double>& times, double accuracy) {
  namespace odeint = boost::numeric::odeint;
  Creep creep(law, stress);
  const double loaded_strain = strain;
  const auto slope = [&](const double& e, double& rate, double t) {
    // Too long a step, which will be rejected, may try strains that the column has passed or cannot have.
    rate = e < farthest_strain ? creep.rate(loaded_at + t, std::max(e, loaded_strain)) : 0;
  };
  auto stepper = odeint::make_controlled(accuracy, accuracy, odeint::runge_kutta_fehlberg78<double>());
  std::vector<HoldPlace> result;
  double last = 0;
  for (const double time : times) {
    // In bounded stretches, so that a strain which has settled is found before the steps become many.
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
std::vector<HoldPlace> crept(const LinearViscoelastic& law, double stress, double, double strain,
                             const std::vector<double>& times, double) {
  const double lasting = stress / law.asymptotic_modulus;
  const double time_constant = law.relaxation_time * law.initial_modulus / law.asymptotic_modulus;
  std::vector<HoldPlace> result;
  for (const double time : times) {
    const double left = (strain - lasting) * std::exp(-time / time_constant);
    if (lasting + left >= farthest_strain) break;
    result.push_back({lasting + left, -left / time_constant});
  }
  return result;
}

/// The loading, as far as the strain where the stress is reached; absent where it is not.
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
  ColumnTest loading = drive(law, {{{*strain / test.loading_rate, 0, test.loading_rate, 0}}}, places);
  const double loaded_at = loading.time.back();
  const std::vector<double> times = hold_times(test.hold, places);
  const auto held = crept(law, test.stress, loaded_at, *strain, times, tolerance);
  const auto coarse = crept(law, test.stress, loaded_at, *strain, times, 100 * tolerance);
  const Creep creep(law, test.stress);
  return with_hold(std::move(loading), test, times, held, coarse,
                   [&](double e) { return creep.lasting_slope(e); });
}

/// Laws 1 and 3: the strain is that of the curve.
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
    result = drive(law, {{{strain / test.loading_rate, 0, test.loading_rate, 0}}}, places);
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
