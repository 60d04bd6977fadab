// Tables of measured pulses: how each style of file is read, and what is said about each kind of bad one.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "dashpad/input/fault.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "shared/gravity.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using ::testing::Pointwise;

injury::MeasuredPulse read(const std::string& text, const input::PulseOptions& options = {}) {
  const test::TemporaryFolder folder;
  return input::read_pulse_csv(folder.write("pulse.csv", text), options).value().measured;
}

/// What is said, a fault a line; "" if nothing.
std::string said(const std::string& text, const input::PulseOptions& options = {}) {
  try {
    read(text, options);
  } catch (const input::InputError& error) {
    std::string lines = error.what();
    for (auto at = lines.find("/pulse.csv"); at != std::string::npos; at = lines.find("/pulse.csv")) {
      const auto begin = lines.rfind('\n', at);
      lines.erase(begin == std::string::npos ? 0 : begin + 1,
                  at + 10 - (begin == std::string::npos ? 0 : begin + 1));
    }
    return lines;
  }
  return "";
}

input::Sensitivity ten_mv_per_g() { return input::sensitivity_of("10 mV/g"); }
const input::PulseOptions in_ms_and_g{.time_unit = "ms", .acceleration_unit = "g"};

/// The same two samples in many styles.
struct Style {
  std::string text;
  std::vector<std::string> remarks;
  input::PulseOptions options = {};
};

const std::vector<Style> styles{
    {"time [ms],acceleration [g]\n0,1\n2,3\n", {}},
    {"Time (ms),Acc (g)\n0,1\n2,3", {}},
    {"t_ms,acceleration_g\n0,1\n2,3\n", {}},
    {"Time / ms;Acceleration / g\n0;1\n2;3\n", {}},
    {"Time/ms;Acc/g;Speed m/s\n0;1;7\n2;3;7\n", {}},
    {"Time ms\tAcc g\n0\t1\n2\t3\n", {}},
    {"Time 1 [ms]\tnote\tAcc 2 [g]\n0\ta\t1\n2\tb\t3\n", {}},
    {"Time 1 of 2 [ms]\tAcc no 2 of 3 [g]\n0\t1\n2\t3\n", {}},
    {"t_s,accel[m/s^2]\n0,9.80665\n0.002,29.41995\n", {}},
    {"time_s,acceleration_m_per_s2\n0,9.80665\n2e-3,2.941995E1\n", {}},
    {"t [\xc2\xb5s];a [m/s\xc2\xb2]\n0;9.80665\n2000;29.41995\n", {}},
    {"t [\xb5s];a [m/s\xb2]\n0;9.80665\n2000;29.41995\n",
     {"the header is not UTF-8; it was read as Latin-1"}},
    {"Time,Acceleration\nms,g\n0,1\n2,3\n", {}},
    {"Time,Acceleration\n[ms],[g]\n0,1\n2,3\n", {}},
    {"Time,Kopf\n(ms),(g)\n0,1\n2,3\n", {}},
    {"ms,g\n0,1\n2,3\n", {}},
    {"Company;\nSampling rate;500\nTime [ms];Acc [g]\n0;1\n2;3\n", {}},
    {"\"Time, of day [ms]\",\"Acc \"\"x\"\" [g]\"\n\"0\",\"1\"\n2,3\n", {}},
    {"\"Time\n(ms)\",Acc (g)\n0,1\n2,3\n", {}},
    {"# drop 7\nt_ms,a_g\n0,1\n# tea\n2,3\n",
     {"1 line that begins with # among the numbers was left out (line 4)"}},
    {"t_ms,a_g\n0,1\n#1,2\n2,3\n# 3,4\n#\n",
     {"3 lines that begin with # among the numbers were left out (the first on line 3)"}},
    {"t_ms,a_g\n0,1\n0,1\n2,3\n", {"1 sample that repeats the previous one was left out (line 3)"}},
    {"  t_ms   a_g\n   0.0   1.0\n +2.0   3.0\n", {}},
    {"0,1\n2,3\n", {}, {.time = "1", .acceleration = {"2"}, .time_unit = "ms", .acceleration_unit = "g"}},
    {"a_g,t_ms,note\n1,0,begin\n3,2,end\n", {}},
    {"time_s,force_N,acceleration_g,velocity_m_per_s\n0,9,1,9\n0.002,9,3,9\n", {}},
    {"\xef\xbb\xbft_ms,a_g\n0,1\n2,3\n", {"the byte order mark at the beginning was ignored"}},
    {"t_ms,a_g\r\n0,1\r\n2,3\r\n", {}},
    {"t_ms,a_g\r0,1\r2,3\r", {}},
    {"t_ms,a_g\n0,1\r\n2,3\r", {"the file has mixed line endings"}},
    {"t_ms;a_g\n0,0;1,0\n2,0;3,0\n", {"decimal commas were read as decimal points"}},
    {"t_ms\ta_g\n0,0\t1,0\n2,0\t3\n", {"decimal commas were read as decimal points"}},
    {"t_ms a_g\n0,0 1,0\n2,0 3,0\n", {"decimal commas were read as decimal points"}},
    {"t_ms,a_g,,\n0,1,,\n2,3,,\n", {"empty columns at the end were left out"}},
    {"t_ms,a_g\n\n0,1\n,\n2,3\n\n\n", {"1 line without content was left out"}},
    {"t_ms,a_g\n0,1\n0,1\n0,1\n2,3\n",
     {"2 samples that repeat the previous one were left out (the first on line 3)"}},
    {"# t_ms a_g\n0 1\n2 3\n", {"the column names were read from the comment on line 1"}},
    {"0,1\n2,3\n",
     {"the first of the two columns is used as the time, the second as the acceleration"},
     in_ms_and_g},
    {"time [ms],acc [mg]\n0,1000\n2,3000\n", {}},
    {"t_ms,ax_mg\n0,1000\n2,3000\n", {}},
    {"Time (s),Accel (G's)\n0,1\n0.002,3\n", {}},
    {"Time,Acceleration\nSEC,G'S\n0,1\n0.002,3\n", {}},
    {"TIME (MSEC);HEAD ACC (GS)\n0;1\n2;3\n", {}},
    {"t_ms,acc (Gs)\n0,1\n2,3\n", {}},
    {"Timestamp [milliseconds];a_g\n0;1\n2;3\n", {}},
    {"\"Time (ms)\",\"Acc (g)\"\n\"0,0\",\"1,0\"\n\"2,0\",\"3,0\"\n",
     {"decimal commas were read as decimal points"}},
    {"t_ms,a_g\n-1,NaN\n0,1\n2,3\n", {"the first row has no value and was left out"}},
    {"t_ms,a_g\n-1,#N/A\n0,1\n2,3\n", {"the first row has no value and was left out"}},
    {"t_ms,a_g\n0,1\n2,3\n4,null\n6,n/a\n", {"the last 2 rows have no value and were left out"}},
    {"t/ms;a/g\n0;1\n2;3\n", {}},
    {"t/ms,a/(m/s^2)\n0,9.80665\n2,29.41995\n", {}},
    {"t_ms,a_g,comment,operator\n0,1\n2,3\n", {}},
    {"t_ms,a_g,comment\n0,1\n2,3,\n", {"empty columns at the end were left out"}},
    {"\n          X         A:A3 PI: HEAD N: 1\n\n     0.0E+00     1.0E+00\n     2.0E-03     3.0E+00\n",
     {},
     {.time = "X", .acceleration = {"A:A3 PI: HEAD N: 1"}, .time_unit = "s", .acceleration_unit = "g"}},
    {"Curve of the head, node 1\n 0 1\n 2 3\n",
     {"the first of the two columns is used as the time, the second as the acceleration"},
     in_ms_and_g},
    {"t_ms,a_g,F_N\n-1,,7\n0,1,7\n2,3,7\n4,,7\n6,NaN,7\n",
     {"the first row has no value and was left out", "the last 2 rows have no value and were left out"}},
    {"t_s,a_g\n0,1\n2,3\n",
     {"t_s: the unit in the file is s, but ms was given and is used"},
     {.time_unit = "ms"}},
};

