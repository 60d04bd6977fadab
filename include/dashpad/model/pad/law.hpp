#pragma once
/// The closed set of pad laws, and the contract that each of them keeps.
///
/// The five laws of the report are an envelope G and a relaxation rate h (theory.md, Eq. 8):
///
///   d(stress)/dt = dG/dt | (rate and largest strain held) + h (G - stress)
///
/// so that over a step of constant strain rate (theory.md, Eq. 9)
///
///   stress_1 = G(e_1) + (stress_0 - G(e_0)) exp(-H),   H = integral of h over the step.
///
/// A law is a value without state, so a step can be tried, accepted or dropped. The struct holds its
/// parameters and what is the same for all columns of a step; its formulas, written once for vectors of
/// columns and for single numbers, follow below it (src/model/pad/formulas.hpp).

#include <concepts>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "dashpad/model/pad/crushable_foam.hpp"
#include "dashpad/model/pad/elastic.hpp"
#include "dashpad/model/pad/foam.hpp"
#include "dashpad/model/pad/linear_viscoelastic.hpp"
#include "dashpad/model/pad/nine_parameter.hpp"
#include "dashpad/model/pad/rigid_foam.hpp"
#include "dashpad/model/pad/twenty_one_parameter.hpp"
#include "dashpad/model/pad/viscoelastic_foam.hpp"
#include "dashpad/model/parameter.hpp"

namespace dashpad {

using PadLaw = std::variant<Elastic, LinearViscoelastic, RigidFoam, NineParameter, TwentyOneParameter, Foam,
                            CrushableFoam, ViscoelasticFoam>;

/// The requirements on every law.
template <class L>
concept IsPadLaw = requires {
  { L::name } -> std::convertible_to<const char*>;
  { L::memoryless } -> std::convertible_to<bool>;
  L::parameters;
};

/// A law whose stress equals its envelope at all times: its contact force is a closed form, without columns.
template <class L>
concept IsMemoryless = IsPadLaw<L> && L::memoryless && requires(const L law) {
  { law.curve() } -> std::same_as<StressCurve>;
  { L::recovers } -> std::convertible_to<bool>;
};

/// A law with memory: the stress of a column depends on its history. Stresses in Pa, rates in 1/s, times s.
template <class L>
concept HasMemory =
    IsPadLaw<L> && !L::memoryless && requires(const L law, double x, typename L::RatePart rate) {
  { law.exponents() } -> std::same_as<PowerExponents>;
  { law.rate_part(x) } -> std::same_as<typename L::RatePart>;
  /// The time part of the step from one time to another.
  { law.time_part(x, x) } -> std::same_as<typename L::TimePart>;
  /// h of a column at strain zero at a time, 1/s.
  { law.relaxation_rate(x) } -> std::same_as<double>;
  /// Limit of stress / A at the contact edge, where the strain has just begun to grow.
  { law.edge_ratio(rate) } -> std::same_as<double>;
};

/// A law given by curves of tests; all columns share one slip (src/model/pad/foam/foam_stress.hpp).
template <class L>
concept SharesSlip = IsPadLaw<L> && requires(const L law) {
  { law.curves } -> std::same_as<const FoamCurves&>;
};

/// Memory that a blow leaves in a pad for the next one (theory.md, Eqs. 46 to 48).
enum class BlowMemory {
  none,            ///< the pad recovers by its law, as if it had not been struck
  largest_strain,  ///< columns keep it, and load more softly up to it
  crater,          ///< the pad stays crushed
};

/// Tuple of Of<Law> over all laws that satisfy HasMemory.
template <template <class> class Of, class... Laws>
auto tuple_with_memory(const std::variant<Laws...>*) {
  return std::tuple_cat([]<class Law>(const Law*) {
    if constexpr (HasMemory<Law>)
      return std::tuple<Of<Law>>();
    else
      return std::tuple<>();
  }(static_cast<const Laws*>(nullptr))...);
}
template <template <class> class Of>
using WithMemory = decltype(tuple_with_memory<Of>(static_cast<const PadLaw*>(nullptr)));

/// All rules that the law's parameters break: each parameter's bounds, and rules between parameters.
std::vector<Violation> violations(const PadLaw& law);

/// The curves of tests that the law is made of (SharesSlip); null for any other law.
const FoamCurves* foam_curves(const PadLaw& law);
bool has_curves(const PadLaw& law);

BlowMemory blow_memory(const PadLaw& law);

/// Tested rates with a curve that falls by more than 0.1 % somewhere, 1/s; none for a law without curves.
std::vector<double> softening_rates(const PadLaw& law);

/// The law's name in case files.
std::string name_of(const PadLaw& law);

}  // namespace dashpad
