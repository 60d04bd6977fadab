// Cases as JSON objects, a line each.

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "dashpad/input/case_file.hpp"
#include "input/case_tables.hpp"
#include "json/json_values.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {
namespace {

constexpr int max_depth = 16;

/// A value of a case as a tree; all entries have the line of the object.
TomlNode tree_of(const Json& json, std::string key, int line) {
  TomlNode node;
  node.line = line;
  node.key = std::move(key);
  if (json.is_object()) {
    node.kind = TomlNode::Kind::table;
    for (const auto& [name, value] : json.items()) node.children.push_back(tree_of(value, name, line));
  } else if (json.is_array()) {
    node.kind = TomlNode::Kind::array;
    for (const Json& value : json)
      node.children.push_back(tree_of(value, fmt::format("[{}]", node.children.size() + 1), line));
  } else if (json.is_string()) {
    node.kind = TomlNode::Kind::text;
    node.text = json.get<std::string>();
  } else if (json.is_number()) {
    node.kind = TomlNode::Kind::number;
    node.number = json.get<double>();
    node.text = json.dump();
  } else {
    node.text = json.dump();
  }
  return node;
}

struct Parsed {
  Json json;
  std::string rule;  ///< "" if it is an object
};

/// The object in a line, of limited depth, with no key twice in a table.
Parsed parsed(std::string_view text) {
  std::vector<std::set<std::string>> keys;
  std::string rule;
  const auto look = [&](int depth, Json::parse_event_t event, Json& value) {
    if (depth > max_depth && rule.empty()) rule = fmt::format("is nested more than {} deep", max_depth);
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end && !keys.empty()) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.empty() && rule.empty())
      if (const auto name = value.get<std::string>(); !keys.back().insert(name).second)
        rule = fmt::format("{} is given twice", quoted_part(name));
    return depth <= max_depth;
  };
  Json json = Json::parse(text, look, false);
  if (!rule.empty()) return {{}, rule};
  if (json.is_discarded()) return {{}, "is not JSON"};
  if (!json.is_object()) return {{}, "must be a JSON object: {\"case\": \"drop.toml\", \"set\": {...}}"};
  return {std::move(json), ""};
}

/// The settings of "set" as those of --set: "pad.thickness=30 mm".
std::vector<std::string> settings_in(const Json& set) {
  std::vector<std::string> settings;
  for (const auto& [key, value] : set.items())
    settings.push_back(key + "=" + (value.is_string() ? value.get<std::string>() : value.dump()));
  return settings;
}

/// Whether the value of "set" is an object of texts, numbers and the like.
bool is_flat(const Json& set) {
  return set.is_object() &&
         std::ranges::none_of(set, [](const Json& value) { return value.is_structured(); });
}

}  // namespace

JsonCase read_case_json(std::string_view text, int line, const std::string& file,
                        const std::filesystem::path& folder, const std::filesystem::path& materials) {
  auto [json, rule] = parsed(text);
  const auto fault = [&](std::string key, std::string broken) {
    return std::vector{Fault{file, line, std::move(key), "", std::move(broken)}};
  };
  if (!rule.empty()) return {"", fault("", rule)};
  JsonCase result{json.contains("id") ? json["id"].dump(-1, ' ', false, Json::error_handler_t::replace) : "",
                  std::vector<Fault>{}};
  json.erase("id");
  if (!json.contains("case")) {
    TomlFile tree{file, "", tree_of(json, "", line)};
    tree.root.line = line;
    result.read = read_case_tree(tree, folder / file, materials);
    return result;
  }
  std::vector<Fault> faults;
  const auto refuse = [&](const char* key, std::string broken) {
    faults.push_back(fault(key, std::move(broken)).front());
  };
  if (!json["case"].is_string() || json["case"].get<std::string>().empty())
    refuse("case", "must be the name of a case file");
  if (json.contains("set") && !is_flat(json["set"]))
    refuse("set", "must be an object with a value for each key: {\"pad.thickness\": \"30 mm\"}");
  for (const auto& [key, value] : json.items())
    if (key != "case" && key != "set") refuse(key.c_str(), "is not a key beside case; keys: case, set, id");
  if (faults.empty()) {
    const auto settings = json.contains("set") ? settings_in(json["set"]) : std::vector<std::string>{};
    result.read = read_case(folder / json["case"].get<std::string>(), materials, settings);
    faults = result.read.faults();
    for (Fault& each : faults)
      if (each.file == "--set") {
        each.file = file;
        each.line = line;
      }
  }
  if (!faults.empty()) result.read = std::move(faults);
  return result;
}

}  // namespace dashpad::input
