// The schema itself: nothing undescribed, nothing let through.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "schema.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;

bool is_number(const json& type) {
  return type == "number" || type == "integer" || (type.is_array() && type[0] == "number");
}

/// Goes through a schema with all schemas in it: every key described, and none optional or unknown.
void expect_strict(const json& schema, const std::string& place) {
  EXPECT_TRUE(schema.contains("description")) << place;
  if (schema.contains("type") && is_number(schema["type"])) {
    EXPECT_THAT(schema["description"].get<std::string>(), testing::HasSubstr("Unit: ")) << place;
  }
  const json properties = schema.value("properties", json::object());
  for (const auto& [name, part] : properties.items()) {
    EXPECT_THAT(schema["required"], testing::Contains(name)) << place;
    expect_strict(part, fmt::format("{}.{}", place, name));
  }
  const json patterns = schema.value("patternProperties", json::object());
  for (const auto& [name, part] : patterns.items()) expect_strict(part, fmt::format("{}.{}", place, name));
  if (schema.contains("properties") || schema.contains("patternProperties")) {
    EXPECT_EQ(schema.value("additionalProperties", true), false) << place;
  }
  if (schema.contains("items")) expect_strict(schema["items"], place + "[]");
  for (const json& part : schema.value("oneOf", json::array())) expect_strict(part, place + "|");
}

TEST(Schema, DescribesEveryKeyAndItsUnit) {
  for (const char* name : {"summary", "pulse-comparison", "fit"}) expect_strict(schema_of(name), name);
}

class SchemaTest : public CommandTest {};

/// Whatever command wrote it; that of validate is looked at where it is made, in test_validate.cpp.
TEST_F(SchemaTest, EveryResultBeginsWithItsFormat) {
  write_file(file("study.toml"),
             "case = \"case.toml\"\nresponses = [\"peak_force\"]\n"
             "[factors.\"impactor.speed\"]\nvalues = [\"2 m/s\", \"3 m/s\"]\n");
  ASSERT_EQ(dashpad({"study", file("study.toml"), "--out", file("study.db"), "--quiet"}).exit_code, 0);
  write_file(file("pulse.csv"), "time_s,acceleration_g\n0,0\n0.002,20\n0.004,40\n0.006,20\n0.008,0\n");
  const std::string fits = examples + "fits/vn600.toml";
  const std::vector<std::vector<std::string>> commands{
      {"run", case_file()},
      {"assess", case_file(), "--standard", "fmvss-208-hic15"},
      {"assess", case_file(), "--standard", "fmvss-208-hic15", "--standard", "en-1078"},
      {"pulse", file("pulse.csv")},
      {"compare", case_file()},
      {"compare", case_file(), "--pulse", file("pulse.csv")},
      {"post-impact", case_file(), "--other-mass", "100 kg"},
      {"spit1984", case_file()},
      {"material-test", "ensolite-aac-9", "--test", "constant-rate", "--rate", "10"},
      {"fit", fits},
      {"study", "summary", file("study.db")},
      {"study", "replay", file("study.db"), "1"},
  };
  for (std::vector<std::string> command : commands) {
    SCOPED_TRACE(testing::PrintToString(command));
    command.insert(command.end(), {"--json", "-"});
    const Outcome outcome = dashpad(command);
    ASSERT_TRUE(json::accept(outcome.out)) << outcome.out << outcome.err;
    const json result = json::parse(outcome.out);
    for (const json& one : result.is_array() ? result : json::array({result})) EXPECT_EQ(one["format"], 3);
    EXPECT_THAT(outcome.out, testing::ContainsRegex("^(\\[\n  )?\\{\n +\"format\": 3,\n"));
  }
}

