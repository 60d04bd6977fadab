/// Lanes of a vector register as a number type (src/model/pad/formulas.hpp).
///
/// Included as text in a namespace of each instruction set, between HWY_BEFORE_NAMESPACE and
/// HWY_AFTER_NAMESPACE, after hwy/highway.h and hwy/contrib/math/math-inl.h.

namespace hn = hwy::HWY_NAMESPACE;
using LanesTag = hn::CappedTag<double, 4>;

struct Lanes {
  using Vector = hn::Vec<LanesTag>;
  using Mask = hn::Mask<LanesTag>;
  Vector v;

  HWY_INLINE Lanes() = default;
  HWY_INLINE Lanes(Vector x) : v(x) {}                       // NOLINT(google-explicit-constructor)
  HWY_INLINE Lanes(double x) : v(hn::Set(LanesTag(), x)) {}  // NOLINT(google-explicit-constructor)

  friend HWY_INLINE Lanes operator+(Lanes a, Lanes b) { return hn::Add(a.v, b.v); }
  friend HWY_INLINE Lanes operator-(Lanes a, Lanes b) { return hn::Sub(a.v, b.v); }
  friend HWY_INLINE Lanes operator*(Lanes a, Lanes b) { return hn::Mul(a.v, b.v); }
  friend HWY_INLINE Lanes operator/(Lanes a, Lanes b) { return hn::Div(a.v, b.v); }
  friend HWY_INLINE Mask operator<(Lanes a, Lanes b) { return hn::Lt(a.v, b.v); }
  friend HWY_INLINE Mask operator<=(Lanes a, Lanes b) { return hn::Le(a.v, b.v); }
  friend HWY_INLINE Lanes exp(Lanes x) { return hn::Exp(LanesTag(), x.v); }
  friend HWY_INLINE Lanes log(Lanes x) { return hn::Log(LanesTag(), x.v); }
  friend HWY_INLINE Lanes pow(Lanes x, double exponent) { return exp(exponent * log(x)); }
  friend HWY_INLINE Lanes sqrt(Lanes x) { return hn::Sqrt(x.v); }
  friend HWY_INLINE Lanes max(Lanes a, Lanes b) { return hn::Max(a.v, b.v); }
  friend HWY_INLINE Lanes min(Lanes a, Lanes b) { return hn::Min(a.v, b.v); }
};

HWY_INLINE Lanes select(Lanes::Mask where, Lanes yes, Lanes no) { return hn::IfThenElse(where, yes.v, no.v); }
HWY_INLINE bool all(Lanes::Mask where) { return hn::AllTrue(LanesTag(), where); }
HWY_INLINE bool none(Lanes::Mask where) { return hn::AllFalse(LanesTag(), where); }
HWY_INLINE Lanes::Mask both(Lanes::Mask a, Lanes::Mask b) { return hn::And(a, b); }

/// Evaluates only the alternatives that some lane needs.
template <class Yes, class No>
HWY_INLINE Lanes choose(Lanes::Mask where, Yes&& yes, No&& no) {
  if (all(where)) return yes();
  if (none(where)) return no();
  return select(where, yes(), no());
}

template <class N>
struct Register;
template <>
struct Register<Lanes> {
  static HWY_INLINE std::size_t size() { return hn::Lanes(LanesTag()); }
  static HWY_INLINE Lanes load(const double* from) { return hn::LoadU(LanesTag(), from); }
  static HWY_INLINE void store(Lanes x, double* to) { hn::StoreU(x.v, LanesTag(), to); }
  /// x in the first `count` lanes, 0 in the others.
  static HWY_INLINE Lanes first(std::size_t count, Lanes x) {
    return hn::IfThenElseZero(hn::FirstN(LanesTag(), count), x.v);
  }
};
