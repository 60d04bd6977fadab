// Strain histories from tables.

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/input/fault.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

class StrainCsvTest : public ::testing::Test {
 protected:
  input::StrainTable read(const std::string& text) {
    const auto file = folder_.path() / "strains.csv";
    std::ofstream{file, std::ios::binary} << text;
    return input::read_strain_csv(file).value();
  }
  std::vector<input::Fault> faults(const std::string& text) {
    try {
      read(text);
    } catch (const input::InputError& error) {
      return error.faults();
    }
    ADD_FAILURE() << "accepted: " << text;
    return {};
  }
  std::string first_rule(const std::string& text) {
    const auto found = faults(text);
    return found.empty() ? "" : found.front().rule;
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(StrainCsvTest, ReadsUnitsFromTheHeader) {
  for (const char* text :
       {"time_s,strain\n0,0\n0.01,0.5\n", "time [ms];strain [%]\n0;0\n10;50\n",
        "t_ms\tStrain %\n0\t0\n10\t50\n", "Time / ms,strain (1)\n0,0\n10,0.5\n",
        "# t_ms,strain_percent\n0,0\n10,50\n", "time,strain\n[ms],[%]\n0,0\n10,50\n",
        "\xef\xbb\xbftime_ms;strain\r\n0;0\r\n10;0,5\r\n", "strain,force [N],time_s\n0,1,0\n0.5,2,0.01\n"}) {
    const input::StrainTable table = read(text);
    EXPECT_THAT(table.time, ElementsAre(0, DoubleEq(0.01))) << text;
    EXPECT_THAT(table.strain, ElementsAre(0, DoubleEq(0.5))) << text;
    EXPECT_THAT(table.remarks, SizeIs(0)) << text;
  }
}

TEST_F(StrainCsvTest, BeginsAtFirstContact) {
  const input::StrainTable table = read("time_s,strain\n2,0\n2.5,0.25\n");
  EXPECT_THAT(table.time, ElementsAre(0, 0.5));
  EXPECT_THAT(table.remarks, ElementsAre(HasSubstr("2 s, was taken as first contact and subtracted")));
}

TEST_F(StrainCsvTest, LeavesOutRowsThatRepeat) {
  const input::StrainTable table = read("time_s,strain\n0,0\n0.5,0.25\n0.5,0.25\n1,0\n");
  EXPECT_THAT(table.time, ElementsAre(0, 0.5, 1));
  EXPECT_THAT(table.remarks, ElementsAre("1 row that repeats the previous one was left out"));
  EXPECT_THAT(first_rule("time_s,strain\n0,0\n0.5,0.25\n0.5,0.3\n"), HasSubstr("must be later"));
}

TEST_F(StrainCsvTest, NeedsAHeaderThatSaysWhatIsWhat) {
  EXPECT_THAT(first_rule("0,0\n1,0.5\n"), HasSubstr("needs a header line"));
  EXPECT_THAT(first_rule("time,strain\n0,0\n1,0.5\n"), HasSubstr("its unit is not stated"));
  EXPECT_THAT(first_rule("time_s,force [N]\n0,0\n1,0.5\n"), HasSubstr("no column for the strain"));
  EXPECT_THAT(first_rule("time_s,strain,strain [%]\n0,0,0\n1,0.5,50\n"),
              HasSubstr("several columns could be the strain"));
  EXPECT_THAT(first_rule("time_s,strain [mm]\n0,0\n1,0.5\n"),
              HasSubstr("is a displacement; for a strain, give the specimen thickness"));
  EXPECT_THAT(first_rule("strain [%],x\n0,0\n1,0.5\n"), HasSubstr("no column for the time"));
  EXPECT_THAT(first_rule(""), HasSubstr("is empty"));
  EXPECT_THAT(first_rule("time_s,strain\n"), HasSubstr("no row"));
}

TEST_F(StrainCsvTest, NamesEveryFaultWithItsLine) {
  const auto found = faults("time_s,strain\n0,0.1\n0.1,x\n0.05,1.5\n0.04,0.2\n\n,0.3\n");
  std::vector<int> lines;
  for (const input::Fault& fault : found) lines.push_back(fault.line);
  EXPECT_THAT(lines, ElementsAre(2, 3, 4, 5, 7));
}

/// The first time is taken off: 0 and 1 are both 1e17 after -1e17.
TEST_F(StrainCsvTest, RefusesTimesThatCannotBeToldApartAfterTheFirst) {
  EXPECT_THAT(first_rule("time_s,strain\n-1e17,0\n0,0.1\n1,0.2\n"),
              HasSubstr("cannot be told apart from the previous time"));
  EXPECT_THAT(first_rule("time_s,strain\n-1e308,0\n1e308,0.1\n"), HasSubstr("too large"));
  EXPECT_THAT(first_rule("time [Ys],strain\n0,0\n1e300,0.1\n"), HasSubstr("too large"));
}

TEST_F(StrainCsvTest, RefusesAHistoryWithoutContent) {
  EXPECT_THAT(first_rule("time_s,strain\n0,0\n"), HasSubstr("only one row"));
  EXPECT_THAT(first_rule("time_s,strain\n0,0\n1,0\n"), HasSubstr("is 0 throughout"));
  EXPECT_THAT(first_rule("time_s,strain\n0,0\n1,1e-20\n"), HasSubstr("is below 1e-12 throughout"));
  std::string text = "time_s,strain\n0,0\n";
  for (int i = 1; i <= 10'000; ++i) text += std::to_string(i) + ",0.5\n";
  EXPECT_THAT(first_rule(text), HasSubstr("more than 10000 rows"));
}

TEST_F(StrainCsvTest, DoesNotLoseARowBelowTheHeader) {
  const auto found = faults("time_s,strain\nzero,0\n0,0\n1,0.5\n");
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].line, 2);
}

}  // namespace
}  // namespace dashpad
