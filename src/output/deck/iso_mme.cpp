// Writes curves as a test in ISO-MME. Lines end in CR LF, like those of laboratory programs.

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/cfc_filter.hpp"
#include "dashpad/output/deck/exports.hpp"
#include "dashpad/output/deck/iso_mme_test.hpp"
#include "dashpad/version.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t max_histories = 999;
constexpr std::size_t longest_test_name = 100;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

std::string line(const std::string& label, const std::string& value) {
  return fmt::format("{:<28}:{}\r\n", label, value.empty() ? "NOVALUE" : one_line(value));
}

std::string line(const std::string& label, double value) { return line(label, fmt::format("{}", value)); }

void require(bool holds, const std::string& rule) {
  if (!holds) throw std::invalid_argument("ISO-MME: " + rule);
}

void check(const IsoMmeTest& test) {
  const auto is_plain = [](char c) {
    return is_digit(c) || is_capital(c) || (c >= 'a' && c <= 'z') || c == '-' || c == '_';
  };
  require(
      !test.name.empty() && test.name.size() <= longest_test_name && std::ranges::all_of(test.name, is_plain),
      "the test name must consist of at most 100 letters, digits, - and _");
  require(std::isfinite(test.time_of_first_sample) && std::isfinite(test.sampling_interval) &&
              test.sampling_interval > 0,
          "the first time must be finite, and the sampling interval finite and more than 0");
  require(!test.histories.empty() && test.histories.size() <= max_histories, "1 to 999 histories are needed");
  std::set<std::string> codes;
  for (const IsoMmeHistory& history : test.histories) {
    require(history.code.size() == 16 &&
                std::ranges::all_of(history.code, [](char c) { return is_digit(c) || is_capital(c); }),
            fmt::format("the code \"{}\" must consist of 16 characters, each a digit or a capital letter",
                        one_line(history.code)));
    require(codes.insert(history.code).second, "the code " + history.code + " appears twice");
    require(!history.unit.empty(), history.code + " needs a unit");
    require(history.values.size() >= 2, history.code + " needs at least two samples");
    require(history.values.size() == test.histories.front().values.size(),
            history.code + " must have as many samples as the first history");
    require(std::ranges::all_of(history.values, [](double value) { return std::isfinite(value); }),
            history.code + " has a value that is not finite");
  }
}

std::string main_text(const IsoMmeTest& test) {
  std::string text = line("Data format edition number", "1.6");
  text += line("Laboratory name", test.laboratory);
  for (const char* label : {"Laboratory contact name", "Laboratory contact phone", "Laboratory contact fax",
                            "Laboratory contact email", "Laboratory test ref. number", "Customer name",
                            "Customer test ref. number", "Customer project ref. number",
                            "Customer order number", "Customer cost unit"})
    text += line(label, "");
  text += line("Title", test.title);
  text += line("Medium No./number of media", "1/1");
  text += line("Timestamp", "");
  text += line("Type of the test", "calculation");
  for (const char* label : {"Subtype of the test", "Regulation", "Reference temperature",
                            "Relative air humidity", "Date of the test"})
    text += line(label, "");
  text += line("Number of test objects", "1");
  for (const char* label : {"Name of test object 1", "Class of test object 1", "Code of test object 1",
                            "Ref. number of test object 1"})
    text += line(label, "");
  return text + line("Comments", test.comment);
}

std::string list_text(const IsoMmeTest& test) {
  std::string text = line("Instrumentation standard", "");
  text += line("Number of channels", std::to_string(test.histories.size()));
  for (std::size_t i = 0; i < test.histories.size(); ++i)
    text += line(fmt::format("Name of channel {:03}", i + 1),
                 fmt::format("{} / {}", test.histories[i].code, test.histories[i].name));
  return text;
}

