#include "oracle/closed_forms.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace dashpad::oracle {

namespace {

using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;

/// Integral of F/factor from 0 to y.
double energy_shape(double radius, double y) {
  const double nose = std::min(y, radius);
  const double shallow = radius * nose * nose * nose / 6 - nose * nose * nose * nose / 24;
  if (y <= radius) return shallow;
  return shallow + radius * radius * (y - radius) * (y + radius) / 4 -
         radius * radius * radius * (y - radius) / 6;
}

double nine_envelope(const NineParameter& law, double strain, double rate) {
  if (strain == 0) return 0;
  const double shape = std::pow(strain, law.contact_exponent) / std::pow(1 - strain, law.compaction_exponent);
  return shape * (law.asymptotic_modulus + law.rate_modulus * std::pow(rate, law.rate_exponent));
}

double twenty_one_envelope(const TwentyOneParameter& law, double strain, double rate) {
  if (strain == 0) return 0;
  const double shape = std::pow(strain, law.contact_exponent) / std::pow(1 - strain, law.compaction_exponent);
  const double power =
      law.rate_exponent * std::exp(-std::pow(strain, law.rate_strain_exponent) / law.rate_strain_scale);
  const double growth = std::exp(std::pow(strain, law.growth_strain_exponent) / law.growth_strain_scale);
  const double onset = std::exp(-std::pow(strain, law.onset_strain_exponent) / law.onset_strain_scale);
  return law.asymptotic_modulus * shape + law.rate_stress * std::pow(rate, power) * (growth - onset);
}

}  // namespace

ElasticBounce::ElasticBounce(double mass, double radius, double speed, double modulus, double thickness)
    : mass_(mass), radius_(radius), factor_(2 * std::numbers::pi * modulus / thickness) {
  const double wanted = mass * speed * speed / 2;
  const auto excess = [&](double y) { return energy(y) - wanted; };
  double high = radius;
  while (excess(high) < 0) high *= 2;
  std::uintmax_t calls = 200;
  const auto root = boost::math::tools::toms748_solve(excess, 0.0, high, -wanted, excess(high),
                                                      boost::math::tools::eps_tolerance<double>(52), calls);
  deepest_ = (root.first + root.second) / 2;
}

double ElasticBounce::force(double y) const {
  const double nose = std::min(y, radius_);
  return factor_ * nose * (radius_ * y - (radius_ + y) * nose / 2 + nose * nose / 3);
}

double ElasticBounce::energy(double y) const { return factor_ * energy_shape(radius_, y); }

double ElasticBounce::mean_force(double low, double high) const {
  // Simpson's rule is exact on each side of Y = R, where F is a polynomial.
  const auto simpson = [&](double a, double b) {
    return (b - a) * (force(a) + 4 * force((a + b) / 2) + force(b)) / 6;
  };
  if (low >= radius_ || high <= radius_) return simpson(low, high) / (high - low);
  return (simpson(low, radius_) + simpson(radius_, high)) / (high - low);
}

double ElasticBounce::contact_time() const {
  const auto integrand = [&](double w) {
    const double y = deepest_ * (1 - w * w);
    const double mean = w == 0 ? force(deepest_) : mean_force(y, deepest_);
    return 2 * deepest_ / std::sqrt(2 * deepest_ * mean / mass_);
  };
  const double corner = deepest_ > radius_ ? std::sqrt(1 - radius_ / deepest_) : 0;
  double half = Quadrature::integrate(integrand, corner, 1.0, 12, 1e-14);
  if (corner > 0) half += Quadrature::integrate(integrand, 0.0, corner, 12, 1e-14);
  return 2 * half;
}

double linear_column_at_constant_rate(const LinearViscoelastic& law, double rate, double time) {
  return law.asymptotic_modulus * rate * time - (law.initial_modulus - law.asymptotic_modulus) *
                                                    law.relaxation_time * rate *
                                                    std::expm1(-time / law.relaxation_time);
}

double linear_column_after_step(const LinearViscoelastic& law, double strain, double time) {
  return strain * (law.asymptotic_modulus +
                   (law.initial_modulus - law.asymptotic_modulus) * std::exp(-time / law.relaxation_time));
}

double nine_column_at_constant_rate(const NineParameter& law, ColumnStart start, double rate, double time) {
  const double strain = start.strain + rate * (time - start.time);
  return nine_envelope(law, strain, rate) + (start.stress - nine_envelope(law, start.strain, rate)) *
                                                std::exp((start.time - time) / law.relaxation_time);
}

double twenty_one_column_at_constant_rate(const TwentyOneParameter& law, ColumnStart start, double rate,
                                          double time) {
  const double a = law.relaxation_exponent;
  const auto strain_at = [&](double t) { return start.strain + rate * (t - start.time); };
  const double relaxed =
      Quadrature::integrate(
          [&](double u) { return std::pow(law.relaxation_strain_base, -strain_at(std::pow(u, 1 / a))); },
          std::pow(start.time, a), std::pow(time, a), 12, 1e-14) /
      law.relaxation_scale;
  return twenty_one_envelope(law, strain_at(time), rate) +
         (start.stress - twenty_one_envelope(law, start.strain, rate)) * std::exp(-relaxed);
}

}  // namespace dashpad::oracle
