// Critical fall heights of drops: curves, limits, places, counted drops, and the table.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "dashpad/fall_height/fall_height.hpp"
#include "dashpad/input/standard_file.hpp"
#include "dashpad/quantities/constants.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad::test {
namespace {

using fall_height::Answer;
using fall_height::Crossing;
using fall_height::DropTable;
using testing::ElementsAre;
using testing::HasSubstr;

injury::Standard preset_called(const std::string& name) {
  return input::read_standard(std::string(DASHPAD_SOURCE_DIR "/standards/") + name + ".toml").value();
}

/// A standard that limits HIC to 1000 and nothing else.
injury::Standard hic_of_1000() {
  injury::Standard standard;
  standard.criteria = {
      {.quantity = &result_quantity("hic_unlimited"), .limit = 1000, .description = {}, .origin = {}}};
  return standard;
}

void add_drop(DropTable& table, double height, double hic, int number = 0,
              const std::vector<fall_height::Remark>& remarks = {}) {
  table.drops.push_back(
      {.height = height, .figures = {hic}, .doubts = {0}, .number = number, .remarks = remarks});
}

const Crossing& crossing_of(const Answer& answer) { return answer.places.front().crossings.front(); }

bool has_flag(const std::vector<Flag>& flags, const std::string& name) {
  return std::ranges::find(flags, name, &Flag::name) != flags.end();
}

TEST(FallHeight, OfAPowerIsThatOfThePower) {
  DropTable table;
  for (const double height : {1.0, 1.5, 2.0, 2.5}) add_drop(table, height, 400 * std::pow(height, 1.4));
  const Answer answer = evaluated(table, hic_of_1000());
  const Crossing& crossing = crossing_of(answer);
  ASSERT_TRUE(crossing.height);
  EXPECT_NEAR(*crossing.height, std::pow(2.5, 1 / 1.4), 1e-9);
  EXPECT_EQ(crossing.curve->terms, 2);
  EXPECT_NEAR(crossing.curve->coefficients[1], 1.4, 1e-9);
  EXPECT_DOUBLE_EQ(crossing.below.value(), 1.5);
  EXPECT_DOUBLE_EQ(crossing.above.value(), 2);
  ASSERT_TRUE(crossing.interval);
  EXPECT_NEAR(crossing.interval->first, *crossing.height, 1e-6);
  EXPECT_NEAR(crossing.interval->second, *crossing.height, 1e-6);
}

TEST(FallHeight, IsKnownIfTheLastDropJustExceedsTheLimit) {
  DropTable table;
  for (const auto& [height, hic] : {std::pair{0.6, 300.0}, {0.9, 475.0}, {1.2, 700.0}, {1.5, 1020.0}})
    add_drop(table, height, hic);
  const Answer answer = evaluated(table, hic_of_1000());
  const Crossing& crossing = crossing_of(answer);
  ASSERT_TRUE(crossing.height);
  EXPECT_GT(*crossing.height, 1.5);
  EXPECT_LT(*crossing.height, 1.5 / 0.9);
  EXPECT_DOUBLE_EQ(crossing.below.value(), 1.2);
  EXPECT_DOUBLE_EQ(crossing.above.value(), 1.5);
  EXPECT_FALSE(has_flag(answer.places.front().flags, "LIMIT NOT ENCLOSED"));
}

TEST(FallHeight, OfABendIsThatOfTheBend) {
  DropTable table;
  const auto hic = [](double height) {
    const double x = std::log(height / 2);
    return 900 * std::exp(2 * x + 0.8 * x * x);
  };
  for (const double height : {1.2, 1.5, 1.8, 2.1, 2.3}) add_drop(table, height, hic(height));
  const Answer answer = evaluated(table, hic_of_1000());
  const Crossing& crossing = crossing_of(answer);
  EXPECT_EQ(crossing.curve->terms, 3);
  EXPECT_NEAR(hic(crossing.height.value()), 1000, 1e-6);
}

TEST(FallHeight, OfAScatterHasTheIntervalOfStudentsT) {
  // Two terms: y = ln f is 0.02 beside a line, in turn. By hand: s^2 = sum r^2 / (n - 2).
  DropTable table;
  const std::vector<double> heights{1, 2, 3, 4};
  const std::vector<double> off{0.02, -0.02, -0.02, 0.02};
  for (std::size_t i = 0; i < heights.size(); ++i)
    add_drop(table, heights[i], std::exp(std::log(400) + 1.2 * std::log(heights[i]) + off[i]));
  const Answer answer = evaluated(table, hic_of_1000());
  const Crossing& crossing = crossing_of(answer);
  const auto& curve = *crossing.curve;
  EXPECT_EQ(curve.freedom, 2u);
  double mean = 0, squares = 0, left = 0;
  for (const double height : heights) mean += std::log(height) / 4;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    squares += std::pow(std::log(heights[i]) - mean, 2);
    const double value = std::log(400) + 1.2 * std::log(heights[i]) + off[i];
    left += std::pow(value - std::log(curve.at(heights[i])), 2);
  }
  const double t = 4.302653;  // two-sided 95 %, two degrees of freedom, from tables
  EXPECT_NEAR(curve.deviation, std::sqrt(left / 2), 1e-12);
  for (const double height : {1.0, 2.2, 5.0})
    EXPECT_NEAR(curve.half_width(height),
                t * curve.deviation * std::sqrt(0.25 + std::pow(std::log(height) - mean, 2) / squares), 1e-6);
  const auto [low, high] = crossing.interval.value();
  EXPECT_NEAR(std::log(curve.at(low)) + curve.half_width(low), std::log(1000), 1e-9);
  EXPECT_NEAR(std::log(curve.at(high)) - curve.half_width(high), std::log(1000), 1e-9);
}

