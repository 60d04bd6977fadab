#include "contact/sweep.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "contact/sweep.cpp"
#include <hwy/foreach_target.h>

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dashpad::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::ScalableTag<double>;
using V = hn::Vec<Tag>;
using M = hn::Mask<Tag>;

HWY_INLINE V set(double x) { return hn::Set(Tag(), x); }
HWY_INLINE V load(const double* from) { return hn::LoadU(Tag(), from); }
HWY_INLINE void store(V x, double* to) { hn::StoreU(x, Tag(), to); }
HWY_INLINE V exp(V x) { return hn::Exp(Tag(), x); }
HWY_INLINE V log(V x) { return hn::Log(Tag(), x); }

/// A column that the sphere does not reach still has a logarithm.
constexpr double least_strain = 1e-300;

struct Strains {
  V value;
  V complement;
};

/// In four sums that do not wait for each other.
template <std::size_t N>
HWY_INLINE V polynomial(const std::array<double, N>& c, V x) {
  static_assert(N % 4 == 0);
  const V y = hn::MulSub(set(4), x, set(1));
  const V y2 = hn::Mul(y, y);
  const V y4 = hn::Mul(y2, y2);
  V a = set(c[N - 4]), b = set(c[N - 3]), d = set(c[N - 2]), e = set(c[N - 1]);
  for (std::size_t i = N - 4; i > 0; i -= 4) {
    a = hn::MulAdd(a, y4, set(c[i - 4]));
    b = hn::MulAdd(b, y4, set(c[i - 3]));
    d = hn::MulAdd(d, y4, set(c[i - 2]));
    e = hn::MulAdd(e, y4, set(c[i - 1]));
  }
  return hn::MulAdd(hn::MulAdd(e, y, d), y2, hn::MulAdd(b, y, a));
}

struct Shape {
  V shape;
  V measure;
  V log_strain;
};
/// As PowerShape::at.
HWY_INLINE Shape shape_at(const PowerShape& power, Strains e) {
  Shape at;
  at.log_strain = log(e.value);
  const V log_complement = log(e.complement);
  const PowerExponents x = power.exponents();
  at.shape = exp(hn::NegMulAdd(set(x.n), log_complement, hn::Mul(set(x.m), at.log_strain)));
  const M low = hn::Le(e.value, set(0.5));
  const auto below = [&] {
    return hn::Mul(hn::Mul(e.value, at.shape), polynomial(power.near_contact(), e.value));
  };
  const auto above = [&] {
    const V algebraic =
        hn::Mul(hn::Mul(e.complement, at.shape), polynomial(power.near_bottom(), e.complement));
    return hn::Sub(set(power.offset()), hn::MulAdd(set(power.log_weight()), log_complement, algebraic));
  };
  if (hn::AllTrue(Tag(), low))
    at.measure = below();
  else if (hn::AllFalse(Tag(), low))
    at.measure = above();
  else
    at.measure = hn::IfThenElse(low, below(), above());
  return at;
}

/// E of Eq. 14, 1 on loading.
struct UnloadingFactor {
  bool unloading;
  V ratio;
  V scale;
  UnloadingFactor(bool is_unloading, double residual_ratio)
      : unloading(is_unloading), ratio(set(residual_ratio)), scale(set(1 / (1 - residual_ratio))) {}
  HWY_INLINE V of(V envelope, V strain, V largest) const {
    if (!unloading) return envelope;
    return hn::Mul(envelope, hn::Mul(scale, hn::Div(hn::NegMulAdd(largest, ratio, strain), strain)));
  }
};

/// What sweep_columns asks of a law: its strain part, its envelope by rate, its decay. `before` and the like
/// are strains.
struct LinearLanes {
  static constexpr std::size_t parts = 1;
  V modulus, viscous, duration;
  LinearLanes(const LinearViscoelastic& law, const PowerShape&, const LinearViscoelastic::RatePart& rate,
              const LinearViscoelastic::TimePart& time)
      : modulus(set(law.asymptotic_modulus)),
        viscous(set(rate.viscous_stress)),
        duration(set(-time.duration)) {}
  HWY_INLINE Shape strain_part(Strains e, V* part) const {
    part[0] = hn::Mul(modulus, e.value);
    return {e.value, hn::Mul(set(0.5), hn::Mul(e.value, e.value)), e.value};
  }
  HWY_INLINE V envelope(const V* part, V, V) const { return hn::Add(part[0], viscous); }
  HWY_INLINE V decay(V, V, V share) const { return exp(hn::Mul(duration, share)); }
};

