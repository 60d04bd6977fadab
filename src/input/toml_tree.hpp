#pragma once
/// A TOML file as a plain tree that remembers lines.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace dashpad::input {

/// In place of a line: not in the file, but set by an option of the command.
inline constexpr int set_by_option = -1;

struct TomlNode {
  enum class Kind { table, array, text, number, other };

  Kind kind = Kind::other;
  int line = 0;
  std::string key = {};   ///< in its table; "[1]", "[2]", ... in an array
  std::string text = {};  ///< of a text; of other kinds, what stands there in the user's words
  double number = 0;      ///< of a number, whole or not
  std::vector<TomlNode> children = {};

  /// The entry of a table, or null.
  [[nodiscard]] const TomlNode* child(std::string_view name) const;
  /// The entry with a dotted key, such as "pad.thickness" or "support.points[3]", or the last one on the way.
  [[nodiscard]] const TomlNode& nearest(std::string_view dotted_key) const;
  /// The value as in the file, shortened to a line; "" for tables and arrays.
  [[nodiscard]] std::string written() const;
};

/// Throws InputError if the file cannot be read (input/text_file.hpp) or is not TOML.
TomlNode read_toml(const std::filesystem::path& file);

/// A value as a command line gives it: in TOML, or else a text without quotes, as 30 mm. Set by an option.
TomlNode toml_value(const std::string& value);

}  // namespace dashpad::input