TEST(FallHeight, HasTheDoubtOfTheInstrument) {
  DropTable table;
  for (const double height : {1.0, 1.5, 2.0, 2.5}) add_drop(table, height, 400 * std::pow(height, 1.4));
  for (fall_height::Drop& drop : table.drops) drop.doubts = {0.05};
  const Answer answer = evaluated(table, hic_of_1000());
  const auto [low, high] = crossing_of(answer).interval.value();
  EXPECT_NEAR(low, std::pow(2.5 / 1.05, 1 / 1.4), 1e-6);
  EXPECT_NEAR(high, std::pow(2.5 * 1.05, 1 / 1.4), 1e-6);
}

TEST(FallHeight, IsNoneWhereNoDropExceedsTheLimit) {
  DropTable table;
  for (const double height : {1.0, 1.2, 1.4}) add_drop(table, height, 500 * std::pow(height, 1.4));
  const Answer answer = evaluated(table, hic_of_1000());
  const Crossing& crossing = crossing_of(answer);
  EXPECT_FALSE(crossing.is_enclosed());
  EXPECT_FALSE(crossing.is_exceeded);
  EXPECT_NEAR(crossing.height.value(), std::pow(2, 1 / 1.4), 1e-9);  // by the curve
  EXPECT_TRUE(has_flag(answer.places.front().flags, "LIMIT NOT ENCLOSED"));
}

TEST(FallHeight, OfTwoDropsHasNoInterval) {
  DropTable table;
  add_drop(table, 1, 500);
  add_drop(table, 3, 1500);
  const Answer answer = evaluated(table, hic_of_1000());
  EXPECT_NEAR(crossing_of(answer).height.value(), 2, 1e-9);
  EXPECT_FALSE(crossing_of(answer).interval);
  EXPECT_TRUE(has_flag(answer.places.front().flags, "FEW DROPS"));
}

TEST(FallHeight, OfOneHeightIsUnknown) {
  DropTable table;
  add_drop(table, 2, 990);
  add_drop(table, 2, 1010);
  const Answer answer = evaluated(table, hic_of_1000());
  EXPECT_FALSE(crossing_of(answer).height);
  EXPECT_FALSE(crossing_of(answer).curve);
}

TEST(FallHeight, OfFiguresThatFallIsUnknown) {
  DropTable table;
  for (const double height : {1.0, 1.5, 2.0}) add_drop(table, height, 1500 / height);
  const Answer answer = evaluated(table, hic_of_1000());
  EXPECT_FALSE(crossing_of(answer).height);
}

TEST(FallHeight, TheLowestPlaceCounts) {
  DropTable table;
  for (const double height : {1.0, 1.5, 2.0, 2.5}) {
    add_drop(table, height, 400 * std::pow(height, 1.4), 0, {{"Position", "centre"}, {"operator", "M"}});
    add_drop(table, height, 500 * std::pow(height, 1.4), 0, {{"Position", "edge"}, {"operator", "M"}});
  }
  const Answer answer = evaluated(table, hic_of_1000());
  ASSERT_EQ(answer.places.size(), 2u);
  EXPECT_EQ(answer.lowest, 1u);
  EXPECT_EQ(answer.places[1].remarks, (std::vector<fall_height::Remark>{{"Position", "edge"}}));
  EXPECT_EQ(answer.common, (std::vector<fall_height::Remark>{{"operator", "M"}}));
  EXPECT_NEAR(answer.decides().height.value(), std::pow(2, 1 / 1.4), 1e-9);
}

TEST(FallHeight, OfAPlaceAboveTheLimitIsTheLowest) {
  DropTable table;
  for (const double height : {1.0, 1.5, 2.0}) {
    add_drop(table, height, 400 * std::pow(height, 1.4), 0, {{"position", "centre"}});
    add_drop(table, height, 1500 * std::pow(height, 0.1), 0, {{"position", "seam"}});
  }
  const Answer answer = evaluated(table, hic_of_1000());
  EXPECT_EQ(answer.lowest, 1u);
  EXPECT_FALSE(answer.decides().is_kept);
}

