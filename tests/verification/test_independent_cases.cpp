/// Cases in which an independent solver found errors: true values with their uncertainty, in
/// tests/verification/cases/independent.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "dashpad/impact/solve.hpp"
#include "dashpad/input/case_file.hpp"
#include "result/summary_values.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

struct TrueFigure {
  std::string key;
  double value = 0, uncertainty = 0;
};

std::map<std::string, std::vector<TrueFigure>> true_figures() {
  std::ifstream file(source_folder / "tests/verification/cases/independent/truth.csv");
  std::map<std::string, std::vector<TrueFigure>> all;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#') || line.starts_with("case,")) continue;
    std::istringstream fields(line);
    std::string name;
    TrueFigure figure;
    std::getline(fields, name, ',');
    std::getline(fields, figure.key, ',');
    char comma = 0;
    fields >> figure.value >> comma >> figure.uncertainty;
    all[name].push_back(figure);
  }
  return all;
}

/// Each figure is within the tolerance, or its estimate covers it; the absorbed share is held to ten times
/// the tolerance (theory.md, What a tolerance means).
TEST(IndependentCases, FiguresAreTrue) {
  const auto all = true_figures();
  ASSERT_EQ(all.size(), 8U);
  for (const double tolerance : {1e-3, 1e-4}) {
    for (const auto& [name, figures] : all) {
      const input::CaseFile input =
          input::read_case(source_folder / "tests/verification/cases/independent" / (name + ".toml"),
                           source_folder / "materials")
              .value();
      const Summary summary = solve(input.impact, {.tolerance = tolerance}).summary;
      EXPECT_EQ(summary.status, Status::released) << name << ' ' << tolerance;
      for (const TrueFigure& figure : figures) {
        const auto quantities = summary_quantities();
        const auto quantity = std::ranges::find_if(quantities, [&](const SummaryQuantity& summary_quantity) {
          return summary_quantity.quantity->key == figure.key;
        });
        ASSERT_NE(quantity, quantities.end()) << figure.key;
        const EstimatedValue found = quantity->of(summary);
        ASSERT_FALSE(std::isnan(found.value)) << name << ' ' << figure.key;
        const double off = std::abs(found.value - figure.value) - figure.uncertainty;
        const double allowed = figure.key == "energy_absorbed_fraction"
                                   ? 10 * tolerance * std::max(figure.value, 0.05)
                                   : std::max(tolerance, found.error) * std::abs(figure.value);
        EXPECT_LE(off, allowed) << name << ' ' << figure.key << " at " << tolerance << ": " << found.value;
      }
    }
  }
}

/// What the crushed columns give back is known in closed form: its error fell no further than 1e-3.
TEST(IndependentCases, LinersOfEpsMeetTheDefaultTolerance) {
  ImpactCase liner =
      input::read_case(source_folder / "examples/helmet-on-anvil.toml", source_folder / "materials")
          .value()
          .impact;
  liner.backing = {};
  liner.support = Support::rigid();
  int missed = 0;
  for (int i = 0; i < 60; ++i) {
    liner.pad.thickness = 0.015 + 0.0005 * i;
    missed += solve(liner).summary.trustworthy() ? 0 : 1;
  }
  EXPECT_EQ(missed, 0);
}

TEST(IndependentCases, ARunThatDidNotLeaveHasNoRebound) {
  const Summary summary =
      solve(input::read_case(source_folder / "tests/verification/cases/left-and-came-back.toml",
                             source_folder / "materials")
                .value()
                .impact)
          .summary;
  ASSERT_EQ(summary.status, Status::bottomed_out);
  EXPECT_FALSE(summary.release);
  EXPECT_FALSE(summary.rebound_speed);
  EXPECT_FALSE(summary.restitution);
}

