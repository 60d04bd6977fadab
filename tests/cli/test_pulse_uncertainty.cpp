// dashpad pulse: what sampling and calibration leave open, and the times of a clock that began long ago.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class PulseUncertaintyTest : public CommandTest {
 protected:
  /// 3 ms up and 7 ms down to 80 g, every 0.1 ms from `first` on, with so many digits behind the point.
  std::string pulse_from(const std::string& first_whole, double first_part) {
    std::string text = "time [s],a [g]\n";
    for (int i = 0; i <= 140; ++i) {
      const double t = 1e-4 * i - 2e-3;
      const double share = t < 3e-3 ? t / 3e-3 : (10e-3 - t) / 7e-3;
      const double a = t > 0 && t < 10e-3 ? 80 * std::pow(std::sin(std::numbers::pi / 2 * share), 2) : 0;
      text +=
          first_whole + fmt::format("{:.4f}", first_part + 1e-4 * i).substr(1) + fmt::format(",{:.6f}\n", a);
    }
    return text;
  }
  Outcome pulse(const std::string& text, std::vector<std::string> options) {
    write_file(file("pulse.csv"), text);
    options.insert(options.begin(), {"pulse", file("pulse.csv")});
    return dashpad(options);
  }
  json result(const std::string& text, std::vector<std::string> options) {
    options.insert(options.end(), {"--json", "-"});
    const Outcome outcome = pulse(text, options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    said = outcome.err;
    return outcome.exit_code == 0 ? json::parse(outcome.out) : json();
  }
  std::string said;  ///< the text of the last result
};

TEST_F(PulseUncertaintyTest, ACalibrationIsInEveryFigureToItsPower) {
  const std::string text = pulse_from("0", 0);
  const json of = result(text, {"--calibration", "2 %"}).at("uncertainty");
  EXPECT_THAT(
      said, testing::AllOf(testing::ContainsRegex("Uncertainty of +Combined +Sampling +Filter +Calibration"),
                           testing::ContainsRegex("Peak acceleration +± 2[^\n]+ 2 %")));
  EXPECT_THAT(said, Not(HasSubstr("--calibration")));
  EXPECT_NEAR(of.at("calibration").get<double>(), 0.02, 1e-15);
  for (const auto& [key, share] : of.at("figures").items()) {
    const bool is_hic = key.starts_with("hic");
    const double calibration = is_hic ? std::pow(1.02, 2.5) - 1 : 0.02;
    EXPECT_NEAR(share.at("calibration").get<double>(), calibration, 1e-12) << key;
    EXPECT_TRUE(share.at("filter").is_null()) << key;
    EXPECT_NEAR(share.at("combined").get<double>(),
                std::hypot(share.at("sampling").get<double>(), calibration), 1e-12)
        << key;
  }
  for (const char* key : {"peak_acceleration", "hic15", "hic36", "clip_3ms", "velocity_change"})
    EXPECT_TRUE(of.at("figures").contains(key)) << key;
  const json without = result(text, {}).at("uncertainty");
  EXPECT_TRUE(without.at("calibration").is_null());
  EXPECT_THAT(said, HasSubstr("--calibration"));
}

TEST_F(PulseUncertaintyTest, ItIsOnThePage) {
  const Outcome outcome = pulse(pulse_from("0", 0), {"--calibration", "3 %", "--report", file("pulse.html")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(read_file(file("pulse.html")),
              testing::AllOf(HasSubstr("Uncertainty (k = 2)"), HasSubstr("Uncertainty of<"),
                             testing::ContainsRegex(">3[^<]{1,6}%<")));
}

TEST_F(PulseUncertaintyTest, WhatIsNoCalibrationIsRefused) {
  for (const char* wrong : {"60 %", "0 %", "-2 %", "nan", "2 g", "", "1e300"}) {
    const Outcome outcome = pulse(pulse_from("0", 0), {"--calibration", wrong});
    EXPECT_EQ(outcome.exit_code, 2) << wrong;
    EXPECT_THAT(outcome.err, HasSubstr("--calibration")) << wrong;
    EXPECT_THAT(outcome.err, HasSubstr("1 error")) << wrong;
    EXPECT_EQ(outcome.out, "") << wrong;
  }
}

/// The same samples by a clock of 1764068400 s count from the first of them, and lose no digit.
TEST_F(PulseUncertaintyTest, TimesOfAClockCountFromTheFirstSample) {
  const json plain = result(pulse_from("0", 0), {});
  EXPECT_TRUE(plain.at("source").at("counts_from").is_null());
  const json clock = result(pulse_from("1764068400", 0.1234), {});
  EXPECT_EQ(clock.at("source").at("counts_from"), "1764068400.1234 s");
  EXPECT_THAT(said, HasSubstr("1764068400.1234 s"));
  EXPECT_EQ(clock.at("source").at("begin_s"), 0);
  for (const char* key : {"hic15", "clip_3ms", "velocity_change", "peak_acceleration"}) {
    const json &there = plain.at("figures").at(key), &here = clock.at("figures").at(key);
    for (const auto& [name, value] : there.items())
      if (value.is_number()) {
        EXPECT_NEAR(here.at(name).get<double>(), value.get<double>(),
                    1e-9 * std::abs(value.get<double>()) + 1e-14)
            << key << ' ' << name;
      }
  }
}

}  // namespace
}  // namespace dashpad::test
