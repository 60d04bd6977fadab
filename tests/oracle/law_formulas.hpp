#pragma once
/// The laws with memory, written anew for the oracles: nothing here comes from dashpad's own formulas, only
/// the parameters do.
///
/// A column obeys, with e its strain, r = de/dt its rate and e* its largest strain (all compression
/// positive),
///
///   d(stress)/dt = dG/de(e, r, e*) r + h(t, e) (G(e, r, e*) - stress)
///
/// While it loads, the stress over the shape A(e) = e^m (1-e)^-n is smooth, q = stress/A, and
///
///   d(stress)/dt = c(r) A'(e) r + A g,    dq/dt = (c - q) (A'/A) r + g
///
/// with c the limit of q where the column has just been touched, and g free of the singularity of A' at e =
/// 0. Stresses in Pa, times in s, rates in 1/s.

#include <cmath>

#include "dashpad/model/pad/linear_viscoelastic.hpp"
#include "dashpad/model/pad/nine_parameter.hpp"
#include "dashpad/model/pad/twenty_one_parameter.hpp"

namespace dashpad::oracle {

/// A strain in (0, 1) with what all formulas need of it.
struct StrainPoint {
  double strain = 0;
  double complement = 1;  ///< 1 - strain, without cancellation
  double log_strain = 0;
  double shape = 0;      ///< A
  double log_slope = 0;  ///< A'/A
};

inline StrainPoint strain_point(double strain, double complement, double log_strain, double m, double n) {
  StrainPoint point{strain, complement, log_strain, 0, m / strain + n / complement};
  point.shape = std::exp(m * log_strain - (n == 0 ? 0 : n * std::log(complement)));
  return point;
}
inline StrainPoint strain_point(double strain, double complement, double m, double n) {
  return strain_point(strain, complement, std::log(strain), m, n);
}

/// Value and strain derivative of an envelope.
struct Envelope {
  double value = 0;
  double slope = 0;
};

/// The factor E = (1 - D e*/e)/(1 - D) of laws 4 and 5 on an envelope that unloads.
inline Envelope unloaded(Envelope loading, double strain, double largest, double ratio) {
  const double share = ratio * largest / strain;
  const double factor = (1 - share) / (1 - ratio);
  return {loading.value * factor, loading.slope * factor + loading.value * share / (strain * (1 - ratio))};
}

/// D = (tau* |r|)^p; beyond 1 the law means nothing, and the limit is kept as the library documents it.
inline double residual_ratio_of(double rate, double scale_time, double exponent) {
  return std::fmin(std::pow(scale_time * std::fabs(rate), exponent), 1 - 1e-6);
}

/// Law 2: G = E_inf e + (E_0 - E_inf) tau r, h = 1/tau; A = e.
class LinearFormulas {
 public:
  using Law = LinearViscoelastic;
  struct Rate {
    double rate = 0;
  };
  struct Column {};

  explicit LinearFormulas(const Law& law) : law_(law) {}
  [[nodiscard]] double m() const { return 1; }
  [[nodiscard]] double n() const { return 0; }
  [[nodiscard]] Rate at_rate(double rate) const { return {rate}; }
  /// The same with the rate's logarithm at hand (loading; the rate may underflow).
  [[nodiscard]] Rate at_rate(double rate, double) const { return {rate}; }
  [[nodiscard]] Column at_strain(const StrainPoint&) const { return {}; }
  [[nodiscard]] double relaxation(double, double) const { return 1 / law_.relaxation_time; }
  [[nodiscard]] double edge(Rate) const { return law_.initial_modulus; }
  [[nodiscard]] double regular(const StrainPoint&, Column, Rate, double q, double h) const {
    return h * (law_.asymptotic_modulus - q);
  }
  [[nodiscard]] Envelope envelope(const StrainPoint& point, Column, Rate rate, double) const {
    const double viscous = (law_.initial_modulus - law_.asymptotic_modulus) * law_.relaxation_time;
    return {law_.asymptotic_modulus * point.strain + viscous * rate.rate, law_.asymptotic_modulus};
  }
  /// Part of d(stress)/dt that is not h (G - stress).
  [[nodiscard]] double envelope_rate(Envelope envelope, Rate rate) const {
    return envelope.slope * rate.rate;
  }
  /// stress/A of a column that was loaded at a constant rate from the start.
  [[nodiscard]] double started(const StrainPoint& point, Column, Rate rate) const {
    const double since = point.strain / (rate.rate * law_.relaxation_time);
    return law_.asymptotic_modulus -
           (law_.initial_modulus - law_.asymptotic_modulus) * std::expm1(-since) / since;
  }

 private:
  Law law_;
};

/// Law 4: G = A B [E], B = E_inf + E_r |r|^r', h = 1/tau.
class NineFormulas {
 public:
  using Law = NineParameter;
  struct Rate {
    double rate = 0;
    double modulus = 0;  ///< B
    double ratio = 0;    ///< D
  };
  struct Column {};