TEST(pulse_csv, every_style_gives_the_same_pulse) {
  for (const Style& style : styles) {
    SCOPED_TRACE(style.text);
    ASSERT_NO_THROW(read(style.text, style.options)) << said(style.text, style.options);
    const injury::MeasuredPulse measured = read(style.text, style.options);
    EXPECT_THAT(measured.pulse.time, Pointwise(DoubleEq(), {0.0, 0.002}));
    EXPECT_THAT(measured.pulse.acceleration, Pointwise(DoubleEq(), {g, 3 * g}));
    EXPECT_EQ(measured.remarks, style.remarks);
    EXPECT_EQ(measured.format, "CSV");
    EXPECT_EQ(measured.acceleration.size(), 1U);
    EXPECT_FALSE(measured.time.unit.empty());
    EXPECT_FALSE(measured.acceleration.front().unit.empty());
  }
}

/// The header alone is longer than what was looked at for the separator.
TEST(pulse_csv, a_header_of_five_thousand_columns_hides_no_separator) {
  for (const std::string separator : {";", "\t", ","}) {
    std::string text = "t_ms", row;
    for (int i = 0; i < 5000; ++i) {
      text +=
          separator + "channel no " + std::to_string(i) + " of the logger (" + (i == 77 ? "g" : "V") + ")";
      row += separator + std::to_string(i);
    }
    const injury::MeasuredPulse measured = read(text + "\n0" + row + "\n2" + row + "\n", {});
    EXPECT_EQ(measured.acceleration.front().number, 79) << separator;
    EXPECT_THAT(measured.pulse.acceleration, Pointwise(DoubleEq(), {77 * g, 77 * g})) << separator;
  }
}

TEST(pulse_csv, says_which_columns_and_units_were_used) {
  const injury::MeasuredPulse measured =
      read("note,Time (ms),Acc (g)\nx,0,1\ny,2,3\n", {.acceleration_unit = "m/s2"});
  EXPECT_EQ(measured.time.name, "Time (ms)");
  EXPECT_EQ(measured.time.number, 2);
  EXPECT_EQ(measured.time.unit, "ms");
  EXPECT_EQ(measured.time.unit_origin, "header");
  EXPECT_DOUBLE_EQ(measured.time.factor, 1e-3);
  EXPECT_EQ(measured.acceleration.front().unit, "m/s2");
  EXPECT_EQ(measured.acceleration.front().unit_origin, "given");
  EXPECT_THAT(measured.pulse.acceleration, ElementsAre(1, 3));
}