TEST_F(SchemaTest, DescribesEveryNoseAndTheFaceOfThePad) {
  for (const std::string nose :
       {"nose = \"cone\"\nradius = \"3 in\"\nhalf_angle = \"60 deg\"",
        "nose = \"ellipsoid\"\nhalf_depth = \"3 in\"\nhalf_length = \"4 in\"\nhalf_width = \"2 in\"",
        "nose = \"rod\"\nradius = \"1 in\"\ntip_radius = \"3 in\"",
        "nose = \"platen\"\nlength = \"4 in\"\nwidth = \"3 in\"",
        "nose = \"cylinder\"\nradius = \"2 in\"\nlength = \"4 in\"",
        "nose = \"profile\"\nscale = 1.1\nradii = [[\"0 mm\", \"5 mm\"], [\"30 mm\", \"60 mm\"]]",
        "nose = \"profile\"\nareas = [[\"0 mm\", \"0 mm2\"], [\"30 mm\", \"90 cm2\"]]"}) {
    write_file(file("shaped.toml"), "[impactor]\n" + nose + R"(
mass = "4 kg"
speed = "3 m/s"
[pad]
thickness = "40 mm"
area = "60 cm2"
law = "elastic"
parameters = { modulus = "40 psi" }
[support]
type = "rigid"
)");
    const auto outcome = dashpad({"run", file("shaped.toml"), "--json", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json result = json::parse(outcome.out);
    EXPECT_EQ(schema_faults(result), "") << nose;
    EXPECT_EQ(result["case"]["pad"]["area_m2"], 0.006);
  }
}

TEST_F(SchemaTest, DescribesTheBlowsOfASeries) {
  const auto outcome =
      dashpad({"run", DASHPAD_SOURCE_DIR "/examples/playground-three-drops.toml", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(schema_faults(result), "");
  ASSERT_EQ(result["blows"].size(), 3u);
  EXPECT_GT(result["blows"][1]["peak_acceleration_g"], result["blows"][0]["peak_acceleration_g"]);
  EXPECT_EQ(result["blows"][2]["hic15"], result["injury"]["hic15"]["value"]);
}

TEST_F(SchemaTest, DescribesWhatASupportHasBesideItsCurve) {
  const std::string head = "[impactor]\nmass = \"4 kg\"\nradius = \"80 mm\"\nspeed = \"3 m/s\"\n";
  const std::string pad =
      "[pad]\nthickness = \"40 mm\"\nlaw = \"elastic\"\nparameters = { modulus = \"40 psi\" }\n";
  for (const std::string support :
       {"unloading_stiffness = \"400 N/mm\"\nearlier_force = \"100 N\"", "mass = \"1 kg\"\ngap = \"1 mm\"",
        "loss_factor = 0.2\npreload = \"50 N\"", "body_mass = \"20 kg\"\ndamping = \"10 N s/m\""}) {
    write_file(file("moving.toml"),
               head + pad + "[support]\ntype = \"linear\"\nstiffness = \"100 N/mm\"\n" + support);
    const auto outcome = dashpad({"run", file("moving.toml"), "--json", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json result = json::parse(outcome.out);
    EXPECT_EQ(schema_faults(result), "") << support;
    EXPECT_TRUE(result["peak_transmitted_force_N"].is_number()) << support;
  }
}

TEST_F(SchemaTest, DescribesAPadOfLayers) {
  const std::string example = DASHPAD_SOURCE_DIR "/examples/playground-mat-in-layers.toml";
  const auto outcome = dashpad({"run", example, "--tolerance", "1e-2", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(schema_faults(result), "");
  ASSERT_EQ(result["layers"].size(), 2U);
  EXPECT_EQ(result["layers"][1]["material"], "plastazote-ld33");
  EXPECT_EQ(result["case"]["pad"]["layers"][0]["law"], "foam");
  EXPECT_TRUE(result["case"]["pad"]["law"].is_null());
}

TEST_F(SchemaTest, NoticesWhatIsMissingOrTooMuch) {
  const json result = json::parse(dashpad({"run", case_file(), "--json", "-"}).out);
  ASSERT_EQ(schema_faults(result), "");
  json poorer = result;
  poorer.erase("restitution");
  EXPECT_NE(schema_faults(poorer), "");
  json richer = result;
  richer["case"]["colour"] = "grey";
  EXPECT_NE(schema_faults(richer), "");
  json wrong = result;
  wrong["peak_force_N"] = "1300 lbf";
  EXPECT_NE(schema_faults(wrong), "");
}

}  // namespace
}  // namespace dashpad::test
