#pragma once
/// A TOML file as a plain tree with the places of all entries.

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dashpad/input/reading.hpp"

namespace dashpad::input {

/// The line of an entry that was set by an option of the command.
inline constexpr int set_by_option = -1;

struct TomlNode {
  enum class Kind { table, array, text, number, other };

  /// The columns of a key or a value, in characters from 1; 0 if unknown.
  struct Columns {
    std::size_t begin = 0, end = 0;
  };

  Kind kind = Kind::other;
  int line = 0;
  Columns columns = {};      ///< of the value; to the end of the line if that ends in another
  Columns key_columns = {};  ///< of the key
  std::string key = {};      ///< in its table; "[1]", "[2]", ... in an array
  std::string text = {};     ///< of a text; for other kinds as written
  double number = 0;         ///< of a number, whole or not
  std::vector<TomlNode> children = {};

  /// The entry of a table, or null.
  [[nodiscard]] const TomlNode* child(std::string_view name) const;
  [[nodiscard]] TomlNode* child(std::string_view name) {
    return const_cast<TomlNode*>(std::as_const(*this).child(name));
  }
  /// The entry with a dotted key, such as "support.points[3]", or the last existing one on the way.
  [[nodiscard]] const TomlNode& nearest(std::string_view dotted_key) const;
  /// The value as in the file, as one line; "" for tables and arrays.
  [[nodiscard]] std::string written() const;
};

/// Removes the first part of a dotted key: "pad.layers[2].mu" has the parts pad, layers, [2], mu.
std::string_view take_key_part(std::string_view& key);

struct TomlFile {
  std::string name;  ///< as faults call it
  std::string text;
  TomlNode root = {};
};

/// Faults: the file cannot be read (input/disk.hpp) or is not TOML.
Reading<TomlFile> read_toml(const std::filesystem::path& file);
/// Reads a text, which faults call `name`.
Reading<TomlFile> read_toml_text(std::string name, std::string text);

/// A line of a text, from 1, with marked columns; empty if there is no such line.
Excerpt excerpt_of(std::string_view text, int line, TomlNode::Columns columns);

/// A value of the command line: TOML, or text without quotes, such as 30 mm.
TomlNode toml_value(const std::string& value);

}  // namespace dashpad::input
