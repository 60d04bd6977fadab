#include "oracle/column_history.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

#include "oracle/law_formulas.hpp"

namespace dashpad::oracle {

namespace {

/// Integral of h between two times after the column was touched.
template <class Formulas, class Law>
double relaxed(const Formulas& formulas, const Law&, const StrainHistory&, double from, double to) {
  return (to - from) * formulas.relaxation(0, 0);
}
double relaxed(const TwentyOneFormulas&, const TwentyOneParameter& law, const StrainHistory& history,
               double from, double to) {
  // In u = t^a the integrand c^-e / b is not singular.
  const double a = law.relaxation_exponent;
  const auto integrand = [&](double u) {
    const double time = std::clamp(std::pow(u, 1 / a) - history.touched, from, to);
    return std::pow(law.relaxation_strain_base, -history.strain(time)) / law.relaxation_scale;
  };
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
      integrand, std::pow(history.touched + from, a), std::pow(history.touched + to, a), 8, 1e-13);
}

template <class Formulas>
double stress(const typename Formulas::Law& law, const StrainHistory& history, double time) {
  const Formulas formulas(law);
  const double largest = history.strain(history.turning);
  const auto source = [&](double at, bool unloading) {
    const double strain = history.strain(at);
    if (strain <= 0) return 0.0;
    double rate = history.rate(at);
    rate = unloading ? std::fmin(rate, -0.0) : std::fmax(rate, 0.0);
    const StrainPoint point = strain_point(strain, 1 - strain, formulas.m(), formulas.n());
    const auto column = formulas.at_strain(point);
    const auto terms = formulas.at_rate(rate);
    const Envelope envelope = formulas.envelope(point, column, terms, largest);
    const double h = formulas.relaxation(history.touched + at, strain);
    return std::exp(-relaxed(formulas, law, history, at, time)) *
           (formulas.envelope_rate(envelope, terms) + h * envelope.value);
  };
  boost::math::quadrature::tanh_sinh<double> quadrature(12);
  const double loaded = std::min(time, history.turning);
  double sum = quadrature.integrate([&](double at) { return source(at, false); }, 0.0, loaded, 1e-12);
  if (time > history.turning)
    sum += quadrature.integrate([&](double at) { return source(at, true); }, history.turning, time, 1e-12);
  return sum;
}

}  // namespace

double column_stress(const LinearViscoelastic& law, const StrainHistory& history, double time) {
  return stress<LinearFormulas>(law, history, time);
}
double column_stress(const NineParameter& law, const StrainHistory& history, double time) {
  return stress<NineFormulas>(law, history, time);
}
double column_stress(const TwentyOneParameter& law, const StrainHistory& history, double time) {
  return stress<TwentyOneFormulas>(law, history, time);
}

}  // namespace dashpad::oracle
