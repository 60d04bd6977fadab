// dashpad pulse of drop tests: what a drop height, gravity and the record before the impact tell.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr double earth = 9.80665;
constexpr double drop_height = 1.8;  // m
constexpr double touch = 20e-3;      // s

double impact_speed() { return std::sqrt(2 * earth * drop_height); }

/// What a sensor in the body shows of a half sine of contact that gives back `restitution` of the speed: the
/// momentum, and what gravity adds meanwhile. g, from 0 s on.
double sensed(double time, double restitution) {
  const double change = (1 + restitution) * impact_speed() + earth * touch;
  const double peak = change * std::numbers::pi / 2 / touch / earth;
  return time > 0 && time < touch ? peak * std::sin(std::numbers::pi * time / touch) : 0;
}

class PulseDropTest : public CommandTest {
 protected:
  json result(const std::string& text, std::vector<std::string> arguments) {
    write_file(file("drop.csv"), text);
    arguments.insert(arguments.begin(), {"pulse", file("drop.csv")});
    arguments.insert(arguments.end(), {"--json", "-"});
    const Outcome outcome = dashpad(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    said = outcome.err;
    return outcome.exit_code == 0 ? json::parse(outcome.out) : json();
  }
  double restitution(const std::string& text, std::vector<std::string> arguments) {
    return result(text, std::move(arguments)).at("impact").at("restitution").get<double>();
  }
  std::string said;  ///< the text of the last result
};

/// Three directions with offsets and noise of 0.6 g, to 60 ms: without gravity and with the length of the
/// noise as part of the pulse the restitution would be 0.68.
TEST_F(PulseDropTest, ARestitutionIsThatOfTheContactOfAResultantWithoutGravity) {
  std::mt19937 random(1984);
  const auto noise = [&] {
    double sum = -6;
    for (int k = 0; k < 12; ++k) sum += static_cast<double>(random()) / 4294967296.0;
    return 0.6 * sum;
  };
  std::string text = "time [s],ax [g],ay [g],az [g]\n";
  for (int i = -400; i <= 1200; ++i) {
    const double time = 5e-5 * i, a = sensed(time, 0.605);
    text +=
        fmt::format("{:.6f},{:.3f},{:.3f},{:.3f}\n", time, 0.04 * a - 0.6 + noise(), 0.03 * a + 0.4 + noise(),
                    std::sqrt(1 - 0.04 * 0.04 - 0.03 * 0.03) * a + 1.1 + noise());
  }
  const std::vector<std::string> options{"--resultant", "--zero", "auto", "--filter", "CFC1000"};
  std::vector<std::string> of_drop = options, of_speed = options;
  of_drop.insert(of_drop.end(), {"--drop-height", "1.8 m"});
  of_speed.insert(of_speed.end(), {"--speed", fmt::format("{} m/s", impact_speed())});
  EXPECT_NEAR(restitution(text, of_drop), 0.605, 5e-3);
  EXPECT_THAT(said, HasSubstr(", after subtracting 0.19"));
  EXPECT_NEAR(restitution(text, of_speed), 0.605 + earth * touch / impact_speed(), 5e-3);
  EXPECT_THAT(said, Not(HasSubstr("gravity")));
  const json change = result(text, of_drop).at("figures").at("velocity_change");
  EXPECT_NEAR(change.at("value_m_per_s").get<double>(), 1.605 * impact_speed() + earth * touch, 0.02);
  EXPECT_NEAR(change.at("begin_s").get<double>(), 0, 5e-4);
  EXPECT_NEAR(change.at("end_s").get<double>(), touch, 5e-4);
}

/// No body rebounds faster than it struck, or goes on: what it would be is not told as if it were a figure.
TEST_F(PulseDropTest, ARestitutionThatCannotBeIsNone) {
  std::string text = "time [s],a [g]\n";
  for (int i = -40; i <= 100; ++i) text += fmt::format("{:.4f},{:.6f}\n", 5e-4 * i, sensed(5e-4 * i, 0.3));
  for (const char* height : {"0.01 m", "20 m"}) {
    const json of = result(text, {"--drop-height", height});
    EXPECT_TRUE(of.at("impact").at("restitution").is_null()) << height;
    EXPECT_FALSE(of.at("impact").at("check").at("agrees").get<bool>());
    EXPECT_THAT(said, HasSubstr("IMPOSSIBLE VELOCITY CHANGE"));
    EXPECT_THAT(said, Not(HasSubstr("Restitution")));
  }
}

/// A logger that shows 1 g at rest for 250 ms, and 0 g in the fall and in the rebound; or 0 and -1 g.
TEST_F(PulseDropTest, RestAndFallAreNotOfThePulse) {
  const double fall = std::sqrt(2 * drop_height / earth);
  for (const double at_rest : {1.0, 0.0}) {
    SCOPED_TRACE(at_rest);
    std::string text = "time [s],az [g]\n";
    for (int i = 0; i * 5e-4 < 0.25 + fall + 0.15; ++i) {
      const double time = i * 5e-4;
      const double shown = time < 0.25 ? 1 : sensed(time - 0.25 - fall, 0.3);
      text += fmt::format("{:.4f},{:.5f}\n", time, shown + at_rest - 1);
    }
    EXPECT_NEAR(restitution(text, {"--drop-height", "1.8 m", "--zero", "auto"}), 0.3, 5e-3);
    EXPECT_THAT(
        said,
        AllOf(
            HasSubstr("REMARK: the first 500 samples, up to 249.5 ms, differ by 1 g from those in the fall"),
            Not(HasSubstr("PULSE CUT")), Not(HasSubstr("IMPOSSIBLE"))));
    const json all = result(text, {"--drop-height", "1.8 m", "--zero", "300 ms,500 ms"});
    EXPECT_NEAR(all.at("impact").at("restitution").get<double>(), 0.3, 5e-3);
    EXPECT_TRUE(all.at("flags").empty()) << all.at("flags");
    EXPECT_NEAR(all.at("offset").at("mean_g").at(0).get<double>(), at_rest - 1, 1e-9);
    EXPECT_EQ(all.at("source").at("begin_s").get<double>(), 0.25);
  }
}

/// The fall in the record is one of 1.8 m; a speed that is too low for the change of velocity has its way
/// out.
TEST_F(PulseDropTest, SaysWhatHeightFallAndVelocityChangeSayOfEachOther) {
  const double fall = std::sqrt(2 * drop_height / earth);
  std::string text = "time [s],az [g]\n";
  for (int i = 0; i * 5e-4 < 0.25 + fall + 0.15; ++i)
    text += fmt::format("{:.4f},{:.5f}\n", i * 5e-4, i < 500 ? 1 : sensed(i * 5e-4 - 0.25 - fall, 0.3));
  const json right = result(text, {"--drop-height", "1.8 m", "--zero", "auto"});
  EXPECT_TRUE(right.at("flags").empty()) << right.at("flags");
  const json& check = right.at("impact").at("check");
  EXPECT_EQ(check.at("agrees"), true);
  const double change = 1.3 * impact_speed() + earth * touch;
  EXPECT_NEAR(check.at("least_scale").get<double>(), (impact_speed() + earth * touch) / change, 2e-3);
  EXPECT_NEAR(check.at("greatest_scale").get<double>(), (2 * impact_speed() + earth * touch) / change, 4e-3);
  EXPECT_THAT(said, HasSubstr("The velocity change agrees with the drop height: "));

  EXPECT_EQ(result(text, {"--drop-height", "1.7 m", "--zero", "auto"}).at("flags").at(0).at("name"),
            "DROP HEIGHT IN DOUBT");
  const json low = result(text, {"--speed", "12 m/s", "--zero", "auto"}).at("impact").at("check");
  EXPECT_EQ(low.at("agrees"), false);
  EXPECT_NEAR(low.at("least_scale").get<double>(), 12 / change, 4e-3);
  EXPECT_THAT(said, HasSubstr("For its velocity change to agree with the speed"));
  EXPECT_TRUE(result(text, {"--zero", "auto"}).at("impact").is_null());
  EXPECT_THAT(said, Not(HasSubstr("velocity change agrees")));
}

}  // namespace
}  // namespace dashpad::test
