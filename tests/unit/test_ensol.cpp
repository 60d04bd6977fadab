// The dialogue of the 1984 main program: every prompt in its words, and the deck that the answers make.

#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/spit1984/deck.hpp"

namespace dashpad::spit1984 {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

struct Dialogue {
  std::optional<Deck> deck;
  std::string terminal;
};

/// What the terminal shows of it is what the program wrote; the echo of the answers is not there.
Dialogue typed(const std::string& answers) {
  std::istringstream input{answers};
  std::ostringstream terminal;
  std::optional<Deck> deck = ensol(input, terminal);
  return {deck, terminal.str()};
}

const std::string up_to_the_support =
    "SPHERE/PAD IMPACT TRACKER VERSION 2-DEC 1984\n"
    "PLEASE CHOOSE MODEL: 1 = ELASTIC\n"
    "                     2 = LINEAR V.E.\n"
    "                     3 = RIGID-FOAM\n"
    "                     4 = 9-PARAMETER\n"
    "                     5 = 21-PARAMETER: "
    "\n"
    "PLEASE ENTER: 1 = LINEAR ELASTIC SUPPORT\n"
    "              2 = PIECEWISE LINEAR SUPPORT (2 SLOPES)\n"
    "              3 = PIECEWISE LINEAR SUPPORT (3 SLOPES)\n"
    "              4 = PIECEWISE LINEAR SUPPORT (4 SLOPES): "
    "\n"
    "ENTER SPHERE RADIUS (IN.): "
    "ENTER INITIAL SPEED (MPH): "
    "ENTER WEIGHT (LBS): "
    "ENTER FOAM THICKNESS (IN.): "
    "INITIAL TIME STEP SIZE (MSEC): "
    "ENTER PRINT INTERVAL, NDEL: ";

TEST(Ensol, AsksForALinearSupport) {
  const auto [deck, terminal] = typed("4\n1\n3\n20\n10.\n1.\n.1\n10\n600\n");
  EXPECT_EQ(terminal, up_to_the_support + "ENTER SUPPORT STIFFNESS (LB/IN): ");
  ASSERT_TRUE(deck);
  EXPECT_EQ(deck->pad, PadKey::nine_parameter);
  EXPECT_EQ(deck->support, 1);
  EXPECT_EQ(deck->radius_in, 3);
  EXPECT_EQ(deck->speed_mph, 20);
  EXPECT_EQ(deck->weight_lb, 10);
  EXPECT_EQ(deck->thickness_in, 1);
  EXPECT_EQ(deck->time_step_ms, 0.1);
  EXPECT_EQ(deck->print_interval, 10);
  EXPECT_THAT(deck->support_parameters, ElementsAre(0, 0, 0, 0, 0, 0, 0, 0, 600, 0, 0, 0));
}

TEST(Ensol, AsksForThePointsOfAPiecewiseLinearSupport) {
  const auto [deck, terminal] = typed("5\n3\n3\n20\n10\n1\n0.1\n10\n0.1,900\n0.2 2E3\n .3 , 4000.\n");
  EXPECT_EQ(terminal, up_to_the_support +
                          "ENTER BREAK POINTS FOR PIECEWISE LINEAR SUPPORT: \n"
                          "DEFLECTION-LOAD PAIR  1:"
                          "DEFLECTION-LOAD PAIR  2:"
                          "DEFLECTION-LOAD PAIR  3:");
  ASSERT_TRUE(deck);
  EXPECT_EQ(deck->support, 3);
  EXPECT_THAT(deck->support_parameters, ElementsAre(0.1, 900, 0.2, 2000, 0.3, 4000, 0, 0, 0, 0, 0, 0));
}

TEST(Ensol, FillsInEnsolite) {
  const std::string rest = "1\n3\n20\n10\n1\n.1\n10\n600\n";
  EXPECT_THAT(typed("4\n" + rest).deck.value().pad_parameters,
              ElementsAre(7.96, 0.675, 1.09, 8.81e-3, 5.45, 0.166, 9.76e-6, 0.0987, 22.127, 0, 0, 0, 0, 0, 0,
                          0, 0, 0, 0, 0, 0));
  EXPECT_THAT(typed("5\n" + rest).deck.value().pad_parameters,
              ElementsAre(7.96, 0.675, 1.09, 0.13, 0.156, 3.08, 4.153, 0.19, 3.17, 0.58, 2.57, 0.296, 2.23,
                          1.64e-3, 9.76e-6, 0.0987, 66.0, 10.12, 0.279, 1.94, 0.029));
}

TEST(Ensol, NeverAsksForTheParametersOfTheOtherModels) {
  for (const PadKey pad : {PadKey::elastic, PadKey::linear_viscoelastic, PadKey::rigid_foam}) {
    const auto deck = typed(std::to_string(static_cast<int>(pad)) + "\n1\n3\n20\n10\n1\n.1\n10\n600\n").deck;
    ASSERT_TRUE(deck);
    EXPECT_EQ(deck->pad, pad);
    EXPECT_THAT(deck->pad_parameters, Each(0));
  }
}

TEST(Ensol, AsksAgainForWhatIsNotANumber) {
  const auto [deck, terminal] =
      typed("five\n5\n2\nthree\n3 in\n3\n20\n10\n1\n.1\n2.5\n10\n.1;900\n.1 9oo\n.1 900\n.2 2000\n");
  EXPECT_THAT(terminal,
              HasSubstr("5 = 21-PARAMETER: That is not a whole number. Please try again: \nPLEASE "));
  EXPECT_THAT(terminal,
              HasSubstr("ENTER SPHERE RADIUS (IN.): That is not a number. Please try again: That is "
                        "not a number. Please try again: ENTER INITIAL SPEED (MPH): "));
  EXPECT_THAT(terminal, HasSubstr("NDEL: That is not a whole number. Please try again: ENTER BREAK POINTS"));
  EXPECT_THAT(terminal, HasSubstr("PAIR  1:Those are not two numbers. Please try again: "
                                  "Those are not two numbers. Please try again: DEFLECTION-LOAD PAIR  2:"));
  ASSERT_TRUE(deck);
  EXPECT_EQ(deck->radius_in, 3);
  EXPECT_EQ(deck->print_interval, 10);
  EXPECT_THAT(deck->support_parameters, ElementsAre(0.1, 900, 0.2, 2000, 0, 0, 0, 0, 0, 0, 0, 0));
}

TEST(Ensol, AsksAgainForAModelOrASupportThatThereIsNot) {
  const auto [deck, terminal] = typed("6\n0\n\n5\n5\n-1\n1\n3\n20\n10\n1\n.1\n10\n600\n");
  const std::string model = "Please type a whole number from 1 to 5: ";
  const std::string support = "Please type a whole number from 1 to 4: ";
  EXPECT_THAT(terminal, HasSubstr("5 = 21-PARAMETER: " + model + model + model + "\nPLEASE ENTER: "));
  EXPECT_THAT(terminal, HasSubstr("(4 SLOPES): " + support + support + "\nENTER SPHERE RADIUS"));
  ASSERT_TRUE(deck);
  EXPECT_EQ(deck->pad, PadKey::twenty_one_parameter);
  EXPECT_EQ(deck->support, 1);
}

TEST(Ensol, HasNoDeckWhereTheInputEndsBeforeTheLastAnswer) {
  for (const auto& answers :
       {std::vector<std::string>{"4", "1", "3", "20", "10", "1", ".1", "10", "600"},
        std::vector<std::string>{"5", "2", "3", "20", "10", "1", ".1", "10", ".1,9", ".2,20"}}) {
    std::string so_far;
    for (const std::string& answer : answers) {
      EXPECT_FALSE(typed(so_far).deck) << so_far;
      so_far += answer + "\n";
    }
    EXPECT_TRUE(typed(so_far).deck);
    EXPECT_FALSE(typed(so_far.substr(0, so_far.rfind('\n', so_far.size() - 2) + 1) + "what?\n").deck);
  }
}

TEST(Ensol, ReadsTenCharactersOfANumber) {
  const auto deck = typed("4\n1\n3.00000001999\n20\n10\n1\n.1\n10\n600\n").deck;
  ASSERT_TRUE(deck);
  EXPECT_EQ(deck->radius_in, 3.00000001);
}

TEST(Ensol, TakesALastLineWithoutItsEnd) { EXPECT_TRUE(typed("4\n1\n3\n20\n10\n1\n.1\n10\n600").deck); }

TEST(Ensol, TakesLinesThatEndAsOnWindows) {
  const auto deck = typed("4\r\n2\r\n3\r\n20\r\n10\r\n1\r\n.1\r\n10\r\n.1,9\r\n.2,20\r\n").deck;
  ASSERT_TRUE(deck);
  EXPECT_EQ(deck->print_interval, 10);
  EXPECT_EQ(deck->support_parameters[3], 20);
}

TEST(Ensol, LeavesWhatFollowsTheLastAnswer) {
  std::istringstream input{"4\n1\n3\n20\n10\n1\n.1\n10\n600\nmore"};
  std::ostringstream terminal;
  EXPECT_TRUE(ensol(input, terminal));
  std::string left;
  std::getline(input, left);
  EXPECT_EQ(left, "more");
}

}  // namespace
}  // namespace dashpad::spit1984
