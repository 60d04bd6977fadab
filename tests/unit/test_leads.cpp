// What stands on top of the pages of material tests, validation, studies and fits: the answer follows from
// the figures that were given.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/output/materials.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "made_up_study.hpp"
#include "output/text/capitals.hpp"
#include "output/text/study_answer.hpp"
#include "report1986/validation_tables.hpp"

namespace dashpad {
namespace {

using output::Lead;
using output::Tone;
using output::ValueRow;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<std::string> labels_of(const std::vector<ValueRow>& figures) {
  std::vector<std::string> labels;
  for (const ValueRow& figure : figures) labels.push_back(figure.label);
  return labels;
}

/// The figure of that label; an empty one without it.
ValueRow figure_of(const std::vector<ValueRow>& figures, const std::string& label) {
  for (const ValueRow& figure : figures)
    if (figure.label == label) return figure;
  return {};
}

Material spring_card() {
  return {.name = "spring",
          .title = "A spring",
          .source = "a test",
          .reservations = {"It is made up."},
          .law = Elastic{.modulus = 300e3},
          .fitted = FittedRange{0.5, 1, 10}};
}

/// Plateau and wall: the efficiency has its maximum at a strain of 0.5, given by hand.
laboratory::MaterialTestReport with_a_wall() {
  laboratory::MaterialTestReport report{.material = spring_card(), .test = {.rates = {1, 50}, .strain = 0.8}};
  for (const double rate : report.test.rates) {
    laboratory::MaterialTestRun run;
    run.rate = rate;
    const double peak = 1e3 * rate;
    run.column.time = {0, 1, 2};
    run.column.strain = {0, 0.5, 0.8};
    run.column.rate = {rate, rate, rate};
    run.column.stress = {0, peak, 12'345 * peak};
    run.column.work = {0, 400 * rate, 2000 * rate};
    run.column.largest_strain = 0.8;
    run.cushion = {{0.5, 0.8}, {peak, 12'345 * peak}, {400 * rate, 2000 * rate}, {0.4, 0.1}, {0.8, 0.1}};
    run.figures = {12'345 * peak, 0.8, 2000 * rate, 500 * rate, 0.75, {0.5, peak, 400 * rate, 0.4, 0.8}, 0};
    run.unloads = true;
    report.runs.push_back(run);
  }
  return report;
}

Lead lead_of(const laboratory::MaterialTestReport& report) {
  return *output::material_test_document(report, unit_system("si"), output::Pictures::drawn).lead;
}

TEST(MaterialTestLead, SaysWhereTheFoamIsUsedBestAtTheHighestRate) {
  const Lead lead = lead_of(with_a_wall());
  EXPECT_EQ(lead.answer, "Best used up to 50 kPa, having absorbed 20 kJ/m³ (at 50 per second)");
  EXPECT_THAT(labels_of(lead.figures),
              ElementsAre("Best used at", "Energy absorbed by then", "Strain at best use", "Energy returned",
                          "Strain reached", "Largest stress"));
  EXPECT_EQ(figure_of(lead.figures, "Energy returned").value, "25 %");
  EXPECT_EQ(figure_of(lead.figures, "Largest stress").value, "617000 kPa");  // three digits
  const ValueRow reached = figure_of(lead.figures, "Strain reached");
  EXPECT_EQ(reached.tone, Tone::doubtful);
  EXPECT_EQ(reached.remark, "fitted up to 0.5");
  EXPECT_DOUBLE_EQ(*reached.share, 1.6);
  // The wall does not hide the rest.
  EXPECT_DOUBLE_EQ(*lead.curve->panels.at(0).y.high, 200);
}

TEST(MaterialTestLead, AFoamThatHasNotRunOutIsNotSaidToHaveABestStress) {
  laboratory::MaterialTest test;
  test.strain = 0.4;
  const Lead lead = lead_of(run_material_test(spring_card(), test));
  EXPECT_THAT(lead.answer, HasSubstr(", with its efficiency still rising"));
  EXPECT_THAT(labels_of(lead.figures),
              ElementsAre("Energy input", "Energy returned", "Strain reached", "Largest stress"));
  EXPECT_EQ(figure_of(lead.figures, "Strain reached").tone, Tone::plain);
}

TEST(MaterialTestLead, AnswersTheStressLimitThatWasAskedFor) {
  laboratory::MaterialTest test;
  test.strain = 0.4;
  test.rates = {5};
  test.stress_limits = {30e3, 130e3};
  const Lead lead = lead_of(run_material_test(spring_card(), test));
  EXPECT_EQ(lead.answer, "Absorbs 1.5 kJ/m³ before its stress reaches 30 kPa (at 5 per second)");
  EXPECT_EQ(figure_of(lead.figures, "Energy below 130 kPa").remark, "this stress is not reached");
}

TEST(MaterialTestLead, OfAHoldItSaysWhatIsLeft) {
  laboratory::MaterialTest test;
  test.kind = laboratory::TestKind::relaxation;
  test.strain = 0.4;
  test.rates = {5};
  const Lead lead = lead_of(run_material_test(spring_card(), test));
  EXPECT_EQ(lead.answer, "After 1000 ms at a strain of 0.4, 100 % of the stress remains (at 5 per second)");
  EXPECT_THAT(lead.curve->panels.at(0).x.label, HasSubstr("Time"));
}

TEST(MaterialTestLead, RestsOnTheCard) {
  const output::Document document = output::material_test_document(with_a_wall(), unit_system("si"));
  EXPECT_THAT(
      document.sections.at(1).tables.at(0).rows.at(0),
      ElementsAre(
          "Foam",
          "A spring (spring, elastic law); fitted up to a strain of 0.5, at a strain rate of 1 to 10 per "
          "second",
          "a test", "It is made up."));
}

TEST(ValidationLead, FollowsTheVerdicts) {
  report1986::Study study = test::made_up_study();
  Lead lead = report1986::validation_lead(study, output::Pictures::drawn);
  EXPECT_EQ(
      lead.answer,
      "The report's foam law does not meet all the rules for the 1986 tests: it meets 1 of 2, and a foam "
      "fitted with the predicted test left out meets 0 of 1");
  EXPECT_EQ(lead.tone, Tone::bad);
  study.held_out.scores.front().passed = true;
  EXPECT_EQ(report1986::validation_lead(study, output::Pictures::drawn).tone, Tone::doubtful);
  study.rebounds.front().passed = true;
  lead = report1986::validation_lead(study, output::Pictures::drawn);
  EXPECT_EQ(lead.tone, Tone::good);
  EXPECT_THAT(lead.answer, HasSubstr("foam law meets all the rules for the 1986 tests: it meets 2 of 2"));
}

TEST(ValidationLead, ABiasStandsBesideItsRule) {
  report1986::Study study = test::made_up_study();
  study.held_out.scores = {{.name = "peak_force",
                            .support = report1986::TestSupport::load_cell,
                            .quantity = report1986::Quantity::peak_force,
                            .errors = {{.test = 1, .measured = 500, .predicted = 450, .error = -0.1}},
                            .bias = -0.03,
                            .standard_error = 0.04,
                            .scatter = 0.20,
                            .passed = true}};
  const Lead lead = report1986::validation_lead(study, output::Pictures::drawn);
  const ValueRow figure = figure_of(lead.figures, "Scatter in peak force, load cell");
  EXPECT_EQ(figure.value, "20.0 %");
  EXPECT_EQ(figure.remark,
            "limit 25 %; bias -3.0 ± 4.0\u00a0%, limit ±15 %; with the report's law the bias is -12.5 %");
  EXPECT_DOUBLE_EQ(*figure.share, 0.8);  // the scatter is nearer to its limit
  EXPECT_EQ(figure.tone, Tone::good);
  const output::Series& foam = lead.curve->panels.at(0).series.at(2);
  EXPECT_EQ(foam.label, "foam fitted to the other tests");
  EXPECT_THAT(foam.x, ElementsAre(500));
  EXPECT_THAT(foam.y, ElementsAre(450));
}

/// Rows with one response, all of one group.
study::StudyAnswers answers_of(const std::vector<double>& peaks, bool drawn) {
  study::StudyAnswers answers;
  answers.study.responses = {"peak_acceleration"};
  answers.study.factors = {{.key = "impactor.speed", .unit = "m/s"}};
  answers.responses = {0};
  answers.records.responses = {peaks};
  answers.records.factors = {{}};
  study::StudyAnswers::OfGroup of;
  of.group.drawn = drawn;
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    answers.records.rows.push_back(i);
    answers.records.statuses.push_back(Status::released);
    answers.records.factors[0].push_back(1 + static_cast<double>(i));
    of.group.places.push_back(i);
  }
  of.distributions = {study::distribution(peaks, drawn)};
  of.sensitivities = {std::nullopt};
  answers.groups = {of};
  return answers;
}

TEST(StudyKeyFigures, OfDrawsWithALimitTheProbabilityAndTheQuantilesTowardsIt) {
  std::vector<double> peaks;
  for (int i = 1; i <= 100; ++i) peaks.push_back(standard_gravity * i);
  study::StudyAnswers answers = answers_of(peaks, true);
  const double limit = 80 * standard_gravity;
  answers.limits = {{"peak_acceleration", limit}};
  std::vector<study::Reading> readings;
  for (const double peak : peaks) readings.push_back({peak, peak});
  answers.groups[0].exceedances = {study::exceedance(readings, limit)};
  answers.records.beyond_strain = 25;
  const std::vector<ValueRow> figures = output::study_key_figures(answers, unit_system("si"));
  EXPECT_EQ(figures.at(0).label, "Peak acceleration above 80 g");
  EXPECT_EQ(figures.at(0).value, "20 %");
  EXPECT_THAT(figures.at(0).remark, HasSubstr("95 % interval 12."));
  EXPECT_EQ(figures.at(1).value, "50 g");
  EXPECT_DOUBLE_EQ(*figures.at(1).share, 0.625);
  EXPECT_EQ(figures.back().value, "25 %");
  EXPECT_EQ(figures.back().tone, Tone::doubtful);
}

TEST(StudyKeyFigures, OfOtherResponsesNineDrawsInTen) {
  std::vector<double> peaks, hics;
  for (int i = 1; i <= 100; ++i) {
    peaks.push_back(standard_gravity * i);
    hics.push_back(1000 - 9 * i);
  }
  study::StudyAnswers answers = answers_of(peaks, true);
  answers.study.responses.emplace_back("hic15");
  answers.responses.push_back(1);
  answers.records.responses.push_back(hics);
  answers.groups[0].distributions.push_back(study::distribution(hics, true));
  answers.groups[0].sensitivities.emplace_back();
  const ValueRow figure = figure_of(output::study_key_figures(answers, unit_system("si")), "HIC15");
  EXPECT_EQ(figure.value, "136 to 946");  // the 5th and the 95th
}

TEST(StudyKeyFigures, OfAGridTheLeastAndTheGreatestWithTheirPlaces) {
  const std::vector<ValueRow> figures =
      output::study_key_figures(answers_of({300, 100, 200}, false), unit_system("si"));
  ASSERT_THAT(figures, SizeIs(2));
  EXPECT_EQ(figures[0].label, "Peak acceleration, lowest");
  EXPECT_EQ(figures[0].value, "10.2 g");
  EXPECT_EQ(figures[0].remark, "at impact speed 2 m/s");
  EXPECT_EQ(figures[1].value, "30.6 g");
}

TEST(StudyKeyFigures, OfIndicesTheLargestFirst) {
  study::StudyAnswers answers = answers_of({1, 2, 3}, true);
  answers.groups[0].sensitivities = {
      study::Sensitivity{.indices = {{.factor = "pad.thickness", .first = {}, .total = {0.024, 0.01, 0.04}},
                                     {.factor = "impactor.speed", .first = {}, .total = {0.76, 0.7, 0.8}}},
                         .draws = 3}};
  const std::vector<ValueRow> figures = output::study_key_figures(answers, unit_system("si"));
  EXPECT_EQ(figures.at(0).label, "Peak acceleration, due to the impact speed");
  EXPECT_EQ(figures.at(0).value, "76 %");
  EXPECT_EQ(figures.at(1).value, "2.4 %");
}

TEST(StudyKeyFigures, AreNotThereWithoutRows) {
  EXPECT_THAT(output::study_key_figures({}, unit_system("si")), IsEmpty());
}

/// With the share of rows above a limit, in g.
void ask_for(study::StudyAnswers& answers, double limit_in_g) {
  const double limit = limit_in_g * standard_gravity;
  std::vector<study::Reading> readings;
  for (const double peak : answers.records.responses[0]) readings.push_back({peak, peak});
  answers.limits.push_back({"peak_acceleration", limit});
  answers.groups[0].exceedances.push_back(study::exceedance(readings, limit));
}

std::string answer_to(const study::StudyAnswers& answers) {
  return output::study_answer(answers, unit_system("si"));
}

TEST(StudyAnswer, OverOneFactorSaysWhereTheLimitIsPassed) {
  study::StudyAnswers rising = answers_of({100, 200, 300, 400}, false);
  ask_for(rising, 25);
  EXPECT_EQ(answer_to(rising),
            "Peak acceleration exceeds 25 g if the impact speed is 3 m/s or more, but not at 2 m/s or less");
  study::StudyAnswers falling = answers_of({400, 300, 200, 100}, false);
  ask_for(falling, 25);
  EXPECT_EQ(answer_to(falling),
            "Peak acceleration exceeds 25 g if the impact speed is 2 m/s or less, but not at 3 m/s or more");
  study::StudyAnswers hump = answers_of({100, 300, 100}, false);
  ask_for(hump, 25);
  EXPECT_EQ(answer_to(hump), "Peak acceleration exceeds 25 g in 1 of 3 rows");
}

TEST(StudyAnswer, OverMaterialsNamesTheFewer) {
  study::StudyAnswers answers = answers_of({100, 200, 300}, false);
  answers.study.factors = {{.key = "pad.material", .unit = "", .spread = study::Levels{{0, 1, 2}}}};
  for (const char* name : {"soft", "firm", "hard"}) answers.study.materials.push_back({.name = name});
  answers.records.factors = {{0, 1, 2}};
  ask_for(answers, 15);
  EXPECT_EQ(answer_to(answers), "Peak acceleration exceeds 15 g with all but soft");
  answers.limits.clear();
  answers.groups[0].exceedances.clear();
  ask_for(answers, 25);
  EXPECT_EQ(answer_to(answers), "Peak acceleration exceeds 25 g with hard");
}

TEST(StudyAnswer, OverTwoFactorsSaysUpToWhereTheLimitIsKept) {
  study::StudyAnswers answers = answers_of({100, 200, 300, 300, 300, 300, 100, 100, 100}, false);
  answers.study.factors.push_back({.key = "pad.thickness", .unit = "m"});
  answers.records.factors = {{1, 2, 3, 1, 2, 3, 1, 2, 3}, {.03, .03, .03, .01, .01, .01, .06, .06, .06}};
  ask_for(answers, 25);
  EXPECT_EQ(answer_to(answers),
            "Peak acceleration stays within the limit of 25 g nowhere at 10 mm, and everywhere at 60 mm");
  answers.records.factors[1] = {.06, .06, .06, .01, .01, .01, .03, .03, .03};
  EXPECT_EQ(
      answer_to(answers),
      "Peak acceleration stays within the limit of 25 g nowhere at 10 mm, and up to somewhere between 2 m/s "
      "and 3 m/s at 60 mm; best at 30 mm, everywhere");
  // The optimum between the ends, as of density against thickness.
  answers = answers_of({300, 300, 100, 300, 100, 100, 300, 300, 300}, false);
  answers.study.factors.push_back({.key = "pad.thickness", .unit = "m"});
  answers.records.factors = {{1, 2, 3, 1, 2, 3, 1, 2, 3}, {.01, .01, .01, .03, .03, .03, .06, .06, .06}};
  ask_for(answers, 25);
  EXPECT_EQ(answer_to(answers),
            "Peak acceleration stays within the limit of 25 g from somewhere between 2 m/s and 3 m/s upwards "
            "at 10 mm, "
            "and nowhere at 60 mm; best at 30 mm, from somewhere between 1 m/s and 2 m/s upwards");
}

TEST(StudyAnswer, IndicesWithOverlappingIntervalsDecideNothing) {
  study::StudyAnswers answers = answers_of({1, 2, 3}, true);
  const auto with_low = [&](double low) {
    answers.groups[0].sensitivities = {
        study::Sensitivity{.indices = {{.factor = "pad.thickness", .first = {}, .total = {0.2, 0.1, 0.4}},
                                       {.factor = "impactor.speed", .first = {}, .total = {0.76, low, 0.8}}},
                           .draws = 3}};
    return answer_to(answers);
  };
  EXPECT_EQ(with_low(0.5),
            "Peak acceleration depends most on the impact speed, which explains 76 % of its variance");
  EXPECT_EQ(with_low(0.3),
            "The draws do not determine which factor affects peak acceleration most; it may be the impact "
            "speed");
}

TEST(StudyAnswer, OfDrawsThatBottomOutSaysHowManyFirst) {
  EXPECT_EQ(
      answer_to(answers_of({100, 200, HUGE_VAL, HUGE_VAL}, true)),
      "The pad bottoms out in 50 % of the draws; peak acceleration: half of the draws are below 20.4 g");
  EXPECT_EQ(answer_to(answers_of({100, 200, HUGE_VAL}, false)),
            "The pad bottoms out in 1 of 3 rows; in the others, peak acceleration is 10.2 to 20.4 g");
}

TEST(StudyAnswer, SpeaksOfTheLimitThatIsExceededMost) {
  study::StudyAnswers answers = answers_of({100, 200, 300, 400}, true);
  ask_for(answers, 35);
  ask_for(answers, 15);
  EXPECT_THAT(answer_to(answers), HasSubstr("Peak acceleration exceeds 15 g in 75 % of the draws"));
}

TEST(StudyAnswer, OfNoneOrAllOfTheDrawsGivesTheEndThatIsNotSure) {
  study::StudyAnswers above = answers_of({100, 200, 300, 400}, true), below = above;
  ask_for(above, 5);
  EXPECT_THAT(answer_to(above),
              AllOf(HasSubstr("Peak acceleration exceeds 5 g in all 4 draws (probability at "
                              "least "),
                    Not(HasSubstr("100 %"))));
  ask_for(below, 50);
  EXPECT_THAT(answer_to(below),
              AllOf(HasSubstr("Peak acceleration exceeds 50 g in none of the 4 draws (probability "
                              "at most "),
                    Not(HasSubstr(" 0 %"))));
}

TEST(StudyAnswer, OfSeveralCombinationsNamesTheBestAndTheWorst) {
  study::StudyAnswers answers = answers_of({100, 200, 300, 400}, true);
  answers.study.factors.front().spread = study::Levels{{1, 2}};
  ask_for(answers, 15);
  answers.groups.push_back(answers.groups.front());
  answers.groups[0].group.levels = {1};
  answers.groups[1].group.levels = {2};
  answers.groups[1].exceedances[0].probability.value = 0.1;
  EXPECT_EQ(
      answer_to(answers),
      "Peak acceleration exceeds 15 g in 10 % of the draws at impact speed 2 m/s, and in 75 % of the draws "
      "at impact speed 1 m/s");
}

TEST(StudyAnswer, OfDrawsAtSeveralLevelsTheMediansWithTheirPlaces) {
  study::StudyAnswers answers = answers_of({100, 200, 300}, true);
  answers.study.factors.front().spread = study::Levels{{1, 2}};
  answers.groups.push_back(answers.groups.front());
  answers.groups[0].group.levels = {1};
  answers.groups[1].group.levels = {2};
  answers.groups[1].distributions = {study::distribution(std::vector<double>{50, 100, 150}, true)};
  EXPECT_EQ(answer_to(answers),
            "The median peak acceleration ranges from 10.2 g at impact speed 2 m/s to 20.4 g at impact "
            "speed 1 m/s");
  EXPECT_EQ(output::study_key_figures(answers, unit_system("si")).at(1).value, "20.4 g");
}

TEST(StudyAnswer, OfASingleRowIsItsValue) {
  EXPECT_EQ(answer_to(answers_of({100}, false)), "Peak acceleration is 10.2 g");
}

TEST(StudyAnswer, SaysThatAllRowsBottomOut) {
  study::StudyAnswers answers = answers_of({HUGE_VAL, HUGE_VAL, HUGE_VAL}, false);
  answers.records.struck_through = 3;
  EXPECT_EQ(answer_to(answers), "The pad bottoms out in all 3 rows");
}

TEST(Capitals, FollowTheirPlaceInASentence) {
  EXPECT_EQ(output::capitalised("stiffness of the support"), "Stiffness of the support");
  EXPECT_EQ(output::uncapitalised("Peak force"), "peak force");
  EXPECT_EQ(output::uncapitalised("HIC15"), "HIC15");
}

}  // namespace
}  // namespace dashpad