std::string channel_text(const IsoMmeTest& test, const IsoMmeHistory& history) {
  const auto [low, high] = std::ranges::minmax_element(history.values);
  const auto time_of = [&](const auto& place) {
    return test.time_of_first_sample +
           test.sampling_interval * static_cast<double>(place - history.values.begin());
  };
  std::string text = line("Test object number", history.code.substr(0, 1));
  text += line("Name of the channel", history.name);
  text += line("Laboratory channel code", "");
  text += line("Customer channel code", "");
  text += line("Channel code", history.code);
  text += line("Unit", history.unit);
  text += line("Reference channel", "implicit");
  text += line("Reference channel name", "");
  text += line("Data source", "calculation");
  text += line("Data status", "ok");
  text += line("Sampling interval", test.sampling_interval);
  text += line("Bit resolution", "");
  text += line("Time of first sample", test.time_of_first_sample);
  text += line("Number of samples", std::to_string(history.values.size()));
  text += line("Channel frequency class", "");
  text += line("Location", history.code.substr(2, 4));
  text += line("Dimension", history.dimension);
  text += line("Direction", history.code.substr(14, 1));
  text += line("First global maximum value", *high);
  text += line("Time of maximum value", time_of(std::ranges::find(history.values, *high)));
  text += line("First global minimum value", *low);
  text += line("Time of minimum value", time_of(low));
  text += line("Comments", test.comment);
  for (const double value : history.values) text += fmt::format("{}\r\n", value);
  return text;
}

struct CurveChannel {
  const char* curve;
  const char* code;
  const char* name;
  const char* dimension;
};

constexpr CurveChannel channels[] = {
    {"acceleration", computed_acceleration_code, "Acceleration of the impactor", "Acceleration"},
    {"force", computed_force_code, "Force on the impactor", "Force"},
    {"velocity", "10HEAD000000VEX0", "Velocity of the impactor", "Velocity"},
    {"motion", "10HEAD000000DSX0", "Displacement of the impactor", "Displacement"},
    {"penetration", "10PADS000000DSX0", "Penetration of the pad", "Displacement"},
};

const CurveChannel* channel_of(const std::string& curve) {
  const auto* const found =
      std::ranges::find_if(channels, [&](const CurveChannel& channel) { return curve == channel.curve; });
  return found == std::end(channels) ? nullptr : found;
}

IsoMmeHistory history_of(const Curve& curve, bool in_g) {
  const CurveChannel* channel = channel_of(curve.name);
  if (channel == nullptr)
    throw std::invalid_argument("ISO-MME: " + curve.name + " is not a function of time");
  IsoMmeHistory history{channel->code, channel->name, channel->dimension, curve.ordinate.si_unit,
                        injury::resampled({curve.x, curve.y}, iso_mme_interval).acceleration};
  if (in_g && curve.name == "acceleration") {
    history.unit = "g";
    for (double& value : history.values) value /= standard_gravity;
  }
  return history;
}

}  // namespace

std::map<std::string, std::string> iso_mme_files(const IsoMmeTest& test) {
  check(test);
  std::map<std::string, std::string> files;
  files[test.name + ".mme"] = main_text(test);
  files["Channel/" + test.name + ".chn"] = list_text(test);
  for (std::size_t i = 0; i < test.histories.size(); ++i)
    files[fmt::format("Channel/{}.{:03}", test.name, i + 1)] = channel_text(test, test.histories[i]);
  return files;
}

bool is_over_time(const std::string& curve_name) { return channel_of(curve_name) != nullptr; }

std::string iso_mme_zip(const CurveFile& file) {
  IsoMmeTest test;
  test.title = file.title;
  test.laboratory = "computed";
  test.comment = fmt::format("dashpad {}", version());
  for (const std::string& line : file.origin) test.comment += "; " + line;
  for (const std::string& flag : file.flags) test.comment += "; " + flag;
  test.sampling_interval = iso_mme_interval;
  for (const FileCurve& file_curve : file.curves)
    test.histories.push_back(history_of(file_curve.curve, file.acceleration_in_g));
  return zip_of(iso_mme_files(test));
}

}  // namespace dashpad::output