TEST(pulse_csv, columns_are_named_with_or_without_unit_or_by_number) {
  const std::string text = "t_ms,Acc x [g],Acc y [g],5\n0,1,7,9\n2,3,8,9\n";
  for (const std::string name : {"Acc y [g]", "Acc y", "acc Y", "3"}) {
    SCOPED_TRACE(name);
    EXPECT_THAT(read(text, {.acceleration = {name}}).pulse.acceleration, ElementsAre(7 * g, 8 * g));
  }
}

TEST(pulse_csv, three_columns_come_to_a_resultant_each_with_its_unit) {
  const std::string text = "t_ms,ax [g],ay [m/s2],az [g]\n0,-3,0,4\n1,0,-9.80665,0\n";
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{}, std::vector<std::string>{"az", "2", "ay"}}) {
    const injury::MeasuredPulse measured = read(text, {.acceleration = names, .resultant = true});
    EXPECT_THAT(measured.pulse.acceleration, Pointwise(DoubleEq(), {5 * g, g}));
    EXPECT_EQ(measured.acceleration.size(), 3U);
    EXPECT_TRUE(measured.resultant);
    EXPECT_EQ(measured.components.size(), 3U);
  }
  EXPECT_THAT(read(text, {.resultant = true}).components,
              ElementsAre(ElementsAre(-3 * g, 0), ElementsAre(0, -9.80665), ElementsAre(4 * g, 0)));
  EXPECT_TRUE(read(text, {.acceleration = {"ax"}}).components.empty());
}

/// A table with these times, in ms; the first is in line 2.
std::string at_times(const std::vector<double>& times) {
  std::string text = "t_ms,a_g\n";
  for (const double time : times) text += std::to_string(time) + ",1\n";
  return text;
}

TEST(pulse_csv, missing_rows_are_refused_unless_they_are_to_be_bridged) {
  const std::string text = at_times({0, 1, 2, 3, 50, 51, 52});
  EXPECT_EQ(said(text),
            ":6: t_ms: has a gap of 47 ms between lines 5 and 6 (typical step: 1 ms); --bridge-gaps "
            "interpolates linearly");
  const injury::MeasuredPulse bridged = read(text, {.bridge_gaps = true});
  EXPECT_THAT(bridged.remarks,
              ElementsAre("the gap of 47 ms between lines 5 and 6 was bridged by linear interpolation"));
  EXPECT_EQ(bridged.pulse.time.size(), 7U);
  EXPECT_THAT(said(at_times({0, 1, 2, 3, 5, 6, 7, 9, 10})),
              ::testing::AllOf(HasSubstr("2 ms between lines 5 and 6"),
                               HasSubstr("\n:9: t_ms: has a gap of 2 ms between lines 8 and 9")));
}

TEST(pulse_csv, a_gap_in_uneven_times_is_longer_than_all_around_it) {
  EXPECT_THAT(said(at_times({0, 1, 1.5, 3, 3.6, 5, 30, 31, 31.5, 33})),
              HasSubstr("25 ms between lines 7 and 8"));
  EXPECT_EQ(said(at_times({0, 1, 1.5, 3, 3.6, 5, 13, 14, 14.5, 16})), "");  // 8 ms: less than 10 times 1 ms
}

TEST(pulse_csv, steps_that_grow_rounded_times_and_two_rates_are_no_gaps) {
  std::vector<double> growing{0}, rounded{0}, two_rates{0};
  double step = 0.01;
  for (int i = 0; i < 60; ++i) {
    growing.push_back(growing.back() + step);
    if (i > 40) step *= 1.5;
    rounded.push_back(std::round(1.2 * (i + 1)));
    two_rates.push_back(two_rates.back() + (i < 40 ? 1 : 5));
  }
  for (const auto& times : {growing, rounded, two_rates, {0, 1, 3}, {0, 1, 50}})
    EXPECT_EQ(said(at_times(times)), "") << ::testing::PrintToString(times);
}

TEST(pulse_csv, lists_columns) {
  const test::TemporaryFolder folder;
  const auto columns = input::pulse_csv_columns(folder.write("a.csv", "Time,Head\nms,g\n0,1\n2,3\n")).value();
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_EQ(columns[0].name, "Time");
  EXPECT_EQ(columns[0].unit, "ms");
  EXPECT_EQ(columns[1].name, "Head");
  EXPECT_EQ(columns[1].number, 2);
}

