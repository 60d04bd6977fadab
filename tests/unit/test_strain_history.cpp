/// The histories of material tests, and what is refused.

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "dashpad/laboratory/column_test.hpp"
#include "laboratory/arc.hpp"

namespace dashpad::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> keys(const laboratory::StrainHistory& history) {
  std::vector<std::string> result;
  for (const Violation& v : laboratory::violations(history)) result.push_back(v.key);
  return result;
}

double end_of(const laboratory::StrainPiece& piece) { return piece.strain_at(piece.duration); }

TEST(StrainHistory, OfAConstantRateGoesUpAndDown) {
  const laboratory::StrainHistory test = laboratory::constant_rate_test(50, 0.8);
  ASSERT_EQ(test.pieces.size(), 2u);
  EXPECT_EQ(test.pieces[0].duration, 0.8 / 50);
  EXPECT_EQ(test.pieces[0].rate, 50);
  EXPECT_EQ(test.pieces[1].rate, -50);
  EXPECT_DOUBLE_EQ(end_of(test.pieces[0]), 0.8);
  EXPECT_NEAR(end_of(test.pieces[1]), 0, 1e-15);
}

/// Report, Eqs. 30 and 31: t0 = strain / rate, twice the mean rate at first.
TEST(StrainHistory, OfAParabolaHasTheMeanRateOnTheWayUp) {
  const laboratory::StrainHistory test = laboratory::parabolic_test(100, 0.95);
  ASSERT_EQ(test.pieces.size(), 1u);
  const laboratory::StrainPiece& piece = test.pieces[0];
  EXPECT_DOUBLE_EQ(piece.duration, 2 * 0.0095);
  EXPECT_EQ(piece.rate_at(0), 200);
  EXPECT_NEAR(piece.rate_at(0.0095), 0, 1e-12);
  EXPECT_DOUBLE_EQ(piece.strain_at(0.0095), 0.95);
  EXPECT_DOUBLE_EQ(piece.strain_at(0.00475), 0.75 * 0.95);
  EXPECT_NEAR(end_of(piece), 0, 1e-15);
}

TEST(StrainHistory, OfCyclesComesBackToTheLowStrain) {
  const laboratory::StrainHistory test = laboratory::cyclic_test(10, 0.6, 0.2, 3);
  ASSERT_EQ(test.pieces.size(), 6u);
  EXPECT_EQ(test.pieces[0].strain, 0);
  for (int i : {2, 4}) EXPECT_EQ(test.pieces[static_cast<std::size_t>(i)].strain, 0.2);
  EXPECT_DOUBLE_EQ(end_of(test.pieces[5]), 0.2);
  EXPECT_DOUBLE_EQ(test.pieces[1].duration, 0.04);
}

TEST(StrainHistory, OfARampIsHeld) {
  const laboratory::StrainHistory test = laboratory::ramp_and_hold_test(10, 0.6, 3);
  ASSERT_EQ(test.pieces.size(), 2u);
  EXPECT_EQ(test.pieces[1].duration, 3);
  EXPECT_EQ(test.pieces[1].strain, 0.6);
  EXPECT_EQ(test.pieces[1].rate, 0);
}

TEST(StrainHistory, OfPointsIsStraightBetweenThem) {
  const laboratory::StrainHistory test = laboratory::measured_test({2, 2.5, 2.75}, {0, 0.5, 0.25});
  ASSERT_EQ(test.pieces.size(), 2u);
  EXPECT_EQ(test.pieces[0].rate, 1);
  EXPECT_EQ(test.pieces[1].rate, -1);
  EXPECT_EQ(test.pieces[1].duration, 0.25);
}

