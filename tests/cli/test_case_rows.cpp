// Tables of cases: rows of a study, draws of a study, drops of a fit, and a batch of JSON lines.

#include <map>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class CaseRows : public CommandTest {
 protected:
  Outcome study(const std::string& keys, const std::string& rows, const std::string& more = "") {
    fs::remove(file("rows.db"));
    write_file(file("rows.toml"), "case = \"case.toml\"\nresponses = [\"peak_force\"]\n" + keys);
    write_file(file("design.csv"), rows);
    return dashpad({"study", file("rows.toml"), "--out", file("rows.db" + more)});
  }
  /// The lines of the exported rows.
  std::vector<std::string> exported() {
    std::istringstream csv(dashpad({"study", "export", file("rows.db"), "--csv", "-"}).out);
    std::vector<std::string> lines;
    for (std::string line; std::getline(csv, line);) lines.push_back(line);
    return lines;
  }
  /// The peak force of a case with settings, N.
  double peak_force(const std::vector<std::string>& settings) {
    std::vector<std::string> arguments{"run", file("case.toml"), "--tolerance", "1e-3", "--json",
                                       "-",   "--no-intervals"};
    for (const std::string& setting : settings) arguments.insert(arguments.end(), {"--set", setting});
    return json::parse(dashpad(arguments).out).at("peak_force_N");
  }
  /// The field of a line of CSV, from 0.
  static std::string field(const std::string& line, std::size_t place) {
    std::istringstream fields(line);
    std::string text;
    for (std::size_t i = 0; i <= place; ++i) std::getline(fields, text, ',');
    return text;
  }
};

