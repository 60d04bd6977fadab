#pragma once
/// What several test programs need: sample laws and impacts, and the product step of a single column.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/io/case_file.hpp"

namespace dashpad::test {

inline const std::filesystem::path source_folder = DASHPAD_SOURCE_DIR;
inline const std::filesystem::path material_folder = source_folder / "materials";
inline const std::filesystem::path reference_file = source_folder / "data/reference-cases.csv";

/// Sound parameters of every law; laws 4 and 5 are those of the cards.
template <class Law>
Law sample_law() {
  if constexpr (std::is_same_v<Law, Elastic>) return {.modulus = 3e5};
  if constexpr (std::is_same_v<Law, LinearViscoelastic>)
    return {.asymptotic_modulus = 140e3, .initial_modulus = 420e3, .relaxation_time = 5e-3};
  if constexpr (std::is_same_v<Law, RigidFoam>)
    return {.crush_stress = 2e5, .crush_strain = 0.6, .second_stress = 4e5, .second_strain = 0.8};
  if constexpr (std::is_same_v<Law, NineParameter>)
    return std::get<Law>(read_material(material_folder / "ensolite-aac-9.toml").law);
  if constexpr (std::is_same_v<Law, TwentyOneParameter>)
    return std::get<Law>(read_material(material_folder / "ensolite-aac-21.toml").law);
}

/// A head-sized sphere on 3 cm of foam.
inline ImpactCase impact_on(const PadLaw& law, Support support = Support::rigid()) {
  ImpactCase impact;
  impact.title = name_of(law);
  impact.impactor = {.mass = 4, .radius = 0.08, .speed = 3};
  impact.pad.thickness = 0.03;
  impact.pad.material.name = "in line";
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

/// One column, driven through the product step of the law contract (dashpad/pad/law.hpp).
template <IsPadLaw Law>
class Column {
 public:
  /// From rest where it is touched, `touched` s after first contact, or from any loaded state.
  explicit Column(const Law& law, double touched = 0, double strain = 0, double stress = 0)
      : law_(law),
        power_(law.exponents()),
        time_(touched),
        strain_(strain),
        largest_(strain),
        stress_(stress) {}

  /// Strain goes evenly to `strain` (in [0, 1)) while time goes to `time`, s since first contact.
  void go(double strain, double time) {
    const auto rate = law_.rate_part((strain - strain_) / (time - time_));
    const auto step = law_.time_part(time_, time);
    const double end = law_.envelope(part(strain), rate, strain, largest_);
    const double start = law_.envelope(part(strain_), rate, strain_, largest_);
    stress_ = end + (stress_ - start) * law_.decay(step, strain_, strain, 1);
    strain_ = strain, time_ = time;
    largest_ = std::max(largest_, strain);
  }
  [[nodiscard]] double stress() const { return stress_; }

 private:
  [[nodiscard]] typename Law::StrainPart part(double strain) const {
    return law_.strain_part(strain_of(strain), power_.at(strain_of(strain)));
  }

  Law law_;
  PowerShape power_;
  double time_;
  double strain_;
  double largest_;
  double stress_;
};

}  // namespace dashpad::test
