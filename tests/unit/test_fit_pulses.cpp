/// Whole pulses in fits: which part counts, and what is said about bad ones.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "dashpad/fit/fit.hpp"
#include "dashpad/injury/metrics.hpp"
#include "dashpad/input/fault.hpp"
#include "fit/card.hpp"
#include "shared/temporary_folder.hpp"
#include "unit/sample_case.hpp"

namespace dashpad::fit {
namespace {

using test::edited;
using testing::HasSubstr;

constexpr double pi = 3.141592653589793;

/// Half a sine of 10 ms and 500 m/s2 from 20 ms on, downwards, every 10 us.
Pulse half_sine(double begin = 0) {
  Pulse pulse;
  for (int i = 0; i <= 5000; ++i) {
    const double t = begin + 1e-5 * i;
    pulse.time.push_back(t);
    pulse.acceleration.push_back(t >= 0.02 && t <= 0.03 ? -500 * std::sin(pi * (t - 0.02) / 0.01) : 0);
  }
  return pulse;
}

TEST(DecelerationOf, GoesFromTheOnsetToTheEndWithThePeakUp) {
  const MeasuredDeceleration measured_deceleration = deceleration_of({half_sine()});
  // 5 % of the peak are reached after asin(0.05) / pi of the 10 ms.
  const double after = 0.01 * std::asin(0.05) / pi;
  EXPECT_NEAR(measured_deceleration.onset, 0.02 + after, 1e-8);
  EXPECT_NEAR(measured_deceleration.peak, 500, 1e-9);
  EXPECT_NEAR(measured_deceleration.half_peak_width, 0.01 * 2 / 3, 1e-7);
  EXPECT_NEAR(measured_deceleration.interval, 1e-5, 1e-12);
  EXPECT_EQ(measured_deceleration.time.size(), max_pulse_points);
  EXPECT_NEAR(static_cast<double>(measured_deceleration.samples), 984, 1);
  EXPECT_GE(measured_deceleration.time.front(), 0);
  EXPECT_LT(measured_deceleration.time.front(), 1e-5);
  EXPECT_NEAR(measured_deceleration.time.back(), 0.01 - after, 1e-5);
  for (std::size_t i = 0; i < measured_deceleration.time.size(); ++i)
    EXPECT_NEAR(measured_deceleration.deceleration[i],
                500 * std::sin(pi * (measured_deceleration.time[i] + after) / 0.01), 2e-5)
        << i;
}

/// A resultant of noise never changes its sign: with its quiet part known the tail does not count.
TEST(DecelerationOf, EndsAtTheLevelOfTheQuietPart) {
  Pulse pulse = half_sine();
  for (std::size_t i = 0; i < pulse.time.size(); ++i)
    pulse.acceleration[i] = std::hypot(pulse.acceleration[i], 1 + static_cast<double>(i % 7) / 4);
  const MeasuredDeceleration measured_deceleration = deceleration_of({pulse}, injury::Stretch{0, 0.018});
  EXPECT_NEAR(static_cast<double>(measured_deceleration.samples), 984, 12);
  EXPECT_NEAR(measured_deceleration.velocity_change, 2 / pi * 500 * 0.01, 0.01);
  EXPECT_GT(deceleration_of({pulse}).samples, 2900U);  // nothing tells the noise from the pulse
}

TEST(DecelerationOf, TakesTheHicOfTheImpactAlone) {
  const double alone = deceleration_of({half_sine()}).hic;
  EXPECT_NEAR(alone, injury::hic(half_sine(), injury::unlimited_window).value, 1e-4 * alone);
  Pulse twice = half_sine();  // and again, a little weaker, as the head falls back
  for (std::size_t i = 0; i < twice.time.size(); ++i)
    if (const double t = twice.time[i]; t >= 0.034 && t <= 0.044)
      twice.acceleration[i] = -480 * std::sin(pi * (t - 0.034) / 0.01);
  ASSERT_GT(injury::hic(twice, injury::unlimited_window).value, 1.1 * alone);
  EXPECT_DOUBLE_EQ(deceleration_of({twice}).hic, alone);
}

TEST(DecelerationOf, KeepsAllSamplesOfAShortPulse) {
  Pulse pulse;
  for (int i = 0; i <= 20; ++i) {
    pulse.time.push_back(0.001 * i);
    pulse.acceleration.push_back(i > 2 && i < 15 ? 100 * std::sin(pi * (i - 2) / 13) : 0);
  }
  const MeasuredDeceleration measured_deceleration = deceleration_of({pulse});
  EXPECT_EQ(measured_deceleration.samples, measured_deceleration.time.size());
  EXPECT_GE(measured_deceleration.time.size(), 12U);
}

std::string fault_in(const Pulse& pulse) {
  try {
    deceleration_of({pulse});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(DecelerationOf, RefusesPulsesWithoutOnsetWithoutHeightAndWithTooFewSamples) {
  EXPECT_THAT(fault_in(half_sine(0.025)), HasSubstr("the record does not include the onset"));
  Pulse flat = half_sine();
  for (double& a : flat.acceleration) a = 0;
  EXPECT_THAT(fault_in(flat), HasSubstr("its acceleration is 0 throughout"));
  EXPECT_THAT(fault_in({{0, 1, 2, 3}, {0, 5, 0, 0}}), HasSubstr("a fit needs at least 5"));
}

const std::string elastic_drop = R"(title = "Drop"
[impactor]
mass = "5 kg"
radius = "80 mm"
speed = "3 m/s"
[pad]
thickness = "50 mm"
law = "elastic"
[pad.parameters]
modulus = "300 kPa"
[support]
type = "rigid"
)";

const std::string pulse_fit = R"(case = "drop.toml"
[unknowns]
"pad.parameters.modulus" = {bounds = ["50 kPa", "2 MPa"]}
[[impacts]]
case = "drop.toml"
pulse = {file = "drop.csv", deviation = "5 %"}
)";

class FitPulseTest : public testing::Test {
 protected:
  void SetUp() override {
    write("drop.toml", elastic_drop);
    write("drop.csv", csv(half_sine()));
  }
  static std::string csv(const Pulse& pulse) {
    std::string text = "time_ms,acceleration_g\n";
    for (std::size_t i = 0; i < pulse.time.size(); i += 5)
      text += fmt::format("{:.6f},{:.6f}\n", 1e3 * pulse.time[i], pulse.acceleration[i] / standard_gravity);
    return text;
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
  }
  FitFile read(const std::string& text) {
    write("fit.toml", text);
    return read_fit(folder_.path() / "fit.toml", DASHPAD_SOURCE_DIR "/materials").value();
  }
  std::vector<input::Fault> faults_of(const std::string& text) {
    try {
      read(text);
    } catch (const input::InputError& error) {
      return error.faults();
    }
    return {};
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(FitPulseTest, TakesTheDeviationAsAShareOfThePeakOrInUnits) {
  const auto deviation = [&](const std::string& text) {
    return read(edited(pulse_fit, "\"5 %\"", text)).fit.impacts.at(0).pulse.value().deviation;
  };
  EXPECT_NEAR(deviation("\"5 %\""), 25, 1e-3);
  EXPECT_NEAR(deviation("\"3 g\""), 3 * standard_gravity, 1e-9);
  EXPECT_NEAR(deviation("\"40 m/s2\""), 40, 1e-9);
}

TEST_F(FitPulseTest, TakesColumnsUnitsAndAFilter) {
  write("drop.csv", edited(csv(half_sine()), "time_ms,acceleration_g", "t,a"));
  const FitFile fit_file = read(edited(pulse_fit, "deviation =",
                                       "columns = {time = \"t\", acceleration = \"a\"}, time_unit = \"ms\", "
                                       "acceleration_unit = \"g\", filter = \"CFC600\", deviation ="));
  const MeasuredDeceleration& pulse = fit_file.fit.impacts.at(0).pulse.value();
  EXPECT_EQ(pulse.filter.value().channel_frequency_class, 600);
  EXPECT_NEAR(pulse.peak, 500, 5);
  EXPECT_EQ(fit_file.files.back().file.filename(), "drop.csv");
}

/// The file's own quiet part is found, and samples of rest before a fall are left out.
TEST_F(FitPulseTest, TakesTheContactAlone) {
  Pulse pulse = half_sine();
  for (std::size_t i = 0; i < pulse.time.size(); ++i)
    pulse.acceleration[i] =
        std::hypot(pulse.acceleration[i], 1 + static_cast<double>(i / 5 % 7) / 4) + (i < 500 ? 10 : 0);
  write("drop.csv", csv(pulse));
  const MeasuredDeceleration measured_deceleration = read(pulse_fit).fit.impacts.at(0).pulse.value();
  EXPECT_NEAR(static_cast<double>(measured_deceleration.samples), 984.0 / 5, 5);
  EXPECT_NEAR(measured_deceleration.velocity_change, 2 / pi * 500 * 0.01, 0.02);
}

TEST_F(FitPulseTest, NamesOneFaultForEach) {
  struct Row {
    std::string old, fresh, said;
  };
  const std::vector<Row> rows{
      {"drop.csv", "nowhere.csv", "no such file"},
      {"\"5 %\"", "\"5 mm\"", "acceleration"},
      {"\"5 %\"", "\"0 %\"", "must be more than 0"},
      {", deviation = \"5 %\"", "", "is missing"},
      {"deviation =", "filter = \"CFC100\", deviation =", "CFC180"},
      {"deviation =", "trigger = 1, deviation =", "trigger"},
      {"deviation =", "speed = \"0 m/s\", deviation =", "must be more than 0"},
      {"deviation =", "drop_height = \"1 s\", deviation =", "length"},
      {"deviation =", "speed = \"3 m/s\", drop_height = \"1 m\", deviation =", "not both"},
  };
  for (const Row& row : rows) {
    const auto faults = faults_of(edited(pulse_fit, row.old, row.fresh));
    ASSERT_EQ(faults.size(), 1U) << row.fresh;
    EXPECT_THAT(faults[0].rule + faults[0].key, HasSubstr(row.said));
  }
}

/// The case strikes at 3 m/s, and the pulse changes the velocity by 3.18 m/s.
TEST_F(FitPulseTest, PulsesOfOtherImpactsAreReservations) {
  const auto reservations = [&](const std::string& stated, double factor = 1) {
    Pulse pulse = half_sine();
    for (double& each : pulse.acceleration) each *= factor;
    write("drop.csv", csv(pulse));
    const FitFile fit_file = read(edited(pulse_fit, "deviation =", stated + "deviation ="));
    std::string all;
    for (const std::string& each :
         reservations_of(fit_file.fit, std::vector<double>(fit_file.fit.unknowns.size(), 3e5), {}))
      if (each.find("drop.csv") != std::string::npos) all += each;
    return all;
  };
  EXPECT_EQ(reservations(""), "");
  EXPECT_EQ(reservations("speed = \"3.02 m/s\", "), "");
  EXPECT_EQ(reservations("speed = \"3.04 m/s\", "),
            "drop.toml has an impact speed of 3 m/s, but the impact recorded in drop.csv was at 3.04 m/s.");
  EXPECT_THAT(reservations("drop_height = \"1 m\", "), HasSubstr("drop.csv was at 4.429 m/s."));
  EXPECT_EQ(reservations("", 0.91), "");  // 2.9 m/s: 5 % below 3 m/s are forgiven
  EXPECT_THAT(reservations("", 0.88), HasSubstr("has a velocity change of 2.8"));
  EXPECT_EQ(reservations("", 1.97), "");
  EXPECT_THAT(reservations("", 2), HasSubstr("for an impact at 3 m/s, the speed in drop.toml"));
}

TEST_F(FitPulseTest, NamesFileAndLineOfBadSamples) {
  const std::string sound = csv(half_sine());
  struct Row {
    std::string old, fresh, said;
    int line;
  };
  for (const Row& row : {Row{"\n0.100000,", "\n0.010000,", "is earlier than the previous time", 4},
                         Row{"\n0.100000,-0.000000", "\n0.100000,nan", "", 4},
                         Row{"\n0.100000,0.000000", "\n0.100000,nan", "", 4}}) {
    if (sound.find(row.old) == std::string::npos) continue;  // of the two signs of nothing one is there
    write("drop.csv", edited(sound, row.old, row.fresh));
    const auto faults = faults_of(pulse_fit);
    ASSERT_EQ(faults.size(), 1U) << row.fresh;
    EXPECT_EQ(faults[0].line, row.line);
    EXPECT_THAT(faults[0].file, testing::EndsWith("drop.csv"));
    EXPECT_THAT(faults[0].rule, HasSubstr(row.said));
  }
  write("drop.csv", csv(half_sine(0.025)));
  const auto faults = faults_of(pulse_fit);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_THAT(faults[0].file, testing::EndsWith("fit.toml"));
  EXPECT_EQ(faults[0].line, 6);
  EXPECT_THAT(faults[0].rule, HasSubstr("the record does not include the onset"));
}

}  // namespace
}  // namespace dashpad::fit
