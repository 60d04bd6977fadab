#pragma once
/// A TOML file as a plain tree that remembers where everything stands.

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dashpad/input/reading.hpp"

namespace dashpad::input {

/// In place of a line: not in the file, but set by an option of the command.
inline constexpr int set_by_option = -1;

struct TomlNode {
  enum class Kind { table, array, text, number, other };

  /// Of a key or a value in its line, in characters from 1; 0: not known.
  struct Columns {
    std::size_t begin = 0, end = 0;
  };

  Kind kind = Kind::other;
  int line = 0;
  Columns columns = {};      ///< of the value; to the end of the line where that ends in another
  Columns key_columns = {};  ///< of the key, where it stands in the line
  std::string key = {};      ///< in its table; "[1]", "[2]", ... in an array
  std::string text = {};     ///< of a text; of other kinds, what stands there in the user's words
  double number = 0;         ///< of a number, whole or not
  std::vector<TomlNode> children = {};

  /// The entry of a table, or null.
  [[nodiscard]] const TomlNode* child(std::string_view name) const;
  [[nodiscard]] TomlNode* child(std::string_view name) {
    return const_cast<TomlNode*>(std::as_const(*this).child(name));
  }
  /// The entry with a dotted key, such as "pad.thickness" or "support.points[3]", or the last one on the way.
  [[nodiscard]] const TomlNode& nearest(std::string_view dotted_key) const;
  /// The value as in the file, shortened to a line; "" for tables and arrays.
  [[nodiscard]] std::string written() const;
};

/// Takes the first part off a dotted key: of "pad.layers[2].thickness" pad, then layers, [2], thickness.
std::string_view take_key_part(std::string_view& key);

struct TomlFile {
  std::string name;  ///< as faults call it
  std::string text;
  TomlNode root = {};
};

/// A fault where the file cannot be read (input/text_file.hpp) or is not TOML.
Reading<TomlFile> read_toml(const std::filesystem::path& file);
/// The same of a text, which faults call `name`.
Reading<TomlFile> read_toml_text(std::string name, std::string text);

/// A line of a text, from 1, with what stands in those columns; empty for a line that is not there.
Excerpt excerpt_of(std::string_view text, int line, TomlNode::Columns columns);

/// A value as a command line gives it: in TOML, or else a text without quotes, as 30 mm. Set by an option.
TomlNode toml_value(const std::string& value);

}  // namespace dashpad::input
