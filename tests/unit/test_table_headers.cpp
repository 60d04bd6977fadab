// Headers of tables as programs write them: which names stand for which columns, what is no sample, and what
// is said of files that hold something else than one table.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "dashpad/input/fault.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::Pointwise;

class TableHeaderTest : public testing::Test {
 protected:
  static constexpr double gravity = 9.80665;

  injury::MeasuredPulse pulse(const std::string& text, const input::PulseOptions& options = {}) {
    return input::read_pulse_csv(folder_.write("pulse.csv", text), options).value().measured;
  }
  /// The faults; none if the pulse is read.
  std::vector<input::Fault> faults(const std::string& text, const input::PulseOptions& options = {}) {
    try {
      pulse(text, options);
    } catch (const input::InputError& error) {
      return error.faults();
    }
    return {};
  }
  /// The rule of the only fault.
  std::string refused(const std::string& text, const input::PulseOptions& options = {}) {
    const std::vector<input::Fault> found = faults(text, options);
    EXPECT_EQ(found.size(), 1U) << text;
    return found.empty() ? "" : found.front().rule;
  }
  /// Of 1, 3 and 2 g at 0, 2 and 4 ms.
  void expect_the_pulse(const std::string& text, const input::PulseOptions& options = {}) {
    SCOPED_TRACE(text);
    const std::vector<input::Fault> found = faults(text, options);
    for (const input::Fault& fault : found) ADD_FAILURE() << to_string(fault);
    if (!found.empty()) return;
    const injury::MeasuredPulse measured = pulse(text, options);
    EXPECT_THAT(measured.pulse.time, Pointwise(DoubleEq(), {0.0, 0.002, 0.004}));
    EXPECT_THAT(measured.pulse.acceleration, Pointwise(DoubleEq(), {gravity, 3 * gravity, 2 * gravity}));
  }

  test::TemporaryFolder folder_;
};

const std::string rows_of_blanks = "0 1\n2 3\n4 2\n";

TEST_F(TableHeaderTest, UnitsSplitFromTheirNamesAtBlanksBelongToThem) {
  for (const std::string header :
       {"Time (ms)   Acc (g)\n", "Time [ms] Head acc [g]\n", "Time ( ms ) Acc (g)\n", "Time / ms   Acc / g\n",
        "t_ms, a_g\n", "# Time (ms) Acc (g)\n", "# drop test 7\n# Time (ms)  Acc (g)\n# Run= 1\n",
        "# columns: t_ms a_g\n", "% t_ms a_g\n", "%Time (ms) Acc (g)\n",
        "Drop on pad\nTime (ms)\nAcc (g)\nNode 1\n"})
    expect_the_pulse(header + rows_of_blanks);
}

TEST_F(TableHeaderTest, TheNamesAreInAnyComment) {
  const injury::MeasuredPulse measured = pulse("# half sine\n# t_ms a_g\n# begin 1\n" + rows_of_blanks);
  EXPECT_EQ(measured.acceleration.front().name, "a_g");
  EXPECT_THAT(measured.remarks, ElementsAre("the column names were read from the comment on line 2"));
}

TEST_F(TableHeaderTest, AKeywordBeforeTheNamesIsNoColumn) {
  const std::string rows = "0,1,7\n2,3,7\n4,2,8\n";
  for (const std::string header :
       {"SIGNAL,TIME [ms],A [g],B\n", "VERT_UNITS,ms,g,g\nSIGNAL,TIME,A,B\n", "TIME,A,B\nUNITS,ms,g,g\n",
        ";Headers, t_ms, A [g], B\n", "Names:,t_ms,A [g],B\n"})
    expect_the_pulse(header + rows, {.acceleration = {"A"}});
  EXPECT_THAT(pulse("SIGNAL,TIME [ms],A [g],B\n" + rows).remarks,
              ElementsAre("SIGNAL, at the beginning of line 1, names no column and was left out"));
}

TEST_F(TableHeaderTest, AnExtraNameAtTheEndShiftsNothing) {
  expect_the_pulse("t_ms,a_g,comment\n0,1\n2,3\n4,2\n");
  expect_the_pulse("a_g,t_ms,comment\n1,0\n3,2\n2,4\n");
  // Without a time that increases in one place alone nothing tells a keyword from a name.
  EXPECT_THAT(pulse("A,t_ms,B\n1,0\n2,2\n3,4\n", {.acceleration = {"A"}, .acceleration_unit = "g"})
                  .pulse.acceleration,
              Pointwise(DoubleEq(), {gravity, 2 * gravity, 3 * gravity}));
}