TEST(FallHeight, APlaceThatFailsEverywhereHidesNoLowerHeight) {
  // At B all that is known is that its height is below 2 m, which may be below that of A: A's, with a doubt.
  DropTable table;
  for (const double height : {1.0, 1.2, 1.5, 1.8})
    add_drop(table, height, 400 * std::pow(height, 2), 0, {{"position", "A"}});
  add_drop(table, 2, 1100, 0, {{"position", "B"}});
  const Answer answer = evaluated(table, hic_of_1000());
  EXPECT_EQ(answer.lowest, 0u);
  EXPECT_NEAR(answer.decides().height.value(), std::sqrt(2.5), 1e-9);
  EXPECT_TRUE(has_flag(answer.places[1].flags, "LIMIT NOT ENCLOSED"));
  EXPECT_FALSE(answer.is_sure());
}

TEST(FallHeight, IsInDoubtWhereAPlaceWasNotTestedSoHigh) {
  DropTable table;
  for (const double height : {1.0, 1.2, 1.5, 1.8})
    add_drop(table, height, 400 * std::pow(height, 2), 0, {{"position", "A"}});
  EXPECT_TRUE(evaluated(table, hic_of_1000()).is_sure());
  add_drop(table, 1, 300, 0, {{"position", "B"}});
  const Answer answer = evaluated(table, hic_of_1000());
  EXPECT_EQ(answer.lowest, 0u);
  EXPECT_TRUE(has_flag(answer.places[1].flags, "LIMIT NOT ENCLOSED"));
  EXPECT_FALSE(answer.is_sure());
  table.drops.back().height = 2;  // tested higher, and kept there
  EXPECT_TRUE(evaluated(table, hic_of_1000()).is_sure());
}

TEST(FallHeight, SaysThatADropFailedFarBelow) {
  DropTable table;
  for (const double height : {1.2, 1.4, 1.6, 1.8, 2.0, 2.2, 2.4})
    add_drop(table, height, 290 * std::pow(height, 2));
  EXPECT_TRUE(evaluated(table, hic_of_1000()).is_sure());
  add_drop(table, 1.4, 1010);
  const Answer answer = evaluated(table, hic_of_1000());
  EXPECT_TRUE(has_flag(answer.places.front().flags, "SCATTERED DROPS"));
  EXPECT_FALSE(answer.is_sure());
}

TEST(FallHeight, ALimitWithoutFiguresDoesNotDecide) {
  injury::Standard two = hic_of_1000();
  two.criteria.insert(two.criteria.begin(), {.quantity = &result_quantity("peak_acceleration"),
                                             .limit = 200 * standard_gravity,
                                             .description = {},
                                             .origin = {}});
  DropTable table;
  table.drops.push_back({.height = 1.5, .figures = {std::nan(""), 500}, .doubts = {0, 0}});
  const Answer answer = evaluated(table, two);
  EXPECT_EQ(answer.decides().criterion, 1u);
  EXPECT_TRUE(has_flag(answer.places.front().flags, "FIGURE MISSING"));
  EXPECT_TRUE(has_flag(answer.places.front().flags, "LIMIT NOT ENCLOSED"));
}

TEST(FallHeight, OneTemperatureWrittenInTwoWaysIsOnePlace) {
  DropTable table;
  add_drop(table, 1, 300, 0, {{"temperature [degC]", "23"}});
  add_drop(table, 2, 1300, 0, {{"temperature [degC]", "23.0"}});
  EXPECT_EQ(evaluated(table, hic_of_1000()).places.size(), 1u);
}

TEST(FallHeight, AsF1292CountsDropsTwoAndThree) {
  const injury::Standard standard = preset_called("astm-f1292");
  ASSERT_TRUE(standard.drop_series);
  EXPECT_THAT(standard.drop_series->counted, ElementsAre(2, 3));
  EXPECT_DOUBLE_EQ(standard.drop_series->step, 0.3048);
  injury::Standard one = hic_of_1000();
  one.drop_series = standard.drop_series;
  DropTable table;
  for (const double height : {1.0, 1.5, 2.0, 2.5}) {
    const double hic = 400 * std::pow(height, 1.4);
    add_drop(table, height, 0.8 * hic);
    add_drop(table, height, 0.97 * hic);
    add_drop(table, height, 1.03 * hic);
  }
  const Answer answer = evaluated(table, one);
  EXPECT_EQ(crossing_of(answer).points.size(), 4u);
  EXPECT_NEAR(crossing_of(answer).height.value(), std::pow(2.5, 1 / 1.4), 1e-9);
  EXPECT_FALSE(has_flag(answer.places.front().flags, "DROPS NOT COUNTED"));
  DropTable missing = table, twice = table;
  missing.drops.erase(missing.drops.begin() + 1);
  EXPECT_TRUE(has_flag(evaluated(missing, one).places.front().flags, "DROPS NOT COUNTED"));
  for (fall_height::Drop& drop : twice.drops) drop.number = 2;
  EXPECT_TRUE(has_flag(evaluated(twice, one).places.front().flags, "DROPS NOT COUNTED"));
}

