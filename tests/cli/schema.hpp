#pragma once
/// JSON texts against schema/summary.schema.json.

#include <string>

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "command.hpp"

namespace dashpad::test {

inline nlohmann::json summary_schema() {
  return nlohmann::json::parse(read_file(fs::path{DASHPAD_SOURCE_DIR} / "schema/summary.schema.json"));
}

/// What is wrong with a document, one line a fault; empty if it is as the schema says.
inline std::string schema_faults(const nlohmann::json& document) {
  const nlohmann::json text = summary_schema();
  valijson::Schema schema;
  valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema);

  valijson::Validator validator;
  valijson::ValidationResults results;
  validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(document), &results);
  std::string faults;
  valijson::ValidationResults::Error error;
  while (results.popError(error)) {
    for (const std::string& part : error.context) faults += part;
    faults += ": " + error.description + "\n";
  }
  return faults;
}

}  // namespace dashpad::test
