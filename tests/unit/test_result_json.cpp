// The JSON summary of a result made by hand: SI, full precision, null where there is no figure.

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dashpad/output/impact.hpp"
#include "dashpad/version.hpp"
#include "example_result.hpp"

namespace dashpad {
namespace {

using nlohmann::json;

json written(const Summary& summary) {
  return json::parse(output::result_json(test::example_case(), summary));
}

TEST(ResultJson, HasTheFiguresInSI) {
  const json result = written(test::example_summary());
  EXPECT_EQ(result["status"], "released");
  EXPECT_EQ(result["peak_force_N"], 5768.7654321);
  EXPECT_EQ(result["time_to_peak_force_s"], 0.0130234567);
  EXPECT_DOUBLE_EQ(result["peak_acceleration_g"], 130);
  EXPECT_EQ(result["force_below_weight"], (json{{"time_s", 0.0241}, {"velocity_m_per_s", -8.6025}}));
  EXPECT_EQ(result["contact_end"]["time_s"], 0.0242);
  EXPECT_EQ(result["contact_end"]["velocity_m_per_s"], -8.6030);
  EXPECT_EQ(result["release"]["velocity_m_per_s"], -8.6031);
  EXPECT_EQ(result["energy_residual_fraction"], 0.009 / 180);
  EXPECT_EQ(result["errors"]["contact_end"], 4e-5);
  EXPECT_FALSE(result["errors"].contains("release"));
  EXPECT_EQ(result["solver"]["stations"], 80);
  EXPECT_TRUE(result["bottomed"].is_null());
  EXPECT_EQ(result["energy"]["pad_energy_J"], 13.991);
  EXPECT_EQ(result["errors"]["restitution"], 1e-5);
}

TEST(ResultJson, EchoesTheCase) {
  const json echo = written(test::example_summary())["case"];
  EXPECT_EQ(echo["title"], "Head on a dashboard");
  EXPECT_EQ(echo["impactor"], (json{{"gravity_m_per_s2", 0},
                                    {"mass_kg", 4.5},
                                    {"nose", "sphere"},
                                    {"radius_m", 0.0762},
                                    {"speed_m_per_s", 8.9408}}));
  EXPECT_EQ(echo["pad"]["law"], "linear-viscoelastic");
  EXPECT_EQ(echo["pad"]["parameters"]["relaxation_time"]["value"], 1.0 / 3000);
  EXPECT_EQ(echo["pad"]["parameters"]["initial_modulus"]["unit"], "Pa");
  EXPECT_EQ(echo["pad"]["fitted"]["highest_rate_per_s"], 100);
  EXPECT_EQ(echo["support"]["type"], "linear");
  EXPECT_EQ(echo["support"]["stiffness_N_per_m"], 105000);
}

TEST(ResultJson, EchoesEachKindOfSupport) {
  ImpactCase impact = test::example_case();
  impact.support = Support::rigid();
  EXPECT_EQ(json::parse(output::result_json(impact, test::example_summary()))["case"]["support"]["type"],
            "rigid");
  impact.support = Support::through({{0.001, 100}, {0.002, 900}});
  const json support = json::parse(output::result_json(impact, test::example_summary()))["case"]["support"];
  EXPECT_EQ(support["type"], "curve");
  EXPECT_EQ(support["points"][1], (json{{"deflection_m", 0.002}, {"force_N", 900}}));
}

TEST(ResultJson, NamesTheProgram) {
  const json program = written(test::example_summary())["program"];
  EXPECT_EQ(program["name"], "dashpad");
  EXPECT_EQ(program["version"], version());
  EXPECT_EQ(program["commit"], build_facts().git_commit);
}

TEST(ResultJson, ReadsBackAsTheSameNumbers) {
  for (const double force : {0.1, 1.0 / 3, 2.0 / 3e7, 5e-324, 1.7976931348623157e308, 123456789.123456789}) {
    Summary summary = test::example_summary();
    summary.peak_force = force;
    EXPECT_EQ(written(summary)["peak_force_N"].get<double>(), force);
  }
}

TEST(ResultJson, HasNullsWhereThePadBottomedOut) {
  const json result = written(test::bottomed_out_summary());
  EXPECT_EQ(result["status"], "bottomed out");
  for (const char* key : {"peak_force_N", "time_to_peak_force_s", "peak_acceleration_g", "force_below_weight",
                          "contact_end", "release", "rebound_speed_m_per_s", "restitution"})
    EXPECT_TRUE(result.at(key).is_null()) << key;
  EXPECT_TRUE(result["errors"]["peak_force"].is_null());
  EXPECT_EQ(result["bottomed"], (json{{"time_s", 0.0059307}, {"velocity_m_per_s", 5.05}}));
}

TEST(ResultJson, NeverHoldsANumberThatIsNotFinite) {
  Summary summary = test::example_summary();
  summary.peak_force = std::numeric_limits<double>::infinity();
  summary.errors.peak_motion = std::nan("");
  summary.energy = {};                   // 0/0
  const json result = written(summary);  // throws for text such as "nan"
  EXPECT_TRUE(result["peak_force_N"].is_null());
  EXPECT_TRUE(result["errors"]["peak_motion"].is_null());
  EXPECT_TRUE(result["energy_residual_fraction"].is_null());
}

TEST(ResultJson, SurvivesTextThatIsNotUtf8) {
  ImpactCase impact = test::example_case();
  impact.title = "caf\xe9 \"quoted\"\n";
  const json result = json::parse(output::result_json(impact, test::example_summary()));
  EXPECT_EQ(result["case"]["title"], "caf\xef\xbf\xbd \"quoted\"\n");
}

TEST(ResultJson, SaysWhyAResultIsExtrapolated) {
  Summary summary = test::example_summary();
  summary.extrapolations = {{Beyond::strain, "strain"}, {Beyond::rate, "rate"}};
  EXPECT_EQ(written(summary)["extrapolations"], (json{"strain", "rate"}));
  EXPECT_EQ(written(summary)["extrapolated"], true);
}

}  // namespace
}  // namespace dashpad