TEST(FallHeight, OverAWideRangeUsesTheDropsNearby) {
  DropTable table;
  const auto hic = [](double height) { return 1000 * std::exp(2 * std::sinh(std::log(height / 2))); };
  for (int i = 0; i < 20; ++i) add_drop(table, 0.8 * std::pow(1.1, i), hic(0.8 * std::pow(1.1, i)));
  const Answer answer = evaluated(table, hic_of_1000());
  EXPECT_LT(crossing_of(answer).near.size(), crossing_of(answer).points.size());
  EXPECT_NEAR(crossing_of(answer).height.value(), 2, 2e-3);
}

class FallHeightTable : public testing::Test {
 protected:
  input::Reading<DropTable> read(const std::string& text) {
    std::ofstream(folder_.path() / "drops.csv") << text;
    return fall_height::read_drops(folder_.path() / "drops.csv", preset_called("en-1177"));
  }
  std::vector<std::string> faults(const std::string& text) {
    std::vector<std::string> lines;
    const auto table = read(text);
    if (!table)
      for (const input::Fault& fault : table.faults())
        lines.push_back(std::to_string(fault.line) + " " + fault.key + ": " + fault.rule);
    return lines;
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(FallHeightTable, KnowsNamesAsLaboratoriesWriteThem) {
  for (const std::string header :
       {"Height [m],HIC,gmax", "drop_height [m],hic_unlimited,peak_acceleration [g]",
        "Fall height [m],HIC,g-max [g]", "drop_height_m,hic,gmax_g", "HEIGHT [m],HIC,GMAX",
        "height [m],HIC,Gmax (g)"}) {
    const auto table = read(header + ",Operator\n1.5,600,120,M\n");
    ASSERT_TRUE(table) << header << ": " << table.faults().front().rule;
    const fall_height::Drop& drop = table->drops.front();
    EXPECT_DOUBLE_EQ(drop.height, 1.5) << header;
    EXPECT_DOUBLE_EQ(drop.figures[0], 120 * standard_gravity) << header;
    EXPECT_DOUBLE_EQ(drop.figures[1], 600) << header;
    EXPECT_THAT(drop.remarks, ElementsAre(fall_height::Remark("Operator", "M")));
  }
  EXPECT_DOUBLE_EQ(read("drop_height [cm];hic\n150,5;600\n").value().drops.front().height, 1.505);
}

TEST_F(FallHeightTable, KeepsWhatOnlyBeginsLikeAName) {
  const auto table = read("height [m],hic,drop date,file name,Drop ID,hic limit\n1.5,600,today,a,7,x\n");
  ASSERT_TRUE(table) << table.faults().front().rule;
  EXPECT_EQ(table->drops.front().remarks.size(), 4u);
  EXPECT_EQ(table->drops.front().number, 0);
}

TEST_F(FallHeightTable, HasAFaultForEachThatIsWrong) {
  EXPECT_THAT(faults("position,height [m],hic\nA,1,300\n,2,1300\n"),
              ElementsAre(HasSubstr("3 position: is empty")));
  EXPECT_THAT(faults("hic,operator\n600,M\n"), ElementsAre(HasSubstr("drop_height: is missing")));
  EXPECT_THAT(faults("drop_height [m],operator\n1,M\n"),
              ElementsAre(HasSubstr("names neither files of pulses")));
  EXPECT_THAT(faults("drop_height [m],height [m],hic\n1,1,600\n"),
              ElementsAre(HasSubstr("the same as another")));
  EXPECT_THAT(faults("drop_height,hic\n1,600\n"), ElementsAre(HasSubstr("needs a unit")));
  EXPECT_THAT(faults("drop_height [m],hic,file\n-1,600,\n1,,\n1,600,a.csv\n1,-5,\n"),
              ElementsAre(HasSubstr("2 drop_height: is -1 m; must be more than 0"),
                          HasSubstr("3 : has neither the file of a pulse nor a figure"),
                          HasSubstr("4 : has the file of a pulse and figures"),
                          HasSubstr("5 hic: must be more than 0")));
  EXPECT_THAT(faults("drop_height [m],hic,drop\n1,600,1.5\n"),
              ElementsAre(HasSubstr("must be a whole number")));
  EXPECT_THAT(faults("drop_height [m],hic\n"), ElementsAre(HasSubstr("no rows")));
}

}  // namespace
}  // namespace dashpad::test
