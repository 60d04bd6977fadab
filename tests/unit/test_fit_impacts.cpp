/// Fits of impacts: their figures, the table beside the model, and the card that comes of them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "dashpad/fit/fit.hpp"
#include "dashpad/fit/report.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/output/card_toml.hpp"
#include "dashpad/output/fit.hpp"
#include "output/text/fit_words.hpp"
#include "shared/temporary_folder.hpp"
#include "unit/sample_case.hpp"

namespace dashpad::fit {
namespace {

using test::edited;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A table with a rate effect and an unloading, tested up to 0.7 at 0.01 to 100 per second.
const std::string table_card = R"(title = "A foam"
source = "made up"
basis = "test"
reservations = ["One batch."]
law = "foam"
[parameters]
friction = 0.05
unloading_factor = 0.5
unloading_shape = 1
recoil = 0.3
[curve]
form = "table"
rate = "0.01 1/s"
stress_unit = "kPa"
strain = [0.05, 0.3, 0.5, 0.6, 0.7]
stress = [60, 90, 140, 200, 330]
[rate]
form = "power"
exponent = 0.03
exponent_slope = 0
highest_rate = "100 1/s"
[fitted]
highest_strain = 0.7
lowest_rate = "0.01 1/s"
highest_rate = "100 1/s"
)";

const std::string drop_case = R"(title = "Drop"
[impactor]
mass = "4.6 kg"
radius = "80 mm"
speed = "4 m/s"
[pad]
thickness = "50 mm"
material = "foam.toml"
scale = SCALE
neighbours = 0
[support]
type = "linear"
stiffness = "STIFFNESS N/mm"
)";

std::string drop(double scale, double stiffness) {
  return edited(edited(drop_case, "SCALE", fmt::format("{}", scale)), "STIFFNESS",
                fmt::format("{}", stiffness));
}

double value_of(const FitReport& report, const std::string& key) {
  const auto found = std::ranges::find(report.unknowns, key, &FittedUnknown::key);
  EXPECT_NE(found, report.unknowns.end()) << key;
  return found == report.unknowns.end() ? NAN : found->value;
}

class FitImpactsTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("foam.toml", table_card);
    folder_.write("drop.toml", drop(1, 300));
  }
  Solution solution(const std::string& text) {
    const input::CaseFile read = input::read_case(folder_.write("solved.toml", text), materials_).value();
    return solve(read.impact, read.options);
  }
  Summary solved(const std::string& text) { return solution(text).summary; }
  FitFile read(const std::string& text) {
    return read_fit(folder_.write("fit.toml", text), materials_).value();
  }
  /// Peak, rebound and time of the drop with another scale and support, as figures.
  std::string figures(double scale, double stiffness) {
    const Summary truth = solved(drop(scale, stiffness));
    return fmt::format(
        "peak_acceleration = {{value = \"{} m/s2\", deviation = \"1 %\"}}\n"
        "rebound_speed = {{value = \"{} m/s\", deviation = \"1 %\"}}\n"
        "peak_penetration = {{value = \"{} m\", deviation = \"1 %\"}}\n",
        *truth.peak_acceleration, *truth.rebound_speed, truth.peak_penetration);
  }
  std::string fit_of_scale(double scale, double stiffness) {
    return R"(title = "Tuned"
case = "drop.toml"
[unknowns]
"pad.scale" = {bounds = [0.5, 2]}
"support.stiffness" = {bounds = ["100 N/mm", "1000 N/mm"]}
[[impacts]]
case = "drop.toml"
)" + figures(scale, stiffness) +
           "[fit]\nstarts = 2\n";
  }

  test::TemporaryFolder folder_;
  const std::filesystem::path materials_ = DASHPAD_SOURCE_DIR "/materials";
};

