// ISO-MME: what is written reads back, by a reader of this test and by ours; what is told about bad tests;
// what cannot be reached.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "dashpad/input/iso_mme/iso_mme.hpp"
#include "dashpad/output/deck/exports.hpp"
#include "dashpad/output/deck/iso_mme_test.hpp"
#include "sample_mme.hpp"

namespace dashpad {
namespace {

using output::IsoMmeTest;

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

using test::channel;
using test::Files;
using test::said;
using test::sample_test;
using test::with_first;
using test::write;

/// A reader by the description of the format and nothing else: labels up to the first line without a colon.
struct SimpleChannel {
  std::map<std::string, std::string> labels;
  std::vector<double> values;
};
SimpleChannel simple_reader(const std::string& text) {
  SimpleChannel channel;
  std::istringstream stream(text);
  std::string line;
  while (std::getline(stream, line)) {
    EXPECT_TRUE(line.ends_with('\r')) << line;
    line.pop_back();
    const auto colon = line.find(':');
    if (colon == std::string::npos)
      channel.values.push_back(std::strtod(line.c_str(), nullptr));
    else
      channel.labels[line.substr(0, line.find_last_not_of(' ', colon - 1) + 1)] = line.substr(colon + 1);
  }
  return channel;
}

IsoMmeTest test_to_write() {
  return {.title = "A title:\nin two lines",
          .comment = "dashpad",
          .time_of_first_sample = -0.002,
          .sampling_interval = 1e-4,
          .histories = {{output::computed_acceleration_code,
                         "Head",
                         "Acceleration",
                         "m/s2",
                         {0, -1.0 / 3, 1e-300, -981.123456789012345, 5e-324 * 4, 1e8}},
                        {output::computed_force_code, "Head", "Force", "N", {1, 2, 3, 4, 5, 0.1}}}};
}

TEST(iso_mme, what_is_written_reads_back_elsewhere) {
  const IsoMmeTest test = test_to_write();
  const Files files = output::iso_mme_files(test);
  ASSERT_THAT(files, SizeIs(4));
  const SimpleChannel main = simple_reader(files.at("dashpad.mme"));
  EXPECT_EQ(main.labels.at("Title"), "A title: in two lines");
  EXPECT_EQ(main.labels.at("Laboratory name"), "NOVALUE");
  const SimpleChannel list = simple_reader(files.at("Channel/dashpad.chn"));
  EXPECT_EQ(list.labels.at("Number of channels"), "2");
  EXPECT_EQ(list.labels.at("Name of channel 001"), "10HEAD000000ACX0 / Head");
  for (std::size_t i = 0; i < 2; ++i) {
    const SimpleChannel channel = simple_reader(files.at("Channel/dashpad.00" + std::to_string(i + 1)));
    EXPECT_EQ(channel.labels.at("Channel code"), test.histories[i].code);
    EXPECT_EQ(channel.labels.at("Unit"), test.histories[i].unit);
    EXPECT_EQ(channel.labels.at("Reference channel"), "implicit");
    EXPECT_EQ(std::strtod(channel.labels.at("Time of first sample").c_str(), nullptr), -0.002);
    EXPECT_EQ(std::strtod(channel.labels.at("Sampling interval").c_str(), nullptr), 1e-4);
    EXPECT_EQ(channel.labels.at("Number of samples"), "6");
    EXPECT_EQ(channel.values, test.histories[i].values);  // the very same doubles
  }
}

TEST(iso_mme, the_header_has_both_extremes_with_their_times) {
  const Files files = output::iso_mme_files(test_to_write());
  const auto expect = [&](const char* file, const std::string& which, double value, double time) {
    const SimpleChannel channel = simple_reader(files.at(file));
    EXPECT_EQ(std::strtod(channel.labels.at("First global " + which + " value").c_str(), nullptr), value);
    EXPECT_DOUBLE_EQ(std::strtod(channel.labels.at("Time of " + which + " value").c_str(), nullptr), time);
  };
  expect("Channel/dashpad.001", "maximum", 1e8, -0.0015);
  expect("Channel/dashpad.001", "minimum", -981.123456789012345, -0.0017);
  expect("Channel/dashpad.002", "maximum", 5, -0.0016);
  expect("Channel/dashpad.002", "minimum", 0.1, -0.0015);
}

TEST(iso_mme, what_is_written_reads_back_here) {
  IsoMmeTest test = test_to_write();
  test.histories[0].values = {0, -1.0 / 3, 1e-300, -981.123456789012345, 7, 1e8};
  const test::TemporaryFolder folder;
  write(folder.path(), output::iso_mme_files(test));
  const injury::MeasuredPulse measured = input::read_iso_mme(folder.path(), {}).value().measured;
  EXPECT_EQ(measured.pulse.acceleration, test.histories[0].values);
  EXPECT_EQ(measured.pulse.time.front(), -0.002);
  EXPECT_DOUBLE_EQ(measured.pulse.time.back(), -0.0015);
  EXPECT_THAT(measured.remarks, SizeIs(0));
}

TEST(iso_mme, times_of_a_clock_count_from_the_first_sample) {
  Files files = sample_test();
  for (auto& [name, text] : files) {
    const std::string first = ":-0.001\nSampling";
    if (const auto at = text.find(first); at != std::string::npos)
      text.replace(at, first.size(), ":1764068400.5\nSampling");
  }
  const test::TemporaryFolder folder;
  write(folder.path(), files);
  const injury::MeasuredPulse measured =
      input::read_iso_mme(folder.path(), {.channel = "1"}).value().measured;
  EXPECT_EQ(measured.pulse.time, (std::vector<double>{0, 0.001, 0.002}));
  EXPECT_THAT(measured.counts_from, testing::HasSubstr("1764068400.5"));
  EXPECT_THAT(measured.remarks, testing::Contains(testing::HasSubstr("1764068400.5")));
}

/// In m/s2 or in g, the acceleration reads back as it was computed; so does the force beside it.
TEST(iso_mme, curves_read_back_in_the_unit_that_was_asked_for) {
  std::vector<double> times, accelerations, forces;
  for (int i = 0; i <= 100; ++i) {
    times.push_back(output::iso_mme_interval * i);
    accelerations.push_back(-3.0 * i);
    forces.push_back(7.0 * i);
  }
  for (const bool in_g : {false, true}) {
    output::CurveFile file;
    file.acceleration_in_g = in_g;
    file.curves = {{{"acceleration", {"time", "s"}, {"acceleration", "m/s2"}, times, accelerations}, ""},
                   {{"force", {"time", "s"}, {"force", "N"}, times, forces}, ""}};
    const test::TemporaryFolder folder;
    const fs::path zip = folder.write("test.zip", output::iso_mme_zip(file));
    const injury::MeasuredPulse read = input::read_iso_mme(zip, {}).value().measured;
    EXPECT_EQ(read.acceleration.front().unit, in_g ? "g" : "m/s2");
    ASSERT_THAT(read.pulse.acceleration, SizeIs(101));
    for (std::size_t i = 0; i < 101; ++i)
      EXPECT_NEAR(read.pulse.acceleration[i], accelerations[i], 1e-9) << i;
  }
}

TEST(iso_mme, bad_tests_are_not_written) {
  const auto refused = [](auto&& change) {
    IsoMmeTest test = test_to_write();
    change(test);
    EXPECT_THROW(output::iso_mme_files(test), std::invalid_argument);
  };
  for (const std::string name : {"", "../x", "a/b", "a b", "a.b"})
    refused([&](IsoMmeTest& test) { test.name = name; });
  for (const std::string code : {"", "11HEAD", "11HEAD0000??ACX0", "11head0000H3ACX0", "10HEAD000000FOX0"})
    refused([&](IsoMmeTest& test) { test.histories[0].code = code; });
  refused([](IsoMmeTest& test) { test.sampling_interval = 0; });
  refused([](IsoMmeTest& test) { test.time_of_first_sample = std::nan(""); });
  refused([](IsoMmeTest& test) { test.histories.clear(); });
  refused([](IsoMmeTest& test) { test.histories[0].unit.clear(); });
  refused([](IsoMmeTest& test) { test.histories[1].values.pop_back(); });
  refused([](IsoMmeTest& test) { test.histories[1].values[2] = std::numeric_limits<double>::infinity(); });
}

TEST(iso_mme, text_may_be_latin_1_with_any_line_ends) {
  Files files = with_first(
      "Name of the channel :Kopf, Pr\xfc"
      "fung\r\nChannel code:11HEAD0000H3ACXA\r\n"
      "Unit\t:m/s\xb2\r\nReference channel :NOVALUE\r\nTime of first sample : 0\r\n"
      "Sampling interval :1E-3\r\nNumber of samples :NOVALUE\r\n 1.0E+00\r\n2\r\n\r\n\x1a");
  files["v1.mme"] = "\xef\xbb\xbfTitle :x";
  const test::TemporaryFolder folder;
  write(folder.path(), files);
  EXPECT_EQ(input::iso_mme_channels(folder.path()).value().front().name,
            "Kopf, Pr\xc3\xbc"
            "fung");
  const injury::MeasuredPulse measured =
      input::read_iso_mme(folder.path(), {.channel = "1"}).value().measured;
  EXPECT_THAT(measured.pulse.acceleration, ElementsAre(1, 2));
  EXPECT_EQ(measured.acceleration.front().unit, "m/s\xc2\xb2");
}

TEST(iso_mme, remarks) {
  const test::TemporaryFolder folder;
  Files files = with_first(channel("11HEAD0000H3ACXA"));
  write(folder.path(), files);
  EXPECT_THAT(input::read_iso_mme(folder.path(), {.channel = "1", .acceleration_unit = "m/s2"})
                  .value()
                  .measured.remarks,
              ElementsAre("11HEAD0000H3ACXA: the unit in the file is g, but m/s2 was given and is used"));
}

injury::MeasuredPulse read(const Files& files, const input::PulseOptions& options) {
  const test::TemporaryFolder folder;
  write(folder.path(), files);
  return input::read_iso_mme(folder.path(), options).value().measured;
}

TEST(iso_mme, samples_without_a_value_at_the_ends_are_left_out) {
  Files files = sample_test();
  files["Channel/v1.001"] = channel("11HEAD0000H3ACXA", "NOVALUE\n3\n6\n9\nNOVALUE\nNOVALUE\n", "m/s2");
  files["Channel/v1.002"] = channel("11HEAD0000H3ACYA", "1\n4\n8\n12\n1\nNOVALUE\n", "m/s2");
  const injury::MeasuredPulse one = read(files, {.channel = "1"});
  EXPECT_EQ(one.pulse.time, (std::vector<double>{0, 0.001, 0.002}));
  EXPECT_THAT(one.pulse.acceleration, ElementsAre(3, 6, 9));
  EXPECT_THAT(one.remarks, ElementsAre("the first sample has no value (NOVALUE) and was left out",
                                       "the last 2 samples have no value (NOVALUE) and were left out"));
  files.erase("Channel/v1.003");
  files.erase("Channel/v1.chn");
  const injury::MeasuredPulse both = read(files, {.channel = "11HEAD0000H3AC?A", .resultant = true});
  EXPECT_THAT(both.pulse.acceleration, ElementsAre(5, 10, 15));
  EXPECT_EQ(read(files, {.channel = "1", .cut = {.from = 0.5e-3}}).pulse.time,
            (std::vector<double>{0.001, 0.002}));
}

TEST(iso_mme, without_a_first_time_it_is_0) {
  for (const std::string first : {":NOVALUE", ":", ""}) {
    std::string text = channel("11HEAD0000H3ACXA");
    const std::string stated = first.empty() ? "Time of first sample        :-0.001\n" : ":-0.001";
    text.replace(text.find(stated), stated.size(), first);
    const injury::MeasuredPulse measured = read(with_first(text), {.channel = "1"});
    EXPECT_EQ(measured.pulse.time.front(), 0);
    EXPECT_THAT(measured.remarks,
                ElementsAre("the time of the first sample is not stated; it is taken as 0"));
  }
}

TEST(iso_mme, explicit_times_are_those_of_another_channel) {
  const auto with_times = [](const std::string& times, const std::string& name,
                             const std::string& unit = "ms") {
    Files files = sample_test();
    files.erase("Channel/v1.chn");
    files["Channel/v1.005"] = channel("10TIRS000000TI00", times, unit);
    std::string text = channel("11HEAD0000H3ACXA", "1\n2\n3\n4\n");
    const std::string implicit = ":implicit";
    files["Channel/v1.001"] = text.replace(text.find(implicit), implicit.size(), ":explicit" + name);
    return files;
  };
  const std::string named = "\nReference channel name :10tirs000000ti00";
  for (const std::string& name : {named, std::string()}) {
    const injury::MeasuredPulse measured = read(with_times("-1\n-0.5\n0\n0.6\n", name), {.channel = "1"});
    EXPECT_EQ(measured.pulse.time, (std::vector<double>{-1e-3, -0.5e-3, 0, 0.6e-3}));
    EXPECT_EQ(measured.time.name, "10TIRS000000TI00");
    EXPECT_THAT(measured.remarks, SizeIs(0));
  }
  EXPECT_EQ(read(with_times("0\n1\n2\nNOVALUE\n", named), {.channel = "1"}).pulse.time,
            (std::vector<double>{0, 1e-3, 2e-3}));
  const injury::MeasuredPulse clock = read(
      with_times("1764068400000\n1764068400001\n1764068400002\n1764068400003\n", named), {.channel = "1"});
  EXPECT_EQ(clock.pulse.time, (std::vector<double>{0, 1e-3, 2e-3, 3e-3}));
  EXPECT_EQ(clock.counts_from, "1764068400000 ms");
  const auto told = [&](const std::string& times, const std::string& unit = "ms") {
    return said(with_times(times, named, unit), {.channel = "1"});
  };
  EXPECT_THAT(told("0\n1\n1\n2\n"), HasSubstr("v1.005: has times that do not increase"));
  EXPECT_THAT(told("0\n1\n2\n"), HasSubstr("has 3 times for 4 samples"));
  EXPECT_THAT(told("0\n1\n2\n3\n", "m"), HasSubstr("Unit = m: a time is needed"));
}

TEST(iso_mme, choices_that_are_not_clear_are_told) {
  const auto rule = [](const input::PulseOptions& options) { return said(sample_test(), options); };
  EXPECT_THAT(rule({}), HasSubstr("several channels match: 11HEAD0000H3ACXA (1), "));
  EXPECT_THAT(rule({.channel = "9"}),
              HasSubstr("--channel 9: no such channel; available: 11HEAD0000H3ACXA (1)"));
  EXPECT_THAT(rule({.channel = "HEAD"}), HasSubstr("a number or a code of 16 characters"));
  EXPECT_THAT(rule({.channel = "11PELV0000H3ACXA"}), HasSubstr("no such channel"));
  EXPECT_THAT(rule({.channel = "4"}), HasSubstr("Channel/v1.004:4: Unit = kN: an acceleration is needed"));
  EXPECT_THAT(rule({.channel = "1", .resultant = true}),
              HasSubstr("needs two or three directions (X, Y, Z)"));
  EXPECT_THAT(rule({.channel = "????????????????", .resultant = true}),
              HasSubstr("several resultants are possible"));
  EXPECT_THAT(rule({.channel = "1", .acceleration_unit = "kg"}), HasSubstr("--acceleration-unit kg"));
  Files two = sample_test();
  two["other.mme"] = "Title :x\n";
  EXPECT_THAT(said(two), HasSubstr("contains 2 tests: other, v1; choose one with --test"));
  EXPECT_EQ(said(two, {.test = "V1", .channel = "1"}), "");
  EXPECT_EQ(said(two, {.test = "v1.mme", .channel = "1"}), "");
  EXPECT_THAT(said(two, {.test = "v2", .channel = "1"}),
              HasSubstr("--test v2: no such test; available: other, v1"));
  EXPECT_THAT(said(sample_test(), {.test = "v2"}), HasSubstr("no such test"));
  Files uneven = sample_test();
  uneven["Channel/v1.002"] = channel("11HEAD0000H3ACYA", "0\n1\n");
  EXPECT_THAT(said(uneven, {.resultant = true}), HasSubstr("has different times from 11HEAD0000H3ACXA"));
}

TEST(iso_mme, each_kind_of_bad_channel_is_told) {
  const auto of = [](const std::string& samples, const std::string& more = "") {
    return said(with_first(channel("11HEAD0000H3ACXA", samples, "g", more)));
  };
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = channel("11HEAD0000H3ACXA");
    return said(with_first(text.replace(text.find(from), from.size(), to)));
  };
  EXPECT_EQ(of("0\n1\n"), "");
  EXPECT_THAT(of("0\nNOVALUE\n1\n"),
              HasSubstr("v1.001:10: sample = NOVALUE: is missing between two other samples; a pulse must"));
  EXPECT_THAT(
      of("0\nNOVALUE\nNOVALUE\n1\nNOVALUE\n2\n"),
      HasSubstr("v1.001:10: sample = NOVALUE: is missing between two other samples (3 missing in all);"));
  EXPECT_THAT(of("NOVALUE\n1\nNOVALUE\n"), HasSubstr("a pulse needs at least two samples"));
  EXPECT_THAT(of("0\n\n1\n"), HasSubstr("v1.001:10: sample: is missing; gaps are not allowed"));
  EXPECT_THAT(of("0\nx\n1\n"), HasSubstr("v1.001:10: sample = x: must be a number"));
  EXPECT_THAT(of("0\n1,5\n1\n"), HasSubstr("must be a number"));
  EXPECT_THAT(of("0\nnan\n1\n"), HasSubstr("must be a finite number"));
  EXPECT_THAT(of("0\n1e999\n1\n"), HasSubstr("too large or too small"));
  EXPECT_THAT(of("0\n1e308\n1\n"), HasSubstr("too large to compute with"));
  EXPECT_THAT(of("0\n"), HasSubstr("a pulse needs at least two samples"));
  EXPECT_THAT(of(""), HasSubstr("a pulse needs at least two samples"));
  EXPECT_THAT(of("0\n1\n", "no label\n"), HasSubstr("v1.001:9: sample = no label: must be a number"));
  EXPECT_THAT(of(std::string("0\n\0\n", 4)), HasSubstr("is not text"));
  EXPECT_THAT(changed("samples           :3", "samples           :4"),
              HasSubstr(":8: Number of samples = 4: must be the number of samples in the file, 3"));
  EXPECT_THAT(changed("samples           :3", "samples           :99999999999999999999"),
              HasSubstr("must be the number"));
  EXPECT_THAT(changed("samples           :3", "samples           :-1"), HasSubstr("must be the number"));
  EXPECT_THAT(changed("interval           :0.001", "interval           :0"),
              HasSubstr("must be more than 0"));
  EXPECT_THAT(changed("interval           :0.001", "interval           :1e-30"),
              HasSubstr("does not give increasing times"));
  // 1e16, 1.0000000000000002e16 and the same again: between 1e16 and 2e16 doubles are 2 apart.
  EXPECT_THAT(changed("sample        :-0.001\nSampling interval           :0.001",
                      "sample        :1e16\nSampling interval           :1.2"),
              HasSubstr("does not give increasing times"));
  EXPECT_THAT(changed("interval           :0.001", "interval           :NOVALUE"), HasSubstr("is missing"));
  EXPECT_THAT(changed("interval ", "intervall"), HasSubstr("Sampling interval: is missing"));
  EXPECT_THAT(changed("sample        :-0.001", "sample        :x"), HasSubstr("must be a number"));
  EXPECT_THAT(changed(":implicit", ":explicit"), HasSubstr("needs a time channel"));
  EXPECT_THAT(changed(":implicit", ":explicit\nReference channel name :10TIRS000000TI00"),
              HasSubstr("the time channel, 10TIRS000000TI00, is missing"));
  EXPECT_THAT(changed(":implicit", ":other"), HasSubstr("must be implicit or explicit"));
  EXPECT_THAT(changed(":g", ":NOVALUE"), HasSubstr("the acceleration has no unit"));
  EXPECT_THAT(changed(":g", ":furlong"), HasSubstr("Unit = furlong"));
}

TEST(iso_mme, files_that_are_missing_are_told) {
  Files files = sample_test();
  files.erase("v1.mme");
  EXPECT_THAT(said(files), HasSubstr("contains no .mme file"));
  EXPECT_THAT(said({{"v1.mme", "Title :x\n"}}),
              HasSubstr("contains no channels: there is no file Channel/v1.001"));
  files = sample_test();
  files.erase("Channel/v1.001");
  EXPECT_THAT(said(files, {.channel = "11HEAD0000H3ACXA"}), HasSubstr("its file is missing"));
  files = sample_test();
  files.erase("Channel/v1.chn");
  EXPECT_EQ(said(files), "");
  EXPECT_THAT(said(fs::path("/none"), {}), HasSubstr("no such file"));
}

TEST(iso_mme, nothing_outside_of_the_folder_is_read) {
  const test::TemporaryFolder folder;
  const fs::path secret = folder.path() / "secret", test = folder.path() / "test";
  write(secret, sample_test());
  write(test, {{"v1.mme", "Title :x\n"},
               {"Channel/v1.chn", "Name of channel 001 :../../secret/Channel/v1.001\n"},
               {"Channel/v1.002", channel("11HEAD0000H3ACYA")}});
  fs::create_symlink(secret / "Channel/v1.001", test / "Channel/v1.001");
  fs::create_hard_link(test / "Channel/v1.002", test / "Channel/v1.003");  // its own: no harm
  EXPECT_THAT(said(test, {.channel = "1"}), HasSubstr("its file is missing"));
  EXPECT_EQ(said(test, {.channel = "2"}), "");
  fs::remove_all(test / "Channel");
  fs::create_directory_symlink(secret / "Channel", test / "Channel");
  EXPECT_THAT(said(test, {.channel = "1"}), HasSubstr("contains no channels"));
  fs::remove(test / "v1.mme");
  fs::create_symlink(secret / "v1.mme", test / "v1.mme");
  EXPECT_THAT(said(test, {.channel = "1"}), HasSubstr("contains no .mme file"));
}

}  // namespace
}  // namespace dashpad