TEST_F(TableHeaderTest, ARowWithoutNumbersNamesTheColumnsRatherThanOneWith) {
  const std::string text = "X,CH1,Start\nSequence,Volt,-2e-3\n0,1,\n1,3,\n2,2,\n";
  EXPECT_THAT(refused(text),
              AllOf(HasSubstr("neither a time nor an acceleration column was recognized"),
                    HasSubstr("or give the time between samples with --interval"), HasSubstr("CH1 (2)")));
  EXPECT_THAT(pulse(text, {.acceleration = {"CH1"}, .acceleration_unit = "g", .interval = 2e-3}).pulse.time,
              Pointwise(DoubleEq(), {0.0, 0.002, 0.004}));
}

TEST_F(TableHeaderTest, RowsOfUnitsNameAnyUnit) {
  const input::Sensitivity ten = input::sensitivity_of("10 mV/g");
  expect_the_pulse("X,CH1\nSecond,Volt\n0,0.01\n0.002,0.03\n0.004,0.02\n", {.sensitivity = {ten}});
  expect_the_pulse("time,acc\nms,millivolts\n0,10\n2,30\n4,20\n", {.sensitivity = {ten}});
  expect_the_pulse("time,T,acc\nms,degC,g\n0,20,1\n2,20,3\n4,20,2\n");
  expect_the_pulse("force,time,acc\nN,ms,g\n9,0,1\n9,2,3\n9,4,2\n");
  expect_the_pulse("time,acc (head)\nms,g\n0,1\n2,3\n4,2\n");
  EXPECT_THAT(pulse("time,acc\ns,cm/s2\n0,1\n0.002,3\n").pulse.acceleration,
              Pointwise(DoubleEq(), {0.01, 0.03}));
}

TEST_F(TableHeaderTest, ACountAboveATitleIsNoSample) {
  const input::PulseOptions units{.time_unit = "ms", .acceleration_unit = "g"};
  expect_the_pulse("1\n3 'HEAD ACC'\n" + rows_of_blanks, units);
  expect_the_pulse("3\n" + rows_of_blanks, units);
  expect_the_pulse("2 3\nHEAD\n" + rows_of_blanks, units);
  EXPECT_THAT(refused("t_ms,a_g\nx,5\n0,1\n2,3\n"), HasSubstr("must be a number"));
}

TEST_F(TableHeaderTest, WithoutAHeaderOneSentenceSaysHowToChoose) {
  const std::string text = "0,7,1\n2,7,3\n4,8,2\n";
  EXPECT_THAT(refused(text),
              HasSubstr("no header names the 3 columns; choose two by their numbers and give their "
                        "units, such as --time 1 --time-unit ms --acceleration 2"));
  expect_the_pulse(text, {.time = "1", .acceleration = {"3"}, .time_unit = "ms", .acceleration_unit = "g"});
}

TEST_F(TableHeaderTest, SizesAboveTheNamesAreNoTable) {
  const std::string table = "t_ms,a_g\n0,1\n2,3\n4,2\n";
  for (const std::string above : {"7,8,9\n", "Width,Depth,Height\n7,8,9\n", "7,8,9\n1,2,3,4\n5\n"})
    expect_the_pulse(above + table);
  for (const std::string above : {"7 8\n", "7 8\n9 10\nspecimen A\n"})
    expect_the_pulse(above + "t_ms a_g\n" + rows_of_blanks);
  EXPECT_THAT(pulse("7 8\nt_ms a_g\n" + rows_of_blanks).remarks,
              ElementsAre("the numbers from line 1 on, above the text, were left out"));
  EXPECT_THAT(pulse("7,8,9\n" + table).remarks, IsEmpty());
  // What has the names and the width of the table below may be its first rows.
  EXPECT_THAT(faults("t_ms,a_g\n0,1\nx,y\n2,3\n4,2\n6,1\n"), Not(IsEmpty()));
}

TEST_F(TableHeaderTest, XOfAReportIsTheTime) {
  const std::string report =
      "\n          X         acc\n\n     0.0E+00     1\n     2.0E+00     3\n     4.0E+00     2\n";
  expect_the_pulse(report + "\n     MINIMUM     0.     1.\n     AT X =     0.     0.\n",
                   {.time_unit = "ms", .acceleration_unit = "g"});
  EXPECT_THAT(pulse(report, {.time_unit = "ms", .acceleration_unit = "g"}).remarks,
              Contains("column X is used as the time, as in reports of Abaqus"));
  EXPECT_THAT(refused("X,acc [g],n\n0,1,0\n2,3,0\n"), HasSubstr("no time column was recognized"));
}

