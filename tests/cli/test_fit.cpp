// dashpad fit as a user runs it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include <sys/stat.h>

#include "command.hpp"
#include "schema.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// 100 kPa e^0.8 / (1 - e) with an alternating error of 1 kPa.
std::string power_csv() {
  std::string csv = "strain,stress_kPa\n";
  for (int i = 1; i <= 40; ++i) {
    const double e = 0.015 * i;
    csv += std::to_string(e) + "," +
           std::to_string(100 * std::pow(e, 0.8) / (1 - e) + (i % 2 == 0 ? 1 : -1)) + "\n";
  }
  return csv;
}

const std::string power_fit = R"(title = "A made-up foam"
[pad]
law = "foam"
[pad.curve]
form = "power"
rate = "0.01 1/s"
modulus = "50 kPa"
contact_exponent = 1
compaction_exponent = 0.5
highest_strain = 0.6
[unknowns]
"pad.curve.modulus" = {bounds = ["1 kPa", "1 MPa"]}
"pad.curve.contact_exponent" = {bounds = [0.1, 1.5]}
"pad.curve.compaction_exponent" = {bounds = [0, 4]}
[[tests]]
file = "test.csv"
strain_unit = "fraction"
rate = "0.01 1/s"
noise = "1 kPa"
[fit]
starts = 2
)";

class FitTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_file(file("test.csv"), power_csv());
    write_file(file("fit.toml"), power_fit);
  }
};

