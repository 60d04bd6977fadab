#include "live/case_tables.hpp"

#include <cmath>

#include <fmt/format.h>

#include "output/text/case_toml.hpp"

namespace dashpad::live {

namespace {

using Node = input::TomlNode;

bool is_bare(const std::string& key) {
  return !key.empty() &&
         key.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
             std::string::npos;
}
std::string toml_key(const std::string& key) { return is_bare(key) ? key : output::toml_string(key); }

/// A value in one line.
std::string toml_value(const Json& value) {
  if (value.is_string()) return output::toml_string(value.get<std::string>());
  if (value.is_array()) {
    std::string list;
    for (const Json& each : value) list += (list.empty() ? "" : ", ") + toml_value(each);
    return "[" + list + "]";
  }
  if (value.is_object()) {
    std::string list;
    for (const auto& [key, each] : value.items())
      list += (list.empty() ? " " : ", ") + toml_key(key) + " = " + toml_value(each);
    return "{" + list + " }";
  }
  return value.is_null() ? "\"\"" : value.dump();
}

}  // namespace

Json tables_of(const Node& node) {
  switch (node.kind) {
    case Node::Kind::table: {
      Json table = Json::object();
      for (const Node& child : node.children) table[child.key] = tables_of(child);
      return table;
    }
    case Node::Kind::array: {
      Json list = Json::array();
      for (const Node& child : node.children) list.push_back(tables_of(child));
      return list;
    }
    case Node::Kind::text: return node.text;
    case Node::Kind::number:
      // A whole number stays one.
      return Json::accept(node.text) ? Json::parse(node.text) : number(node.number);
    case Node::Kind::other: break;
  }
  if (node.text == "true" || node.text == "false") return node.text == "true";
  return node.text;
}

std::string toml_of(const Json& tables) {
  if (!tables.is_object()) return {};
  std::string values, rest;
  for (const auto& [key, value] : tables.items()) {
    if (!value.is_object()) {
      values += toml_key(key) + " = " + toml_value(value) + "\n";
      continue;
    }
    rest += fmt::format("\n[{}]\n", toml_key(key));
    for (const auto& [name, each] : value.items()) rest += toml_key(name) + " = " + toml_value(each) + "\n";
  }
  return values + rest;
}

}  // namespace dashpad::live
