// What a material test reports: against closed forms of an elastic foam, and layout of a report made by hand.

#include <cmath>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dashpad/output/materials.hpp"
#include "dashpad/spit1984/run.hpp"
#include "laboratory/arc.hpp"

namespace dashpad {
namespace {

std::string told(const laboratory::MaterialTestReport& report, const char* units = "si") {
  return output::to_terminal(output::material_test_document(report, unit_system(units)),
                             output::Detail::main);
}

using laboratory::run_material_test;
using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

Material spring() {
  return {.name = "spring",
          .title = "A spring",
          .source = "a test",
          .law = Elastic{.modulus = 300e3},
          .fitted = FittedRange{0.5, 1, 10},
          .also_published = {}};
}

Material foam() {
  Material material = spring();
  material.law =
      LinearViscoelastic{.asymptotic_modulus = 1e5, .initial_modulus = 4e5, .relaxation_time = 0.01};
  material.fitted.reset();
  return material;
}

/// A report of two places, so that every number of the files is known.
laboratory::MaterialTestReport by_hand() {
  laboratory::MaterialTestRun run;
  run.rate = 2;
  run.column.time = {0, 0.25, 0.5};
  run.column.strain = {0, 0.5, 0};
  run.column.rate = {2, 2, -2};
  run.column.stress = {0, 150e3, 0};
  run.column.work = {0, 37500, 7500};
  run.column.events = {{laboratory::ColumnEvent::Kind::turned, 0.25, 0.5, 150e3, 149e3}};
  run.column.largest_strain = 0.5;
  run.column.stress_error = 1e-9;
  run.cushion = {{0.5}, {150e3}, {37500}, {0.25}, {0.5}};
  run.figures = {150e3, 0.5, 37500, 30000, 0.2, {0.5, 150e3, 37500, 0.25, 0.5}, 2e-6};
  run.unloads = true;
  run.at_limits = {laboratory::CushionPoint{0.2, 60e3, 6000, 0.1, 0.5}, std::nullopt};
  run.update_of_1984 = laboratory::UpdateOf1984{.step = 0.25,
                                                .time = {0, 0.25, 0.5},
                                                .strain = {0, 0.5, 0},
                                                .stress = {0, 160e3, -1e3},
                                                .exact = {0, 150e3, 0},
                                                .update_at_turn = laboratory::StressAtTurn{160e3, -1e3},
                                                .exact_at_turn = laboratory::StressAtTurn{150e3, 0}};
  run.flags = {{"EXTRAPOLATED", "EXTRAPOLATED: too fast"}};
  laboratory::MaterialTest test;
  test.rates = {2};
  test.strain = 0.5;
  test.stress_limits = {60e3, 200e3};
  test.steps_of_1984 = 1;
  return {spring(), test, {run}};
}

TEST(MaterialTestReport, AnElasticFoamHasTheFiguresOfATriangle) {
  laboratory::MaterialTest test;
  test.strain = 0.4;
  test.rates = {5, 7};
  test.stress_limits = {30e3, 130e3};
  const laboratory::MaterialTestReport report = run_material_test(spring(), test);
  ASSERT_THAT(report.runs, SizeIs(2));
  EXPECT_EQ(report.runs[1].rate, 7);
  for (const laboratory::MaterialTestRun& run : report.runs) {
    EXPECT_NEAR(run.figures.peak_stress, 120e3, 1e-6);
    EXPECT_NEAR(run.figures.energy_in, 24e3, 0.1);
    EXPECT_NEAR(run.figures.hysteresis, 0, 1e-6);
    EXPECT_NEAR(run.figures.best_efficiency.efficiency, 0.2, 1e-6);
    ASSERT_TRUE(run.at_limits[0]);
    EXPECT_NEAR(run.at_limits[0]->strain, 0.1, 1e-6);
    EXPECT_FALSE(run.at_limits[1]);
    EXPECT_TRUE(run.unloads);
    EXPECT_THAT(run.flags, IsEmpty());
  }
}

TEST(MaterialTestReport, FlagsStrainAndRateBeyondTheFit) {
  laboratory::MaterialTest test;
  test.strain = 0.6;
  test.rates = {5, 20};
  const laboratory::MaterialTestReport report = run_material_test(spring(), test);
  ASSERT_THAT(report.runs[0].flags, SizeIs(1));
  EXPECT_THAT(report.runs[0].flags[0].text, StartsWith("EXTRAPOLATED STRAIN: the strain reaches 0.600"));
  ASSERT_THAT(report.runs[1].flags, SizeIs(2));
  EXPECT_THAT(report.runs[1].flags[1].text, HasSubstr("rate reaches 20 per second"));
  EXPECT_THAT(told(report),
              AllOf(HasSubstr("EXTRAPOLATED STRAIN (at 5 and 20 per second): the strain reaches"),
                    HasSubstr("EXTRAPOLATED RATE (at 20 per second): the strain rate reaches")));
}

/// Law 2 in closed form: on a ramp stress = E_inf rate t + (E_0 - E_inf) tau rate (1 - exp(-t/tau)); on hold
/// the second part decays.
TEST(MaterialTestReport, RelaxesInClosedForm) {
  laboratory::MaterialTest test;
  test.kind = laboratory::TestKind::relaxation;
  test.strain = 0.2;
  test.rates = {10};
  test.hold = 0.05;
  test.steps_of_1984 = 20;
  const laboratory::MaterialTestRun run =
      run_material_test(foam(), test, spit1984::stresses_of_update).runs[0];
  const double tau = 0.01, over = 3e5 * tau * 10 * (1 - std::exp(-0.02 / tau));
  ASSERT_TRUE(run.relaxed);
  EXPECT_NEAR(run.relaxed->at_end_of_ramp, 2e4 + over, 1e-6);
  EXPECT_NEAR(run.relaxed->after_tenth, 2e4 + over * std::exp(-0.5), 1e-6);
  EXPECT_NEAR(run.relaxed->after_hold, 2e4 + over * std::exp(-5.), 1e-6);
  EXPECT_FALSE(run.unloads);
  ASSERT_TRUE(run.update_of_1984);
  EXPECT_THAT(run.update_of_1984->time, SizeIs(20 + 50 + 1));
  ASSERT_TRUE(run.update_of_1984->exact_at_turn);
  EXPECT_NEAR(run.update_of_1984->exact_at_turn->next, 2e4 + over * std::exp(-0.1), 1e-6);
}

TEST(MaterialTestReport, CreepsToTheAsymptoticModulus) {
  laboratory::MaterialTest test;
  test.kind = laboratory::TestKind::creep;
  test.stress = 2e4;
  test.rates = {10};
  test.hold = 2;
  const laboratory::MaterialTestRun run = run_material_test(foam(), test).runs[0];
  ASSERT_TRUE(run.crept);
  EXPECT_LT(run.crept->at_end_of_loading, 0.1);
  EXPECT_NEAR(run.crept->after_hold, 0.2, 1e-7);
  test.stress = 2e5;
  EXPECT_THROW(run_material_test(foam(), test), std::invalid_argument);
}

TEST(MaterialTestReport, TheUpdateOf1984StandsAtTheTimesOfTheExactStress) {
  for (const laboratory::TestKind kind :
       {laboratory::TestKind::constant_rate, laboratory::TestKind::parabolic, laboratory::TestKind::cyclic}) {
    laboratory::MaterialTest test;
    test.kind = kind;
    test.strain = 0.4;
    test.low = 0.1;
    test.rates = {10};
    test.steps_of_1984 = 8;
    const laboratory::MaterialTestRun run =
        run_material_test(spring(), test, spit1984::stresses_of_update).runs[0];
    const laboratory::UpdateOf1984& update = *run.update_of_1984;
    EXPECT_NEAR(update.step, 0.04 / 8, 1e-15) << to_string(kind);
    EXPECT_NEAR(update.strain[8], 0.4, 1e-12) << to_string(kind);
    for (std::size_t i = 0; i < update.time.size(); ++i)
      EXPECT_NEAR(update.exact[i], 300e3 * update.strain[i], 1e-5) << to_string(kind) << i;
    EXPECT_NEAR(update.update_at_turn->last_loading, 120e3, 1) << to_string(kind);
  }
}

/// Law 2 with steps of four relaxation times: an explicit step of more than two is unstable.
TEST(MaterialTestReport, SaysWhereTheUpdateOf1984IsUnstable) {
  laboratory::MaterialTest test;
  test.strain = 0.4;
  test.rates = {0.5};
  test.steps_of_1984 = 20;
  const laboratory::MaterialTestReport unstable =
      run_material_test(foam(), test, spit1984::stresses_of_update);
  ASSERT_THAT(unstable.runs[0].flags, SizeIs(1));
  EXPECT_EQ(unstable.runs[0].flags[0].name, "OUT OF BOUNDS");
  EXPECT_EQ(unstable.runs[0].flags[0].figures.at(0).key, "step_s");
  EXPECT_EQ(unstable.runs[0].flags[0].figures.at(0).value, unstable.runs[0].update_of_1984->step);
  const double peak = unstable.runs[0].figures.peak_stress / 1e3;
  const output::Plot plot = output::material_test_plot(unstable, unit_system("si"));
  for (const double stress : plot.panels[0].series[1].y)
    EXPECT_TRUE(std::isnan(stress) || (stress >= -0.1 * peak && stress <= 1.5 * peak)) << stress;
  test.steps_of_1984 = 400;
  EXPECT_THAT(run_material_test(foam(), test, spit1984::stresses_of_update).runs[0].flags, IsEmpty());
}

/// A strain that was computed as 0.95 + 1e-16 is not beyond a fit up to 0.95.
TEST(MaterialTestReport, RoundingIsNoExtrapolation) {
  Material material = foam();
  material.fitted = FittedRange{0.95, 1, 2};
  laboratory::MaterialTest test;
  test.kind = laboratory::TestKind::parabolic;
  test.rates = {1};
  const laboratory::MaterialTestReport report =
      run_material_test(material, test, spit1984::stresses_of_update);
  for (const Flag& flag : report.runs[0].flags)
    EXPECT_FALSE(flag.name.starts_with("EXTRAPOLATED")) << flag.text;
}

TEST(MaterialTestReport, TextShowsEveryTable) {
  const std::string text = told(by_hand());
  EXPECT_THAT(text, HasSubstr("\nA spring (spring, elastic law)\nLoaded to a strain of 0.5 and unloaded to"));
  EXPECT_THAT(text, HasSubstr("\nEXTRAPOLATED (at 2 per second): too fast\n"));
  EXPECT_THAT(text, ContainsRegex("\n2 +150.00 +0.50000 +37.500 +30.000 +20.000 +0.25000 +0.50000 +150.00 "
                                  "+0.50000\n"));
  EXPECT_THAT(text, ContainsRegex("\n2 +60.000 +0.20000 +6.0000 +0.10000 +0.50000\n"));
  EXPECT_THAT(text, ContainsRegex("\n2 +200.00 +not reached"));
  EXPECT_THAT(text, ContainsRegex("\n2 +250.00 +1984 +160.00 +-1.0000 +-161.00 +-100.62\n"));
  EXPECT_THAT(text, ContainsRegex("\n2 +250.00 +exact +150.00 +0 +-150.00 +-100.00\n"));
  EXPECT_THAT(text, ContainsRegex("\n2 +unloading begins +0.50000 +250.00 +150.00 +149.00\n"));
  EXPECT_THAT(text, ContainsRegex("Foam +A spring .* a test\n"));
}

TEST(MaterialTestReport, TablesOfRelaxationAndCreepHaveAllTheirNumbers) {
  laboratory::MaterialTestReport report = by_hand();
  report.test.kind = laboratory::TestKind::relaxation;
  report.runs[0].relaxed = laboratory::RelaxedStress{80e3, 50e3, 20e3};
  report.runs[0].unloads = false;
  EXPECT_THAT(told(report), ContainsRegex("\n2 +80.000 +50.000 +20.000 +25.000\n"));
  report.test.kind = laboratory::TestKind::creep;
  report.test.stress = 50e3;
  report.runs[0].crept = laboratory::CreptStrain{0.1, 0.25};
  EXPECT_THAT(told(report), ContainsRegex("\n2 +0.10000 +0.25000 +0.15000\n"));
}

TEST(MaterialTestReport, TextIsSafeForATerminal) {
  laboratory::MaterialTestReport report = by_hand();
  report.material.title = "A\x1b[31mfoam\n";
  report.material.source = "a\x07 test";
  EXPECT_THAT(told(report, "us"), AllOf(Not(HasSubstr("\x1b")), Not(HasSubstr("\x07"))));
}

TEST(MaterialTestReport, JsonHasEveryField) {
  const json result = json::parse(output::material_test_json(by_hand()));
  EXPECT_EQ(result["test"],
            json::parse(R"({"kind": "constant-rate", "strain": 0.5, "hold_s": null, "stress_Pa": null,
                            "low_strain": null, "cycles": null, "history": null, "history_remarks": [],
                            "stress_limits_Pa": [60000.0, 200000.0], "steps_of_1984": 1})"));
  EXPECT_EQ(result["material"]["material"], "spring");
  EXPECT_EQ(result["material"]["law"], "elastic");
  EXPECT_EQ(result["material"]["source"], "a test");
  EXPECT_EQ(result["material"]["parameters"]["modulus"]["value"], 300e3);
  EXPECT_EQ(result["material"]["fitted"]["highest_rate_per_s"], 10);
  EXPECT_EQ(result["program"]["name"], "dashpad");
  ASSERT_THAT(result["runs"], SizeIs(1));
  const json expected = json::parse(R"({
    "rate_per_s": 2.0,
    "figures": {"peak_stress_Pa": 150000.0, "peak_stress_strain": 0.5, "energy_in_J_per_m3": 37500.0,
                "energy_returned_J_per_m3": 30000.0, "hysteresis": 0.2,
                "best_efficiency": {"strain": 0.5, "stress_Pa": 150000.0, "energy_J_per_m3": 37500.0,
                                    "efficiency": 0.25, "ideality": 0.5}},
    "stress_limits": [{"limit_Pa": 60000.0,
                       "reached": {"strain": 0.2, "stress_Pa": 60000.0, "energy_J_per_m3": 6000.0,
                                   "efficiency": 0.1, "ideality": 0.5}},
                      {"limit_Pa": 200000.0, "reached": null}],
    "relaxation": null,
    "creep": null,
    "update_of_1984": {"step_s": 0.25,
      "stress_discontinuity": {"last_loading_Pa": 160000.0, "next_Pa": -1000.0, "jump_Pa": -161000.0},
      "exact_stress_at_the_same_times": {"last_loading_Pa": 150000.0, "next_Pa": 0.0, "jump_Pa": -150000.0},
      "time_s": [0.0, 0.25, 0.5], "strain": [0.0, 0.5, 0.0], "stress_Pa": [0.0, 160000.0, -1000.0],
      "exact_stress_Pa": [0.0, 150000.0, 0.0]},
    "flags": [{"name": "EXTRAPOLATED", "severity": "doubtful", "text": "EXTRAPOLATED: too fast",
               "figures": {}}],
    "events": [{"event": "turned", "time_s": 0.25, "strain": 0.5, "stress_before_Pa": 150000.0,
                "stress_after_Pa": 149000.0}],
    "errors": {"stress_fraction_of_peak": 1e-9, "energy_fraction_of_energy_in": 2e-6},
    "column": {"time_s": [0.0, 0.25, 0.5], "strain": [0.0, 0.5, 0.0],
               "strain_rate_per_s": [2.0, 2.0, -2.0], "stress_Pa": [0.0, 150000.0, 0.0],
               "work_J_per_m3": [0.0, 37500.0, 7500.0]},
    "first_loading": {"strain": [0.5], "largest_stress_Pa": [150000.0], "energy_J_per_m3": [37500.0],
                      "efficiency": [0.25], "ideality": [0.5]}})");
  EXPECT_EQ(result["runs"][0], expected) << json::diff(result["runs"][0], expected);
}

TEST(MaterialTestReport, JsonOfRelaxationAndCreep) {
  laboratory::MaterialTestReport report = by_hand();
  report.test.kind = laboratory::TestKind::creep;
  report.runs[0].crept = laboratory::CreptStrain{0.1, 0.2};
  report.runs[0].relaxed = laboratory::RelaxedStress{3, 2, 1};
  report.runs[0].unloads = false;
  const json result = json::parse(output::material_test_json(report));
  EXPECT_EQ(result["test"]["hold_s"], 1);
  EXPECT_EQ(result["test"]["strain"], nullptr);
  EXPECT_EQ(result["runs"][0]["creep"],
            json::parse(R"({"end_of_loading_strain": 0.1, "after_hold_strain": 0.2})"));
  EXPECT_EQ(result["runs"][0]["relaxation"],
            json::parse(R"({"end_of_ramp_Pa": 3.0, "after_tenth_of_hold_Pa": 2.0, "after_hold_Pa": 1.0})"));
  EXPECT_EQ(result["runs"][0]["figures"]["hysteresis"], nullptr);
}

TEST(MaterialTestReport, CsvHasARowAPlace) {
  EXPECT_EQ(output::material_test_csv(by_hand(), plain_si()),
            "rate_1_per_s,time_s,strain,strain_rate_1_per_s,stress_Pa,stress_1984_Pa\n"
            "2,0,0,2,0,0\n2,0.25,0.5,2,150000,160000\n2,0.5,0,-2,0,-1000\n");
  laboratory::MaterialTestReport report = by_hand();
  EXPECT_THAT(output::material_test_csv(report, unit_system("engineering-metric")),
              AllOf(HasSubstr(",stress_MPa,stress_1984_MPa\n"), HasSubstr("\n2,250,0.5,2,0.15,0.16\n")));
  report.test.steps_of_1984.reset();
  report.runs[0].rate.reset();
  EXPECT_THAT(output::material_test_csv(report, unit_system("engineering-metric")),
              AllOf(StartsWith("rate_1_per_s,time_ms,strain,strain_rate_1_per_s,stress_MPa\n,0,0,2,0\n"),
                    HasSubstr("\n,250,0.5,2,0.15\n")));
}

TEST(MaterialTestReport, TheStillSaysWhereItComesFrom) {
  const output::Plot plot = output::material_test_plot(by_hand(), unit_system("si"));
  EXPECT_THAT(plot.source, AllOf(HasSubstr("dashpad "), HasSubstr("spring: a test"), HasSubstr("too fast")));
  ASSERT_THAT(plot.panels, SizeIs(2));
  const output::Panel& stress = plot.panels[0];
  EXPECT_EQ(stress.y.label, "Stress (kPa)");
  ASSERT_THAT(stress.series, SizeIs(2));
  EXPECT_EQ(stress.series[0].label, "2 per second");
  EXPECT_THAT(stress.series[0].y, ElementsAre(0, DoubleEq(150), 0));
  EXPECT_EQ(stress.series[1].label, "1984 update, 1 step, 2 per second");
  EXPECT_EQ(stress.series[1].style, output::SeriesStyle::points);
  EXPECT_EQ(stress.series[1].palette_index, stress.series[0].palette_index);
  EXPECT_THAT(plot.panels[1].series[0].x, ElementsAre(DoubleEq(150)));
  EXPECT_THAT(plot.panels[1].series[0].y, ElementsAre(0.25));
}

TEST(StrainMarks, SplittingChangesNoStrain) {
  const laboratory::StrainHistory history = laboratory::parabolic_test(10, 0.95);
  const laboratory::StrainHistory split = laboratory::split_at(history, {0.01, 0.02, 0.095, 0.0951, 0.19});
  EXPECT_THAT(laboratory::violations(split), IsEmpty());
  EXPECT_GT(split.pieces.size(), history.pieces.size() + 2);
  EXPECT_DOUBLE_EQ(laboratory::duration_of(split), laboratory::duration_of(history));
  for (double time = 0; time <= 0.19; time += 0.0007)
    EXPECT_NEAR(laboratory::strain_at(split, time), laboratory::strain_at(history, time), 1e-14) << time;
  EXPECT_NEAR(laboratory::end_of_first_loading(history), 0.095, 1e-15);
}

TEST(StrainMarks, TheFirstLoadingEndsWhereTheStrainStopsToGrow) {
  EXPECT_DOUBLE_EQ(laboratory::end_of_first_loading(laboratory::constant_rate_test(2, 0.5)), 0.25);
  EXPECT_DOUBLE_EQ(laboratory::end_of_first_loading(laboratory::ramp_and_hold_test(2, 0.5, 3)), 0.25);
  EXPECT_DOUBLE_EQ(
      laboratory::end_of_first_loading(laboratory::measured_test({0, 1, 2, 3, 4}, {0, 0.1, 0.4, 0.4, 0.6})),
      2);
  EXPECT_DOUBLE_EQ(laboratory::end_of_first_loading(laboratory::measured_test({0, 1, 2}, {0, 0, 0.4})), 2);
}

}  // namespace
}  // namespace dashpad