/// Verification: a row of a study is the case with the numbers of that row.
TEST_F(CaseRows, AreCasesInTheirOrderWithTheirLabels) {
  const Outcome outcome = study("rows = \"design.csv\"\n",
                                "# drops of Tuesday\n"
                                "test,impactor.speed [km/h],impactor.mass,remark\n"
                                "b7,7.2,5 kg,\"new, dry\"\n"
                                "a1,3.6,6000 g,\n"
                                "a1,10.8,5 kg,worn\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::vector<std::string> lines = exported();
  ASSERT_EQ(lines.size(), 4);
  EXPECT_THAT(lines[0],
              testing::EndsWith("impactor.speed_m_per_s,impactor.mass_kg,peak_force_N,test,remark"));
  const std::vector<std::vector<std::string>> settings{{"impactor.speed=2 m/s", "impactor.mass=5 kg"},
                                                       {"impactor.speed=1 m/s", "impactor.mass=6 kg"},
                                                       {"impactor.speed=3 m/s", "impactor.mass=5 kg"}};
  for (std::size_t i = 0; i < settings.size(); ++i)
    EXPECT_NEAR(std::stod(field(lines[i + 1], 9)) / peak_force(settings[i]), 1, 1e-12) << lines[i + 1];
  EXPECT_THAT(lines[1], testing::EndsWith(",b7,\"new, dry\""));
  EXPECT_THAT(lines[2], testing::EndsWith(",a1,"));
  const Outcome summary = dashpad({"study", "summary", file("rows.db")});
  EXPECT_THAT(summary.out, AllOf(HasSubstr("Over the rows"), HasSubstr("b7"), HasSubstr("3 rows: 2 m/s")));
}

TEST_F(CaseRows, TakeTheColumnsOfAnExport) {
  ASSERT_EQ(
      study("rows = \"design.csv\"\n", "row,impactor.speed_m_per_s,peak_force_N\n0,2,1\n1,3,1\n").exit_code,
      0);
  EXPECT_THAT(exported().at(0), testing::EndsWith("peak_force_N,row,peak_force_N"));
}

TEST_F(CaseRows, GoWithLevelsAndDraws) {
  ASSERT_EQ(study("rows = \"design.csv\"\nsamples = 10\n[factors.\"impactor.mass\"]\nvalues = [\"4 kg\", "
                  "\"5 kg\"]\n[factors.\"pad.thickness\"]\ndistribution = \"uniform\"\nlow = \"40 mm\"\nhigh "
                  "= \"50 mm\"\n",
                  "impactor.speed [m/s],site\n1,north\n2,south\n3,west\n")
                .exit_code,
            0);
  const std::vector<std::string> lines = exported();
  ASSERT_EQ(lines.size(), 61);
  EXPECT_EQ(field(lines[20], 7), "1");
  EXPECT_EQ(field(lines[21], 7), "2") << "rows of the table change most slowly";
  EXPECT_THAT(lines[60], testing::EndsWith(",west"));
  EXPECT_THAT(dashpad({"study", "summary", file("rows.db")}).out, HasSubstr("south: impact speed 2 m/s"));
}

/// Verification: 2 kPa on 100 cm2 is a weight of 20 N.
TEST_F(CaseRows, MayStateTheStaticStress) {
  std::string flat = with(elastic_case(), "radius = \"80 mm\"", "nose = \"flat-disc\"\nradius = \"200 mm\"");
  flat = with(flat, "thickness = \"50 mm\"", "thickness = \"50 mm\"\narea = \"200 cm2\"");
  write_file(file("case.toml"), flat);
  ASSERT_EQ(
      study("rows = \"design.csv\"\n", "impactor.static_stress [kPa],pad.area [cm2]\n2,100\n").exit_code, 0);
  EXPECT_NEAR(std::stod(field(exported().at(1), 9)),
              peak_force({"impactor.mass=" + std::to_string(20 / 9.80665) + " kg", "pad.area=100 cm2"}),
              0.01);
  const Outcome both =
      study("rows = \"design.csv\"\n", "impactor.static_stress [kPa],impactor.mass [kg]\n2,5\n");
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_THAT(both.err, HasSubstr("vary one or the other"));
}

TEST_F(CaseRows, NameEachFaultWithItsCell) {
  const auto refused = [&](const std::string& rows) {
    const Outcome outcome = study("rows = \"design.csv\"\n", rows);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_FALSE(fs::exists(file("rows.db")));
    return outcome.err;
  };
  EXPECT_THAT(refused("impactor.speed [m/s],impactor.mass\n2,\n3,5\n4,5 mm\nx,5 kg\n"),
              AllOf(HasSubstr("design.csv:2: impactor.mass: is empty"),
                    HasSubstr("design.csv:3: impactor.mass = 5: needs a unit"),
                    HasSubstr("design.csv:4: impactor.mass = 5 mm"),
                    HasSubstr("design.csv:5: impactor.speed [m/s] = x")));
  EXPECT_THAT(refused("impactor.speed [m/s],impactor.speed [mph]\n1,2\n"), HasSubstr("has two columns"));
  EXPECT_THAT(refused("impactor.speed [kg]\n1\n"), HasSubstr("design.csv:1: impactor.speed [kg]"));
  EXPECT_THAT(refused("impactor.sped [m/s]\n1\n"),
              HasSubstr("design.csv:1: impactor.sped [m/s]: is not a quantity of the case"));
  EXPECT_THAT(refused("impactor.speed [m/s],blows.recovery\n1,1\n"),
              HasSubstr("design.csv:1: blows.recovery"));
  EXPECT_THAT(refused("impactor.speed [m/s],Pad.thickness [mm]\n1,1\n"), HasSubstr("Pad.thickness"));
  EXPECT_THAT(refused("impactor.speed [m/s],impactor.drop_height [m]\n1,1\n"),
              HasSubstr("design.csv:1: impactor.drop_height: give"));
  EXPECT_THAT(refused("impactor.speed [m/s],pad.material\n1,vn600\n2,nosuch\n"),
              AllOf(HasSubstr("design.csv:3: pad.material = nosuch"), HasSubstr("1 error")));
  EXPECT_THAT(refused("a,b\n1,2\n"), HasSubstr("impactor.mass [kg]"));
  EXPECT_THAT(
      refused("impactor.speed [m/s]\n1\n-2\n0\n"),
      AllOf(HasSubstr("design.csv:3: impactor.speed = -2"), HasSubstr("design.csv:4: impactor.speed = 0")));
  EXPECT_THAT(refused("impactor.speed [m/s]\n"), HasSubstr("no rows"));
  EXPECT_THAT(refused("impactor.speed [m/s]\n1,2\n"), HasSubstr("more fields than the header"));
}

/// Verification: factors of a table of draws keep the pairs of its rows.
TEST_F(CaseRows, DrawnTogetherKeepTheirCorrelation) {
  ASSERT_EQ(study("samples_from = \"design.csv\"\nsamples = 64\n",
                  "impactor.speed [m/s],impactor.mass [kg]\n1,10\n2,20\n3,30\n4,40\n")
                .exit_code,
            0);
  const std::vector<std::string> lines = exported();
  ASSERT_EQ(lines.size(), 65);
  std::map<std::string, int> count;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    EXPECT_EQ(field(lines[i], 7) + "0", field(lines[i], 8));
    ++count[field(lines[i], 7)];
  }
  for (const auto& [speed, times] : count) EXPECT_EQ(times, 16) << speed << ": Sobol points are even";
  EXPECT_EQ(
      study("samples_from = \"design.csv\"\nsamples = 8\nindices = true\n", "impactor.speed [m/s]\n1\n2\n")
          .exit_code,
      2);
}

