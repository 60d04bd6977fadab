// The validation as figures, tables and JSON, of a made-up study.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dashpad/report1986/validation_report.hpp"
#include "made_up_study.hpp"
#include "shared/markdown_table.hpp"

namespace dashpad {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const output::Series& series_of(const output::Plot& plot, const std::string& label, std::size_t panel = 0) {
  const auto& all = plot.panels.at(panel).series;
  const auto found = std::ranges::find(all, label, &output::Series::label);
  if (found == all.end()) throw std::out_of_range("no series " + label);
  return *found;
}

report1986::ValidationFigure figure(const std::string& slug) {
  for (const report1986::ValidationFigure& figure : report1986::validation_figures(test::made_up_study()))
    if (figure.slug == slug) return figure;
  throw std::out_of_range("no figure " + slug);
}

TEST(ValidationFigures, HaveTheirSlugsUnitsAndSource) {
  const auto figures = report1986::validation_figures(test::made_up_study());
  const auto slugs = report1986::validation_figure_slugs();
  ASSERT_EQ(figures.size(), slugs.size());
  for (std::size_t i = 0; i < figures.size(); ++i) {
    EXPECT_EQ(figures[i].slug, slugs[i]);
    EXPECT_THAT(figures[i].plot.source, HasSubstr("Volume III (1986)")) << slugs[i];
    for (const output::Panel& panel : figures[i].plot.panels) {
      EXPECT_THAT(panel.x.label, HasSubstr("(")) << slugs[i];
      EXPECT_FALSE(panel.series.empty()) << slugs[i];
    }
  }
}

TEST(ValidationFigures, DrawCertainReadingsOnly) {
  const report1986::ValidationFigure force = figure("figure-4-2");
  EXPECT_THAT(series_of(force.plot, "measured").y, ElementsAre(500, 3000));
  EXPECT_THAT(series_of(force.plot, "measured", 1).y, ElementsAre(4000));
  EXPECT_THAT(force.note, HasSubstr("2 readings of peak force whose test is unknown are left out"));
}

TEST(ValidationFigures, TheBandSpansTheRadiiAndTheLineIsAtOneOfThem) {
  const output::Plot plot = figure("figure-4-3").plot;
  const output::Series& band = series_of(plot, "accurate, range over nose radii");
  EXPECT_THAT(band.x, ElementsAre(10, 15, 20));
  EXPECT_THAT(band.y, ElementsAre(6000, 9000, 12000));
  EXPECT_THAT(band.y2, ElementsAre(16000, 24000, 32000));
  EXPECT_THAT(series_of(plot, "accurate, 2.50 in").y, ElementsAre(10000, 15000, 20000));
  EXPECT_THAT(series_of(plot, "1984 program, 2.50 in").y, ElementsAre(2500, 3750, 5000));
}

TEST(ValidationFigures, MarkTheReconstruction) {
  EXPECT_THAT(figure("figure-3-3").plot.panels[0].series[0].label, HasSubstr("RECONSTRUCTED"));
}

TEST(ValidationFigures, ShowTheRatioOfEachTest) {
  const output::Plot plot = figure("force-ratio").plot;
  EXPECT_THAT(series_of(plot, "accurate").x, ElementsAre(12, 18));
  EXPECT_THAT(series_of(plot, "accurate").y, ElementsAre(1.2, 0.5));
  EXPECT_THAT(series_of(plot, "report: its predictions divided by its trend", 1).y, ElementsAre(1.4, 0.4));
}

TEST(ValidationTables, ComeBackFromMarkdown) {
  const auto table =
      test::read_markdown(report1986::validation_markdown_tables(test::made_up_study()).at("verdict"));
  ASSERT_EQ(table.size(), 3U);
  EXPECT_THAT(table[0], testing::Contains("verdict"));
  EXPECT_THAT(table[1],
              ElementsAre("1984 program", "load cell", "all", "peak force", "2, plus 1 without prediction",
                          "-12.5 %", "25.0 %", "-20.0 % to +10.0 %", "20.0 % to 30.0 %", "0 of 6", "FAIL"));
  EXPECT_EQ(table[2].back(), "pass");
}

TEST(ValidationTables, CellsAreComparedByTheirLastDigit) {
  EXPECT_TRUE(test::same_cell("-12.5 % to 3", "-12.6 % to 4"));
  EXPECT_FALSE(test::same_cell("-12.5 %", "-12.7 %"));
  EXPECT_FALSE(test::same_cell("12.5 %", "12.5 in"));
  EXPECT_FALSE(test::same_cell("pass", "FAIL"));
}

TEST(ValidationJson, HasWhatTheStudyHas) {
  const auto json = nlohmann::json::parse(report1986::validation_json(test::made_up_study()));
  EXPECT_EQ(json["favoured_radius_in"], 2.5);
  EXPECT_EQ(json["verdicts"][0]["passed"], false);
  EXPECT_EQ(json["verdicts"][1]["errors"][1]["test"], 24);
  EXPECT_EQ(json["verdicts"][1]["errors"][1]["error"], -0.5);
  EXPECT_EQ(json["constants"][0]["confidence_95"]["low"], 1.6);
  EXPECT_EQ(json["tests"][3]["rebound_mph"], nullptr);
  EXPECT_EQ(json["tests"][3]["peak_force_lbf"], 4000);
  EXPECT_EQ(json["rebounds"][0]["too_high"], 1);
  EXPECT_EQ(json["anomaly"]["slope_halves"], true);
  EXPECT_EQ(json["anomaly"]["the_support_defect"], "does not explain it");
  EXPECT_EQ(json["nominal_stress"]["points"][1]["test"], nullptr);
  EXPECT_EQ(json["lost_readings"][0]["readings"][1], 636);
}

/// With one test there is neither a scatter nor a standard error.
TEST(ValidationJson, HasTheTestsHeldOut) {
  const auto json = nlohmann::json::parse(report1986::validation_json(test::made_up_study()))["held_out"];
  EXPECT_EQ(json["rebound_plate"]["bias"], 0.1);
  EXPECT_EQ(json["rebound_plate"]["standard_error"], nullptr);
  EXPECT_EQ(json["rebound_plate"]["scatter"], nullptr);
  EXPECT_EQ(json["rebound_plate"]["tests"], 1);
  EXPECT_EQ(json["rebound_plate"]["missing"], 1);
  EXPECT_EQ(json["rebound_plate"]["passed"], false);
  EXPECT_EQ(json["rebound_plate"]["errors"][0]["predicted"], 10.45);
  EXPECT_EQ(json["foam"]["plateau_stress_psi"], 43);
  EXPECT_EQ(json["folds"][1]["converged"], false);
  EXPECT_THAT(json["note"].get<std::string>(), HasSubstr("not a blind test"));
}

TEST(ValidationText, SaysThatTheTestsWereSeen) {
  const std::string text = output::to_markdown(report1986::validation_document(test::made_up_study()));
  EXPECT_THAT(text, HasSubstr("1, plus 1 without prediction"));
  EXPECT_THAT(text, HasSubstr("+10.0 %"));
  EXPECT_THAT(text, HasSubstr("not a blind test"));
}

TEST(ValidationVerdict, NeedsEveryRule) {
  report1986::Study study = test::made_up_study();
  EXPECT_FALSE(report1986::passes(study));  // the rebounds
  study.rebounds[0].passed = true;
  EXPECT_TRUE(report1986::passes(study));
  study.verdicts[1].score.passed = false;
  EXPECT_FALSE(report1986::passes(study));
  EXPECT_THAT(report1986::validation_document(study).lead->answer, HasSubstr("it meets 1 of 2"));
}

TEST(ValidationPage, BeginsWithTheVerdict) {
  const output::Document page =
      report1986::validation_document(test::made_up_study(), output::Pictures::drawn);
  ASSERT_TRUE(page.lead);
  EXPECT_THAT(page.lead->answer, HasSubstr("it meets 1 of 2"));
  EXPECT_EQ(page.sections.front().heading, "Verdict");
  EXPECT_THAT(page.warnings.front(), HasSubstr("UNKNOWN RADIUS"));
  std::size_t figures = 0;
  for (const output::Section& section : page.sections) figures += section.figures.size();
  EXPECT_EQ(figures, report1986::validation_figure_slugs().size());
}

}  // namespace
}  // namespace dashpad