TEST(pulse_csv, a_table_without_times_is_read_with_an_interval) {
  for (const std::string text :
       {"acc [g]\n1\n3\n", "acc [g]\n1,0\n3\n", "Logger 12 34\nacc\n[g]\n1.0\n3.0\n", "a_g\r\n1\r\n3\r\n\r\n",
        "count,a_g\n7,1\n8,3\n", "time [ms];a_g\n0,7;1,0\n0,7;3,0\n", "# a_g\n1\n3\n"}) {
    SCOPED_TRACE(text);
    const input::PulseOptions options{.interval = 2e-3};
    ASSERT_EQ(said(text, options), "");
    const injury::MeasuredPulse measured = read(text, options);
    EXPECT_THAT(measured.pulse.time, ElementsAre(0, 2e-3));
    EXPECT_THAT(measured.pulse.acceleration, Pointwise(DoubleEq(), {g, 3 * g}));
    EXPECT_EQ(measured.time.number, 0);
    EXPECT_EQ(measured.time.unit_origin, "given");
  }
  EXPECT_THAT(read("time [ms],a_g\n0,1\n0,3\n", {.interval = 2e-3}).remarks,
              ElementsAre("the times in column 1, time [ms], were not read because --interval was given"));
  EXPECT_THAT(read("count,a_g\n7,NaN\n8,1\n9,3\n", {.interval = 2e-3}).pulse.time, ElementsAre(2e-3, 4e-3));
  EXPECT_THAT(read("1,5\n3,5\n-2,5\n", {.acceleration_unit = "g", .interval = 2e-3}).pulse.acceleration,
              Pointwise(DoubleEq(), {1.5 * g, 3.5 * g, -2.5 * g}));
  EXPECT_THAT(read("ax [g],ay [g]\n3,4\n6,8\n", {.resultant = true, .interval = 2e-3}).pulse.acceleration,
              Pointwise(DoubleEq(), {5 * g, 10 * g}));
}

/// Steps of 0.1 ms behind ten digits of seconds, which a double has no room for.
TEST(pulse_csv, times_of_a_clock_count_from_the_first_sample) {
  const auto table = [](const std::string& whole, char sign) {
    std::string text = std::string("time_s;a_g\n");
    for (int i = 0; i < 400; ++i) {
      const std::string digits = std::to_string(10000 + 1234 + i);
      text += whole + sign + digits.substr(1) + ";" + std::to_string(i % 7) + "\n";
    }
    return text;
  };
  for (const char sign : {'.', ','}) {
    const injury::MeasuredPulse measured = read(table("1764068400", sign));
    EXPECT_EQ(measured.counts_from, std::string("1764068400") + sign + "1234 s");
    EXPECT_THAT(measured.remarks.back(), HasSubstr("Dashpad counts them from the first sample"));
    for (std::size_t i = 1; i < 400; ++i)
      EXPECT_NEAR((measured.pulse.time[i] - measured.pulse.time[i - 1]) / 1e-4, 1, 1e-9) << i;
    EXPECT_EQ(measured.pulse.time.front(), 0);
  }
  const injury::MeasuredPulse near = read(table("39", '.'));
  EXPECT_EQ(near.counts_from, "");  // 39.12 s are less than a thousand times 39.9 ms
  EXPECT_EQ(near.pulse.time.front(), 39.1234);
  EXPECT_EQ(read(table("40", '.')).counts_from, "40.1234 s");
  EXPECT_THAT(said("time_s,a_g\n1764068400.00000002,1\n1764068400.00000001,2\n"), HasSubstr("is earlier"));
}

/// Each notation of two times 2 ms apart.
TEST(pulse_csv, times_of_day_count_from_the_first_sample) {
  for (const auto& [first, second] : std::vector<std::pair<std::string, std::string>>{
           {"10:00:00.000", "10:00:00.002"},
           {"10:00:00,000", "10:00:00,002"},
           {"23:59:59.999", "00:00:00.001"},
           {"2024-05-01T23:59:59.999Z", "2024-05-02T00:00:00.001Z"},
           {"2024-12-31T23:59:59.999", "2025-01-01T00:00:00.001"},
           {"2024-05-01 10:00:00.000+02:00", "2024-05-01 08:00:00.002+00:00"},
           {"2024/05/01 10:00:00.000-0530", "2024/05/01 10:00:00.002-0530"},
           {"28.02.2024 23:59:59.999", "29.02.2024 00:00:00.001"},
           {"05/31/2024 11:59:59.999 PM", "06/01/2024 12:00:00.001 AM"},
           {"05/31/2024 11:59:59.999 p.m.", "06/01/2024 12:00:00.001 a.m."},
           {"2024-05-01 10:00:00.000 CEST", "2024-05-01 08:00:00.002 UTC"},
           {"10:00:00.000 Uhr", "10:00:00.002 Uhr"},
           {"59:59.9990", "00:00.0010"},
           {"7:05:03.1234567", "7:05:03.1254567"}}) {
    SCOPED_TRACE(first);
    const std::string text = "Time;Acc [g]\n" + first + ";1\n" + second + ";3\n";
    ASSERT_EQ(said(text), "");
    const injury::MeasuredPulse measured = read(text);
    EXPECT_EQ(measured.pulse.time.front(), 0);
    EXPECT_NEAR(measured.pulse.time.back(), 2e-3, 1e-12);
    EXPECT_EQ(measured.counts_from, first);
    EXPECT_EQ(measured.time.unit_origin, "format");
  }
  EXPECT_THAT(
      read("Date,Clock,a_g\n2024-05-01,10:00:00.000,1\n2024-05-01,10:00:00.002,3\n", {.time = "Clock"})
          .pulse.acceleration,
      Pointwise(DoubleEq(), {g, 3 * g}));
  EXPECT_EQ(read("stamp;a_g\n10:00:00,1;1\nlate;3\n", {.acceleration = {"a_g"}, .interval = 2e-3})
                .pulse.time.size(),
            2U);
  EXPECT_THAT(said("Time,a_g\n59:59.9,1\n60:00.1,3\n"),
              HasSubstr("must be a time of day, as in the first row of numbers"));
  EXPECT_THAT(said("Time,a_g\n10:00:01,1\n10:00:00,3\n"), HasSubstr("is earlier than the previous time"));
  EXPECT_THAT(said("Time,a_g\n10:00:01,1\n10:00:02,3\n", {.time_unit = "ms"}),
              HasSubstr("is a time of day and takes no unit: leave out --time-unit"));
}

