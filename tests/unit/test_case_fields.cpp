// The numbers of a case stand in the tables of their structures, and nowhere else: docs/case-files.md and the
// schema of results are held to them. To write both anew after a change: DASHPAD_REGENERATE=1 test_unit
// --gtest_filter='CaseFields.*', then look at the difference.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "model/parameter_values.hpp"
#include "shared/generated_text.hpp"

namespace dashpad::test {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

const fs::path root = DASHPAD_SOURCE_DIR;
std::string in_unit(const std::string& unit) { return unit == "1" ? "" : unit; }

std::string words_if_left_out(const CaseField& field) {
  switch (field.left_out) {
    case LeftOut::refused: return "must be given";
    case LeftOut::none:
    case LeftOut::zero: return "none";
    case LeftOut::computed: return "see above";
    case LeftOut::as_default: break;
  }
  if (std::isnan(field.default_value)) return "none";
  return fmt::format("{}{}{}", field.default_value, field.unit == "1" ? "" : " ", in_unit(field.unit));
}

std::string table_of_fields() {
  std::string text = "| key | SI unit | meaning | rule | if left out | since |\n|---|---|---|---|---|---|\n";
  for (const CaseField& field : case_fields())
    text += fmt::format("| `{}.{}` | {} | {} | {} | {} | {} |\n", field.table, field.key, in_unit(field.unit),
                        field.meaning, field.rule, words_if_left_out(field), field.since);
  for (const OtherWay& way : other_ways())
    text += fmt::format("| `{}` | {} | {} | in place of `{}` | | {} |\n", way.key, in_unit(way.unit),
                        way.meaning, way.instead_of, way.since);
  return text;
}

TEST(CaseFields, AreInTheReferenceOfCaseFiles) {
  expect_generated(root / "docs" / "case-files.md", "numbers of a case", table_of_fields());
}

/// Where the schema describes the echo of a table of the case.
Json& echo_of(Json& schema, const std::string& table) {
  Json& of_case = schema["properties"]["case"]["properties"];
  return table == "pad.layers" ? of_case["pad"]["properties"]["layers"]["items"] : of_case[table];
}

TEST(CaseFields, AreInTheSchemaOfResults) {
  const fs::path file = root / "schema" / "summary.schema.json";
  Json schema = Json::parse(text_of(file));
  for (const CaseField& field : case_fields()) {
    if (field.table == "solver") continue;  // no echo: results say what they were solved with
    Json& echo = echo_of(schema, field.table);
    const std::string name = name_with_unit(field.key, field.unit);
    if (is_regenerating() && !echo["properties"].contains(name)) {
      echo["properties"][name] = {{"description", fmt::format("{}. Unit: {}.", field.meaning, field.unit)},
                                  {"type", {"number", "null"}}};
      echo["required"].push_back(name);
    }
    ASSERT_TRUE(echo["properties"].contains(name)) << field.table << " " << name;
    const std::string description = echo["properties"][name]["description"];
    EXPECT_TRUE(description.ends_with("Unit: " + field.unit + ".")) << field.table << " " << description;
    const std::set<std::string> required = echo["required"];
    EXPECT_TRUE(required.contains(name)) << field.table << " " << name;
  }
  if (is_regenerating()) write_text(file, schema.dump(2) + "\n");
}

/// Holds every list of choices that begins as `names` to all of them, and counts these lists. One that admits
/// null still does.
int hold_choices(Json& node, const std::vector<std::string>& names) {
  int count = 0;
  for (auto& [key, value] : node.items()) {
    if (key == "enum" && value.front() == names.front()) {
      Json expected = names;
      if (value.back().is_null()) expected.push_back(nullptr);
      if (is_regenerating()) value = expected;
      EXPECT_EQ(value, expected);
      ++count;
    } else if (value.is_structured()) {
      count += hold_choices(value, names);
    }
  }
  return count;
}

TEST(CaseFields, SchemasHaveTheNamesOfAllLawsAndNoses) {
  int laws = 0, noses = 0;
  for (const char* name : {"summary", "fit"}) {
    const fs::path file = root / "schema" / fmt::format("{}.schema.json", name);
    Json schema = Json::parse(text_of(file));
    laws += hold_choices(schema, names_of_alternatives<PadLaw>());
    noses += hold_choices(schema, names_of_alternatives<Nose>());
    if (is_regenerating()) write_text(file, schema.dump(2) + "\n");
  }
  EXPECT_EQ(laws, 3);
  EXPECT_EQ(noses, 1);
}

}  // namespace
}  // namespace dashpad::test