TEST_F(TableHeaderTest, TextBehindTheNumbersIsLeftOutWithARemark) {
  const std::string table = "t_ms,a_g\n0,1\n2,3\n4,2\n";
  for (const std::string behind :
       {"EOF\n", "EOF,\n", ";shutdown: switched off\n", "end of data, 3 samples, ok\n"}) {
    expect_the_pulse(table + behind);
    EXPECT_THAT(pulse(table + behind).remarks, Contains("the text on line 5 behind the numbers was left out"))
        << behind;
  }
  EXPECT_THAT(pulse(table + "\nEnd\nMax,3\nMin,1\n").remarks,
              Contains("3 lines of text behind the numbers, from line 6 on, were left out"));
  expect_the_pulse("a_g,n\n1,0\n3,0\n2,0\n\nEOF\n", {.interval = 2e-3});
  expect_the_pulse("t_ms a_g\n" + rows_of_blanks + "END DATA\n");
  // A typing error in the last row is none.
  EXPECT_THAT(refused(table + "x,5\n"), HasSubstr("must be a number"));
}

TEST_F(TableHeaderTest, SeveralTablesAreOneSentence) {
  const std::string table = "t_ms,a_g\n0,1\n2,3\n4,2\n";
  for (const std::string& text : std::vector<std::string>{
           table + table, table + "second drop\n" + table, table + "CONTINUE\n0,1\n2,3\n",
           table + "\nDrop, 2, of, 2\nt_ms,a_g\n0,1\n2,3\n",
           "node x y z\n 1 0 1 2\n step 2\n node x y z\n 1 0 1 2\n"}) {
    const std::vector<input::Fault> found = faults(text);
    ASSERT_EQ(found.size(), 1U) << text;
    EXPECT_THAT(found.front().rule,
                HasSubstr("is text among the numbers; if another table begins here, put it in a "
                          "file of its own"));
  }
  EXPECT_EQ(faults(table + table).front().line, 5);
  EXPECT_THAT(refused(table + "0,1\n2,3\n4,2\n"), HasSubstr("is earlier than the previous time"));
  EXPECT_THAT(refused(table + "0,1,1\n2,3,1\n4,2,1\n"), HasSubstr("has 3 fields where 2 are expected"));
}

TEST_F(TableHeaderTest, OtherFormatsAreNamed) {
  EXPECT_THAT(refused("    -1\n    58\nHead\n 0.0 1.0 2.0\n"), HasSubstr("is a universal file (UFF)"));
  EXPECT_THAT(refused("<?xml version=\"1.0\"?>\n<a>1 2</a>\n"), HasSubstr("is XML or HTML, not a table"));
  EXPECT_THAT(refused("<rows><row>1</row></rows>"), HasSubstr("is XML or HTML, not a table"));
  // A column of numbers of six places is none.
  EXPECT_THAT(
      pulse("    -1\n    58\n     3\n", {.acceleration_unit = "g", .interval = 1e-3}).pulse.acceleration,
      Pointwise(DoubleEq(), {-gravity, 58 * gravity, 3 * gravity}));
}

TEST_F(TableHeaderTest, AnEmptyChannelHasNoValues) {
  const std::vector<input::Fault> found =
      faults("t_ms,a_g,b_g\n0,1,\n2,3,\n4,2,\n", {.acceleration = {"b_g"}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().key, "b_g");
  EXPECT_EQ(found.front().rule, "has no values");
}

TEST_F(TableHeaderTest, LabViewSaysHowManySamplesThereAre) {
  const auto file = [](const std::string& samples) {
    return "LabVIEW "
           "Measurement\t\nSeparator\tTab\nX_Columns\tOne\n***End_of_Header***\t\nChannels\t1\nSamples\t" +
           samples +
           "\nY_Unit_Label\tg\nX_Dimension\tTime\nDelta_X\t0.002\n***End_of_Header***\t\n"
           "X_Value\tA\n0\t1\n0.002\t3\n0.004\t2\n";
  };
  expect_the_pulse(file("3"));
  EXPECT_THAT(pulse(file("3")).remarks, IsEmpty());
  EXPECT_THAT(pulse(file("500")).remarks,
              ElementsAre("A: the header states 500 samples, but the file has 3"));
}

}  // namespace
}  // namespace dashpad
