#include "dashpad/quantities/portable_math.hpp"

// No fused multiplications, which only some processors have.
#ifndef HWY_COMPILE_ONLY_SCALAR
#define HWY_COMPILE_ONLY_SCALAR
#endif
#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "dashpad/quantities/constants.hpp"

namespace dashpad::portable {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using One = hn::CappedTag<double, 1>;

/// Up to it neither the exponential nor its parts leave the range of normal numbers.
constexpr double largest_exponent = 700;

/// 2^(j / 64).
constexpr std::array powers_of_two{1.0,
                                   1.0108892860517005,
                                   1.0218971486541166,
                                   1.0330248790212284,
                                   1.0442737824274138,
                                   1.0556451783605572,
                                   1.0671404006768237,
                                   1.0787607977571199,
                                   1.0905077326652577,
                                   1.102382583307841,
                                   1.1143867425958924,
                                   1.1265216186082418,
                                   1.1387886347566916,
                                   1.1511892299529827,
                                   1.1637248587775775,
                                   1.1763969916502812,
                                   1.189207115002721,
                                   1.202156731452703,
                                   1.215247359980469,
                                   1.22848053610687,
                                   1.241857812073484,
                                   1.255380757024691,
                                   1.2690509571917332,
                                   1.2828700160787783,
                                   1.2968395546510096,
                                   1.3109612115247644,
                                   1.3252366431597413,
                                   1.339667524053303,
                                   1.3542555469368927,
                                   1.3690024229745905,
                                   1.383909881963832,
                                   1.3989796725383112,
                                   1.4142135623730951,
                                   1.42961333839197,
                                   1.4451808069770467,
                                   1.460917794180647,
                                   1.4768261459394993,
                                   1.4929077282912648,
                                   1.5091644275934228,
                                   1.5255981507445384,
                                   1.5422108254079407,
                                   1.559004400237837,
                                   1.5759808451078865,
                                   1.593142151342267,
                                   1.6104903319492543,
                                   1.6280274218573478,
                                   1.645755478153965,
                                   1.6636765803267364,
                                   1.681792830507429,
                                   1.7001063537185235,
                                   1.718619298122478,
                                   1.7373338352737062,
                                   1.7562521603732995,
                                   1.7753764925265212,
                                   1.7947090750031072,
                                   1.8142521755003989,
                                   1.8340080864093424,
                                   1.8539791250833855,
                                   1.8741676341103,
                                   1.8945759815869656,
                                   1.9152065613971474,
                                   1.9360617934922943,
                                   1.9571441241754002,
                                   1.978456026387951};

double exp_beyond(double x) {
  if (std::isnan(x)) return x;
  if (std::abs(x) > 2 * largest_exponent) return x > 0 ? infinite : 0;
  const double root = exp(x / 2);
  return root * root;
}

}  // namespace

// e^x = 2^(k / 64) e^r with |r| <= ln 2 / 128. Highway's exponential takes twice the time.
double exp(double x) {
  if (!(std::abs(x) <= largest_exponent)) return exp_beyond(x);
  constexpr double parts_per_unit = 92.332482616893657;  // 64 / ln 2
  constexpr double part = 0.010830424667801708;          // ln 2 / 64, of so few bits that k times it is exact
  constexpr double rest_of_part = 2.8447437476627285e-11;
  constexpr double to_integer = 0x1.8p52;
  const double shifted = x * parts_per_unit + to_integer;
  const auto k = std::bit_cast<std::uint64_t>(shifted);
  const double number = shifted - to_integer;
  const double r = (x - number * part) - number * rest_of_part;
  const double square = r * r;
  const double less_one =
      r + square * ((0.5 + r * (1.0 / 6)) + square * ((1.0 / 24 + r * (1.0 / 120)) + square * (1.0 / 720)));
  const std::size_t place = k % powers_of_two.size();
  const double power =
      std::bit_cast<double>(std::bit_cast<std::uint64_t>(powers_of_two[place]) + ((k - place) << (52 - 6)));
  return power + power * less_one;
}