struct NineLanes {
  static constexpr std::size_t parts = 1;
  const PowerShape& power;
  V modulus, decay_factor;
  UnloadingFactor factor;
  NineLanes(const NineParameter&, const PowerShape& shape, const NineParameter::RatePart& rate,
            const NineParameter::TimePart& time)
      : power(shape),
        modulus(set(rate.modulus)),
        decay_factor(set(time.decay)),
        factor(rate.unloading, rate.residual_ratio) {}
  HWY_INLINE Shape strain_part(Strains e, V* part) const {
    const Shape at = shape_at(power, e);
    part[0] = at.shape;
    return at;
  }
  HWY_INLINE V envelope(const V* part, V strain, V largest) const {
    return factor.of(hn::Mul(part[0], modulus), strain, largest);
  }
  HWY_INLINE V decay(V, V, V) const { return decay_factor; }
};

struct TwentyOneLanes {
  static constexpr std::size_t parts = 3;
  const TwentyOneParameter& law;
  const PowerShape& power;
  V log_rate, moving, scale, centre, log_base;
  UnloadingFactor factor;
  TwentyOneLanes(const TwentyOneParameter& of, const PowerShape& shape,
                 const TwentyOneParameter::RatePart& rate, const TwentyOneParameter::TimePart& time)
      : law(of),
        power(shape),
        log_rate(set(rate.log_rate)),
        moving(set(rate.still ? 0 : 1)),
        scale(set(-time.scale)),
        centre(set(time.centre)),
        log_base(set(-time.log_base)),
        factor(rate.unloading, rate.residual_ratio) {}
  HWY_INLINE Shape strain_part(Strains e, V* part) const {
    const Shape at = shape_at(power, e);
    const auto power_of = [&](double exponent) { return exp(hn::Mul(set(exponent), at.log_strain)); };
    const V u = power_of(law.rate_strain_exponent);
    const V w = power_of(law.growth_strain_exponent);
    const V y = power_of(law.onset_strain_exponent);
    part[0] = hn::Mul(set(law.asymptotic_modulus), at.shape);
    part[1] = hn::Mul(set(law.rate_stress), hn::Sub(exp(hn::Mul(set(1 / law.growth_strain_scale), w)),
                                                    exp(hn::Mul(set(-1 / law.onset_strain_scale), y))));
    part[2] = hn::Mul(set(law.rate_exponent), exp(hn::Mul(set(-1 / law.rate_strain_scale), u)));
    return at;
  }
  HWY_INLINE V envelope(const V* part, V strain, V largest) const {
    const V sensitive = hn::Mul(hn::Mul(moving, part[1]), exp(hn::Mul(part[2], log_rate)));
    return factor.of(hn::Add(part[0], sensitive), strain, largest);
  }
  HWY_INLINE V decay(V before, V after, V) const {
    const V strain = hn::MulAdd(centre, hn::Sub(after, before), before);
    return exp(hn::Mul(scale, exp(hn::Mul(log_base, strain))));
  }
};

template <class Lanes>
HWY_INLINE void sweep_columns(const Lanes& law, const SweepStep& step, const Columns& now,
                              const Columns& next) {
  const V per_thickness = set(1 / step.thickness);
  const V least = set(least_strain);
  const bool loading = step.after > step.before;
  const V per_advance = set(loading ? 1 / (step.after - step.before) : 0);
  for (std::size_t j = 0; j < step.count; j += hn::Lanes(Tag())) {
    const V depth = load(step.depth + j);
    const auto strain_at = [&](double penetration) {
      return hn::Max(hn::Mul(hn::Sub(set(penetration), depth), per_thickness), least);
    };
    const V strain = strain_at(step.after);
    const V complement = hn::Mul(hn::Add(set(step.thickness - step.after), depth), per_thickness);
    const V before = strain_at(step.before);
    const V largest = strain_at(step.largest);
    V part[Lanes::parts];
    V part_before[Lanes::parts];
    for (std::size_t k = 0; k < Lanes::parts; ++k) part_before[k] = load(now.part[k] + j);
    const Shape at = law.strain_part({strain, complement}, part);
    const V stress_before = load(now.stress + j);
    const V remainder = hn::Sub(stress_before, law.envelope(part_before, before, largest));
    V share = set(1);
    if (loading) share = hn::Min(share, hn::Mul(hn::Sub(set(step.after), depth), per_advance));
    const V envelope = law.envelope(part, strain, largest);
    V stress = hn::MulAdd(remainder, law.decay(before, strain, share), envelope);
    // A column in tension does not press again while its envelope is in tension.
    const V zero = hn::Zero(Tag());
    const M lets_go = hn::And(hn::Le(stress_before, zero), hn::Lt(envelope, zero));
    stress = hn::IfThenElse(lets_go, hn::Min(stress, zero), stress);
    store(stress, next.stress + j);
    for (std::size_t k = 0; k < Lanes::parts; ++k) store(part[k], next.part[k] + j);
    store(at.shape, next.shape + j);
    store(at.measure, next.measure + j);
    store(hn::Mul(hn::Div(stress, at.shape), hn::Sub(set(step.radius), depth)), next.ratio + j);
  }
}

