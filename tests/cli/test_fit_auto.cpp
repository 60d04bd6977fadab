// dashpad fit --auto as a user runs it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

#include "command.hpp"
#include "schema.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

/// A loading to a strain of 0.6, times `factor`, and a way back with half of the stress.
std::string loop_csv(double factor, bool comes_back) {
  std::string csv = "strain,stress_kPa\n";
  const auto stress = [&](double e) { return factor * (60 * (1 - std::exp(-25 * e)) + 40 * e / (1 - e)); };
  for (int i = 0; i <= 60; ++i)
    csv += std::to_string(0.01 * i) + "," + std::to_string(stress(0.01 * i)) + "\n";
  for (int i = 59; comes_back && i >= 0; --i)
    csv += std::to_string(0.01 * i) + "," +
           std::to_string(stress(0.01 * i) * (0.4 + 0.6 * std::pow(i / 60.0, 2))) + "\n";
  return csv;
}

class FitAutoTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_file(file("slow.csv"), loop_csv(1, true));
    write_file(file("fast.csv"), loop_csv(1.5, false));
  }
  [[nodiscard]] std::vector<std::string> both(std::vector<std::string> more = {}) const {
    std::vector<std::string> command{"fit",    "--auto",   file("slow.csv"), file("fast.csv"),
                                     "--rate", "0.01 1/s", "--rate",         "100 1/s"};
    command.insert(command.end(), more.begin(), more.end());
    return command;
  }
};