/// A panel that flies free in its gap brings slow foam back to the impactor: what its branches have left is
/// met again. (They held no number, and the two went through each other.)
TEST(IndependentCases, SlowFoamIsMetAgainAsItWasLeft) {
  const ImpactCase impact =
      input::read_case(source_folder / "tests/verification/cases/slow-foam-met-again.toml",
                       source_folder / "materials")
          .value()
          .impact;
  const Summary fine = solve(impact, {.tolerance = 1e-6}).summary;
  ASSERT_EQ(fine.status, Status::released);
  EXPECT_GT(fine.contact_end->time, 0.05);  // the first contact ends at 0.014 s
  for (const double tolerance : {1e-3, 1e-4}) {
    const Summary summary = solve(impact, {.tolerance = tolerance}).summary;
    ASSERT_EQ(summary.status, Status::released) << tolerance;
    EXPECT_NEAR(*summary.rebound_speed / *fine.rebound_speed, 1, tolerance);
    EXPECT_NEAR(summary.contact_end->time / fine.contact_end->time, 1, tolerance);
    EXPECT_NEAR(summary.energy.residual / summary.energy.impact, 0, tolerance);
  }
}

TEST(IndependentCases, APadThatCreepsOnHasNoDepthOfItsOwn) {
  const Summary summary =
      solve(input::read_case(source_folder / "tests/verification/cases/still-sinking.toml",
                             source_folder / "materials")
                .value()
                .impact,
            {.tolerance = 1e-3})
          .summary;
  ASSERT_EQ(summary.status, Status::at_rest);
  EXPECT_TRUE(summary.still_sinking);
  EXPECT_LT(summary.peak_penetration, 0.8e-3);
  EXPECT_EQ(summary.errors.peak_penetration, std::numeric_limits<double>::infinity());
}

/// A panel of next to no mass is none; one that is just heavy enough to be resolved differs by no more than
/// its share of the mass.
TEST(IndependentCases, ALightPanelTendsToNone) {
  ImpactCase impact =
      input::read_case(source_folder / "examples/helmet-pad-10fps.toml", source_folder / "materials")
          .value()
          .impact;
  impact.support = Support::linear(3e5);
  const Summary none = solve(impact).summary;
  for (const double share : {1e-6, 4e-6, 1e-4}) {
    impact.backing.mass = share * impact.impactor.mass;
    const Summary light = solve(impact).summary;
    ASSERT_EQ(light.status, Status::released) << share;
    EXPECT_NEAR(*light.peak_force / *none.peak_force, 1, 2e-4 + share) << share;
    EXPECT_NEAR(*light.rebound_speed / *none.rebound_speed, 1, 2e-4 + share) << share;
    ASSERT_TRUE(light.support);
    EXPECT_NEAR(*light.support->peak_transmitted / *light.peak_force, 1, 1e-3) << share;
  }
}

Summary on_a_sphere(const PadLaw& law) {
  ImpactCase impact;
  impact.impactor = {.mass = 5, .nose = Sphere{0.1}, .speed = 3};
  impact.pad.thickness = 0.05;
  impact.pad.material.law = law;
  impact.support = Support::rigid();
  return solve(impact).summary;
}

/// theory.md, Eq. 11: with a relaxation time beyond all bounds the pad is elastic with its initial modulus,
/// with none with its asymptotic one.
TEST(IndependentCases, RelaxationTimesTendToTheElasticLimits) {
  const double stiff = *on_a_sphere(Elastic{1e6}).peak_force;
  const double soft = *on_a_sphere(Elastic{1e5}).peak_force;
  for (const double tau : {1e6, 1e9, 1e12, 1e15}) {
    const Summary slow = on_a_sphere(LinearViscoelastic{1e5, 1e6, tau});
    ASSERT_EQ(slow.status, Status::released) << tau;
    EXPECT_NEAR(*slow.peak_force / stiff, 1, 2e-4) << tau;
    EXPECT_NEAR(*slow.restitution, 1, 2e-4) << tau;
  }
  for (const double tau : {1e-9, 1e-15}) {
    const Summary fast = on_a_sphere(LinearViscoelastic{1e5, 1e6, tau});
    ASSERT_EQ(fast.status, Status::released) << tau;
    EXPECT_NEAR(*fast.peak_force / soft, 1, 2e-4) << tau;
  }
  NineParameter law{1e5, 0.7, 1.2, 1e-6, 2e4, 0.3, 1e-5, 0.1};
  const double short_memory = *on_a_sphere(law).peak_force;
  for (const double tau : {1e-9, 1e-12, 1e-15}) {
    law.relaxation_time = tau;
    const Summary without = on_a_sphere(law);
    ASSERT_EQ(without.status, Status::released) << tau;
    EXPECT_NEAR(*without.peak_force / short_memory, 1, 4e-4) << tau;
  }
}

}  // namespace
}  // namespace dashpad::test