TEST_F(FitImpactsTest, ThePulseHasFigures) {
  const Solution truth = solution(drop(1.2, 300));
  const injury::InjuryFigures of = injury::injury_figures(truth);
  const std::string held_out = fmt::format(
      "[[impacts]]\ncase = \"drop.toml\"\nhold_out = true\n"
      "hic15 = {{value = {}, deviation = \"2 %\"}}\nhic36 = {{value = {}, deviation = \"2 %\"}}\n"
      "hic_unlimited = {{value = {}, deviation = 5}}\n"
      "clip_3ms = {{value = \"{} m/s2\", deviation = \"2 g\"}}\n"
      "cumulative_3ms = {{value = \"{} m/s2\", deviation = \"2 g\"}}\n"
      "velocity_change = {{value = \"{} m/s\", deviation = \"1 %\"}}\n",
      of.hic15.value, of.hic36.value, of.hic_unlimited.value, of.clip_3ms.level, of.cumulative_3ms.level,
      of.velocity_change);
  const std::string of_scale = edited(fit_of_scale(1.2, 300), "\"support.stiffness\"", "#");
  const FitReport report = run_fit(read(of_scale + held_out).fit);
  ASSERT_TRUE(report.converged) << report.why_not;
  std::size_t held = 0;
  for (const MetFigure& figure : report.figures) {
    if (!figure.is_held_out) continue;
    ++held;
    ASSERT_TRUE(figure.computed) << static_cast<int>(figure.figure);
    EXPECT_NEAR(*figure.computed / figure.measured, 1, 1e-3) << static_cast<int>(figure.figure);
  }
  EXPECT_EQ(held, 6U);
}

TEST_F(FitImpactsTest, HicCanBeFitted) {
  const double hic = injury::injury_figures(solution(drop(1.3, 300))).hic15.value;
  const FitReport report = run_fit(read(fmt::format(R"(case = "drop.toml"
[unknowns]
"pad.scale" = {{bounds = [0.9, 2]}}
[[impacts]]
case = "drop.toml"
hic15 = {{value = {}, deviation = "1 %"}}
[fit]
starts = 2
)",
                                                    hic))
                                       .fit);
  ASSERT_TRUE(report.converged) << report.why_not;
  EXPECT_NEAR(value_of(report, "pad.scale"), 1.3, 0.01);
  ASSERT_EQ(report.comparison.size(), 1U);
  EXPECT_EQ(report.comparison[0].figure, ImpactFigure::hic15);
  EXPECT_NEAR(*report.comparison[0].share(), 0, 1e-3);
}

TEST_F(FitImpactsTest, PeakHicAndReboundOfAPulseStandBesideTheModel) {
  const Solution truth = solution(drop(1.2, 300));
  std::string csv = "time_s,acceleration_g\n0,0\n0.0005,0\n";
  for (std::size_t i = 0; i < truth.history.size(); ++i)
    csv += fmt::format("{:.9f},{:.9f}\n", 0.001 + truth.history.time[i],
                       truth.history.acceleration[i] / standard_gravity);
  csv += fmt::format("{:.9f},0\n", 0.0011 + truth.history.time.back());
  folder_.write("drop.csv", csv);
  FitFile file = read(R"(case = "drop.toml"
[unknowns]
"pad.scale" = {bounds = [0.5, 2]}
[[impacts]]
case = "drop.toml"
pulse = {file = "drop.csv", deviation = "5 %"}
peak_acceleration = {value = "1 g", deviation = "90 g"}
peak_penetration = {value = "40 mm", deviation = "90 mm"}
hold_out = true
[[impacts]]
case = "drop.toml"
)" + figures(1, 300) + "[fit]\nstarts = 1\n");
  const FitReport report = run_fit(file.fit);
  ASSERT_TRUE(report.converged) << report.why_not;
  ASSERT_EQ(report.comparison.size(), 4U + 3U);
  const auto& peak = report.comparison[0];
  EXPECT_EQ(peak.figure, ImpactFigure::peak_acceleration);
  EXPECT_TRUE(peak.is_held_out);
  EXPECT_TRUE(peak.is_of_pulse);
  EXPECT_NEAR(peak.measured / *truth.summary.peak_acceleration, 1, 2e-3);
  EXPECT_NEAR(*peak.computed / *solved(drop(1, 300)).peak_acceleration, 1, 1e-3);
  const auto& hic = report.comparison[1];
  EXPECT_EQ(hic.figure, ImpactFigure::hic_unlimited);
  EXPECT_NEAR(hic.measured / injury::injury_figures(truth).hic_unlimited.value, 1, 5e-3);
  const auto& rebound = report.comparison[2];
  EXPECT_EQ(rebound.figure, ImpactFigure::rebound_speed);
  EXPECT_NEAR(rebound.measured, *truth.summary.rebound_speed, 0.03);
  // What no pulse shows comes from the figures; their peak is that of the pulse already.
  EXPECT_EQ(report.comparison[3].figure, ImpactFigure::peak_penetration);
  EXPECT_FALSE(report.comparison[3].is_of_pulse);
  EXPECT_FALSE(report.comparison[4].is_held_out);
  const std::string text =
      output::to_terminal(output::fit_document(report, plain_si()), output::Detail::main);
  EXPECT_THAT(text, HasSubstr("measured and computed"));
  EXPECT_THAT(text, HasSubstr("Unlimited HIC"));
  EXPECT_THAT(report.material.reservations,
              Contains(HasSubstr("the modelled peak penetration is 13 % below the measured one")));
}