/// Whole numbers beside 1,234 in one column: it may be 1234.
TEST(pulse_csv, commas_of_thousands_are_not_taken_for_decimals) {
  EXPECT_THAT(said("t_ms;a_g\n0;987\n1;1,234\n2;12,345\n"),
              HasSubstr(":3: the comma here may separate thousands"));
  EXPECT_THAT(said("t_ms,a_g\n0,987\n1,\"1,234\"\n"), HasSubstr(":3: the comma here may separate thousands"));
  EXPECT_THAT(read("t_ms;a_g\n0;0\n1;1,234\n2;12,345\n").pulse.acceleration,
              Pointwise(DoubleEq(), {0.0, 1.234 * g, 12.345 * g}));
  EXPECT_EQ(said("t_ms;a_g\n0;987\n1;1,23\n"), "");
}

TEST(pulse_csv, samples_that_share_a_time_are_one_fault_with_the_interval_that_helps) {
  std::string rounded = "t_ms,a_g\n", packets = rounded;
  for (int i = 0; i < 50; ++i) {
    rounded += std::to_string(4 * i / 10) + "," + std::to_string(i) + "\n";
    packets += std::to_string(10 * (i / 5)) + "," + std::to_string(i) + "\n";
  }
  EXPECT_THAT(said(rounded), HasSubstr("--interval \"0.3878 ms\" (19 ms over 49 steps)"));
  EXPECT_THAT(said(packets), HasSubstr("40 samples have the same time as the previous one"));
  EXPECT_THAT(said(packets), HasSubstr("--interval \"2 ms\" (90 ms over 45 steps)"));
  EXPECT_EQ(std::ranges::count(said(packets), '\n'), 0);
}

TEST(pulse_csv, is_cut_on_the_printed_scale) {
  const std::string text = "t_ms,a_g\n0,7\n1,8\n2,bad\n3,1\n5,3\n7,nan\n";
  const injury::MeasuredPulse measured = read(text, {.cut = {.from = 3e-3, .to = 5e-3}});
  EXPECT_THAT(measured.pulse.time, ElementsAre(3e-3, 5e-3));
  EXPECT_THAT(measured.pulse.acceleration, Pointwise(DoubleEq(), {g, 3 * g}));
  EXPECT_THAT(measured.remarks, ElementsAre("only the samples from 3 to 5 ms are used, 2 of 6"));
  EXPECT_THAT(said(text, {.cut = {.from = 2e-3}}), HasSubstr(":4: a_g = bad: must be a number"));
  EXPECT_THAT(said(text, {.cut = {.from = 8e-3}}),
              HasSubstr("--from, --to: there is no sample from 8 to 7 ms; the record runs from 0 to 7 ms"));
  EXPECT_THAT(said(text, {.cut = {.to = 0.5e-3}}), HasSubstr("there is only one sample from 0 to 0.5 ms"));
  const injury::MeasuredPulse of_clock =
      read("Time,a_g\n10:00:00.000,7\n10:00:00.001,1\n10:00:00.003,3\n", {.cut = {.from = 1e-3}});
  EXPECT_EQ(of_clock.pulse.time.size(), 2U);
  EXPECT_NEAR(of_clock.pulse.time.front(), 1e-3, 1e-12);
}

/// NI's layout: one header of the file, one of the segment, then names and numbers.
std::string lvm(const std::string& x_columns, const std::string& table) {
  return "LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\nDecimal_Separator\t,\nX_Columns\t" +
         x_columns +
         "\nTime\t09:51:39,197\n***End_of_Header***\t\n\t\nChannels\t2\t\t\nSamples\t2\t2\t\n"
         "Y_Unit_Label\tNewtons\tg\t\nX_Dimension\tTime\tTime\t\nX0\t0,0E+0\t1,0E-3\t\n"
         "Delta_X\t1,0E-3\t2,0E-3\t\n***End_of_Header***\t\t\t\n" +
         table;
}