/// Lanes j, j + 1, ... below `end`.
HWY_INLINE M below(std::size_t j, std::size_t end) { return hn::FirstN(Tag(), end - j); }

void sweep_linear(const LinearViscoelastic& law, const PowerShape& power,
                  const LinearViscoelastic::RatePart& rate, const LinearViscoelastic::TimePart& time,
                  const SweepStep& step, const Columns& now, const Columns& next) {
  sweep_columns(LinearLanes(law, power, rate, time), step, now, next);
}
void sweep_nine(const NineParameter& law, const PowerShape& power, const NineParameter::RatePart& rate,
                const NineParameter::TimePart& time, const SweepStep& step, const Columns& now,
                const Columns& next) {
  sweep_columns(NineLanes(law, power, rate, time), step, now, next);
}
void sweep_twenty_one(const TwentyOneParameter& law, const PowerShape& power,
                      const TwentyOneParameter::RatePart& rate, const TwentyOneParameter::TimePart& time,
                      const SweepStep& step, const Columns& now, const Columns& next) {
  sweep_columns(TwentyOneLanes(law, power, rate, time), step, now, next);
}

void replay_nine(const PowerShape& power, const LoadingStep* first, const LoadingStep* last,
                 const SweepStep& step, const Columns& columns) {
  const V per_thickness = set(1 / step.thickness);
  const PowerExponents x = power.exponents();
  for (std::size_t j = 0; j < step.count; j += hn::Lanes(Tag())) {
    const V depth = load(step.depth + j);
    const auto strains_at = [&](double penetration) {
      return Strains{hn::Max(hn::Mul(hn::Sub(set(penetration), depth), per_thickness), set(least_strain)),
                     hn::Mul(hn::Add(set(step.thickness - penetration), depth), per_thickness)};
    };
    V stress = hn::Zero(Tag());
    V shape = hn::Zero(Tag());
    for (const LoadingStep* now = first; now != last; ++now) {
      // The innermost column of these is the first to be touched.
      if (now->penetration <= step.depth[j]) continue;
      const V modulus = set(now->modulus);
      const Strains e = strains_at(now->penetration);
      const V touched = exp(hn::NegMulAdd(set(x.n), log(e.complement), hn::Mul(set(x.m), log(e.value))));
      const V shape_after = hn::IfThenElseZero(hn::Gt(e.value, set(least_strain)), touched);
      const V remainder = hn::NegMulAdd(modulus, shape, stress);
      stress = hn::MulAdd(remainder, set(now->decay), hn::Mul(modulus, shape_after));
      shape = shape_after;
    }
    const Shape at = shape_at(power, strains_at(step.after));
    store(stress, columns.stress + j);
    store(at.shape, columns.part[0] + j);
    store(at.shape, columns.shape + j);
    store(at.measure, columns.measure + j);
    store(hn::Mul(hn::Div(stress, at.shape), hn::Sub(set(step.radius), depth)), columns.ratio + j);
  }
}