TEST_F(FitTest, AnswersFirstAndWritesACardThatSolves) {
  const Outcome outcome = dashpad({"fit", file("fit.toml"), "--output", file("card.toml")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(
      outcome.out,
      testing::AllOf(testing::StartsWith("The data determine all 3 unknowns; the model deviates from"),
                     HasSubstr("\nA made-up foam\n3 unknowns from 40 points in 1 test: the "
                               "data determine all of them. 2 of 2 starts")));
  const std::string with_card =
      with(elastic_case(), "law = \"elastic\"\n[pad.parameters]\nmodulus = \"300 kPa\"",
           "material = \"card.toml\"");
  write_file(file("with-card.toml"), with_card);
  EXPECT_EQ(dashpad({"run", file("with-card.toml")}).exit_code, 0);
}

/// A cold test gives the modulus at the temperature of the card.
TEST_F(FitTest, TheTemperatureOfATestScalesItsStresses) {
  ASSERT_EQ(dashpad({"fit", file("fit.toml"), "--output", file("card.toml")}).exit_code, 0);
  const std::string card = read_file(file("card.toml"));
  write_file(file("card.toml"),
             card + "\n[temperature]\ntemperatures = [\"-20 degC\", \"23 degC\"]\nfactors = [1.6, 1]\n");
  std::istringstream warm(power_csv());
  std::string cold, line;
  std::getline(warm, cold);
  while (std::getline(warm, line)) {
    const std::size_t comma = line.find(',');
    cold += "\n" + line.substr(0, comma + 1) + std::to_string(1.6 * std::stod(line.substr(comma + 1)));
  }
  write_file(file("cold.csv"), cold + "\n");
  const std::string fit = R"([pad]
material = "card.toml"
[unknowns]
"pad.curve.modulus" = {bounds = ["1 kPa", "1 MPa"]}
[[tests]]
file = "cold.csv"
rate = "0.01 1/s"
noise = "1 kPa"
temperature = "-20 degC"
)";
  write_file(file("cold.toml"), fit);
  const Outcome outcome = dashpad({"fit", file("cold.toml"), "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NEAR(json::parse(outcome.out)["unknowns"][0]["value"].get<double>(), 100e3, 3e3);
  write_file(file("card.toml"), card);
  const Outcome refused = dashpad({"fit", file("cold.toml")});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("has no temperature table"));
}

TEST_F(FitTest, JsonIsAsTheSchemaSays) {
  const Outcome outcome = dashpad({"fit", file("fit.toml"), "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(schema_faults(result, "fit"), "");
  EXPECT_NEAR(result["unknowns"][0]["value"].get<double>(), 100e3, 3e3);
  EXPECT_EQ(result["unknowns"][0]["interval"]["open"], "no");
}

TEST_F(FitTest, WritesASampleWithinTheBounds) {
  const Outcome outcome = dashpad({"fit", file("fit.toml"), "--posterior", "50", file("draws.csv")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string draws = read_file(file("draws.csv"));
  EXPECT_THAT(draws, testing::StartsWith("pad.curve.modulus [Pa],"));
  EXPECT_EQ(std::ranges::count(draws, '\n'), 51);
  EXPECT_THAT(outcome.out, HasSubstr("Laplace approximation"));
}

TEST_F(FitTest, RefusesFaultsAndWritesNothing) {
  write_file(file("fit.toml"), with(power_fit, "[0, 4]", "[4, 0]"));
  const auto before = other_files();
  const Outcome outcome =
      dashpad({"fit", file("fit.toml"), "--output", file("card.toml"), "--posterior", "none", file("x.csv")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("fit.toml:14: unknowns.pad.curve.compaction_exponent.bounds"));
  EXPECT_THAT(outcome.err, HasSubstr("--posterior none"));
  EXPECT_EQ(other_files(), before);
}

TEST_F(FitTest, GoesThroughImpacts) {
  const std::string of_the_case = R"(case = "case.toml"
[unknowns]
"pad.parameters.modulus" = {bounds = ["50 kPa", "2 MPa"]}
[[impacts]]
case = "case.toml"
peak_acceleration = {value = "30 g", deviation = "5 %"}
)";
  write_file(file("fit.toml"), of_the_case);
  const Outcome outcome = dashpad({"fit", file("fit.toml"), "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(schema_faults(result, "fit"), "");
  EXPECT_NEAR(result["impacts"][0]["computed"].get<double>(), 30 * 9.80665, 0.05);
}

/// The pulse of case.toml at 3 m/s with a tenth more modulus, as `run` writes it, on a clock of its own.
std::string pulse_csv(const std::string& case_file, const std::string& csv) {
  write_file(case_file, with(elastic_case(), "300 kPa", "330 kPa"));
  EXPECT_EQ(dashpad({"run", case_file, "--csv", csv, "--force"}).exit_code, 0);
  std::istringstream lines(read_file(csv));
  std::string line, text = "time_s,acceleration_g\n";
  for (int i = 0; i < 20; ++i) text += std::to_string(1e-4 * i) + ",0\n";
  while (std::getline(lines, line)) {
    double time = 0, force = 0, acceleration = 0;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf", &time, &force, &acceleration) == 3)
      text += std::to_string(0.0021 + time) + "," + std::to_string(acceleration) + "\n";
  }
  return text;
}

const std::string fit_of_a_pulse = R"(case = "case.toml"
[unknowns]
"pad.parameters.modulus" = {bounds = ["50 kPa", "2 MPa"]}
[[impacts]]
case = "case.toml"
pulse = {file = "drop.csv", deviation = "2 %"}
[fit]
starts = 2
)";

TEST_F(FitTest, FitsAWholePulse) {
  write_file(file("drop.csv"), pulse_csv(file("stiff.toml"), file("run.csv")));
  write_file(file("fit.toml"), fit_of_a_pulse);
  const Outcome outcome = dashpad({"fit", file("fit.toml"), "--json", "-", "--report", file("fit.html")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(schema_faults(result, "fit"), "");
  EXPECT_NEAR(result["unknowns"][0]["value"].get<double>(), 330e3, 1e3);
  EXPECT_EQ(result["unknowns"][1]["key"], "impacts[1].pulse.shift");
  EXPECT_LT(result["pulses"][0]["rms_share_of_peak"].get<double>(), 0.01);
  EXPECT_THAT(outcome.err, HasSubstr("drop.csv"));
  EXPECT_THAT(outcome.err, HasSubstr("1 unknown from"));
  const std::string page = read_file(file("fit.html"));
  EXPECT_NE(page.find("The data determine the unknown; the model deviates from the pulses by"),
            std::string::npos);
}

TEST_F(FitTest, RefusesAPulseWithoutOnsetAndWritesNothing) {
  write_file(file("drop.csv"), "time_s,acceleration_g\n0,50\n0.001,60\n0.002,50\n0.003,30\n0.004,0\n");
  write_file(file("fit.toml"), fit_of_a_pulse);
  const auto before = other_files();
  const Outcome outcome = dashpad({"fit", file("fit.toml"), "--output", file("card.toml"), "--report",
                                   file("fit.html"), "--state", file("fit.state")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("fit.toml:6: impacts[1].pulse.file"));
  EXPECT_THAT(outcome.err, HasSubstr("1 error; nothing was run"));
  EXPECT_EQ(other_files(), before);
}

TEST_F(FitTest, StopsAndGoesOn) {
  const std::string impacts = with(with(fit_of_a_pulse, "pulse = {file = \"drop.csv\", deviation = \"2 %\"}",
                                        "peak_acceleration = {value = \"30 g\", deviation = \"5 %\"}"),
                                   "starts = 2", "starts = 1000");
  write_file(file("fit.toml"), impacts);
  const std::string command =
      "\"$DASHPAD\" fit '" + file("fit.toml") + "' --state '" + file("fit.state") + "'";
  const Outcome stopped =
      shell(command + " &\n" + slowed_until("[ -e '" + file("fit.state") + "' ]") + "kill -TERM $!; wait $!");
  EXPECT_EQ(stopped.exit_code, 128 + SIGTERM) << stopped.err;
  EXPECT_THAT(stopped.err, HasSubstr("Stopped; nothing was written except"));
  EXPECT_EQ(stopped.out, "");
  ASSERT_TRUE(fs::exists(file("fit.state")));
  EXPECT_FALSE(fs::exists(file("fit.state.new")));
  // The same fit with fewer starts is another fit.
  write_file(file("fit.toml"), with(impacts, "starts = 1000", "starts = 2"));
  const Outcome other = shell(command);
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.err, HasSubstr("fit.state: is the state of a different fit"));
}

TEST_F(FitTest, KeepsWhatIsFinished) {
  const Outcome first = dashpad({"fit", file("fit.toml"), "--state", file("fit.state")});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const std::string state = read_file(file("fit.state"));
  const Outcome again = dashpad({"fit", file("fit.toml"), "--state", file("fit.state")});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(read_file(file("fit.state")), state);
  const auto answer = [](const std::string& text) {
    return text.substr(0, text.find(" evaluations in")).substr(0, 400);
  };
  EXPECT_EQ(answer(again.out), answer(first.out));
}

TEST_F(FitTest, RefusesAStateThatIsNoRegularFileAtOnce) {
  ASSERT_EQ(::mkfifo(file("a.fifo").c_str(), 0600), 0);
  for (const std::string& name : {std::string("/dev/zero"), std::string("/dev/full"), file("a.fifo")}) {
    const Outcome outcome =
        shell("timeout 20 \"$DASHPAD\" fit '" + file("fit.toml") + "' --state '" + name + "'");
    EXPECT_EQ(outcome.exit_code, 2) << name;
    EXPECT_THAT(outcome.err, HasSubstr(name + ": is not a regular file"));
  }
}

TEST_F(FitTest, RefusesAStateThatCannotBeLookedAtInItsOwnWords) {
  fs::create_symlink("loop.state", file("loop.state"));
  for (const std::string& name : {file("loop.state"), std::string(5000, 'x')}) {
    const Outcome outcome = dashpad({"fit", file("fit.toml"), "--state", name});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("cannot be read: "));
    EXPECT_THAT(outcome.err, Not(HasSubstr("filesystem")));
  }
}

TEST_F(FitTest, RefusesAStateWithANumberThatBecameText) {
  ASSERT_EQ(dashpad({"fit", file("fit.toml"), "--state", file("fit.state")}).exit_code, 0);
  std::string state = read_file(file("fit.state"));
  const auto at = state.find("\"misfit\": ") + 10;
  state.replace(at, state.find(',', at) - at, "\"a\"");
  write_file(file("fit.state"), state);
  const auto before = other_files();
  const Outcome outcome =
      dashpad({"fit", file("fit.toml"), "--state", file("fit.state"), "--output", file("card.toml")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("fit.state: is not a valid fit state: misfit must be a finite number"));
  EXPECT_EQ(other_files(), before);
}

const std::string fit_of_a_support = R"(case = "case.toml"
[unknowns]
"support.stiffness" = {bounds = ["20 N/mm", "500 N/mm"]}
[[impacts]]
case = "case.toml"
peak_acceleration = {value = "22 g", deviation = "5 %"}
[fit]
starts = 2
)";

TEST_F(FitTest, KeepsWhatWasFoundOfACase) {
  write_file(file("fit.toml"), fit_of_a_support);
  const Outcome without = dashpad({"fit", file("fit.toml")});
  EXPECT_THAT(without.out, HasSubstr("Fitted but not part of a card: support.stiffness; --case FILE writes"));
  const Outcome outcome = dashpad({"fit", file("fit.toml"), "--case", file("fitted.toml")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr("--case FILE")));
  const Outcome run = dashpad({"run", file("fitted.toml"), "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NEAR(json::parse(run.out)["peak_acceleration_g"].get<double>(), 22, 0.01);
}

TEST_F(FitTest, RefusesACaseOfWhichNothingWasSought) {
  const auto before = other_files();
  const Outcome outcome = dashpad({"fit", file("fit.toml"), "--case", file("fitted.toml")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("fitted.toml: this fit has no unknown outside the card"));
  EXPECT_EQ(other_files(), before);
}

TEST_F(FitTest, SaysInAPipeHowFarItIs) {
  // Foam with memory, two unknowns and a thousand starts: many seconds.
  std::string long_fit = with(with(fit_of_a_support, "case.toml", nine), "case.toml", nine);
  long_fit =
      with(long_fit, "[[impacts]]", "\"impactor.radius\" = {bounds = [\"2 in\", \"5 in\"]}\n[[impacts]]");
  long_fit = with(long_fit, "[fit]", "contact_time = {value = \"12 ms\", deviation = \"5 %\"}\n[fit]");
  write_file(file("fit.toml"), with(long_fit, "starts = 2", "starts = 1000"));
  const Outcome outcome = shell("\"$DASHPAD\" fit '" + file("fit.toml") + "' 2> '" + file("said") + "' &\n" +
                                until("grep -q several '" + file("said") + "'") +
                                "kill -TERM $!; wait $!; cat '" + file("said") + "' >&2");
  EXPECT_THAT(outcome.err, testing::ContainsRegex(
                               "Searching from several starting points \\([0-9]+ of 1000\\), [0-9]+ s\n"));
}

TEST_F(FitTest, TheExampleWorks) {
  const Outcome outcome = dashpad({"fit", examples + "fits/vn600.toml"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::ContainsRegex("vn600-quasi-static.csv +127 "));
}

}  // namespace
}  // namespace dashpad::test
