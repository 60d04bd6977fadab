/// The formulas of the laws with memory, over a number type N: double, vector lanes, series of either.
///
/// Included as text, since code with vectors must be compiled once for every instruction set, each time in a
/// namespace of its own in which N has + - * /, exp, log, max, min, select and choose (model/pad/scalar.hpp,
/// model/pad/lanes.hpp); a Series of N, by the strain, has what strain_part and envelope need. The formulas
/// of each law are at the end of its header, included by means of DASHPAD_FORMULAS: the powers of the strain
/// that a column keeps (strain_part), G from them (envelope), and exp(-H) over a step (decay); and if they
/// are not the usual ones (measure_of and relaxation_of below), the measure w (measure) and the factor of h
/// at strain zero (relaxation). Stresses in Pa.
///
/// Strains must be at least min_strain.

#define DASHPAD_FORMULA [[nodiscard, gnu::always_inline]] inline

/// A strain with 1 - strain, like dashpad::Strain.
template <class N>
struct Strains {
  N value;
  N complement;
};

/// A(e) (theory.md, Eq. 14) and the logarithms of strain and complement.
template <class N>
struct Shape {
  N shape;
  N log_strain;
  N log_complement;
};

/// Least strain, so that a column that the nose does not reach has a logarithm.
inline constexpr double min_strain = 1e-300;

template <class N>
DASHPAD_FORMULA Shape<N> shape_at(const PowerShape& power, Strains<N> e) {
  const PowerExponents x = power.exponents();
  const N log_strain = log(e.value);
  const N log_complement = log(e.complement);
  return {exp(x.m * log_strain - x.n * log_complement), log_strain, log_complement};
}

/// The first terms of a function of a change x of the strain: value + first x + second x^2.
template <class N>
struct Series {
  N value;
  N first;
  N second;

  Series() : Series(0.0) {}
  Series(double constant) : Series(N(constant), 0.0, 0.0) {}  // NOLINT(google-explicit-constructor)
  Series(N constant, N linear, N quadratic) : value(constant), first(linear), second(quadratic) {}

  DASHPAD_FORMULA friend Series operator+(const Series& a, const Series& b) {
    return {a.value + b.value, a.first + b.first, a.second + b.second};
  }
  DASHPAD_FORMULA friend Series operator-(const Series& a, const Series& b) {
    return {a.value - b.value, a.first - b.first, a.second - b.second};
  }
  DASHPAD_FORMULA friend Series operator*(double a, const Series& b) {
    return {a * b.value, a * b.first, a * b.second};
  }
  DASHPAD_FORMULA friend Series operator*(const Series& a, const Series& b) {
    return {a.value * b.value, a.first * b.value + a.value * b.first,
            a.second * b.value + a.first * b.first + a.value * b.second};
  }
  DASHPAD_FORMULA friend Series operator/(const Series& a, const Series& b) {
    const N ratio = a.value / b.value;
    const N linear = (a.first - ratio * b.first) / b.value;
    return {ratio, linear, (a.second - ratio * b.second - linear * b.first) / b.value};
  }
  DASHPAD_FORMULA friend Series exp(const Series& x) {
    const N power = exp(x.value);
    return {power, power * x.first, power * (x.second + 0.5 * (x.first * x.first))};
  }
  DASHPAD_FORMULA friend Series log(const Series& x) {
    const N linear = x.first / x.value;
    return {log(x.value), linear, x.second / x.value - 0.5 * (linear * linear)};
  }
};

/// A polynomial in y = 4x - 1, as four independent sums.
template <class N, std::size_t terms>
DASHPAD_FORMULA N polynomial(const std::array<double, terms>& c, N x) {
  static_assert(terms % 4 == 0);
  const N y = 4.0 * x - 1.0;
  const N y2 = y * y;
  const N y4 = y2 * y2;
  N a(c[terms - 4]), b(c[terms - 3]), d(c[terms - 2]), e(c[terms - 1]);
  for (std::size_t i = terms - 4; i > 0; i -= 4) {
    a = a * y4 + c[i - 4];
    b = b * y4 + c[i - 3];
    d = d * y4 + c[i - 2];
    e = e * y4 + c[i - 1];
  }
  return (e * y + d) * y2 + (b * y + a);
}

/// w(e) (theory.md, Eq. 19), by an expansion about strain zero up to a half, about full compression above.
template <class N>
DASHPAD_FORMULA N measure_at(const PowerShape& power, Strains<N> e, const Shape<N>& at) {
  const auto below = [&]() { return e.value * at.shape * polynomial(power.near_contact(), e.value); };
  const auto above = [&]() {
    return power.offset() - (power.log_weight() * at.log_complement +
                             e.complement * at.shape * polynomial(power.near_bottom(), e.complement));
  };
  return choose(e.value <= 0.5, below, above);
}

/// The stress on loading, or on unloading that times E (theory.md, Eq. 16).
template <class N, class RatePart>
DASHPAD_FORMULA N unloaded(N loading, const RatePart& rate, N strain, N largest) {
  if (!rate.unloading) return loading;
  const double ratio = rate.residual_ratio;
  return loading * (1 / (1 - ratio) * ((strain - ratio * largest) / strain));
}

/// Mean of max(x, 0) for x linear between g and h.
template <class N>
DASHPAD_FORMULA N positive_mean(N g, N h) {
  const N zero(0.0);
  const N top = max(g, h);
  const N bottom = min(g, h);
  const N mean = 0.5 * (g + h);
  const auto pressing = zero <= bottom;
  if (all(pressing)) return mean;
  return select(pressing, mean, select(zero < top, 0.5 * (top * top / (top - bottom)), zero));
}

template <class Law>
struct Formulas;

/// w of a law: its own formula if it has one, else that of its power shape.
template <class Law, class N>
DASHPAD_FORMULA N measure_of(const Formulas<Law>& formulas, Strains<N> e, const Shape<N>& at) {
  if constexpr (requires { formulas.measure(e, at); })
    return formulas.measure(e, at);
  else
    return measure_at(formulas.power, e, at);
}

/// Factor of h at strain zero: the law's own formula if it has one, else 1.
template <class Law, class N>
DASHPAD_FORMULA N relaxation_of(const Formulas<Law>& formulas, N strain) {
  if constexpr (requires { formulas.relaxation(strain); })
    return formulas.relaxation(strain);
  else
    return N(1.0);
}

/// Whether a law has a step of its own in place of Eq. 9 (step).
template <class Law, class N>
inline constexpr bool steps_itself = requires(const Formulas<Law>& formulas, N* part, N share) {
  formulas.step(share, part, part, share);
};

/// Whether a law keeps and steps the stresses of branches for each column (carry, relaxing).
template <class Law, class N>
inline constexpr bool carries_branches = requires(const Formulas<Law>& formulas, N* part, N share) {
  formulas.carry(part, part, share);
};

#define DASHPAD_FORMULAS
#include "dashpad/model/pad/linear_viscoelastic.hpp"
#include "dashpad/model/pad/nine_parameter.hpp"
#include "dashpad/model/pad/twenty_one_parameter.hpp"
#include "dashpad/model/pad/viscoelastic_foam.hpp"
#undef DASHPAD_FORMULAS
