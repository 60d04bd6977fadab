// The quantities of a result stand in their table, and nowhere else: docs/results.md and the schema of
// results are held to it. To write both anew after a change: DASHPAD_REGENERATE=1 test_unit
// --gtest_filter='ResultFields.*', then look at the difference.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "dashpad/quantities/unit_system.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "shared/generated_text.hpp"

namespace dashpad::test {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

const fs::path root = DASHPAD_SOURCE_DIR;

std::string unit_in_files(const ResultQuantity& result_quantity, const UnitSystem& units) {
  return scaled_unit(result_quantity.si_unit, units).unit;
}

std::string unit_or(const char* none, const std::string& unit) { return unit == "1" ? none : unit; }

std::string with_capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

/// A row for each quantity of these parts.
std::string table_of(const std::string& head, std::initializer_list<Part> parts,
                     const std::function<std::string(const ResultQuantity&)>& row) {
  std::string text = head + "\n|";
  for (std::size_t i = 1; i < head.size(); ++i)
    if (head[i] == '|') text += "---|";
  text += "\n";
  for (const Part part : parts)
    for (const ResultQuantity& result_quantity : result_quantities())
      if (result_quantity.part == part) text += row(result_quantity) + "\n";
  return text;
}

std::string table_of_impact() {
  return table_of("| title | key | unit in files | error | interval | meaning | none |",
                  {Part::impact, Part::moment, Part::energy}, [](const ResultQuantity& result_quantity) {
                    return fmt::format(
                        "| {} | `{}` | {} | {} | {} | {} | {} |", result_quantity.title, result_quantity.key,
                        unit_or("", unit_in_files(result_quantity, plain_si())),
                        result_quantity.role.estimate, result_quantity.has_interval() ? "yes" : "",
                        result_quantity.meaning, result_quantity.role.absent);
                  });
}

std::string table_of_pulse() {
  return table_of("| title | key | unit | interval | meaning |", {Part::pulse},
                  [](const ResultQuantity& result_quantity) {
                    return fmt::format("| {} | `{}` | {} | {} | {} |", result_quantity.title,
                                       result_quantity.key,
                                       unit_or("", unit_in_files(result_quantity, plain_si())),
                                       result_quantity.has_interval() ? "yes" : "", result_quantity.meaning);
                  });
}

/// Files of numbers are in plain SI where a reader sees its prefixes.
std::string table_of_history() {
  const auto in_files = [](const UnitSystem& units) { return units.name == "si" ? plain_si() : units; };
  std::string head = "| column |";
  for (const UnitSystem& units : unit_systems()) head += fmt::format(" `--units {}` |", units.name);
  return table_of(head + " meaning |", {Part::history}, [&](const ResultQuantity& result_quantity) {
    std::string row = fmt::format("| `{}` |", result_quantity.key);
    for (const UnitSystem& units : unit_systems())
      row += fmt::format(" {} |", unit_or("-", unit_in_files(result_quantity, in_files(units))));
    return row + fmt::format(" {} |", result_quantity.meaning);
  });
}

TEST(ResultFields, AreInTheReferenceOfResults) {
  const fs::path document = root / "docs" / "results.md";
  expect_generated(document, "figures of the impact", table_of_impact());
  expect_generated(document, "figures of the pulse", table_of_pulse());
  expect_generated(document, "columns of the history", table_of_history());
}

std::string description_of(const ResultQuantity& result_quantity) {
  std::string text = with_capital(result_quantity.meaning);
  if (*result_quantity.role.absent != '\0') text += fmt::format("; null {}", result_quantity.role.absent);
  const std::string unit = unit_in_files(result_quantity, plain_si());
  const bool says_unit = std::string_view(result_quantity.meaning).ends_with("g^2.5 s");
  return text + (says_unit                              ? ". Unit: g^2.5 s."
                 : result_quantity.part == Part::moment ? "."
                                                        : fmt::format(". Unit: {}.", unit));
}

/// The description of a property that has to be there, always. A new one is made after that of `pattern`.
void expect_property(Json& object, const std::string& key, const std::string& description,
                     const char* pattern) {
  Json& properties = object["properties"];
  if (is_regenerating() && !properties.contains(key)) {
    const Json made = properties.at(pattern);
    properties[key] = made;
    object["required"].push_back(key);
  }
  ASSERT_TRUE(properties.contains(key)) << key;
  EXPECT_TRUE(std::set<std::string>(object["required"]).contains(key)) << key;
  if (is_regenerating())
    properties[key]["description"] = description;
  else
    EXPECT_EQ(properties[key]["description"], description) << key;
}

TEST(ResultFields, AreInTheSchemaOfResults) {
  const fs::path file = root / "schema" / "summary.schema.json";
  Json schema = Json::parse(text_of(file));
  Json& parts = schema["properties"];
  for (const ResultQuantity& result_quantity : result_quantities()) {
    switch (result_quantity.part) {
      case Part::impact:
        expect_property(schema, key_with_unit(result_quantity), description_of(result_quantity),
                        "peak_force_N");
        break;
      case Part::moment:
        expect_property(schema, result_quantity.key, description_of(result_quantity), "contact_end");
        break;
      case Part::energy:
        if (std::string_view(result_quantity.key) != "total_energy")  // over time, on the page
          expect_property(parts["energy"], key_with_unit(result_quantity), description_of(result_quantity),
                          "impact_energy_J");
        break;
      case Part::pulse:
        if (result_quantity.role.in_studies)
          expect_property(parts["injury"], result_quantity.key, description_of(result_quantity),
                          "severity_index");
        break;
      case Part::history: break;
    }
    if (result_quantity.has_estimate() &&
        (result_quantity.part == Part::impact || result_quantity.part == Part::moment))
      expect_property(parts["errors"], result_quantity.key,
                      fmt::format("Estimated error of {}: {}; null if that figure is absent. Unit: 1.",
                                  result_quantity.key, result_quantity.role.estimate),
                      "peak_force");
  }
  if (is_regenerating()) write_text(file, schema.dump(2) + "\n");
}

}  // namespace
}  // namespace dashpad::test