double expm1(double x) {
  return std::abs(x) < 0.5 ? hn::GetLane(hn::Expm1(One(), hn::Set(One(), x))) : exp(x) - 1;
}

double log(double x) {
  if (x > 0 && x < infinite) return hn::GetLane(hn::Log(One(), hn::Set(One(), x)));
  return x == 0 ? -infinite : x < 0 ? no_value : x;
}

double log1p(double x) {
  if (x > -1 && x < infinite) return hn::GetLane(hn::Log1p(One(), hn::Set(One(), x)));
  return log(1 + x);
}

double pow(double base, double exponent) {
  if (exponent == 0 || base == 1) return 1;
  if (exponent == 1) return base;
  return exp(exponent * log(base));
}

double sin(double x) { return hn::GetLane(hn::Sin(One(), hn::Set(One(), x))); }
double cos(double x) { return hn::GetLane(hn::Cos(One(), hn::Set(One(), x))); }
double tan(double x) { return sin(x) / cos(x); }
double asin(double x) { return hn::GetLane(hn::Asin(One(), hn::Set(One(), x))); }

namespace {

double scaled_erfc_by_sum(double x) {
  const double square = x * x;
  if (x < 1) {
    // exp(x^2) erf(x) by its series of positive terms.
    double term = 2 * std::numbers::inv_sqrtpi * x;
    double sum = term;
    for (int n = 1; term > 1e-17 * sum; ++n) {
      term *= 2 * square / (2 * n + 1);
      sum += term;
    }
    return exp(square) - sum;
  }
  // 2 x / pi int exp(-y^2) / (y^2 + x^2) dy over y > 0 by the trapezoidal rule; its error is the residue at a
  // pole, and below rounding beyond pi / h.
  constexpr double h = 0.5;
  constexpr std::array bells{0.77880078307140488,    0.36787944117144233,    0.10539922456186433,
                             0.018315638888734179,   0.0019304541362277093,  0.00012340980408667956,
                             4.7851173921290088e-06, 1.1253517471925912e-07, 1.6052280551856116e-09,
                             1.3887943864964021e-11, 7.2877240958198949e-14, 2.3195228302435691e-16};
  double sum = 1 / (2 * square);
  double y = 0;
  for (const double bell : bells) {
    y += h;
    sum += bell / (y * y + square);
  }
  const double error =
      x < std::numbers::pi / h ? 2 * exp(square) / (exp(2 * std::numbers::pi * x / h) - 1) : 0;
  return 2 * h * x / std::numbers::pi * sum - error;
}

/// Taylor series of w(x) = exp(x^2) erfc(x) about the middles of cells, by w' = 2 x w - 2 / sqrt(pi).
class ScaledErfcTable {
  static constexpr std::size_t cells = 128;
  static constexpr double per_unit = 16;

 public:
  static constexpr double end = cells / per_unit;

  ScaledErfcTable() {
    for (std::size_t i = 0; i < series_.size(); ++i) {
      const double x = middle(i);
      Series& c = series_[i];
      c[0] = scaled_erfc_by_sum(x);
      c[1] = 2 * (x * c[0] - std::numbers::inv_sqrtpi);
      for (std::size_t n = 1; n + 1 < c.size(); ++n) c[n + 1] = 2 * (x * c[n] + c[n - 1]) / double(n + 1);
    }
  }
  [[nodiscard]] double at(double x) const {
    const auto cell = static_cast<std::size_t>(x * per_unit);
    const double t = x - middle(cell);
    const Series& c = series_[cell];
    const double t2 = t * t, t4 = t2 * t2;
    return (c[0] + t * c[1] + t2 * (c[2] + t * c[3])) +
           t4 * (c[4] + t * c[5] + t2 * (c[6] + t * c[7] + t2 * c[8]));
  }

 private:
  static double middle(std::size_t cell) { return (double(cell) + 0.5) / per_unit; }
  using Series = std::array<double, 9>;
  std::array<Series, cells> series_;
};

}  // namespace

double scaled_erfc(double x) {
  static const ScaledErfcTable table;
  return x < ScaledErfcTable::end ? table.at(x) : scaled_erfc_by_sum(x);
}

}  // namespace dashpad::portable
