// dashpad run: what it shows and what it writes.

#include <algorithm>
#include <charconv>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "schema.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class RunTest : public CommandTest {};

/// Header and numbers of a CSV text without quoted fields.
struct Csv {
  std::vector<std::string> header;
  std::vector<std::vector<double>> rows;
};

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

Csv parse_csv(const std::string& text) {
  Csv csv;
  std::istringstream stream(text);
  std::string line;
  std::getline(stream, line);
  csv.header = fields_of(line);
  while (std::getline(stream, line)) {
    std::vector<double> row;
    for (const std::string& field : fields_of(line)) {
      double value = 0;
      const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
      if (error != std::errc{} || end != field.data() + field.size())
        throw std::runtime_error("not a number: " + field);
      row.push_back(value);
    }
    csv.rows.push_back(row);
  }
  return csv;
}

TEST_F(RunTest, ShowsTheSummary) {
  const Outcome outcome = dashpad({"run", case_file()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("A sphere of mass 5 kg and radius 80 mm strikes, at 3 m/s,\n"),
                                 HasSubstr("Peak force"), HasSubstr("restitution")));
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(other_files(), IsEmpty());
}

TEST_F(RunTest, ShowsEachSystemOfUnits) {
  EXPECT_THAT(dashpad({"run", case_file(), "--units", "si"}).out,
              AllOf(HasSubstr(" N\n"), HasSubstr(" mm ")));
  EXPECT_THAT(dashpad({"run", case_file(), "--units", "us"}).out,
              AllOf(HasSubstr(" lbf\n"), HasSubstr(" mph "), HasSubstr(" in ")));
  EXPECT_THAT(dashpad({"run", case_file(), "--units", "engineering-metric"}).out,
              AllOf(HasSubstr(" kN\n"), HasSubstr(" km/h ")));
}