TEST(pulse_csv, labview_files_say_their_units_and_times) {
  const injury::MeasuredPulse none =
      read(lvm("No", "X_Value\tForce\tHead\tComment\n\t5,0\t1,0\tstart\n\t5,0\t3,0\n"));
  EXPECT_THAT(none.pulse.time, Pointwise(DoubleEq(), {1e-3, 3e-3}));
  EXPECT_THAT(none.remarks, ElementsAre("the sampling interval, 2 ms, was read from the header",
                                        "decimal commas were read as decimal points"));
  const injury::MeasuredPulse one =
      read(lvm("One", "X_Value\tForce\tHead\tComment\n0,0\t5,0\t1,0\n0,002\t5,0\t3,0\n"));
  EXPECT_THAT(one.pulse.time, Pointwise(DoubleEq(), {0.0, 2e-3}));
  const injury::MeasuredPulse each = read(
      lvm("Multi",
          "X_Value\tForce\tX_Value\tHead\tComment\n0,0\t5,0\t0,001\t1,0\n0,1\t5,0\t0,003\t3,0\n0,2\t5,0\n"));
  EXPECT_THAT(each.pulse.time, Pointwise(DoubleEq(), {1e-3, 3e-3}));
  for (const injury::MeasuredPulse& measured : {none, one, each}) {
    EXPECT_THAT(measured.pulse.acceleration, Pointwise(DoubleEq(), {g, 3 * g}));
    EXPECT_EQ(measured.acceleration.front().name, "Head");
    EXPECT_EQ(measured.format, "LVM");
  }
  EXPECT_THAT(said(lvm("No", "X_Value\tF\tA\n\t5\t1\n\t5\t3\n") + lvm("No", "X_Value\tF\tA\n\t5\t1\n")),
              HasSubstr("contains 3 measurements; put each in a separate file"));
  EXPECT_THAT(said(lvm("Multi", "X_Value\tA\tX_Value\tB\n0\t5\t0\t1\n1\t5\t1\t3\n"),
                   {.time = "1", .acceleration = {"A", "B"}, .acceleration_unit = "g", .resultant = true}),
              HasSubstr("X_Columns = Multi: each channel has its own times"));
  EXPECT_THAT(said("LabVIEW Measurement\nSeparator\tTab\n"), HasSubstr("has no line ***End_of_Header***"));
}

TEST(pulse_csv, volts_become_an_acceleration_with_a_sensitivity) {
  const input::Sensitivity half = input::sensitivity_of("5 mV/g");
  for (const auto& [text, options] : std::vector<std::pair<std::string, input::PulseOptions>>{
           {"t_ms,ch1 [mV]\n0,10\n2,30\n", {.sensitivity = {ten_mv_per_g()}}},
           {"t_ms,acc [V]\n0,0.01\n2,0.03\n", {.sensitivity = {ten_mv_per_g()}}},
           {"t_ms,acc [V],old_g\n0,0.01,7\n2,0.03,7\n", {.sensitivity = {ten_mv_per_g()}}},
           {"Time,ch1\n[ms],[mV]\n0,10\n2,30\n", {.sensitivity = {ten_mv_per_g()}}},
           {"t_ms,ch1\n0,10\n2,30\n",
            {.acceleration = {"ch1"}, .acceleration_unit = "mV", .sensitivity = {ten_mv_per_g()}}},
           {"ch1 [mV]\n10\n30\n", {.sensitivity = {ten_mv_per_g()}, .interval = 2e-3}},
           {"t_ms,x [mV],y [mV]\n0,6,4\n2,18,12\n",
            {.resultant = true, .sensitivity = {ten_mv_per_g(), half}}}}) {
    SCOPED_TRACE(text);
    ASSERT_EQ(said(text, options), "");
    const injury::MeasuredPulse measured = read(text, options);
    EXPECT_THAT(measured.pulse.acceleration, Pointwise(DoubleEq(), {g, 3 * g}));
    EXPECT_EQ(measured.acceleration.front().sensitivity, "10 mV/g");
  }
  EXPECT_EQ(read("t_ms,a_g\n0,1\n2,3\n").acceleration.front().sensitivity, "");
}

TEST(pulse_csv, a_sensitivity_is_a_voltage_for_an_acceleration) {
  EXPECT_DOUBLE_EQ(ten_mv_per_g().volts_per_acceleration, 10e-3 / g);
  EXPECT_DOUBLE_EQ(input::sensitivity_of("0.5 V / (m/s2)").volts_per_acceleration, 0.5);
  EXPECT_DOUBLE_EQ(input::sensitivity_of("1.02 mV/m/s^2").volts_per_acceleration, 1.02e-3);
  for (const std::string text :
       {"10 mV", "10", "10 g/mV", "10/g", "mV/g", "-1 mV/g", "0 mV/g", "10 mV/s", "/", ""})
    EXPECT_THROW(input::sensitivity_of(text), UnitError) << text;
}

struct Bad {
  std::string text;
  std::string said;
  input::PulseOptions options = {};
};