  explicit NineFormulas(const Law& law) : law_(law) {}
  [[nodiscard]] double m() const { return law_.contact_exponent; }
  [[nodiscard]] double n() const { return law_.compaction_exponent; }
  [[nodiscard]] Rate at_rate(double rate) const {
    Rate result{rate, law_.asymptotic_modulus, 0};
    if (rate != 0) result.modulus += law_.rate_modulus * std::pow(std::fabs(rate), law_.rate_exponent);
    if (rate < 0)
      result.ratio = residual_ratio_of(rate, law_.residual_strain_time, law_.residual_strain_exponent);
    return result;
  }
  [[nodiscard]] Rate at_rate(double rate, double log_rate) const {
    return {rate, law_.asymptotic_modulus + law_.rate_modulus * std::exp(law_.rate_exponent * log_rate), 0};
  }
  [[nodiscard]] Column at_strain(const StrainPoint&) const { return {}; }
  [[nodiscard]] double relaxation(double, double) const { return 1 / law_.relaxation_time; }
  [[nodiscard]] double edge(Rate rate) const { return rate.modulus; }
  [[nodiscard]] double regular(const StrainPoint&, Column, Rate rate, double q, double h) const {
    return h * (rate.modulus - q);
  }
  [[nodiscard]] Envelope envelope(const StrainPoint& point, Column, Rate rate, double largest) const {
    const double value = point.shape * rate.modulus;
    const Envelope loading{value, value * point.log_slope};
    return rate.rate < 0 ? unloaded(loading, point.strain, largest, rate.ratio) : loading;
  }
  [[nodiscard]] double envelope_rate(Envelope envelope, Rate rate) const {
    return envelope.slope * rate.rate;
  }
  [[nodiscard]] double started(const StrainPoint&, Column, Rate rate) const { return rate.modulus; }

 private:
  Law law_;
};

/// Law 5: G = (E_inf A + S |r|^k) [E], k = R exp(-e^U/V), S = S_r (exp(e^W/X) - exp(-e^Y/Z)),
/// h = a t^(a-1)/(b c^e) with t since first contact.
class TwentyOneFormulas {
 public:
  using Law = TwentyOneParameter;
  struct Rate {
    double rate = 0;
    double log_rate = 0;
    double ratio = 0;  ///< D
  };
  struct Column {
    double sensitive = 0;        ///< S
    double sensitive_slope = 0;  ///< dS/de
    double power = 0;            ///< k
    double power_slope = 0;      ///< dk/de
  };

  explicit TwentyOneFormulas(const Law& law) : law_(law), log_base_(std::log(law.relaxation_strain_base)) {}
  [[nodiscard]] double m() const { return law_.contact_exponent; }
  [[nodiscard]] double n() const { return law_.compaction_exponent; }
  [[nodiscard]] Rate at_rate(double rate) const {
    Rate result{rate, rate == 0 ? 0 : std::log(std::fabs(rate)), 0};
    if (rate < 0)
      result.ratio = residual_ratio_of(rate, law_.residual_strain_time, law_.residual_strain_exponent);
    return result;
  }
  [[nodiscard]] Rate at_rate(double rate, double log_rate) const { return {rate, log_rate, 0}; }
  [[nodiscard]] Column at_strain(const StrainPoint& point) const {
    const double u = std::exp(law_.rate_strain_exponent * point.log_strain) / law_.rate_strain_scale;
    const double w = std::exp(law_.growth_strain_exponent * point.log_strain) / law_.growth_strain_scale;
    const double y = std::exp(law_.onset_strain_exponent * point.log_strain) / law_.onset_strain_scale;
    const double growth = std::expm1(w);
    const double onset = std::expm1(-y);
    Column column;
    column.sensitive = law_.rate_stress * (growth - onset);
    column.sensitive_slope =
        law_.rate_stress *
        (law_.growth_strain_exponent * w * (growth + 1) + law_.onset_strain_exponent * y * (onset + 1)) /
        point.strain;
    column.power = law_.rate_exponent * std::exp(-u);
    column.power_slope = -column.power * law_.rate_strain_exponent * u / point.strain;
    return column;
  }
  [[nodiscard]] double relaxation(double time, double strain) const {
    return law_.relaxation_exponent / law_.relaxation_scale *
           std::exp((law_.relaxation_exponent - 1) * std::log(time) - log_base_ * strain);
  }
  [[nodiscard]] double edge(Rate) const { return law_.asymptotic_modulus; }
  [[nodiscard]] double regular(const StrainPoint& point, const Column& column, Rate rate, double q,
                               double h) const {
    const Envelope sensitive = rate_sensitive(column, rate);
    return (sensitive.slope * rate.rate + h * sensitive.value) / point.shape +
           h * (law_.asymptotic_modulus - q);
  }
  [[nodiscard]] Envelope envelope(const StrainPoint& point, const Column& column, Rate rate,
                                  double largest) const {
    const double lasting = law_.asymptotic_modulus * point.shape;
    const Envelope sensitive = rate_sensitive(column, rate);
    const Envelope loading{lasting + sensitive.value, lasting * point.log_slope + sensitive.slope};
    return rate.rate < 0 ? unloaded(loading, point.strain, largest, rate.ratio) : loading;
  }
  [[nodiscard]] double envelope_rate(Envelope envelope, Rate rate) const {
    return envelope.slope * rate.rate;
  }
  [[nodiscard]] double started(const StrainPoint& point, const Column& column, Rate rate) const {
    return law_.asymptotic_modulus + rate_sensitive(column, rate).value / point.shape;
  }

 private:
  [[nodiscard]] Envelope rate_sensitive(const Column& column, Rate rate) const {
    if (rate.rate == 0) return {};
    const double power = std::exp(column.power * rate.log_rate);
    return {column.sensitive * power,
            power * (column.sensitive_slope + column.sensitive * column.power_slope * rate.log_rate)};
  }

  Law law_;
  double log_base_;
};

}  // namespace dashpad::oracle