/// What the sensor feels over the pulse is the change of velocity and what gravity adds meanwhile.
TEST_F(FitImpactsTest, GravityIsNoPartOfTheReboundOfAPulse) {
  const std::string falling =
      edited(drop(1, 300), "speed = \"4 m/s\"", "speed = \"4 m/s\"\ngravity = \"9.80665 m/s2\"");
  folder_.write("falling.toml", falling);
  const Solution truth = solution(falling);
  std::string csv = "time_s,acceleration_g\n0,0\n0.0005,0\n";
  for (std::size_t i = 0; i < truth.history.size(); ++i)
    csv += fmt::format("{:.9f},{:.9f}\n", 0.001 + truth.history.time[i],
                       truth.history.acceleration[i] / standard_gravity);
  csv += fmt::format("{:.9f},0\n", 0.0011 + truth.history.time.back());
  folder_.write("drop.csv", csv);
  const FitReport report = run_fit(read(R"(case = "drop.toml"
[unknowns]
"pad.scale" = {bounds = [0.5, 2]}
[[impacts]]
case = "falling.toml"
pulse = {file = "drop.csv", deviation = "5 %"}
hold_out = true
[[impacts]]
case = "drop.toml"
)" + figures(1, 300) + "[fit]\nstarts = 1\n")
                                       .fit);
  ASSERT_TRUE(report.converged) << report.why_not;
  const ImpactComparison& rebound = report.comparison.at(2);
  ASSERT_EQ(rebound.figure, ImpactFigure::rebound_speed);
  ASSERT_GT(standard_gravity * truth.summary.contact_end->time, 0.15);  // m/s
  EXPECT_NEAR(rebound.measured, *truth.summary.rebound_speed, 0.03);
}

TEST_F(FitImpactsTest, AScaleGoesIntoTheStressesOfTheCard) {
  const FitReport report = run_fit(read(fit_of_scale(1.1, 250)).fit);
  ASSERT_TRUE(report.converged) << report.why_not;
  EXPECT_NEAR(value_of(report, "pad.scale"), 1.1, 0.01);
  folder_.write("tuned.toml", output::card_toml(report.material));
  const double stiffness = value_of(report, "support.stiffness") / 1000;
  EXPECT_NEAR(stiffness, 250, 5);
  const double fitted = *solved(drop(value_of(report, "pad.scale"), stiffness)).peak_acceleration;
  const double by_card = *solved(edited(drop(1, stiffness), "foam.toml", "tuned.toml")).peak_acceleration;
  EXPECT_NEAR(by_card / fitted, 1, 1e-4);
  ASSERT_TRUE(report.fitted_case);
  const double by_case = *solved(output::fitted_case_toml(report)).peak_acceleration;
  EXPECT_NEAR(by_case / fitted, 1, 1e-4);
  EXPECT_NEAR(by_case / *solved(drop(1.1, 250)).peak_acceleration, 1, 1e-3);
  // The scale of a table has no numbers of a card: its error counts as scatter.
  ASSERT_TRUE(report.material.uncertainty.scatter);
  const auto scale = std::ranges::find(report.unknowns, "pad.scale", &FittedUnknown::key);
  const double relative = scale->standard_error.value() / scale->value;
  EXPECT_NEAR(*report.material.uncertainty.scatter, relative, 0.005 * relative);
}

TEST_F(FitImpactsTest, LeavesWhatNeighboursDoToTheLawUnlessACaseSaysOtherwise) {
  folder_.write("drop.toml", edited(drop(1, 300), "neighbours = 0\n", ""));
  const FitFile silent = read(fit_of_scale(1, 300));
  EXPECT_EQ(silent.fit.impacts.front().impact.pad.neighbours, 0);
  EXPECT_EQ(silent.fit.base.pad.neighbours, 0);
  const FitReport report = run_fit(silent.fit);
  ASSERT_TRUE(report.material.nose_over_pad);
  EXPECT_NEAR(*report.material.nose_over_pad, 80.0 / 50, 1e-6);
  EXPECT_THAT(output::card_toml(report.material), HasSubstr("[measured_by]"));
  folder_.write("drop.toml", edited(drop(1, 300), "neighbours = 0", "neighbours = 0.7"));
  const FitFile told = read(fit_of_scale(1, 300));
  EXPECT_EQ(told.fit.impacts.front().impact.pad.neighbours, 0.7);
  EXPECT_FALSE(run_fit(told.fit).material.nose_over_pad);
}

