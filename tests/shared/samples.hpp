#pragma once
/// What several test programs need: sample laws and impacts, and the product step of a single column.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/input/case_file.hpp"
#include "model/pad/column_law.hpp"

namespace dashpad::test {

inline const std::filesystem::path source_folder = DASHPAD_SOURCE_DIR;
inline const std::filesystem::path material_folder = source_folder / "materials";
inline const std::filesystem::path reference_file = source_folder / "data/reference-cases.csv";

template <class Variant>
struct TypesOf;
template <class... Alternatives>
struct TypesOf<std::variant<Alternatives...>> {
  using Type = testing::Types<Alternatives...>;
};
using AllLaws = TypesOf<PadLaw>::Type;
// Of the laws whose columns have one stress (Column below): all, those without jumps, those with a decay.
using LawsOfTheReport =
    testing::Types<Elastic, LinearViscoelastic, RigidFoam, NineParameter, TwentyOneParameter>;
using SmoothLaws = testing::Types<Elastic, LinearViscoelastic, NineParameter, TwentyOneParameter>;
using LawsWithMemory = testing::Types<LinearViscoelastic, NineParameter, TwentyOneParameter>;

/// The slowest test of a soft foam.
inline TableCurve soft_table() {
  return {{0.03, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8},
          {20e3, 40e3, 50e3, 60e3, 74e3, 97e3, 140e3, 230e3, 480e3}};
}

/// Sound parameters of every law; laws 4 and 5 are those of the cards.
template <class Law>
Law sample_law() {
  if constexpr (std::is_same_v<Law, Elastic>) return {.modulus = 3e5};
  if constexpr (std::is_same_v<Law, LinearViscoelastic>)
    return {.asymptotic_modulus = 140e3, .initial_modulus = 420e3, .relaxation_time = 5e-3};
  if constexpr (std::is_same_v<Law, RigidFoam>)
    return {.crush_stress = 2e5, .crush_strain = 0.6, .second_stress = 4e5, .second_strain = 0.8};
  if constexpr (std::is_same_v<Law, NineParameter>)
    return std::get<Law>(input::read_material(material_folder / "ensolite-aac-9.toml").value().law);
  if constexpr (std::is_same_v<Law, TwentyOneParameter>)
    return std::get<Law>(input::read_material(material_folder / "ensolite-aac-21.toml").value().law);
  if constexpr (std::is_same_v<Law, Foam>)
    return {.friction = 0.1,
            .unloading_factor = 0.3,
            .unloading_shape = 2,
            .recoil = 0.5,
            .curves = {.base = soft_table(),
                       .slowest_rate = 0.01,
                       .rate_effect = PowerRateEffect{0.08, 0.05, 300}},
            .unloading_curve = std::nullopt};
  if constexpr (std::is_same_v<Law, ViscoelasticFoam>)
    return {.first_modulus = 30e3,
            .first_exponent = 6,
            .second_modulus = 8e3,
            .second_exponent = -1,
            .first_share = 3,
            .first_time = 0.02,
            .second_share = 1,
            .second_time = 0.3};
  if constexpr (std::is_same_v<Law, CrushableFoam>)
    return {
        .unloading_modulus = 6e6,
        .curves = {.base = TableCurve{{0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8},
                                      {60e3, 110e3, 130e3, 160e3, 190e3, 230e3, 290e3, 390e3, 580e3, 1e6}},
                   .slowest_rate = 0.01,
                   .rate_effect = FactorRateEffect{{1, 100}, {1.1, 1.3}}}};
}

/// A head-sized sphere on 3 cm of foam.
inline ImpactCase impact_on(const PadLaw& law, Support support = Support::rigid()) {
  ImpactCase impact;
  impact.title = name_of(law);
  impact.impactor = {.mass = 4, .nose = Sphere{0.08}, .speed = 3};
  impact.pad.thickness = 0.03;
  impact.pad.material.name = foam_of_the_case;
  impact.pad.material.law = law;
  impact.support = std::move(support);
  return impact;
}

/// |value / expected - 1|; the difference itself where 0 is expected.
inline double relative_error(double value, double expected) {
  return std::abs(value - expected) / (expected == 0 ? 1 : std::abs(expected));
}

inline void expect_relative(double value, double expected, double tolerance, const std::string& what) {
  EXPECT_LE(relative_error(value, expected), tolerance)
      << what << ": " << value << " instead of " << expected;
}

/// G at a signed rate, 1/s.
template <IsPadLaw Law>
double envelope_at(const Law& law, double strain, double rate, double largest_strain) {
  if constexpr (IsMemoryless<Law>)
    return rate < 0 && !Law::recovers ? 0 : law.curve().at(strain);
  else
    return envelope(law, PowerShape(law.exponents()), strain_of(strain), law.rate_part(rate), largest_strain);
}

/// exp(-H) over a step that a column is in contact for all of.
template <HasMemory Law>
double decay_over(const Law& law, double time_from, double time_to, double strain_from, double strain_to) {
  const PowerShape power(law.exponents());
  return scalar::Formulas<Law>{law, power, {}, law.time_part(time_from, time_to)}.decay(strain_from,
                                                                                        strain_to, 1.0);
}

/// One column, driven through the product step of the law contract (dashpad/model/pad/law.hpp).
template <IsPadLaw Law>
class Column {
 public:
  /// From rest where it is touched, `touched` s after first contact, or from any loaded state.
  explicit Column(const Law& law, double touched = 0, double strain = 0, double stress = 0)
      : law_(law), time_(touched), strain_(strain), largest_(strain), stress_(stress) {}

  /// Strain goes evenly to `strain` (in [0, 1)) while time goes to `time`, s since first contact.
  void go(double strain, double time) {
    const double rate = (strain - strain_) / (time - time_);
    const double end = envelope_at(law_, strain, rate, largest_);
    if constexpr (IsMemoryless<Law>)
      stress_ = end;
    else
      stress_ = end + (stress_ - envelope_at(law_, strain_, rate, largest_)) *
                          decay_over(law_, time_, time, strain_, strain);
    strain_ = strain, time_ = time;
    largest_ = std::max(largest_, strain);
  }
  [[nodiscard]] double stress() const { return stress_; }

 private:
  Law law_;
  double time_;
  double strain_;
  double largest_;
  double stress_;
};

}  // namespace dashpad::test