double sum_cells(const Columns& columns, std::size_t cells) {
  V sum = hn::Zero(Tag());
  const V zero = hn::Zero(Tag());
  const V half = set(0.5);
  for (std::size_t j = 0; j < cells; j += hn::Lanes(Tag())) {
    const V g = load(columns.ratio + j);
    const V h = load(columns.ratio + j + 1);
    const V width = hn::Sub(load(columns.measure + j), load(columns.measure + j + 1));
    const V top = hn::Max(g, h);
    const V bottom = hn::Min(g, h);
    V mean = hn::Mul(half, hn::Add(g, h));
    const M pressing = hn::Ge(bottom, zero);
    if (!hn::AllTrue(Tag(), pressing)) {
      const V part = hn::Mul(half, hn::Div(hn::Mul(top, top), hn::Sub(top, bottom)));
      mean = hn::IfThenElse(pressing, mean, hn::IfThenElseZero(hn::Gt(top, zero), part));
    }
    sum = hn::Add(sum, hn::IfThenElseZero(below(j, cells), hn::Mul(mean, width)));
  }
  return hn::GetLane(hn::SumOfLanes(Tag(), sum));
}

double sum_held(const HeldRate& held, const SweepStep& step, const Columns& columns, double& edge) {
  const V zero = hn::Zero(Tag());
  const V still = set(held.still);
  const V per_thickness = set(1 / step.thickness);
  for (std::size_t j = 0; j < step.count; j += hn::Lanes(Tag())) {
    const V depth = load(step.depth + j);
    const V stress = load(columns.stress + j);
    const V gap = hn::Sub(hn::Mul(still, load(columns.part[0] + j)), stress);
    V rate = set(held.rate);
    if (held.log_base != 0) {
      const V strain = hn::Mul(hn::Sub(set(step.after), depth), per_thickness);
      rate = hn::Mul(rate, exp(hn::Mul(set(-held.log_base), strain)));
    }
    const V g =
        hn::Mul(hn::Mul(rate, hn::Div(gap, load(columns.shape + j))), hn::Sub(set(step.radius), depth));
    store(hn::IfThenElseZero(hn::Gt(stress, zero), g), columns.ratio + j);
  }
  V sum = zero;
  const std::size_t cells = step.count - 1;
  for (std::size_t j = 0; j < cells; j += hn::Lanes(Tag())) {
    const V mean = hn::Mul(set(0.5), hn::Add(load(columns.ratio + j), load(columns.ratio + j + 1)));
    const V width = hn::Sub(load(columns.measure + j), load(columns.measure + j + 1));
    sum = hn::Add(sum, hn::IfThenElseZero(below(j, cells), hn::Mul(mean, width)));
  }
  edge = columns.ratio[cells];
  return hn::GetLane(hn::SumOfLanes(Tag(), sum));
}

}  // namespace
}  // namespace dashpad::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dashpad {
namespace {

HWY_EXPORT(sweep_linear);
HWY_EXPORT(sweep_nine);
HWY_EXPORT(sweep_twenty_one);
HWY_EXPORT(replay_nine);
HWY_EXPORT(sum_cells);
HWY_EXPORT(sum_held);

}  // namespace

void sweep(const LinearViscoelastic& law, const PowerShape& power, const LinearViscoelastic::RatePart& rate,
           const LinearViscoelastic::TimePart& time, const SweepStep& step, const Columns& now,
           const Columns& next) {
  HWY_DYNAMIC_DISPATCH(sweep_linear)(law, power, rate, time, step, now, next);
}
void sweep(const NineParameter& law, const PowerShape& power, const NineParameter::RatePart& rate,
           const NineParameter::TimePart& time, const SweepStep& step, const Columns& now,
           const Columns& next) {
  HWY_DYNAMIC_DISPATCH(sweep_nine)(law, power, rate, time, step, now, next);
}
void sweep(const TwentyOneParameter& law, const PowerShape& power, const TwentyOneParameter::RatePart& rate,
           const TwentyOneParameter::TimePart& time, const SweepStep& step, const Columns& now,
           const Columns& next) {
  HWY_DYNAMIC_DISPATCH(sweep_twenty_one)(law, power, rate, time, step, now, next);
}
void replay(const NineParameter&, const PowerShape& power, const std::vector<LoadingStep>& steps,
            const SweepStep& step, const Columns& columns) {
  HWY_DYNAMIC_DISPATCH(replay_nine)(power, steps.data(), steps.data() + steps.size(), step, columns);
}
double sum_of_cells(const Columns& columns, std::size_t cells) {
  return HWY_DYNAMIC_DISPATCH(sum_cells)(columns, cells);
}
double sum_of_held(const HeldRate& held, const SweepStep& step, const Columns& columns, double& edge) {
  return HWY_DYNAMIC_DISPATCH(sum_held)(held, step, columns, edge);
}

}  // namespace dashpad
#endif