TEST_F(FitImpactsTest, ImpactsTestRatesButNoStrains) {
  // The pad is struck to a strain of more than 0.7.
  folder_.write("drop.toml", edited(drop(1, 300), "50 mm", "25 mm"));
  ASSERT_GT(solved(edited(drop(1, 300), "50 mm", "25 mm")).peak_strain, 0.75);
  FitFile file = read(fit_of_scale(1, 300));
  const FitReport report = run_fit(file.fit);
  ASSERT_TRUE(report.converged) << report.why_not;
  ASSERT_TRUE(report.material.fitted);
  EXPECT_EQ(report.material.fitted->highest_strain, 0.7);
  EXPECT_EQ(report.material.fitted->lowest_rate, 0.01);
  EXPECT_GT(report.material.fitted->highest_rate, 120);
  EXPECT_THAT(report.material.reservations, Contains(HasSubstr("For strain rates from 100 to")));
  EXPECT_THAT(report.material.reservations, Contains("One batch."));
}

TEST_F(FitImpactsTest, AFormulaMovesAllItsStressesWithTheScale) {
  folder_.write("foam.toml",
                edited(edited(edited(table_card, "form = \"table\"", "form = \"power\""),
                              "stress_unit = \"kPa\"\nstrain = [0.05, 0.3, 0.5, 0.6, 0.7]\n",
                              "modulus = \"100 kPa\"\ncontact_exponent = 0.5\n"),
                       "stress = [60, 90, 140, 200, 330]", "compaction_exponent = 1\nhighest_strain = 0.7"));
  const FitReport report = run_fit(read(fit_of_scale(1.1, 250)).fit);
  ASSERT_TRUE(report.converged) << report.why_not;
  const PosteriorAxes& axes = report.material.uncertainty.posterior;
  EXPECT_THAT(axes.keys, ElementsAre("curve.modulus"));
  ASSERT_EQ(axes.minus.size(), 1U);
  const auto scale = std::ranges::find(report.unknowns, "pad.scale", &FittedUnknown::key);
  const double half = (axes.plus[0][0] - axes.minus[0][0]) / 2;
  EXPECT_NEAR(std::abs(half), 100e3 * scale->standard_error.value(), 0.05 * std::abs(half));
  // The card with its uncertainty is read as it was written.
  EXPECT_EQ(input::read_material(folder_.write("tuned.toml", output::card_toml(report.material)))
                .value()
                .uncertainty,
            report.material.uncertainty);
}

const std::string in_line = R"(case = "in-line.toml"
[unknowns]
"pad.curve.modulus" = {bounds = ["50 kPa", "200 kPa"]}
[[impacts]]
case = "in-line.toml"
)";

class RecoilTest : public FitImpactsTest {
 protected:
  /// A case with a foam that says nothing of its recoil.
  static std::string case_with(const std::string& parameters) {
    return edited(edited(drop(1, 300), "material = \"foam.toml\"\nscale = 1\n", "law = \"foam\"\n"),
                  "[support]",
                  "[pad.parameters]\nfriction = 0.05\nunloading_factor = 0.5\n" + parameters +
                      R"([pad.curve]
form = "power"
rate = "0.01 1/s"
modulus = "100 kPa"
contact_exponent = 0.5
compaction_exponent = 1
highest_strain = 0.7
[pad.rate]
form = "power"
exponent = 0.05
exponent_slope = 0
highest_rate = "100 1/s"
[support])");
  }
  std::string figures_of(const std::string& text) {
    const Summary truth = solved(text);
    return fmt::format(
        "peak_acceleration = {{value = \"{} m/s2\", deviation = \"1 %\"}}\n"
        "rebound_speed = {{value = \"{} m/s\", deviation = \"1 %\"}}\n",
        *truth.peak_acceleration, *truth.rebound_speed);
  }
};

TEST_F(RecoilTest, IsSoughtWhereNobodyStatedItAndImpactsShowIt) {
  folder_.write("in-line.toml", case_with(""));
  const std::string text = in_line + figures_of(case_with("recoil = 0.2\n"));
  const FitReport report = run_fit(read(text + "[fit]\nstarts = 2\n").fit);
  ASSERT_TRUE(report.converged) << report.why_not;
  EXPECT_NEAR(value_of(report, "pad.parameters.recoil"), 0.2, 0.02);
  EXPECT_TRUE(report.unknowns[1].is_added);
  EXPECT_THAT(output::to_terminal(output::fit_document(report, plain_si()), output::Detail::main),
              testing::ContainsRegex("pad.parameters.recoil\\s+is\\s+fitted\\s+too"));
  const auto& range = report.material.uncertainty.recoil;
  ASSERT_TRUE(range);
  EXPECT_LT(range->low, 0.2);
  EXPECT_GT(range->high, 0.2);
  EXPECT_LT(range->high, 0.5);
}

