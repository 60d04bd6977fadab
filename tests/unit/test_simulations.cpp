/// The predictions for the validation tests: what is simulated, by which program, and what an ABEND leaves.

#include "dashpad/report1986/validation/simulations.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "dashpad/impact/solve.hpp"
#include "dashpad/spit1984/run.hpp"
#include "sample_case.hpp"

namespace dashpad::report1986 {
namespace {

using ImpactSetup = Setup;  // GoogleTest has a Setup of its own

class Simulations : public ::testing::Test {
 protected:
  Simulations() {
    std::vector<input::Fault> faults;
    data = read_validation_data(test::source / "data/validation", faults);
  }
  ValidationData data;
  Material ensolite = input::read_material(test::materials / "ensolite-aac-9.toml").value();
  ImpactSetup soft{Projectile::aluminium, TestSupport::load_cell, 14, 2};
};

TEST_F(Simulations, CaseIsThatOfTheReportInExactUnits) {
  const ImpactCase impact = impact_case(data, ensolite, {Projectile::steel, TestSupport::load_cell, 14.6, 2});
  EXPECT_NEAR(impact.impactor.mass, 7.7 * 0.45359237, 1e-12);
  EXPECT_NEAR(std::get<Sphere>(impact.impactor.nose).radius, 0.0508, 1e-15);
  EXPECT_NEAR(impact.impactor.speed, 14.6 * 0.44704, 1e-12);
  EXPECT_NEAR(impact.pad.thickness, 0.03048, 1e-15);
  const double force = 860 * 4.4482216152605;
  EXPECT_NEAR(impact.support.energy(force), force * 0.0956 * 0.0254 / 2, 1e-9);
  EXPECT_EQ(impact.support.points().size(), 2U);
  EXPECT_TRUE(violations(impact).empty());
  const spit1984::Deck deck = spit1984::deck_of(impact);
  EXPECT_EQ(deck.speed_mph, 14.6) << "the program counts 17.64 in/s itself";
  EXPECT_EQ(deck.weight_lb, 7.7);
  const ImpactCase plate = impact_case(data, ensolite, {Projectile::aluminium, TestSupport::plate, 10, 2});
  EXPECT_NEAR(plate.support.force(0.0254), 5180 * 4.4482216152605, 1e-6);
}

TEST_F(Simulations, FiguresAreThoseOfTheSolver) {
  const Summary summary = solve(impact_case(data, ensolite, soft)).summary;
  const Prediction prediction = predict(data, ensolite, Program::accurate, soft);
  EXPECT_NEAR(*prediction.peak_force_lb, *summary.peak_force / 4.4482216152605, 1e-9);
  EXPECT_NEAR(*prediction.rebound_mph, -summary.force_below_weight->velocity / 0.44704, 1e-12);
  EXPECT_NEAR(*prediction.time_to_peak_ms, 1e3 * *summary.time_of_peak_force, 1e-12);
  EXPECT_EQ(*prediction.peak_strain, summary.peak_strain);
  EXPECT_LE(prediction.error, 3e-4);  // three times what is held to the tolerance
  EXPECT_EQ(prediction.remark, "");
}

TEST_F(Simulations, FirstSlopeLeavesTheCornerOut) {
  const Prediction curve = predict(data, ensolite, Program::accurate, soft);
  const Prediction slope = predict(data, ensolite, Program::accurate_first_slope, soft);
  EXPECT_GT(*curve.peak_force_lb, 1.5 * *slope.peak_force_lb);
  soft.speed_mph = 9;  // stays below the corner
  EXPECT_EQ(predict(data, ensolite, Program::accurate, soft).peak_force_lb,
            predict(data, ensolite, Program::accurate_first_slope, soft).peak_force_lb);
}

TEST_F(Simulations, ProgramOf1984KnowsItsSupportOnlyWhereMended) {
  const ImpactSetup stiff{Projectile::steel, TestSupport::load_cell, 14, 2};
  const spit1984::Run run = spit1984::run(spit1984::deck_of(impact_case(data, ensolite, stiff)));
  const Prediction printed = predict(data, ensolite, Program::printed_1984, stiff);
  EXPECT_EQ(printed.peak_force_lb, -run.peak_force_lb);
  EXPECT_NEAR(*printed.rebound_mph, -run.rebound_speed_mph, 2e-3 * -run.rebound_speed_mph)
      << "the last rows pull, and are left out";
  EXPECT_EQ(printed.remark.find("1 of 123 steps out of equilibrium; used up to 12.1 ms"), 0U)
      << printed.remark;
  const Prediction with_curve = predict(data, ensolite, Program::mended_support_1984, stiff);
  EXPECT_NE(with_curve.peak_force_lb, printed.peak_force_lb);
}

/// Equilibrium is lost before the peak: nothing of the run is of use.
TEST_F(Simulations, RunawayLeavesNoFigures) {
  const Prediction lost = predict(data, ensolite, Program::mended_support_1984,
                                  {Projectile::aluminium, TestSupport::load_cell, 20, 4});
  EXPECT_EQ(lost.remark.find("ABEND 902"), 0U) << lost.remark;
  EXPECT_FALSE(lost.peak_force_lb);
  EXPECT_FALSE(lost.time_to_peak_ms);
  EXPECT_FALSE(lost.rebound_mph);
  EXPECT_FALSE(lost.peak_strain);
}

/// The run breaks down at the end of the rebound, with a tensile force: what came before it is of use. The
/// peak is that of the first slope alone, since the support's curve is idle.
TEST_F(Simulations, RunThatBreaksDownOnTheReboundKeepsWhatCameBefore) {
  soft.speed_mph = 16;
  const spit1984::Run run = spit1984::run(spit1984::deck_of(impact_case(data, ensolite, soft)));
  ASSERT_EQ(run.abend, spit1984::Abend::too_many_time_steps);
  ASSERT_GT(run.rebound_speed_mph, 1e30) << "what the program prints is of no use";
  const Prediction late = predict(data, ensolite, Program::printed_1984, soft);
  EXPECT_NEAR(late.peak_force_lb.value_or(0), 916.8, 0.1);
  EXPECT_NEAR(late.time_to_peak_ms.value_or(0), 6.3, 1e-3);
  EXPECT_NEAR(late.peak_strain.value_or(0), 1.1302733 / 1.2, 1e-4);
  EXPECT_NEAR(late.rebound_mph.value_or(0), 177.66 / 17.64, 0.01);
  EXPECT_NE(late.remark.find("used up to 10.0 ms, when the force is 5 % of its peak"), std::string::npos)
      << late.remark;
}

/// What the last tenth of the peak force adds to the rebound speed, in a run that is complete.
TEST_F(Simulations, LastTenthOfTheForceAddsLittleSpeed) {
  const ImpactSetup complete{Projectile::steel, TestSupport::load_cell, 14.5, 1.75};
  const spit1984::Run run = spit1984::run(spit1984::deck_of(impact_case(data, ensolite, complete)));
  ASSERT_EQ(run.abend, spit1984::Abend::none);
  const auto late = std::ranges::find_if(run.history, [&](const spit1984::Step& step) {
    return step.speed_in_per_s < 0 && step.force_lb >= 0.1 * run.peak_force_lb;
  });
  ASSERT_NE(late, run.history.end());
  const double gain = run.rebound_speed_mph * 17.64 / late->speed_in_per_s - 1;
  EXPECT_NEAR(gain, 0.037, 1e-3);  // the most among the tests of the program as printed
}

/// Too much of the force is left for a rebound speed.
TEST_F(Simulations, EarlyBreakdownOnTheReboundLeavesThePeaksAlone) {
  const Prediction late =
      predict(data, ensolite, Program::printed_1984, {Projectile::steel, TestSupport::load_cell, 14.4, 3.5});
  EXPECT_NEAR(late.peak_force_lb.value_or(0), 1238, 0.1);
  EXPECT_NEAR(late.time_to_peak_ms.value_or(0), 6.3, 1e-3);
  EXPECT_TRUE(late.peak_strain);
  EXPECT_FALSE(late.rebound_mph);
  EXPECT_NE(late.remark.find("when the force is 48 % of its peak"), std::string::npos) << late.remark;
}

TEST_F(Simulations, AllOfThemComeInOrderAndAreRunOnce) {
  const ImpactSetup plate{Projectile::aluminium, TestSupport::plate, 12, 3};
  const std::vector<Program> which{Program::accurate_first_slope, Program::accurate};
  std::vector<std::size_t> told;
  const auto all =
      predict_all(data, ensolite, which, {plate, soft, plate}, [&](std::size_t done, std::size_t given) {
        told.push_back(done);
        EXPECT_EQ(given, 3U) << "the plate is linear, and there twice";
      });
  EXPECT_EQ(told, (std::vector<std::size_t>{1, 2, 3}));
  ASSERT_EQ(all.size(), 6U);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ImpactSetup& setup = i / 2 == 1 ? soft : plate;
    const Prediction alone = predict(data, ensolite, which[i % 2], setup);
    EXPECT_EQ(all[i].setup, setup);
    EXPECT_EQ(all[i].program, which[i % 2]);
    EXPECT_EQ(all[i].peak_force_lb, alone.peak_force_lb);
    EXPECT_EQ(all[i].rebound_mph, alone.rebound_mph);
  }
  EXPECT_EQ(find(all, Program::accurate, soft), &all[3]);
  EXPECT_EQ(find(all, Program::printed_1984, soft), nullptr);
}

TEST_F(Simulations, ImpossibleSetupIsThrownOutOfTheThreads) {
  EXPECT_THROW(
      predict_all(data, ensolite, {Program::accurate}, {soft, {soft.projectile, soft.support, -1, 2}, soft}),
      std::invalid_argument);
  EXPECT_TRUE(predict_all(data, ensolite, {Program::accurate}, {}).empty());
}

}  // namespace
}  // namespace dashpad::report1986
