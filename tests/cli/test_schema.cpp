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

/// Goes through a schema with all schemas in it.
void expect_strict(const json& schema, const std::string& place) {
  EXPECT_TRUE(schema.contains("description")) << place;
  if (schema.contains("type") && is_number(schema["type"])) {
    EXPECT_THAT(schema["description"].get<std::string>(), testing::HasSubstr("Unit: ")) << place;
  }
  for (const char* key : {"properties", "patternProperties"}) {
    if (!schema.contains(key)) continue;
    EXPECT_EQ(schema.value("additionalProperties", true), false) << place;
    for (const auto& [name, part] : schema[key].items())
      expect_strict(part, fmt::format("{}.{}", place, name));
  }
  if (schema.contains("items")) expect_strict(schema["items"], place + "[]");
  for (const json& part : schema.value("oneOf", json::array())) expect_strict(part, place + "|");
}

TEST(Schema, DescribesEveryKeyAndItsUnit) { expect_strict(summary_schema(), "summary"); }

class SchemaTest : public CommandTest {};

TEST_F(SchemaTest, NoticesWhatIsMissingOrTooMuch) {
  const json result = json::parse(dashpad({"run", case_file(), "--json", "-"}).out);
  ASSERT_EQ(schema_faults(result), "");
  for (const auto& [key, value] : result.items()) {
    json poorer = result;
    poorer.erase(key);
    EXPECT_NE(schema_faults(poorer), "") << key;
  }
  json richer = result;
  richer["case"]["colour"] = "grey";
  EXPECT_NE(schema_faults(richer), "");
  json wrong = result;
  wrong["peak_force_N"] = "1300 lbf";
  EXPECT_NE(schema_faults(wrong), "");
}

}  // namespace
}  // namespace dashpad::test
