#include "dashpad/model/pad/power_shape.hpp"

#include <cmath>
#include <numbers>

#include "dashpad/quantities/portable_math.hpp"
#include "model/pad/column_law.hpp"

namespace dashpad {
namespace {

constexpr int series_terms = 80;  // 2^-80: below rounding on [0, 1/2]

/// Tables of interpolation at Chebyshev points, the same for all functions and the costliest part.
template <std::size_t N>
struct ChebyshevTable {
  std::array<double, N> point{};                      ///< from -1 to 1
  std::array<std::array<double, N>, N> polynomial{};  ///< [j][k]: T_j at point k
  std::array<std::array<double, N>, N> monomial{};    ///< [j][i]: factor of y^i in T_j

  ChebyshevTable() {
    for (std::size_t j = 0; j < N; ++j)
      for (std::size_t k = 0; k < N; ++k)
        polynomial[j][k] =
            portable::cos(std::numbers::pi * static_cast<double>(j) * (static_cast<double>(k) + 0.5) / N);
    point = polynomial[1];
    monomial[0][0] = monomial[1][1] = 1;
    for (std::size_t j = 2; j < N; ++j)
      for (std::size_t i = 0; i < N; ++i)
        monomial[j][i] = (i > 0 ? 2 * monomial[j - 1][i - 1] : 0) - monomial[j - 2][i];
  }
};

/// Monomial coefficients in y = 4x - 1 of the Chebyshev interpolant of f on 0 <= x <= 1/2.
template <std::size_t N, class F>
std::array<double, N> interpolate(F&& f) {
  static const ChebyshevTable<N> table;
  std::array<double, N> value{};
  for (std::size_t k = 0; k < N; ++k) value[k] = f((1 + table.point[k]) / 4);
  std::array<double, N> coefficient{};
  for (std::size_t j = 0; j < N; ++j) {
    double c = 0;
    for (std::size_t k = 0; k < N; ++k) c += value[k] * table.polynomial[j][k];
    c *= (j == 0 ? 1.0 : 2.0) / N;
    for (std::size_t i = 0; i <= j; ++i) coefficient[i] += c * table.monomial[j][i];
  }
  return coefficient;
}

}  // namespace

PowerShape::PowerShape(PowerExponents exponents) : exponents_(exponents) {
  const double m = exponents.m;
  const double n = exponents.n;
  near_contact_ = interpolate<terms>([m, n](double e) {
    double sum = 0;
    double c = 1;  // coefficient of (1 - e)^-n
    for (int k = 0; k < series_terms; ++k) {
      sum += c / (m + 1 + k);
      c *= (n + k) / (k + 1) * e;
    }
    return portable::pow(1 - e, n) * sum;
  });
  // The power q^(k+1-n) integrates to a logarithm where n = k + 1.
  near_bottom_ = interpolate<terms>([this, m, n](double q) {
    double sum = 0;
    double c = 1;   // coefficient of (1 - q)^m, times q^k
    double c0 = 1;  // the same without q^k
    for (int k = 0; k < series_terms; ++k) {
      if (std::abs(k + 1 - n) < 1e-8)
        log_weight_ = c0;
      else
        sum += c / (k + 1 - n);
      const double ratio = (k - m) / (k + 1);
      c *= ratio * q;
      c0 *= ratio;
    }
    return portable::pow(1 - q, -m) * sum;
  });
  const double shape = portable::pow(2, n - m);
  const double measure_at_half = shape / 2 * scalar::polynomial(near_contact_, 0.5);
  offset_ =
      measure_at_half + shape / 2 * scalar::polynomial(near_bottom_, 0.5) + log_weight_ * portable::log(0.5);
}

PowerShape::Value PowerShape::at(Strain strain) const {
  if (strain.value <= 0) return {};
  const scalar::Strains<double> e{strain.value, strain.complement};
  const auto at = scalar::shape_at(*this, e);
  return {at.shape, scalar::measure_at(*this, e, at), at.log_strain, at.log_complement};
}

double PowerShape::measure(Strain strain, const Value& value) const {
  return scalar::measure_at(*this, scalar::Strains<double>{strain.value, strain.complement},
                            scalar::Shape<double>{value.shape, value.log_strain, value.log_complement});
}

}  // namespace dashpad