TEST_F(FitAutoTest, AnswersFirstAndSaysWhatIsOpen) {
  const Outcome outcome = dashpad(both({"--output", file("card.toml"), "--report", file("page.html")}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(testing::StartsWith("Proposed: law foam with the measured curve as its base"),
                    HasSubstr("\nWhy:\nLaw: foam, since slow.csv kept pressing during unloading"),
                    HasSubstr("What these tests do not determine:\n1. Unloading at the rate of an impact"),
                    HasSubstr("What to measure next, the most valuable first:\n1. A drop of a flat weight")));
  EXPECT_THAT(read_file(file("page.html")), HasSubstr("What to measure next"));
  EXPECT_EQ(dashpad({"material-test", file("card.toml")}).exit_code, 0);
}

/// The file that is written is the fit that was made.
TEST_F(FitAutoTest, TheProposalIsAFitFileWithTheSameResult) {
  const Outcome outcome = dashpad(both({"--proposal", file("fit.toml"), "--json", file("auto.json")}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Outcome again = dashpad({"fit", file("fit.toml"), "--json", "-"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  json made = json::parse(read_file(file("auto.json"))), read = json::parse(again.out);
  EXPECT_EQ(schema_faults(made, "fit"), "");
  EXPECT_EQ(schema_faults(read, "fit"), "");
  EXPECT_EQ(made["proposal"]["tried"].size(), 2);
  EXPECT_EQ(read["proposal"], nullptr);
  EXPECT_EQ(made["unknowns"], read["unknowns"]);
  EXPECT_EQ(made["material"]["reservations"], read["material"]["reservations"]);
}

TEST_F(FitAutoTest, RatesMayStandInHeadersAndTimes) {
  std::string timed = "time_s,strain,stress_kPa\n",
              headed = "strain,stress_kPa @ 0.01 1/s,stress_kPa @ 1 1/s\n";
  for (int i = 0; i <= 50; ++i) {
    const double e = 0.01 * i, stress = 50 * (1 - std::exp(-30 * e)) + 30 * e / (1 - e);
    timed += std::to_string(0.5 * i) + "," + std::to_string(e) + "," + std::to_string(stress) + "\n";
    headed += std::to_string(e) + "," + std::to_string(stress) + "," + std::to_string(1.2 * stress) + "\n";
  }
  write_file(file("timed.csv"), timed);
  write_file(file("headed.csv"), headed);
  const Outcome by_times = dashpad({"fit", "--auto", file("timed.csv"), "--json", "-"});
  ASSERT_EQ(by_times.exit_code, 0) << by_times.err;
  EXPECT_NEAR(json::parse(by_times.out)["proposal"]["tests"][0]["rate_per_s"].get<double>(), 0.02, 1e-6);
  const Outcome by_headers =
      dashpad({"fit", "--auto", file("headed.csv"), "--json", "-", "--proposal", file("headed.toml")});
  ASSERT_EQ(by_headers.exit_code, 0) << by_headers.err;
  const json result = json::parse(by_headers.out);
  ASSERT_EQ(result["proposal"]["tests"].size(), 2);
  EXPECT_NEAR(result["unknowns"][0]["value"].get<double>(), std::log(1.2) / std::log(100), 1e-4);
  const Outcome again = dashpad({"fit", file("headed.toml"), "--json", "-"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(json::parse(again.out)["unknowns"], result["unknowns"]);
}

TEST_F(FitAutoTest, RefusesAllFaultsAtOnce) {
  write_file(file("held.csv"), "strain,stress_kPa\n0,0\n0.1,20\n0.2,30\n0.2,25\n0.2,22\n0.2,20\n0.2,19\n");
  const Outcome outcome = dashpad({"fit", "--auto", file("nothing.csv"), file("held.csv"), file("slow.csv"),
                                   "--rate", "1 1/s", "--rate", "0.01 1/s", "--output", file("card.toml")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("nothing.csv: no such file"),
                    HasSubstr("held.csv: the strain is held while the stress falls by"),
                    HasSubstr("slow.csv: its strain rate is not stated"), HasSubstr("3 errors")));
  EXPECT_EQ(outcome.out, "");
  write_file(file("few.csv"), "strain,stress_kPa\n0.25,40\n0.4,75\n0.5,115\n0.6,175\n");
  const Outcome few = dashpad({"fit", "--auto", file("few.csv"), "--rate", "0.01 1/s"});
  EXPECT_EQ(few.exit_code, 2);
  EXPECT_THAT(few.err, HasSubstr("4 points of one loading determine no formula"));
}

TEST_F(FitAutoTest, RatesInAnotherOrderThanTheFilesAreRefused) {
  const Outcome outcome = dashpad(
      {"fit", "--auto", file("fast.csv"), file("slow.csv"), "--rate", "0.01 1/s", "--rate", "100 1/s"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err,
              HasSubstr("slow.csv: at a strain of 0.3 its stress is 0.67 times that in fast.csv"));
  EXPECT_THAT(dashpad({"fit", "--auto", file("slow.csv"), file("slow.csv"), "--rate", "1 1/s"}).err,
              AllOf(HasSubstr("is given twice"), HasSubstr("its strain rate is not stated")));
}

/// What is wrong with the tests stands in the card, whose users do not see the answer.
TEST_F(FitAutoTest, DoubtsAreReservationsOfTheCard) {
  const Outcome outcome = dashpad(both({"--output", "-"}));
  EXPECT_THAT(
      outcome.out,
      HasSubstr("The base curve is the loading in slow.csv as measured: no interval contains its noise"));
}

TEST_F(FitAutoTest, OptionsThatDoNotGoTogetherAreRefused) {
  EXPECT_THAT(dashpad(both({"--state", file("state")})).err, HasSubstr("--state: does not go with --auto"));
  EXPECT_THAT(dashpad(both({"--case", file("fitted.toml")})).err,
              HasSubstr("--case: does not go with --auto"));
  EXPECT_THAT(dashpad({"fit", file("slow.csv"), file("fast.csv"), "--rate", "1 1/s"}).err,
              AllOf(HasSubstr("only one fit file can be given"), HasSubstr("need --auto")));
  EXPECT_THAT(dashpad(both({"--rate", "1 1/s"})).err, HasSubstr("--rate: more rates (3) than files (2)"));
}

}  // namespace
}  // namespace dashpad::test