TEST_F(CaseRows, OfAFitAreDropsOfOneCase) {
  std::ostringstream drops;
  drops << "impactor.mass [kg],impactor.speed [m/s],peak_force [N],rebound_speed [m/s],site\n";
  for (const auto& [mass, speed] : {std::pair{4, 1}, {4, 2}, {6, 2}})
    drops << mass << "," << speed << ","
          << peak_force({"impactor.mass=" + std::to_string(mass) + " kg",
                         "impactor.speed=" + std::to_string(speed) + " m/s", "pad.parameters.modulus=2 MPa"})
          << ",,lab\n";
  write_file(file("drops.csv"), drops.str());
  write_file(file("fit.toml"), R"(case = "case.toml"
[unknowns]
"pad.parameters.modulus" = {bounds = ["100 kPa", "50 MPa"]}
[[impacts]]
case = "case.toml"
rows = "drops.csv"
deviation = "1 %"
[fit]
starts = 1
)");
  const Outcome outcome = dashpad({"fit", file("fit.toml"), "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json fit = json::parse(outcome.out);
  EXPECT_NEAR(fit.at("unknowns").at(0).at("value").get<double>(), 2e6, 2e4);
}

TEST_F(CaseRows, OfAFitAreRefusedWithTheirCells) {
  write_file(file("fit.toml"), R"(case = "case.toml"
[unknowns]
"pad.parameters.modulus" = {bounds = ["100 kPa", "50 MPa"]}
[[impacts]]
case = "case.toml"
rows = "drops.csv"
deviation = "1 %"
)");
  const auto refused = [&](const std::string& drops) {
    write_file(file("drops.csv"), drops);
    const Outcome outcome = dashpad({"fit", file("fit.toml")});
    EXPECT_EQ(outcome.exit_code, 2);
    return outcome.err;
  };
  EXPECT_THAT(refused("impactor.mass [kg],peak_forc [N]\n4,9\n"), HasSubstr("drops.csv:1: peak_forc [N]"));
  EXPECT_THAT(refused("impactor.mass [kg],peak_force [N]\n4,9\n5,\n6,0\n-1,9\n"),
              AllOf(HasSubstr("drops.csv:3: has no measured figure"),
                    HasSubstr("drops.csv:4: peak_force = 0"), HasSubstr("drops.csv:5: impactor.mass = -1")));
}

/// A number that would not be used is refused, also under the other name of the same thing.
TEST_F(CaseRows, OfAFitAreNotOverruled) {
  const auto refused = [&](const std::string& unknown, const std::string& set, const std::string& columns,
                           const std::string& values) {
    write_file(file("fit.toml"), "case = \"case.toml\"\n[unknowns]\n" + unknown +
                                     "\n[[impacts]]\ncase = \"case.toml\"\nrows = \"drops.csv\"\n" + set +
                                     "\ndeviation = \"1 %\"\n");
    write_file(file("drops.csv"), columns + ",peak_force [N]\n" + values + ",900\n");
    const Outcome outcome = dashpad({"fit", file("fit.toml")});
    EXPECT_EQ(outcome.exit_code, 2) << columns;
    return outcome.err;
  };
  const std::string modulus = "\"pad.parameters.modulus\" = {bounds = [\"100 kPa\", \"50 MPa\"]}";
  const std::string scale = "\"pad.scale\" = {bounds = [0.1, 10]}";
  const std::string speed = "\"impactor.speed\" = {bounds = [\"1 m/s\", \"10 m/s\"]}";
  for (const char* mass : {"impactor.mass", "impactor.weight"})
    EXPECT_THAT(refused(modulus,
                        "set = {\"" + std::string(mass) + "\" = \"6 " +
                            (mass == std::string("impactor.mass") ? "kg" : "N") + "\"}",
                        "impactor.mass [kg]", "4"),
                HasSubstr("drops.csv:1: impactor.mass: is also given by set"));
  EXPECT_THAT(refused(scale, "", "pad.scale", "1"), HasSubstr("is also decided by an unknown"));
  EXPECT_THAT(refused(speed, "", "impactor.drop_height [m]", "1"),
              HasSubstr("is also decided by an unknown"));
  EXPECT_THAT(refused(modulus, "", "impactor.mass [kg],impactor.weight [N]", "4,40"),
              HasSubstr("is also given by another column"));
  EXPECT_THAT(refused(modulus, "", "foam.continuation,impactor.mass [kg]", "1,4"),
              HasSubstr("drops.csv:1: foam.continuation"));
}

TEST_F(CaseRows, OfAFitMayBeSetOneByOne) {
  write_file(file("fit.toml"), R"(case = "case.toml"
[unknowns]
"pad.parameters.modulus" = {bounds = ["100 kPa", "50 MPa"]}
[[impacts]]
case = "case.toml"
set = {"impactor.mass" = "6 furlong"}
peak_force = {value = "1 kN", deviation = "5 %"}
)");
  const Outcome outcome = dashpad({"fit", file("fit.toml")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("fit.toml:6"), HasSubstr("impactor.mass")));
}

TEST_F(CaseRows, OfABatchAreAnsweredOneByOne) {
  write_file(file("cases.jsonl"), R"({"id": 7, "case": "case.toml", "set": {"impactor.speed": "2 m/s"}}
{"id": "two", "case": "case.toml", "set": {"impactor.speed": "2 kg"}}

not JSON
{"impactor": {"mass": "5 kg", "speed": "2 m/s", "radius": "50 mm"}, "support": {"type": "rigid"}}
{"case": "case.toml", "case": "other.toml"}
)");
  const Outcome outcome = dashpad({"batch", file("cases.jsonl"), "--tolerance", "1e-3", "--no-intervals"});
  EXPECT_EQ(outcome.exit_code, 2);
  std::istringstream lines(outcome.out);
  std::vector<json> answers;
  for (std::string line; std::getline(lines, line);) answers.push_back(json::parse(line));
  ASSERT_EQ(answers.size(), 5);
  EXPECT_EQ(answers[0].at("id"), 7);
  EXPECT_EQ(answers[0].at("peak_force_N"), peak_force({"impactor.speed=2 m/s"}));
  EXPECT_TRUE(answers[0].contains("flags"));
  EXPECT_EQ(answers[1].at("id"), "two");
  EXPECT_EQ(answers[1].at("faults").at(0).at("key"), "impactor.speed");
  EXPECT_EQ(answers[2].at("line"), 4);
  EXPECT_EQ(answers[2].at("faults").at(0).at("rule"), "is not JSON");
  EXPECT_EQ(answers[3].at("faults").at(0).at("key"), "pad");
  EXPECT_THAT(answers[4].at("faults").at(0).at("rule").get<std::string>(), HasSubstr("case"));
}

TEST_F(CaseRows, OfABatchComeFromStandardInputAndAreAnsweredBeforeItEnds) {
  const Outcome outcome =
      shell("mkfifo '" + file("in") + "'; $DASHPAD batch - < '" + file("in") + "' > '" + file("out") +
            "' & exec 3> '" + file("in") + "'; echo '{\"case\": \"" + file("case.toml") + "\"}' >&3; " +
            until("test -s '" + file("out") + "'") + "cat '" + file("out") + "'; exec 3>&-; wait");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("{\"id\":null,\"line\":1,"));
}

TEST_F(CaseRows, OfABatchEndWhereNobodyReadsTheAnswers) {
  const Outcome outcome =
      shell("{ yes '{\"case\": \"" + file("case.toml") +
            "\"}' | timeout 60 $DASHPAD batch - --no-intervals; echo $? >&2; } | head -n 1 | wc -l");
  EXPECT_EQ(outcome.out, "1\n");
  EXPECT_EQ(outcome.err, "0\n") << "124: it goes on for ever";
}

TEST_F(CaseRows, AreCheckedAsJson) {
  const Outcome good = dashpad({"check", file("case.toml"), "--json"});
  EXPECT_EQ(good.exit_code, 0);
  EXPECT_GT(json::parse(good.out).at("case").at("impactor").at("mass_kg").get<double>(), 0);
  const Outcome bad = dashpad({"check", file("case.toml"), "--json", "--set", "impactor.speed=2"});
  EXPECT_EQ(bad.exit_code, 2);
  const json faults = json::parse(bad.out).at("faults");
  EXPECT_EQ(faults.at(0).at("key"), "impactor.speed");
  EXPECT_THAT(faults.at(0).at("rule").get<std::string>(), Not(testing::IsEmpty()));
}

}  // namespace
}  // namespace dashpad::test
