// Texts for other programs, read back by readers that know only the formats.

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/output/deck/exports.hpp"
#include "deck_readers.hpp"
#include "example_result.hpp"

namespace dashpad {
namespace {

using output::Curve;
using output::curve_csv;
using output::CurveFile;
using output::ls_dyna_text;
using output::radioss_text;
using namespace test;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

Curve awkward_curve() {
  return {"acceleration",
          {"time", "s"},
          {"acceleration", "m/s2"},
          {0, 1.0 / 3, 0.5, 1, 1e5 / 7},
          {-0.0, -1.0 / 3, 2.0 / 3e120, -1.23456789012345678e-91, 9.99999999999999e37}};
}

CurveFile file_of(std::vector<Curve> curves, const std::string& system = "kg-m-s") {
  CurveFile file;
  file.title = "A case";
  file.units = consistent_system(system);
  for (Curve& curve : curves) file.curves.push_back({std::move(curve), "a remark"});
  return file;
}

// ---------------------------------------------------------------- round trips

TEST(LsDyna, GivesBackTheCurvesOnReading) {
  const Curve curve = awkward_curve();
  CurveFile file = file_of({curve, curve});
  file.first_id = 9001;
  const KeywordFile read = read_keywords(ls_dyna_text(file));
  EXPECT_THAT(read.keywords, ElementsAre("*KEYWORD", "*DEFINE_CURVE_TITLE", "*DEFINE_CURVE_TITLE", "*END"));
  EXPECT_THAT(ls_dyna_text(file), HasSubstr("\n$ Dashpad: A case\n"));
  ASSERT_EQ(read.curves.size(), 2u);
  EXPECT_EQ(read.curves[0].id, 9001);
  EXPECT_EQ(read.curves[1].id, 9002);
  EXPECT_THAT(read.curves[0].card, ElementsAre(0, 1, 1, 0, 0, 0));
  EXPECT_EQ(read.curves[0].title, "Dashpad acceleration: acceleration (m/s2) against time (s)");
  ASSERT_EQ(read.curves[0].x.size(), curve.size());
  for (std::size_t i = 0; i < curve.size(); ++i) {
    EXPECT_NEAR(read.curves[0].x[i], curve.x[i], 5e-14 * curve.x[i]);
    EXPECT_NEAR(read.curves[0].y[i], curve.y[i], 5e-13 * std::abs(curve.y[i]));
  }
}

TEST(Radioss, GivesBackTheCurvesOnReading) {
  const Curve curve = awkward_curve();
  CurveFile file = file_of({curve, curve});
  file.first_id = 9001;
  const std::vector<ReadCurve> read = read_blocks(radioss_text(file));
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[1].id, 9002);
  EXPECT_EQ(read[1].title, "Dashpad acceleration: acceleration (m/s2) against time (s)");
  ASSERT_EQ(read[1].x.size(), curve.size());
  for (std::size_t i = 0; i < curve.size(); ++i) {
    EXPECT_NEAR(read[1].x[i], curve.x[i], 5e-14 * curve.x[i]);
    EXPECT_NEAR(read[1].y[i], curve.y[i], 5e-13 * std::abs(curve.y[i]));
  }
}

TEST(Decks, LeaveABlankBetweenColumns) {
  for (const auto text : {ls_dyna_text, radioss_text})
    for (const std::string& line : lines_of(text(file_of({awkward_curve()})))) {
      if (line.size() != 40 || line[0] == '$' || line[0] == '#') continue;
      EXPECT_EQ(line[0], ' ');
      EXPECT_EQ(line[20], ' ');
    }
}

TEST(CurveCsv, GivesBackTheVerySameNumbers) {
  const Curve curve = awkward_curve();
  const CsvColumns read = read_csv(curve_csv(file_of({curve})));
  EXPECT_EQ(read.header, "time_s,acceleration_m_per_s2");
  EXPECT_EQ(read.x, curve.x);
  EXPECT_EQ(read.y, curve.y);
}

TEST(Exports, AreInTheUnitsAskedFor) {
  const Curve force{"loading", {"penetration", "m"}, {"force", "N"}, {0, 0.0254}, {0, 4448.2216152605}};
  const ReadCurve crash = read_blocks(radioss_text(file_of({force}, "kg-mm-ms"))).front();
  EXPECT_NEAR(crash.x[1], 25.4, 1e-12);
  EXPECT_NEAR(crash.y[1], 4.4482216152605, 1e-12);
  const ReadCurve inches = read_keywords(ls_dyna_text(file_of({force}, "lbf-s2/in-in-s"))).curves.front();
  EXPECT_NEAR(inches.x[1], 1, 1e-13);
  EXPECT_NEAR(inches.y[1], 1000, 1e-10);
  EXPECT_EQ(inches.title, "Dashpad loading: force (lbf) against penetration (in)");
  EXPECT_EQ(read_csv(curve_csv(file_of({force}, "t-mm-s"))).header, "penetration_mm,force_N");
}

TEST(Exports, GiveAccelerationsInGIfAsked) {
  const Curve curve{
      "acceleration", {"time", "s"}, {"acceleration", "m/s2"}, {0, 1}, {0, -3 * standard_gravity}};
  CurveFile file = file_of({curve}, "kg-mm-ms");
  EXPECT_NEAR(read_csv(curve_csv(file)).y[1], -3e-3 * standard_gravity, 1e-15);
  file.acceleration_in_g = true;
  EXPECT_EQ(read_csv(curve_csv(file)).header, "time_ms,acceleration_g");
  EXPECT_NEAR(read_csv(curve_csv(file)).y[1], -3, 1e-14);
  EXPECT_THAT(ls_dyna_text(file), HasSubstr("acceleration g"));
}

// ---------------------------------------------------------------- what the files say

TEST(Exports, SayWhenceTheyComeAndWhatToMind) {
  CurveFile file = file_of({awkward_curve()});
  file.origin = {"A sphere strikes"};
  file.flags = {"EXTRAPOLATED: strain reaches 0.96"};
  for (const auto text : {ls_dyna_text, radioss_text, curve_csv}) {
    const char mark = text == ls_dyna_text ? '$' : '#';
    const auto comment = [&](const std::string& words) {
      return HasSubstr(std::string(1, mark) + " " + words);
    };
    EXPECT_THAT(text(file),
                AllOf(comment("Dashpad "), comment("Case: A case"), comment("A sphere strikes"),
                      comment("Units: kg-m-s"), comment("Signs: force and penetration are positive in"),
                      comment("FLAG: EXTRAPOLATED: strain reaches 0.96"), HasSubstr("a remark")));
  }
  EXPECT_THAT(radioss_text(file), HasSubstr("# Units of mass, length and time, as in /BEGIN: kg m s\n"));
}

TEST(Exports, FlagWhatIsNotToBeReliedOn) {
  EXPECT_THAT(output::flags_of(test::example_summary()), IsEmpty());
  Summary summary = test::example_summary();
  summary.status = Status::tolerance_not_met;
  summary.extrapolations = {{Beyond::strain, "one"}};
  EXPECT_THAT(output::flags_of(summary), ElementsAre(StartsWith("TOLERANCE NOT MET: a tolerance of 0.01 %"),
                                                     StartsWith("EXTRAPOLATED STRAIN: ")));
  EXPECT_THAT(output::flags_of(test::bottomed_out_summary()),
              ElementsAre(StartsWith("BOTTOMED at 5.9307 ms")));
  summary = test::example_summary();
  summary.bottomed = Moment{.time = 0.005, .velocity = 1};
  summary.extrapolations = {{Beyond::strain, "one"}, {Beyond::rate, "two"}};
  EXPECT_THAT(output::flags_of(summary),
              ElementsAre(AllOf(StartsWith("BOTTOMED at 5 ms"), HasSubstr("support")),
                          "EXTRAPOLATED STRAIN: one", "EXTRAPOLATED RATE: two"));
  summary = test::example_summary();
  summary.status = Status::time_limit;
  EXPECT_THAT(output::flags_of(summary), ElementsAre(StartsWith("TIME LIMIT: ")));
}

TEST(Exports, KeepTheNumberOfACurveThatIsNotThere) {
  CurveFile file = file_of({awkward_curve(), {}, awkward_curve()});
  file.curves[1].remark = "not there: a reason";
  const KeywordFile read = read_keywords(ls_dyna_text(file));
  ASSERT_EQ(read.curves.size(), 2u);
  EXPECT_EQ(read.curves[1].id, 3);
  EXPECT_EQ(read_blocks(radioss_text(file)).at(1).id, 3);
  EXPECT_THAT(ls_dyna_text(file), HasSubstr("not there: a reason"));
}

TEST(Exports, OfASolutionSayHowItWasThinned) {
  Solution solution;
  solution.summary = test::bottomed_out_summary();
  solution.history.time = {0, 1, 2, 3};
  solution.history.force = {0, 1, 2.02, 3};
  solution.history.penetration = {0, 1, 2, 3};
  const CurveFile file =
      output::curve_file(test::example_case(), solution, {"force", "unloading", "loading"}, 2);
  EXPECT_EQ(file.title, "Head on a dashboard");
  EXPECT_THAT(file.origin, Contains(StartsWith("A sphere of mass 4.5 kg")));
  EXPECT_THAT(file.flags, Contains(StartsWith("BOTTOMED")));
  // 0.02 of 3, rounded up.
  EXPECT_EQ(file.curves[0].remark, "2 of 4 points, off by at most 0.67 % of the largest value");
  EXPECT_EQ(file.curves[1].remark, "not available: the impactor did not leave the pad (bottomed out)");
  EXPECT_THAT(file.curves[2].remark, HasSubstr("valid for this impact only"));
  EXPECT_THROW(output::curve_file(test::example_case(), solution, {"power"}), std::invalid_argument);
}

// ---------------------------------------------------------------- foreign text

TEST(Exports, CannotBeBrokenByForeignText) {
  const std::vector<std::string> hostile{
      "\n*END\n*DEFINE_CURVE\n",
      "*KEYWORD",
      "$ comment",
      "/END",
      "#include /etc/passwd",
      "\r\n/FUNCT/7\r\nmine",
      "caf\xc3\xa9 \xe2\x80\xa8 \xf0\x9f\x9a\x97 \xff\xfe\x80",
      std::string("nul\0byte", 8),
      std::string(5000, '*'),
      std::string(5000, ' ') + "*END",
      std::string(75, ' ') + "*END /END #include",
      std::string(300, 'x') + " /END",
      "&parameter <1+1> %s {} \x1b[31m",
      "",
      "   ",
  };
  for (const std::string& words : hostile) {
    CurveFile file = file_of({awkward_curve()});
    file.title = words;
    file.origin = {words};
    file.flags = {words};
    file.curves[0].remark = words;
    const std::string deck = ls_dyna_text(file), blocks = radioss_text(file), csv = curve_csv(file);
    EXPECT_THAT(read_keywords(deck).keywords, ElementsAre("*KEYWORD", "*DEFINE_CURVE_TITLE", "*END"));
    EXPECT_EQ(read_keywords(deck).curves.at(0).x.size(), 5u);
    EXPECT_EQ(read_blocks(blocks).at(0).x.size(), 5u);
    EXPECT_EQ(read_blocks(blocks).size(), 1u);
    EXPECT_EQ(read_csv(csv).x.size(), 5u);
    EXPECT_EQ(read_csv(csv).header, "time_s,acceleration_m_per_s2");
    for (const std::string& text : {deck, blocks, csv}) {
      EXPECT_TRUE(std::ranges::all_of(text, [](char c) { return c == '\n' || (c >= 0x20 && c < 0x7f); }))
          << words;
      EXPECT_THAT(text, Not(HasSubstr("&")));
      for (const std::string& line : lines_of(text)) EXPECT_LE(line.size(), 80u) << line;
    }
  }
}

TEST(Exports, KeepWhatCanBeKeptOfForeignText) {
  CurveFile file = file_of({awkward_curve()});
  file.title = "Schl\xc3\xa4ge: 20 mph";
  EXPECT_THAT(ls_dyna_text(file), HasSubstr("\n$ Dashpad: Schl?ge: 20 mph\n"));
}

// ---------------------------------------------------------------- what is refused

TEST(Exports, RefuseWhatNoDeckCanHold) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto with = [](std::vector<double> x, std::vector<double> y) {
    return file_of({Curve{"force", {"time", "s"}, {"force", "N"}, std::move(x), std::move(y)}});
  };
  for (const auto text : {ls_dyna_text, radioss_text, curve_csv}) {
    EXPECT_THROW(text(with({0, 1, 1}, {0, 1, 2})), std::invalid_argument);
    EXPECT_THROW(text(with({0, 2, 1}, {0, 1, 2})), std::invalid_argument);
    EXPECT_THROW(text(with({0, 1, 1 + 1e-15}, {0, 1, 2})), std::invalid_argument);
    EXPECT_THROW(text(with({0, 1}, {0, infinity})), std::invalid_argument);
    EXPECT_THROW(text(with({0, 1}, {0, 1, 2})), std::invalid_argument);
  }
}

TEST(Exports, RefuseNumbersThatDoNotFit) {
  for (const auto text : {ls_dyna_text, radioss_text}) {
    CurveFile file = file_of({awkward_curve(), awkward_curve()});
    for (const int id : {0, -1, output::highest_curve_id, std::numeric_limits<int>::max()}) {
      file.first_id = id;
      EXPECT_THROW(text(file), std::invalid_argument) << id;
    }
    file.first_id = output::highest_curve_id - 1;
    EXPECT_NO_THROW(text(file));
  }
  CurveFile last = file_of({awkward_curve()});
  last.first_id = output::highest_curve_id;
  EXPECT_EQ(read_keywords(ls_dyna_text(last)).curves.front().id, output::highest_curve_id);
}

TEST(CurveCsv, HoldsOneCurve) {
  EXPECT_THROW(curve_csv(file_of({})), std::invalid_argument);
  EXPECT_THROW(curve_csv(file_of({awkward_curve(), awkward_curve()})), std::invalid_argument);
}

}  // namespace
}  // namespace dashpad