TEST_F(RunTest, WritesJsonThatTheSchemaDescribes) {
  const Outcome outcome = dashpad({"run", case_file(), "--json", file("result.json")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Peak force"));
  const json result = json::parse(read_file(file("result.json")));
  EXPECT_EQ(schema_faults(result), "");
  EXPECT_EQ(result["status"], "released");
  EXPECT_EQ(result["case"]["impactor"]["mass_kg"], 5);
  EXPECT_NEAR(result["restitution"].get<double>(), 1, 1e-3);
  EXPECT_THAT(other_files(), ElementsAre("result.json"));
}

TEST_F(RunTest, GivesJsonInSiWhateverUnitsAreShown) {
  json si = json::parse(dashpad({"run", case_file(), "--json", "-"}).out);
  json us = json::parse(dashpad({"run", case_file(), "--json", "-", "--units", "us"}).out);
  for (json* result : {&si, &us}) (*result)["solver"].erase("wall_time_s");
  EXPECT_EQ(si, us);
}

TEST_F(RunTest, WritesAHistoryThatAgreesWithTheSummary) {
  const Outcome outcome =
      dashpad({"run", case_file(), "--csv", file("history.csv"), "--json", file("result.json")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Csv csv = parse_csv(read_file(file("history.csv")));
  EXPECT_THAT(csv.header,
              ElementsAre("time_s", "force_N", "acceleration_g", "velocity_m_per_s", "motion_m",
                          "penetration_m", "support_deflection_m", "contact_radius_m", "axis_strain"));
  const json result = json::parse(read_file(file("result.json")));
  ASSERT_GT(csv.rows.size(), 10u);
  double peak = 0;
  for (const auto& row : csv.rows) {
    ASSERT_EQ(row.size(), csv.header.size());
    peak = std::max(peak, row[1]);
    EXPECT_NEAR(row[4], row[5] + row[6], 1e-9 + 1e-6 * row[4]);  // motion = penetration + support deflection
    EXPECT_NEAR(row[2], -row[1] / (5 * 9.80665), 1e-6 * (1 + std::abs(row[2])));
  }
  EXPECT_NEAR(peak, result["peak_force_N"].get<double>(), 2e-2 * peak);
  EXPECT_EQ(csv.rows.front()[0], 0);
  EXPECT_EQ(csv.rows.front()[3], 3);
}

TEST_F(RunTest, WritesAHistoryInTheUnitsAskedFor) {
  const Csv si = parse_csv(dashpad({"run", case_file(), "--csv", "-"}).out);
  const Csv us = parse_csv(dashpad({"run", case_file(), "--csv", "-", "--units", "us"}).out);
  EXPECT_THAT(us.header[0], "time_ms");
  EXPECT_THAT(us.header[1], "force_lbf");
  ASSERT_EQ(si.rows.size(), us.rows.size());
  const std::size_t middle = si.rows.size() / 2;
  EXPECT_NEAR(us.rows[middle][1] * 4.4482216152605, si.rows[middle][1], 1e-12 * si.rows[middle][1]);
  EXPECT_EQ(parse_csv(dashpad({"run", case_file(), "--csv", "-", "--units", "si"}).out).header, si.header);
}

TEST_F(RunTest, KeepsToTheToleranceAskedFor) {
  const json result = json::parse(dashpad({"run", case_file(), "--tolerance", "1e-5", "--json", "-"}).out);
  EXPECT_EQ(result["solver"]["tolerance"], 1e-5);
  EXPECT_LE(result["errors"]["peak_force"].get<double>(), 1e-5);
}

TEST_F(RunTest, PutsTheSummaryOnStandardErrorWhereAFileTakesStandardOutput) {
  const Outcome outcome = dashpad({"run", case_file(), "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(schema_faults(json::parse(outcome.out)), "");
  EXPECT_THAT(outcome.err, HasSubstr("Peak force"));
}

TEST_F(RunTest, CountsBottomingOutAsAResult) {
  write_file(file("hard.toml"),
             with(with(with(elastic_case(), "3 m/s", "60 m/s"), "type = \"linear\"", "type = \"rigid\""),
                  "stiffness = \"100 N/mm\"\n", ""));
  const Outcome outcome =
      dashpad({"run", file("hard.toml"), "--json", file("hard.json"), "--csv", file("hard.csv")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("BOTTOMED at"), ContainsRegex("Peak force +none")));
  const json result = json::parse(read_file(file("hard.json")));
  EXPECT_EQ(schema_faults(result), "");
  EXPECT_EQ(result["status"], "bottomed out");
  EXPECT_TRUE(result["peak_force_N"].is_null());
  EXPECT_GT(result["bottomed"]["velocity_m_per_s"].get<double>(), 0);
  EXPECT_GT(parse_csv(read_file(file("hard.csv"))).rows.size(), 2u);
}

TEST_F(RunTest, RunsEveryExample) {
  for (const auto& entry : fs::directory_iterator(fs::path{DASHPAD_SOURCE_DIR} / "examples")) {
    if (entry.path().extension() != ".toml") continue;
    const Outcome outcome = dashpad({"run", entry.path().string(), "--json", "-"});
    EXPECT_EQ(outcome.exit_code, 0) << entry.path() << outcome.err;
    EXPECT_EQ(schema_faults(json::parse(outcome.out)), "") << entry.path();
  }
}

TEST_F(RunTest, TakesMaterialsFromAFolder) {
  fs::create_directory(file("cards"));
  write_file(file("cards/mine.toml"),
             "title = \"Mine\"\nsource = \"a test\"\nlaw = \"elastic\"\n"
             "[parameters]\nmodulus = \"300 kPa\"\n");
  write_file(file("named.toml"),
             with(elastic_case(), "law = \"elastic\"\n[pad.parameters]\nmodulus = \"300 kPa\"",
                  "material = \"mine\""));
  const Outcome named = dashpad({"run", file("named.toml"), "--materials", file("cards"), "--json", "-"});
  ASSERT_EQ(named.exit_code, 0) << named.err;
  const json in_line = json::parse(dashpad({"run", case_file(), "--json", "-"}).out);
  EXPECT_EQ(json::parse(named.out)["peak_force_N"], in_line["peak_force_N"]);
  EXPECT_EQ(shell("DASHPAD_MATERIALS='" + file("cards") + "' $DASHPAD run " + file("named.toml")).exit_code,
            0);
}

}  // namespace
}  // namespace dashpad::test