TEST_F(RecoilTest, StaysWhereItIsStated) {
  folder_.write("in-line.toml", case_with("recoil = 1\n"));
  const std::string text = in_line + figures_of(case_with("recoil = 0.2\n"));
  EXPECT_EQ(read(text).fit.unknowns.size(), 1U);
  // A card that gives it states it, too; but not where it calls it uncertain.
  EXPECT_EQ(read(fit_of_scale(1, 300)).fit.unknowns.size(), 2U);
  folder_.write("foam.toml", table_card + "[uncertainty]\nrecoil = [0, 1]\n");
  const Fit open = read(fit_of_scale(1, 300)).fit;
  ASSERT_EQ(open.unknowns.size(), 3U);
  EXPECT_EQ(open.unknowns[2].key, "pad.parameters.recoil");
}

TEST_F(RecoilTest, IsNotSoughtWhereTheDataDoNotShowIt) {
  folder_.write("in-line.toml", case_with(""));
  const FitReport report = run_fit(
      read(in_line + "peak_acceleration = {value = \"60 g\", deviation = \"5 %\"}\n[fit]\nstarts = 1\n").fit);
  ASSERT_TRUE(report.converged) << report.why_not;
  EXPECT_EQ(report.unknowns.size(), 1U);
  EXPECT_THAT(report.material.reservations, Contains(HasSubstr("(recoil) was not tested")));
  EXPECT_EQ(report.material.uncertainty.recoil, (ValueRange{0, 1}));
}

/// A fast test shows the recoil where it comes back; its beginning at no strain is no way back.
TEST_F(RecoilTest, IsSoughtWhereAFastTestComesBack) {
  const auto unknowns = [&](int points) {
    std::string csv = "time_s,strain,stress_kPa\n";
    for (int i = 0; i < points; ++i)
      csv += fmt::format("{},{},{}\n", 0.001 * (i + 1), 0.05 * std::min(i, 20 - i),
                         10 * std::min(i, 20 - i) + 1);
    folder_.write("fast.csv", csv);
    folder_.write("in-line.toml", case_with(""));
    return read(edited(in_line, "[[impacts]]\ncase = \"in-line.toml\"\n",
                       "[[tests]]\nfile = \"fast.csv\"\nstrain_unit = \"fraction\"\n"
                       "columns = {time = \"time\"}\n"))
        .fit.unknowns.size();
  };
  EXPECT_EQ(unknowns(11), 1U);
  EXPECT_EQ(unknowns(16), 2U);
}

TEST(FittedUnknown, MayEndAtANaturalBound) {
  FittedUnknown friction;
  friction.unit = "1";
  friction.highest = 0.4;
  friction.high = 0.1;
  EXPECT_FALSE(friction.is_identified());
  friction.lowest_is_natural = friction.is_at_lowest = true;
  EXPECT_TRUE(friction.is_identified());
  EXPECT_FALSE(friction.wants_beyond());
  EXPECT_EQ(output::interval_words(friction, plain_si()), "0 to 0.1");
  friction.high = 0.3;
  EXPECT_FALSE(friction.is_identified());
  friction.lowest_is_natural = false;
  EXPECT_TRUE(friction.wants_beyond());
}

TEST(ImpactFigureName, NamesAQuantityThatTheTablesShow) {
  for (const ImpactFigureName& name : impact_figure_names()) {
    FitReport report;
    MetFigure& met = report.figures.emplace_back();
    met.figure = name.figure;
    met.measured = met.deviation = 1;
    const output::Table table = output::table_of_figures(report, unit_systems().front());
    EXPECT_EQ(table.rows.front()[1], name.quantity->title) << name.key;
    EXPECT_EQ(&name_of(name.figure), &name);
  }
}

TEST(DurationWords, AreReadable) {
  EXPECT_EQ(output::duration_words(0.1234), "0.12 s");
  EXPECT_EQ(output::duration_words(912), "15 min");
  EXPECT_EQ(output::duration_words(9000), "2.5 h");
}

}  // namespace
}  // namespace dashpad::fit
