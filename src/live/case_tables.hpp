#pragma once
/// The tables of a case as JSON, as a live page keeps them, and as a case file.

#include <string>

#include "input/toml_tree.hpp"
#include "json/json_values.hpp"

namespace dashpad::live {

/// Texts, numbers and lists as they are written in the file.
Json tables_of(const input::TomlNode& node);

/// The same as TOML: values first, then a table each, with a table of lists of tables written in lines.
std::string toml_of(const Json& tables);

}  // namespace dashpad::live
