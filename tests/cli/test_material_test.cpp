// dashpad material-test: tests of a pad material, their files, and what is refused.

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// Its stress is 300 kPa times the strain, whatever the rate.
const std::string elastic_card =
    "title = \"Spring\"\nsource = \"a test\"\nlaw = \"elastic\"\n[parameters]\nmodulus = \"300 kPa\"\n";

class MaterialTestTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_file(file("spring.toml"), elastic_card);
  }
  Outcome material_test(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "material-test");
    return dashpad(arguments);
  }
  /// The JSON of a test that succeeds.
  json answered(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "-"});
    const Outcome outcome = material_test(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << testing::PrintToString(arguments) << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }
  /// What is said to a command line that is refused; nothing may be written.
  std::string refused(const std::vector<std::string>& arguments) {
    const auto before = other_files();
    const Outcome outcome = material_test(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(arguments) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(other_files(), before);
    return outcome.err;
  }
};

TEST_F(MaterialTestTest, ShowsARowARate) {
  const Outcome outcome = material_test({"ensolite-aac-9"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(
      outcome.out,
      AllOf(StartsWith("Best used up to 327 kPa"),
            HasSubstr("\nEnsolite AAC foam rubber, 9-parameter model (ensolite-aac-9, nine-parameter"),
            HasSubstr("Loaded to a strain of 0.95 and unloaded to zero at the same constant rate"),
            ContainsRegex("\n1 +[0-9.]+ "), ContainsRegex("\n100 +[0-9.]+ "), HasSubstr("Estimated errors: "),
            HasSubstr("unloading begins"), HasSubstr("Appendix C, PAR9")));
  EXPECT_THAT(outcome.out, Not(HasSubstr("1984,")));
}

TEST_F(MaterialTestTest, AnElasticFoamGivesItsEnergyBack) {
  for (const char* kind : {"constant-rate", "parabolic"}) {
    const json result = answered({file("spring.toml"), "--test", kind, "--strain", "0.5", "--rate", "10"});
    const json& run = result["runs"][0];
    EXPECT_EQ(result["test"]["kind"], kind);
    EXPECT_EQ(run["rate_per_s"], 10);
    EXPECT_NEAR(run["figures"]["peak_stress_Pa"].get<double>(), 150e3, 1e-6);
    EXPECT_NEAR(run["figures"]["peak_stress_strain"].get<double>(), 0.5, 1e-12);
    EXPECT_NEAR(run["figures"]["energy_in_J_per_m3"].get<double>(), 37500, 37500e-5);
    EXPECT_NEAR(run["figures"]["energy_returned_J_per_m3"].get<double>(), 37500, 37500e-5);
    EXPECT_NEAR(run["figures"]["hysteresis"].get<double>(), 0, 1e-5);
    EXPECT_NEAR(run["figures"]["best_efficiency"]["efficiency"].get<double>(), 0.25, 1e-5);
    EXPECT_NEAR(run["figures"]["best_efficiency"]["ideality"].get<double>(), 0.5, 1e-5);
    EXPECT_EQ(run["update_of_1984"], nullptr);
    EXPECT_EQ(run["relaxation"], nullptr);
  }
}

TEST_F(MaterialTestTest, ShowsNoNegativeZero) {
  EXPECT_THAT(material_test({file("spring.toml"), "--strain", "0.5", "--rate", "1,10"}).out,
              AllOf(HasSubstr(" 0.000 "), Not(HasSubstr("-0.000"))));
}

TEST_F(MaterialTestTest, SaysAtWhichStrainTheStressPeaks) {
  const json run = answered({"ensolite-aac-9", "--test", "parabolic", "--rate", "1"})["runs"][0];
  const json &stress = run["column"]["stress_Pa"], &strain = run["column"]["strain"];
  const auto peak = static_cast<std::size_t>(std::ranges::max_element(stress) - stress.begin());
  EXPECT_NEAR(run["figures"]["peak_stress_Pa"], stress[peak].get<double>(),
              3e-4 * stress[peak].get<double>());
  EXPECT_GE(run["figures"]["peak_stress_Pa"], stress[peak]);
  EXPECT_NEAR(run["figures"]["peak_stress_strain"], strain[peak].get<double>(), 3e-4);
  EXPECT_LT(strain[peak], 0.9499);  // the law relaxes before the turn
}

TEST_F(MaterialTestTest, ReadsRatesWithAndWithoutUnits) {
  const json result = answered({file("spring.toml"), "--rate", "1,50 1/s", "--rate", "6000 1/min"});
  ASSERT_EQ(result["runs"].size(), 3u);
  EXPECT_EQ(result["runs"][0]["rate_per_s"], 1);
  EXPECT_EQ(result["runs"][1]["rate_per_s"], 50);
  EXPECT_NEAR(result["runs"][2]["rate_per_s"].get<double>(), 100, 1e-12);
  EXPECT_EQ(answered({file("spring.toml")})["runs"].size(), 2u);
}

TEST_F(MaterialTestTest, FindsTheEnergyAtAStressLimit) {
  const json result =
      answered({file("spring.toml"), "--strain", "0.5", "--rate", "1", "--stress-limit", "60 kPa,200 kPa"});
  const json& limits = result["runs"][0]["stress_limits"];
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_EQ(limits[0]["limit_Pa"], 60e3);
  EXPECT_NEAR(limits[0]["reached"]["strain"].get<double>(), 0.2, 1e-5);
  EXPECT_NEAR(limits[0]["reached"]["energy_J_per_m3"].get<double>(), 6000, 0.1);
  EXPECT_NEAR(limits[0]["reached"]["efficiency"].get<double>(), 0.1, 1e-5);
  EXPECT_EQ(limits[1]["reached"], nullptr);
  EXPECT_THAT(material_test(
                  {file("spring.toml"), "--strain", "0.5", "--rate", "1", "--stress-limit", "60 kPa,200 kPa"})
                  .out,
              AllOf(HasSubstr("Cushioning at a stress limit"), HasSubstr("not reached")));
}

TEST_F(MaterialTestTest, RelaxesTheStress) {
  const json result = answered(
      {"ensolite-aac-9", "--test", "relaxation", "--strain", "0.5", "--rate", "100", "--hold", "10 ms"});
  EXPECT_EQ(result["test"]["hold_s"], 0.01);
  const json& of = result["runs"][0]["relaxation"];
  const double ramp = of["end_of_ramp_Pa"], tenth = of["after_tenth_of_hold_Pa"], end = of["after_hold_Pa"];
  // The envelope of a column at rest is E_inf A(e); what is above it decays with the time constant.
  const double rest = 7.96 * 6894.757293168 * std::pow(0.5, 0.675) / std::pow(0.5, 1.09), tau = 8.81e-3;
  EXPECT_NEAR(tenth, rest + (ramp - rest) * std::exp(-1e-3 / tau), 1e-6 * ramp);
  EXPECT_NEAR(end, rest + (ramp - rest) * std::exp(-1e-2 / tau), 1e-6 * ramp);
  EXPECT_EQ(result["runs"][0]["figures"]["hysteresis"], nullptr);
}

TEST_F(MaterialTestTest, CreepsUnderAStress) {
  const json result =
      answered({"ensolite-aac-9", "--test", "creep", "--stress", "50 kPa", "--hold", "1 s", "--rate", "100"});
  EXPECT_EQ(result["test"]["stress_Pa"], 50e3);
  EXPECT_EQ(result["test"]["strain"], nullptr);
  const json& of = result["runs"][0]["creep"];
  EXPECT_GT(of["after_hold_strain"].get<double>(), of["end_of_loading_strain"].get<double>());
  EXPECT_EQ(of["after_hold_strain"], result["runs"][0]["column"]["strain"].back());
  EXPECT_NEAR(result["runs"][0]["column"]["stress_Pa"].back().get<double>(), 50e3, 1);
  EXPECT_THAT(refused({file("spring.toml"), "--test", "creep", "--stress", "500 kPa"}),
              HasSubstr("does not reach a stress of 500000 Pa"));
}

/// As little as can be stated, on foams by their curves as on slow ones.
TEST_F(MaterialTestTest, CreepsUnderNextToNoStress) {
  for (const char* card : {"vn600", "eps-22", "ensolite-aac-9", "ensolite-aac-21"}) {
    const json small = answered({card, "--test", "creep", "--stress", "1e-14 Pa", "--rate", "1"});
    EXPECT_LT(small["runs"][0]["creep"]["after_hold_strain"].get<double>(), 1e-17) << card;
  }
}

TEST_F(MaterialTestTest, CyclesBetweenTwoStrains) {
  const json result = answered({"ensolite-aac-21", "--test", "cyclic", "--strain", "0.6", "--low", "20 %",
                                "--cycles", "2", "--rate", "10"});
  EXPECT_EQ(result["test"]["low_strain"], 0.2);
  EXPECT_EQ(result["test"]["cycles"], 2);
  const json& column = result["runs"][0]["column"];
  EXPECT_NEAR(column["strain"].back().get<double>(), 0.2, 1e-12);
  EXPECT_NEAR(column["time_s"].back().get<double>(), (0.6 + 3 * 0.4) / 10, 1e-12);
}

TEST_F(MaterialTestTest, SaysWhereReloadingIsAssumed) {
  const Outcome outcome = material_test({"ensolite-aac-9", "--test", "cyclic", "--strain", "0.6"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("ASSUMPTION (at 1 and 100 per second): the column was reloaded after contact"),
                    HasSubstr("contact lost"), HasSubstr("contact regained")));
}

TEST_F(MaterialTestTest, FollowsAMeasuredHistory) {
  write_file(file("strains.csv"), "time [ms];strain [%]\n0;0\n5;50\n15;0\n");
  const json result = answered({file("spring.toml"), "--test", "history", "--history", file("strains.csv")});
  const json& run = result["runs"][0];
  EXPECT_EQ(result["test"]["history"], file("strains.csv"));
  EXPECT_EQ(run["rate_per_s"], nullptr);
  EXPECT_NEAR(run["column"]["time_s"].back().get<double>(), 0.015, 1e-15);
  EXPECT_NEAR(run["figures"]["peak_stress_Pa"].get<double>(), 150e3, 1e-6);
  EXPECT_EQ(run["column"]["strain_rate_per_s"][1], 100);
}

TEST_F(MaterialTestTest, SaysWhatIsExtrapolated) {
  const Outcome outcome =
      material_test({"ensolite-aac-9", "--strain", "0.97", "--rate", "10,1000", "--units", "us"});
  EXPECT_THAT(
      outcome.out,
      AllOf(HasSubstr("EXTRAPOLATED STRAIN (at 10 and 1000 per second): the strain reaches 0.970"),
            HasSubstr("EXTRAPOLATED RATE (at 1000 per second): the strain rate reaches 1000 per second"),
            HasSubstr("(psi)"), HasSubstr("(in·lbf/in³)")));
  const json flags = answered({"ensolite-aac-9", "--rate", "100", "--test", "parabolic"})["runs"][0]["flags"];
  ASSERT_FALSE(flags.empty());
  EXPECT_EQ(flags[0]["name"], "EXTRAPOLATED RATE");
  EXPECT_THAT(flags[0]["text"].get<std::string>(), HasSubstr("rate reaches 200 per second"));
  EXPECT_THAT(material_test({file("spring.toml")}).out, HasSubstr("states no fitted range"));
}

TEST_F(MaterialTestTest, PutsTheUpdateOf1984BesideTheExactStress) {
  const json result =
      answered({"ensolite-aac-9", "--test", "parabolic", "--explicit-1984", "--rate", "1", "--steps", "10"});
  EXPECT_EQ(result["test"]["steps_of_1984"], 10);
  const json& update = result["runs"][0]["update_of_1984"];
  EXPECT_NEAR(update["step_s"].get<double>(), 0.095, 1e-15);
  ASSERT_EQ(update["stress_Pa"].size(), 21u);
  ASSERT_EQ(update["exact_stress_Pa"].size(), 21u);
  EXPECT_EQ(update["stress_Pa"][0], 0);
  const json& jump = update["stress_discontinuity"];
  EXPECT_EQ(jump["last_loading_Pa"], update["stress_Pa"][10]);
  EXPECT_EQ(jump["next_Pa"], update["stress_Pa"][11]);
  EXPECT_EQ(jump["jump_Pa"].get<double>(),
            update["stress_Pa"][11].get<double>() - update["stress_Pa"][10].get<double>());
  EXPECT_EQ(update["exact_stress_at_the_same_times"]["last_loading_Pa"], update["exact_stress_Pa"][10]);
  for (const char* kind : {"constant-rate", "cyclic", "relaxation"})
    EXPECT_EQ(material_test({"ensolite-aac-21", "--test", kind, "--explicit-1984"}).exit_code, 0) << kind;
  EXPECT_THAT(refused({"ensolite-aac-9", "--test", "relaxation", "--hold", "1e6 s", "--explicit-1984"}),
              HasSubstr("at most 100000 are allowed"));
}

TEST_F(MaterialTestTest, WritesCsv) {
  const Outcome outcome = material_test(
      {file("spring.toml"), "--rate", "1,10", "--strain", "0.5", "--csv", "-", "--explicit-1984"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              StartsWith("rate_1_per_s,time_s,strain,strain_rate_1_per_s,stress_Pa,stress_1984_Pa\n"
                         "1,0,0,"));
  EXPECT_THAT(outcome.out, HasSubstr("\n10,0,0,"));
  std::istringstream rows(outcome.out);
  int with_1984 = 0;
  std::string row;
  std::getline(rows, row);
  while (std::getline(rows, row)) with_1984 += row.ends_with(',') ? 0 : 1;
  EXPECT_EQ(with_1984, 2 * 41);
  EXPECT_THAT(outcome.err, HasSubstr("Figures"));  // the text makes room
  EXPECT_THAT(material_test({file("spring.toml"), "--csv", "-", "--units", "us"}).out,
              StartsWith("rate_1_per_s,time_ms,strain,strain_rate_1_per_s,stress_psi\n"));
}

TEST_F(MaterialTestTest, ReadsItsOwnCsvAsAHistory) {
  ASSERT_EQ(material_test({"ensolite-aac-9", "--rate", "10", "--strain", "0.6", "--csv", file("one.csv")})
                .exit_code,
            0);
  const json once = answered({"ensolite-aac-9", "--rate", "10", "--strain", "0.6"});
  const json again = answered({"ensolite-aac-9", "--test", "history", "--history", file("one.csv")});
  const double peak = once["runs"][0]["figures"]["peak_stress_Pa"];
  EXPECT_NEAR(again["runs"][0]["figures"]["peak_stress_Pa"].get<double>(), peak, 1e-9 * peak);
}

TEST_F(MaterialTestTest, WritesPicturesAndThePage) {
  for (const char* kind : {"constant-rate", "relaxation", "cyclic"}) {
    const std::string name = file(std::string{kind} + ".svg");
    const Outcome outcome = material_test({"ensolite-aac-21", "--test", kind, "--picture", name,
                                           "--explicit-1984", "--stress-limit", "50 kPa"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(read_file(name),
                AllOf(HasSubstr("Stress"), HasSubstr("Efficiency"), HasSubstr("limit 50 kPa"),
                      HasSubstr("1984 update, 20 steps, 100 per second"), HasSubstr("PAR21")));
  }
  const Outcome outcome = material_test({"ensolite-aac-9", "--report", file("page.html")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(read_file(file("page.html")), AllOf(HasSubstr("Ideality against strain"), HasSubstr("PAR9")));
}

TEST_F(MaterialTestTest, RefusesValuesThatMakeNoTest) {
  const std::string card = "ensolite-aac-9";
  for (const char* rate :
       {"-1", "0", "nan", "inf", "abc", "1e300", "1e-308", "1e-320", "1e-12", "10 m/s", "1,1"})
    EXPECT_THAT(refused({card, "--rate", rate}), HasSubstr("--rate ")) << rate;
  for (const char* strain : {"1", "0", "-0.5", "nan", "2", "abc", "0.5 m", "100 %", "1e-300", "0.99999999"})
    EXPECT_THAT(refused({card, "--strain", strain}), HasSubstr("--strain")) << strain;
  for (const char* hold : {"0 s", "-1 s", "1", "1 m", "nan s"})
    EXPECT_THAT(refused({card, "--test", "relaxation", "--hold", hold}), HasSubstr("--hold")) << hold;
  for (const char* stress : {"0 kPa", "-5 kPa", "50", "50 N"})
    EXPECT_THAT(refused({card, "--test", "creep", "--stress", stress}), HasSubstr("--stress")) << stress;
  for (const char* limit : {"0 kPa", "-5 kPa", "50", "1 kPa,50"})
    EXPECT_THAT(refused({card, "--stress-limit", limit}), HasSubstr("--stress-limit")) << limit;
  for (const char* low : {"-0.1", "0.6", "0.7", "nan"})
    EXPECT_THAT(refused({card, "--test", "cyclic", "--strain", "0.6", "--low", low}), HasSubstr("--low"))
        << low;
  for (const char* cycles : {"0", "-1", "1001", "1.5"})
    EXPECT_THAT(refused({card, "--test", "cyclic", "--cycles", cycles}), HasSubstr("--cycles")) << cycles;
  for (const char* steps : {"0", "10001", "x"})
    EXPECT_THAT(refused({card, "--explicit-1984", "--steps", steps}), HasSubstr("--steps")) << steps;
}

TEST_F(MaterialTestTest, RefusesAnOptionOfAnotherTest) {
  const std::string card = "ensolite-aac-9";
  EXPECT_THAT(refused({card, "--test", "parabolic", "--hold", "1 s"}),
              HasSubstr("--hold: does not apply to --test parabolic, only to relaxation, creep\n"));
  EXPECT_THAT(
      refused({card, "--test", "creep", "--stress", "50 kPa", "--strain", "0.5"}),
      HasSubstr(
          "--strain: does not apply to --test creep, only to constant-rate, parabolic, relaxation, cyclic"));
  EXPECT_THAT(refused({card, "--test", "creep", "--stress", "50 kPa", "--explicit-1984"}),
              HasSubstr("--explicit-1984: does not apply to --test creep"));
  EXPECT_THAT(refused({card, "--test", "creep"}), HasSubstr("needs --stress"));
  EXPECT_THAT(refused({card, "--test", "history"}), HasSubstr("needs --history"));
  EXPECT_THAT(refused({card, "--low", "0.2"}),
              HasSubstr("--low: does not apply to --test constant-rate, only to cyclic"));
  EXPECT_THAT(refused({card, "--cycles", "2"}),
              HasSubstr("--cycles: does not apply to --test constant-rate, only to cyclic"));
  EXPECT_THAT(refused({card, "--stress", "5 kPa"}),
              HasSubstr("--stress: does not apply to --test constant-rate, only to creep"));
  EXPECT_THAT(refused({card, "--history", "a.csv"}),
              HasSubstr("--history: does not apply to --test constant-rate, only to history"));
  EXPECT_THAT(refused({"Ensolite AAC 9"}), HasSubstr("did you mean \"ensolite-aac-9\"?"));
  EXPECT_THAT(refused({card, "--steps", "20"}), HasSubstr("add --explicit-1984"));
  EXPECT_THAT(refused({card, "--test", "squash"}), AllOf(HasSubstr("--test"), HasSubstr("parabolic")));
}

TEST_F(MaterialTestTest, NamesAllFaultsAtOnce) {
  write_file(file("taken.csv"), "");
  EXPECT_THAT(
      refused({"unobtainium", "--rate", "-1", "--strain", "1", "--hold", "1 s", "--csv", file("taken.csv"),
               "--picture", file("x.gif")}),
      AllOf(HasSubstr("unobtainium: no such material"), HasSubstr("ensolite-aac-9"), HasSubstr("--rate -1: "),
            HasSubstr("--strain 1: "), HasSubstr("--hold: "), HasSubstr("already exists"),
            HasSubstr("must end in .svg"), EndsWith("6 errors; nothing was run\n")));
}

TEST_F(MaterialTestTest, RefusesACardWithFaults) {
  write_file(file("bad.toml"), with(elastic_card, "300 kPa", "-300 kg"));
  EXPECT_THAT(refused({file("bad.toml")}), HasSubstr("bad.toml:5"));
  EXPECT_THAT(refused({file("missing.toml")}), HasSubstr("missing.toml"));
  EXPECT_THAT(refused({"ensolite-aac-9", "--materials", file("nowhere")}), HasSubstr("nowhere"));
  EXPECT_THAT(refused({}), Not(IsEmpty()));
}

TEST_F(MaterialTestTest, NamesTheLinesOfAHistoryWithFaults) {
  write_file(file("bad.csv"), "time_s,strain\n0,0.1\n0.1,0.2\n0.1,0.3\n0.2,x\n0.3,1\n0.4,-0.1\n0.5,nan\n");
  EXPECT_THAT(
      refused({file("spring.toml"), "--test", "history", "--history", file("bad.csv"), "--rate", "1"}),
      AllOf(HasSubstr("bad.csv:2: strain = 0.1: must be 0, since the history begins at first contact"),
            HasSubstr("bad.csv:4: time_s = 0.1: must be later"), HasSubstr("bad.csv:5: strain = x"),
            HasSubstr("bad.csv:6: strain = 1"), HasSubstr("bad.csv:7: strain = -0.1"),
            HasSubstr("bad.csv:8: strain = nan"),
            ContainsRegex("--rate: does not apply to --test history, only to [-a-z, ]+\n"),
            EndsWith("7 errors; nothing was run\n")));
  EXPECT_THAT(refused({file("spring.toml"), "--test", "history", "--history", file("none.csv")}),
              HasSubstr("none.csv"));
  EXPECT_THAT(refused({file("spring.toml"), "--test", "history", "--history", ""}),
              HasSubstr("--history: must not be empty"));
  write_file(file("fast.csv"), "time_s,strain\n0,0\n1,0.1\n1.0000000001,0.4\n");
  EXPECT_THAT(refused({"ensolite-aac-9", "--test", "history", "--history", file("fast.csv")}),
              HasSubstr("fast.csv: between 1 s and 1.0000000001 s the strain rate is 3e+09 per second"));
}

TEST_F(MaterialTestTest, KeepsExistingFiles) {
  write_file(file("taken.json"), "mine");
  EXPECT_THAT(refused({file("spring.toml"), "--json", file("taken.json")}), HasSubstr("already exists"));
  EXPECT_EQ(read_file(file("taken.json")), "mine");
  EXPECT_EQ(material_test({file("spring.toml"), "--json", file("taken.json"), "--force"}).exit_code, 0);
  EXPECT_NE(read_file(file("taken.json")), "mine");
  EXPECT_THAT(refused({file("spring.toml"), "--json", file("spring.toml"), "--force"}), HasSubstr("--json"));
  write_file(file("strains.csv"), "time_s,strain\n0,0\n0.1,0.5\n");
  for (const char* input : {"strains.csv: is the strain history", "spring.toml: is the material card"})
    EXPECT_THAT(refused({file("spring.toml"), "--test", "history", "--history", file("strains.csv"), "--csv",
                         file(std::string{input}.substr(0, std::string{input}.find(':'))), "--force"}),
                HasSubstr(input))
        << input;
  EXPECT_EQ(read_file(file("spring.toml")), elastic_card);
  write_file(file("named.toml"), elastic_card);
  EXPECT_THAT(refused({"named", "--materials", file("."), "--csv", file("named.toml"), "--force"}),
              HasSubstr("named.toml: is the material card"));
}

}  // namespace
}  // namespace dashpad::test