TEST(StrainHistory, NamesEveryFigureThatMakesNoTest) {
  const auto message = [](auto&& make) -> std::string {
    try {
      make();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(message([] { laboratory::constant_rate_test(0, 1); }),
              testing::AllOf(HasSubstr("rate"), HasSubstr("strain")));
  EXPECT_THAT(message([] { laboratory::parabolic_test(-1, 0.5); }), HasSubstr("rate"));
  EXPECT_THAT(message([] { laboratory::ramp_and_hold_test(1, 0.5, 0); }), HasSubstr("hold"));
  EXPECT_THAT(message([] { laboratory::cyclic_test(1, 0.5, 0.5, 0); }),
              testing::AllOf(HasSubstr("low"), HasSubstr("cycles")));
  EXPECT_THAT(message([] { laboratory::cyclic_test(1, 0.5, 0, 1001); }), HasSubstr("cycles"));
  EXPECT_THAT(message([] { laboratory::measured_test({0, 1}, {0}); }), HasSubstr("2 times and 1 strains"));
  EXPECT_THAT(message([] { laboratory::measured_test({0, 0}, {0, 0.5}); }), HasSubstr("pieces[0].duration"));
  EXPECT_THAT(message([] { laboratory::measured_test({0, 1}, {0.1, 0.5}); }), HasSubstr("pieces[0].strain"));
  EXPECT_THAT(message([] {
                laboratory::measured_test({0, 1}, {0, std::nan("")});
              }),
              HasSubstr("pieces[0].rate"));
}

TEST(StrainHistory, ListsWhatItBreaks) {
  EXPECT_THAT(keys({}), ElementsAre("pieces"));
  EXPECT_TRUE(keys(laboratory::parabolic_test(100, 0.95)).empty());
  EXPECT_TRUE(keys(laboratory::cyclic_test(7, 0.3, 0, 1000)).empty());
  EXPECT_THAT(keys({{{1, 0, 0.5, 0}, {1, 0.6, 0, 0}}}), ElementsAre("pieces[1].strain")) << "a jump";
  EXPECT_THAT(keys({{{1, 0, 1, 0}}}), ElementsAre("pieces[0].strain")) << "full compression";
  EXPECT_THAT(keys({{{2, 0, 2, -2}}}), ElementsAre("pieces[0].strain")) << "a vertex at 1";
  EXPECT_THAT(keys({{{1, 0, -0.1, 0}}}), ElementsAre("pieces[0].strain")) << "tension";
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THAT(keys({{{infinity, 0, infinity, infinity}}}),
              ElementsAre("pieces[0].duration", "pieces[0].rate", "pieces[0].acceleration"));
}

TEST(StrainHistory, IsRefusedByTheLaboratoryWithEverythingAtOnce) {
  try {
    laboratory::drive(Elastic{-1}, {}, 1);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("modulus"), HasSubstr("pieces"), HasSubstr("places")));
  }
  EXPECT_THROW(laboratory::drive(Elastic{1e5}, laboratory::cyclic_test(1, 0.5, 0, 1000), 100000),
               std::invalid_argument);
  EXPECT_THROW(laboratory::creep(Elastic{1e5}, {0, 1, 1}), std::invalid_argument);
  EXPECT_THROW(laboratory::creep(Elastic{1e5}, {1e3, 0, 1}), std::invalid_argument);
  EXPECT_THROW(laboratory::creep(Elastic{1e5}, {1e3, 1, 0}), std::invalid_argument);
  EXPECT_THROW(laboratory::creep(Elastic{1e5}, {1e3, 1, 1}, 1), std::invalid_argument);
}

TEST(Arcs, SplitAPieceWhereItTurns) {
  const auto arcs = laboratory::arcs_of(laboratory::parabolic_test(100, 0.95));
  ASSERT_EQ(arcs.size(), 2u);
  EXPECT_EQ(arcs[0].direction(), 1);
  EXPECT_EQ(arcs[0].end.rate, 0);
  EXPECT_DOUBLE_EQ(arcs[0].end.strain, 0.95);
  EXPECT_EQ(arcs[1].direction(), -1);
  EXPECT_EQ(arcs[1].end.strain, 0);
  EXPECT_DOUBLE_EQ(arcs[1].offset, 0.0095);
  // A rate that vanishes at the vertex does so without cancellation.
  EXPECT_EQ(arcs[0].before_end(1e-30).rate, -arcs[0].acceleration * 1e-30);
  EXPECT_NEAR(arcs[0].at(0.004).strain, laboratory::parabolic_test(100, 0.95).pieces[0].strain_at(0.004),
              1e-15);
  const laboratory::Stretch part = arcs[1].part(0.002, 0.005);
  EXPECT_DOUBLE_EQ(part.start.strain, arcs[1].at(0.002).strain);
  EXPECT_DOUBLE_EQ(part.at(0.001).strain, arcs[1].at(0.003).strain);
}

TEST(ColumnTest, HasItsPlacesEvenlyInTimeAndEveryEventAmongThem) {
  const laboratory::ColumnTest test =
      laboratory::drive(LinearViscoelastic{140e3, 420e3, 5e-3}, laboratory::constant_rate_test(50, 0.8), 10);
  ASSERT_EQ(test.events.size(), 2u);
  EXPECT_EQ(test.size(), 22u);
  for (std::size_t i = 0; i <= 10; ++i) EXPECT_DOUBLE_EQ(test.time[i], 0.0016 * static_cast<double>(i));
  EXPECT_EQ(test.rate[10], 50) << "of the piece that ends";
  EXPECT_EQ(test.rate[11], -50);
  EXPECT_EQ(test.events[0].kind, laboratory::ColumnEvent::Kind::turned);
  EXPECT_EQ(test.events[0].stress_before, test.events[0].stress_after);
  EXPECT_EQ(test.events[0].stress_before, test.stress[10]);
  EXPECT_EQ(test.events[1].kind, laboratory::ColumnEvent::Kind::contact_lost);
  EXPECT_EQ(std::count(test.time.begin(), test.time.end(), test.events[1].time), 1);
  EXPECT_TRUE(std::is_sorted(test.time.begin(), test.time.end()));
  EXPECT_EQ(test.largest_strain, 0.8);
}

}  // namespace
}  // namespace dashpad::test