/// Made on demand: the tests of units want to be the first to ask for any.
std::vector<Bad> bad_files() {
  return {
      // Units.
      {"time,acc\n0,1\n2,3\n", ":1: time: the time has no unit in the header; give one with --time-unit"},
      {"time,acc\n0,1\n2,3\n", ":1: acc: the acceleration has no unit in the header"},
      {"0,1\n2,3\n", ": column 2: the acceleration has no unit"},
      {"time [ms],acc [mile]\n0,1\n2,3\n", "no acceleration column was recognized"},
      {"time [ms],acc [kg]\n0,1\n2,3\n", "an acceleration is needed", {.acceleration = {"acc"}}},
      {"t_ms,a_g\n0,1\n2,3\n",
       "--acceleration-unit kg: an acceleration is needed",
       {.acceleration_unit = "kg"}},
      {"time_ms,acceleration_furlong_per_ms2\n0,1\n2,3\n",
       "\"furlong_per_ms2\" in the header is not a known unit of acceleration; give one with"},
      {"time [ms],acc [mile]\n0,1\n2,3\n", "the unit \"mile\" of column 2 is not a unit of acceleration"},
      {"time [ms],acc [mm/fortnite2]\n0,1\n2,3\n", "unknown unit \"mm/fortnite2\""},
      {"t_ms,a_g\n0,1\n2,3\n", "--time-unit g: a time is needed", {.time_unit = "g"}},
      // Columns.
      {"t_ms,a_g,b_g\n0,1,2\n2,3,4\n",
       "several columns could be the acceleration: a_g (2), b_g (3); choose one with"},
      {"t_ms,t2_ms,a_g\n0,1,2\n2,3,4\n", "several columns could be the time"},
      {"t_ms,x,y\n0,1,2\n2,3,4\n", "no acceleration column was recognized; name it with --acceleration"},
      {"t_ms,a_g\n0,1\n2,3\n",
       "--acceleration b: no such column; available: t_ms (1), a_g (2)",
       {.acceleration = {"b"}}},
      {"t_ms,a_g\n0,1\n2,3\n", "--time 3: columns are numbered 1 to 2", {.time = "3"}},
      {"t_ms,a_g\n0,1\n2,3\n", "--time 0: columns are numbered 1 to 2", {.time = "0"}},
      {"t_ms,a_g,a_g\n0,1,1\n2,3,1\n", "since several have that name", {.acceleration = {"a_g"}}},
      {"t_ms,a_g\n0,1\n2,3\n", "was chosen both as the time and as an acceleration", {.acceleration = {"1"}}},
      {"t_ms,a_g,b_g\n0,1,1\n2,3,1\n", "is named twice", {.acceleration = {"a_g", "2"}, .resultant = true}},
      {"t_ms,a_g,b_g\n0,1,1\n2,3,1\n", "combine them with --resultant", {.acceleration = {"2", "3"}}},
      {"t_ms,a_g\n0,1\n2,3\n", "a resultant needs two or three columns, not 1", {.resultant = true}},
      {"t_ms,a_g,b_g,c_g,d_g\n0,1,1,1,1\n2,3,1,1,1\n", "several columns could be", {.resultant = true}},
      // Numbers.
      {"t_ms,a_g\n0,1\n1,\n2,3\n", ":3: a_g: is missing; gaps are not allowed"},
      {"t_ms,a_g\n0,1\n,2\n2,3\n", ":3: t_ms: is missing"},
      {"t_ms,a_g\n0,1\n1,x\n2,3\n", ":3: a_g = x: must be a number"},
      {"t_ms,a_g\n0,x\n1,2\n2,3\n", ":2: a_g = x: must be a number"},
      {"t_ms,a_g\nx,5\n1,2\n2,3\n", ":2: t_ms = x: must be a number"},
      {"t_ms,a_g\n0,1\n1,nan\n2,3\n", ":3: a_g = nan: must be a finite number"},
      {"t_ms,a_g\n0,1\n1,NaN\n2,\n3,3\n", ":3: a_g = NaN: must be a finite number (2 rows in succession)"},
      {"t_ms,a_g\n0,1\n1,-inf\n2,3\n", ":3: a_g = -inf: must be a finite number"},
      {"t_ms,a_g\n0,1\n1,1e400\n2,3\n", ":3: a_g = 1e400: is too large or too small"},
      {"t_ms,a_g\n0,1\n1,1e308\n2,3\n", ":3: a_g = 1e308: is too large or too small"},
      {"t_ms,a_g\n0,1\n1,0x10\n2,3\n", ":3: a_g = 0x10: must be a number"},
      {"t_ms,a_g\n0,1\n1,5 g\n2,3\n", ":3: a_g = 5 g: must be a number"},
      {"t_ms;a_g\n0;1,5\n1;2.5\n2;3\n", ":3: a_g = 2.5: has a decimal point, but line 2 has a decimal comma"},
      {"t_ms;a_g\n0.0;1\n1;2,5\n2;3\n", ":3: a_g = 2,5: has a decimal comma, but line 2 has a decimal point"},
      {"t_ms;a_g\n0;1.000,5\n1;2,5\n2;3\n", ":2: a_g = 1.000,5: must be a number"},
      {"t_ms,a_g\n0,0,1,0\n1,0,2,5\n", "with decimal commas, use another separator"},
      // Times.
      {"t_ms,a_g\n0,1\n0,2\n2,3\n",
       ":3: t_ms: 1 sample has the same time as the previous one: either the times are rounded"},
      {"t_ms,a_g\n0,1\n2,2\n1,3\n", ":4: t_ms = 1: is earlier than the previous time"},
      {"t_ms,a_g\n1,1\n", "has only one sample"},
      {"t_ms,a_g\n1,1\n1,1\n", "has only one sample"},
      // Rows.
      {"t_ms,a_g\n0,1\n1\n2,3\n", ":3: has 1 field where 2 are expected"},
      {"t_ms,a_g\n0,1\n1,2,3\n2,3\n", ":3: has 3 fields where 2 are expected"},
      {"t_ms,a_g\n0,1\n\"1,2\n2,3\n", ":3: has a quotation mark that is not closed"},
      {"t_ms,a_g\n0,1\n\"1\"x,2\n2,3\n", ":3: has text after a closing quotation mark"},
      {"", ": is empty"},
      {"\n\n", "has no row with two or more numbers"},
      {"t_ms,a_g\n", "has no row with two or more numbers"},
      // One column.
      {"t_ms\n1\n2\n", ":2: has one column of numbers and no times"},
      {"acc [g]\n0.1\n0.3\n0.2\n",
       ":2: has one column of numbers and no times; if this column is the acceleration, give the "
       "sampling interval, such as --interval \"0.1 ms\""},
      {"acc [g]\n0,1\n0,3\n0,2\n", ":2: has one column of numbers"},
      {"Logger 12 34\nacc [g]\n0.1\n0.3\n0.2\n0.1\n", ":3: has one column of numbers"},
      {"1\n3\n", ": column 1: the acceleration has no unit", {.interval = 2e-3}},
      {"acc [g]\n1\n\n3\n", ":3: is blank; without times, a sample may be missing here", {.interval = 2e-3}},
      {"acc [g]\n1\nx\n3\n", ":3: acc [g] = x: must be a number", {.interval = 2e-3}},
      {"acc [g]\n1\n", "has only one sample", {.interval = 2e-3}},
      {"ax [g],ay [g]\n1,2\n3,4\n", "several columns could be the acceleration", {.interval = 2e-3}},
      // Volts.
      {"t_ms,ch1 [mV]\n0,1\n2,3\n",
       "no acceleration column was recognized; name it with --acceleration; available: t_ms (1), ch1 [mV] "
       "(2); column 2 is in mV and needs a sensitivity, such as --sensitivity \"10 mV/g\""},
      {"t_ms,ch1 [mV]\n0,1\n2,3\n",
       ":1: ch1 [mV]: is in mV and needs a sensitivity, such as --sensitivity \"10 mV/g\"",
       {.acceleration = {"2"}}},
      {"t_ms,a_g\n0,1\n2,3\n",
       ":1: a_g: is in g, but --sensitivity applies only to voltages (V, mV)",
       {.sensitivity = {ten_mv_per_g()}}},
      {"t_ms,acc\n0,1\n2,3\n",
       "give one with --acceleration-unit (V, mV)",
       {.sensitivity = {ten_mv_per_g()}}},
      {"t_ms,x [V],y [V],z [V]\n0,1,1,1\n2,3,3,3\n",
       "2 sensitivities were given for 3 acceleration signals; give one for all or one for each",
       {.resultant = true, .sensitivity = {ten_mv_per_g(), ten_mv_per_g()}}},
      // No text.
      {std::string("t_ms,a_g\n0,1\n\0,2", 15), ":3: is not text: it contains the byte 0"},
      {"\xff\xfet", ":1: is UTF-16; save it as UTF-8"},
      {"\x7f"
       "ELF\x02\x01\x01",
       "is not text"},
  };
}

