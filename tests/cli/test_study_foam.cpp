// dashpad study: what the cards leave uncertain, and responses of single blows, as a user asks for them.

#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class StudyFoamTest : public CommandTest {
 protected:
  Outcome study(const std::string& text) {
    write_file(file("study.toml"), text);
    fs::remove(file("study.db"));
    return dashpad({"study", file("study.toml"), "--out", file("study.db")});
  }
  std::string summary() { return dashpad({"study", "summary", file("study.db")}).out; }
};

TEST_F(StudyFoamTest, DrawsWhatTheCardLeavesUncertain) {
  const std::string helmet =
      "case = \"" + examples + "helmet-pad-10fps.toml\"\nsamples = 16\nresponses = [\"hic15\"]\n";
  const Outcome outcome = study(helmet + "foam_uncertainty = true\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(summary(), AllOf(HasSubstr("tests leave open are assumed to be equally likely"),
                               HasSubstr("Unloading of the foam"), HasSubstr("Error of the columns")));
  const Outcome replayed = dashpad({"study", "replay", file("study.db"), "7"});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
  EXPECT_THAT(replayed.out, AllOf(StartsWith("Row 7: foam.continuation = "),
                                  HasSubstr("The stored responses were reproduced to the last bit.\n"
                                            "They include foam.neighbours, the figures above do not.")));

  // A source that is given is not drawn a second time, and false draws none.
  EXPECT_EQ(study(helmet + "foam_uncertainty = true\nindices = true\n[factors.\"foam.way_back\"]\n"
                           "values = [-1, 1]\n")
                .exit_code,
            0);
  EXPECT_THAT(summary(), AllOf(HasSubstr("2 levels: -1, 1"), HasSubstr("Sobol' indices")));
  EXPECT_EQ(study(helmet + "foam_uncertainty = false\n").exit_code, 2);
  const Outcome number = study(helmet + "foam_uncertainty = 1\n");
  EXPECT_THAT(number.err, AllOf(HasSubstr("must be true or false"), HasSubstr("1 error")));
}

TEST_F(StudyFoamTest, RefusesWhatIsNotUncertain) {
  const std::string begin = "case = \"case.toml\"\nsamples = 4\n";
  const Outcome none = study(begin + "[factors.\"foam.scatter\"]\nvalues = [0]\n");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("factors.foam.scatter"));
  const Outcome beyond =
      study("case = \"" + examples + "helmet-pad-10fps.toml\"\n[factors.\"foam.rate\"]\nvalues = [2]\n");
  EXPECT_EQ(beyond.exit_code, 2);
  EXPECT_THAT(beyond.err, HasSubstr("must lie between 0 and 1"));
}

TEST_F(StudyFoamTest, RespondsWithSingleBlowsAndMeans) {
  const std::string begin = "case = \"" + examples + "five-drops-on-a-cushion.toml\"\n";
  const std::string thickness = "[factors.\"pad.thickness\"]\nvalues = [\"50 mm\"]\n";
  const Outcome outcome = study(
      begin +
      "responses = [\"peak_acceleration.blow_1\", \"peak_acceleration.mean_2_5\", \"peak_acceleration\"]\n" +
      thickness);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(summary(), AllOf(HasSubstr("Peak acceleration of blow 1"), HasSubstr("mean of blows 2 to 5")));
  const std::string csv = dashpad({"study", "export", file("study.db"), "--csv", "-"}).out;
  EXPECT_THAT(csv,
              HasSubstr("peak_acceleration.blow_1_g,peak_acceleration.mean_2_5_g,peak_acceleration_g\n"));
  double first = 0, mean = 0, last = 0;
  const std::size_t row = csv.find('\n') + 1;
  const std::size_t values = csv.rfind(',', csv.rfind(',', csv.rfind(',') - 1) - 1);
  ASSERT_GT(values, row);
  ASSERT_EQ(std::sscanf(csv.c_str() + values, ",%lf,%lf,%lf", &first, &mean, &last), 3);
  EXPECT_LT(first, mean);
  EXPECT_LT(mean, last);
  const Outcome replayed = dashpad({"study", "replay", file("study.db"), "0"});
  EXPECT_THAT(replayed.out, HasSubstr("reproduced to the last bit"));

  const Outcome refused = study(begin + "responses = [\"peak_force.mean_2_6\"]\n" + thickness);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("the case has only 5 blows"));
  const Outcome single = study("case = \"case.toml\"\nresponses = [\"peak_force.blow_2\"]\n" + thickness);
  EXPECT_THAT(single.err, AllOf(HasSubstr("no [blows]"), Not(HasSubstr("is not a response"))));
}

/// Materials have their names in exported rows, which can be read again as a table of rows.
TEST_F(StudyFoamTest, ExportedRowsNameTheMaterials) {
  const std::string begin = "case = \"" + examples + "helmet-pad-10fps.toml\"\n";
  ASSERT_EQ(study(begin + "[factors.\"pad.material\"]\nvalues = [\"vn600\", \"eps-15\"]\n").exit_code, 0);
  ASSERT_EQ(dashpad({"study", "export", file("study.db"), "--csv", file("rows.csv")}).exit_code, 0);
  EXPECT_THAT(read_file(file("rows.csv")), AllOf(HasSubstr(",vn600,"), HasSubstr(",eps-15,")));
  EXPECT_EQ(study(begin + "rows = \"rows.csv\"\n").exit_code, 0);
}

}  // namespace
}  // namespace dashpad::test
