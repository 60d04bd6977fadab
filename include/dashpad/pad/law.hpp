#pragma once
/// The closed set of pad laws, and the contract that each of them keeps.
///
/// Every law is an envelope G and a relaxation rate h (theory.md, Eq. 6):
///
///   d(stress)/dt = dG/dt | (rate and largest strain held) + h (G - stress)
///
/// so that over a step of constant strain rate (theory.md, Eq. 7)
///
///   stress_1 = G(e_1) + (stress_0 - G(e_0)) exp(-H),   H = integral of h over the step.
///
/// A law is a value: it remembers nothing, so a step can be tried, accepted or dropped. The envelope is split
/// into a strain part (the costly powers, one set a column), a rate part and a time part (one a step).

#include <concepts>
#include <string>
#include <variant>
#include <vector>

#include "dashpad/pad/elastic.hpp"
#include "dashpad/pad/linear_viscoelastic.hpp"
#include "dashpad/pad/nine_parameter.hpp"
#include "dashpad/pad/rigid_foam.hpp"
#include "dashpad/pad/twenty_one_parameter.hpp"

namespace dashpad {

using PadLaw = std::variant<Elastic, LinearViscoelastic, RigidFoam, NineParameter, TwentyOneParameter>;

/// What every law offers. Stresses in Pa, rates in 1/s, times in s since first contact.
template <class L>
concept IsPadLaw = requires(const L law, Strain strain, PowerShape::Value power, double x,
                            typename L::StrainPart strain_part, typename L::RatePart rate_part,
                            typename L::TimePart time_part) {
  { L::name } -> std::convertible_to<const char*>;
  { L::memoryless } -> std::convertible_to<bool>;
  { law.exponents() } -> std::same_as<PowerExponents>;
  { law.strain_part(strain, power) } -> std::same_as<typename L::StrainPart>;
  { law.rate_part(x) } -> std::same_as<typename L::RatePart>;
  /// G at a strain, given the largest strain that the column has seen.
  { law.envelope(strain_part, rate_part, x, x) } -> std::same_as<double>;
  { law.time_part(x, x) } -> std::same_as<typename L::TimePart>;
  /// exp(-H) over a step in which the strain goes linearly from one value to another, and of which the column
  /// is in contact for a share.
  { law.decay(time_part, x, x, x) } -> std::same_as<double>;
};

/// A law whose stress is its envelope at once: it needs no columns, its contact force is a closed form.
template <class L>
concept IsMemoryless = IsPadLaw<L> && L::memoryless && requires(const L law) {
  { law.curve() } -> std::same_as<StressCurve>;
  { L::recovers } -> std::convertible_to<bool>;
};

/// A law with memory: the stress of a column depends on its history.
template <class L>
concept IsViscous =
    IsPadLaw<L> && !L::memoryless &&
    requires(const L law, Strain strain, const PowerShape& power, double x, typename L::RatePart rate) {
  { law.envelope_slope(strain, power, rate, x) } -> std::same_as<double>;
  { law.relaxation_rate(x, x) } -> std::same_as<double>;
  { law.edge_ratio(rate) } -> std::same_as<double>;
};

static_assert(IsMemoryless<Elastic> && IsMemoryless<RigidFoam>);
static_assert(IsViscous<LinearViscoelastic> && IsViscous<NineParameter> && IsViscous<TwentyOneParameter>);

/// A value that breaks a rule: which one, what it is (SI), and the rule in words.
struct Violation {
  std::string key;
  double value = 0;
  std::string rule;
};

/// All rules that the law's parameters break: each parameter's bounds, and rules between parameters.
std::vector<Violation> violations(const PadLaw& law);

/// The law's name in case files.
std::string name_of(const PadLaw& law);

}  // namespace dashpad