TEST(pulse_csv, each_kind_of_bad_file_is_told) {
  for (const Bad& bad : bad_files()) {
    SCOPED_TRACE(bad.text);
    EXPECT_THAT(said(bad.text, bad.options), HasSubstr(bad.said));
  }
}

TEST(pulse_csv, all_faults_are_told_at_once_but_not_without_end) {
  EXPECT_EQ(said("t_ms,a_g\n0,x\n1,2\n1,3\n4,\n5,1\n"),
            ":2: a_g = x: must be a number\n:5: a_g: is missing; gaps are not allowed\n:4: t_ms: 1 sample "
            "has the same time as the previous one: either the times are rounded, or each time applies to a "
            "packet of samples; if the samples are evenly spaced, give their interval with --interval \"2 "
            "ms\" (4 ms over 2 steps)");
  std::string text = "t_ms,a_g\n0,1\n";
  for (int i = 0; i < 100'000; ++i) text += "x,y\n";
  try {
    read(text);
    FAIL();
  } catch (const input::InputError& error) {
    EXPECT_EQ(error.faults().size(), 200U);
    EXPECT_THAT(error.faults().back().rule, HasSubstr("reading stopped here"));
  }
}

TEST(pulse_csv, only_regular_files_of_limited_size_are_read) {
  const test::TemporaryFolder folder;
  const auto large = folder.write("large.csv", "");
  std::filesystem::resize_file(large, (std::uintmax_t{1} << 30) + 1);  // takes no space: it is a hole
  const auto pipe = folder.path() / "pipe.csv";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::vector<std::pair<std::filesystem::path, std::string>> rows{
      {folder.path() / "none.csv", "no such file"}, {folder.path(), "is a folder"},
      {large, "is larger than 1024 MiB"},           {pipe, "is not a regular file"},
      {"/dev/zero", "is not a regular file"},       {"", "no such file"}};
  for (const auto& [file, rule] : rows) {
    SCOPED_TRACE(file);
    try {
      input::read_pulse_csv(file, {}).value();
      FAIL();
    } catch (const input::InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(rule));
    }
  }
}

}  // namespace
}  // namespace dashpad
