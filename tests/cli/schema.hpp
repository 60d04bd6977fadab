#pragma once
/// JSON texts against a schema, schema/summary.schema.json unless another is named, by python3-jsonschema.

#include <string>

#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {

inline std::string schema_file(const std::string& name = "summary") {
  return DASHPAD_SOURCE_DIR "/schema/" + name + ".schema.json";
}

inline nlohmann::json schema_of(const std::string& name) {
  return nlohmann::json::parse(read_file(schema_file(name)));
}

/// What is wrong with a document, one line a fault; empty if it is as the schema says.
inline std::string schema_faults(const nlohmann::json& document, const std::string& schema = "summary") {
  static constexpr const char* validate = R"(
import json, sys, jsonschema
schema, document = (json.load(open(name)) for name in sys.argv[1:3])
jsonschema.Draft7Validator.check_schema(schema)
for fault in jsonschema.Draft7Validator(schema).iter_errors(document):
    print("/".join(map(str, fault.absolute_path)) + ": " + fault.message)
)";
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "document.json").string();
  write_file(file, document.dump());
  const Outcome outcome = run_program({"/usr/bin/env", "python3", "-c", validate, schema_file(schema), file});
  return outcome.exit_code == 0 ? outcome.out : "could not validate:\n" + outcome.err;
}

}  // namespace dashpad::test
