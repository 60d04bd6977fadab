#include "input/toml_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "dashpad/input/fault.hpp"
#include "input/disk.hpp"
#include "input/toml_parser.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {
namespace {

/// toml++ nests a table for each dot in a key, without limit; ten thousand overflow the stack.
constexpr std::ptrdiff_t max_dots = 64;

/// The end of the string that begins at `begin`; that of the line or text if it is not closed.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const bool has_escapes = quote == '"';
  const std::string fence(3, quote);
  const bool has_lines = text.substr(begin, 3) == fence;
  for (std::size_t at = begin + (has_lines ? 3 : 1); at < text.size(); ++at) {
    if (has_escapes && text[at] == '\\') {
      ++at;
    } else if (has_lines && text.substr(at, 3) == fence) {
      // Up to two more quotes belong to the string before the closing ones.
      at += 3;
      for (int extra = 0; extra < 2 && at < text.size() && text[at] == quote; ++extra) ++at;
      return at;
    } else if (!has_lines && text[at] == quote) {
      return at + 1;
    } else if (!has_lines && text[at] == '\n') {
      return at;
    }
  }
  return text.size();
}

/// The line of the first name with more dots, outside of strings and comments; 0 if there is none. Text is
/// divided as by toml++, up to its first error of syntax.
int line_of_overlong_name(std::string_view text) {
  std::ptrdiff_t dots = 0;
  std::size_t at = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = end_of_string(text, at);
      continue;
    }
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (c == '.' && ++dots > max_dots)
      return 1 + static_cast<int>(std::ranges::count(text.substr(0, at), '\n'));
    if (std::string_view("=,{\n").find(c) != std::string_view::npos) dots = 0;
    ++at;
  }
  return 0;
}

/// The columns of a region that begins in the line; up to its end if the region ends elsewhere.
TomlNode::Columns columns_of(const toml::source_region& region, int line) {
  if (static_cast<int>(region.begin.line) != line) return {};
  const bool ends_there = region.end.line == region.begin.line;
  return {region.begin.column, ends_there ? region.end.column : std::numeric_limits<std::size_t>::max()};
}

TomlNode convert(const toml::node& source, std::string key) {
  TomlNode node;
  node.line = static_cast<int>(source.source().begin.line);
  node.columns = columns_of(source.source(), node.line);
  node.key = std::move(key);
  if (const auto* table = source.as_table()) {
    node.kind = TomlNode::Kind::table;
    for (const auto& [name, value] : *table) {
      node.children.push_back(convert(value, std::string(name.str())));
      node.children.back().key_columns = columns_of(name.source(), node.children.back().line);
    }
    std::ranges::stable_sort(node.children, {}, &TomlNode::line);
  } else if (const auto* array = source.as_array()) {
    node.kind = TomlNode::Kind::array;
    for (const auto& value : *array)
      node.children.push_back(convert(value, fmt::format("[{}]", node.children.size() + 1)));
  } else if (const auto* text = source.as_string()) {
    node.kind = TomlNode::Kind::text;
    node.text = text->get();
  } else if (const auto* whole = source.as_integer()) {
    node.kind = TomlNode::Kind::number;
    node.number = static_cast<double>(whole->get());
    node.text = fmt::format("{}", whole->get());
  } else if (const auto* number = source.as_floating_point()) {
    node.kind = TomlNode::Kind::number;
    node.number = number->get();
    node.text = fmt::format("{}", node.number);
  } else {
    node.text = source.is_boolean() ? (source.value_or(false) ? "true" : "false") : "a date or time";
  }
  return node;
}

}  // namespace

const TomlNode* TomlNode::child(std::string_view name) const {
  const auto found = std::ranges::find(children, name, &TomlNode::key);
  return found != children.end() ? &*found : nullptr;
}

std::string_view take_key_part(std::string_view& key) {
  const std::string_view part = key.substr(0, key.find_first_of(".[", 1));
  key.remove_prefix(part.size());
  if (key.starts_with('.')) key.remove_prefix(1);
  return part;
}

const TomlNode& TomlNode::nearest(std::string_view dotted_key) const {
  const TomlNode* next = child(take_key_part(dotted_key));
  if (!next) return *this;
  return dotted_key.empty() ? *next : next->nearest(dotted_key);
}

std::string TomlNode::written() const {
  const std::string shown = quoted_part(text);
  return kind == Kind::text ? '"' + shown + '"' : shown;
}

TomlNode toml_value(const std::string& value) {
  TomlNode node{.kind = TomlNode::Kind::text, .text = value};
  if (value.find('\n') == std::string::npos && line_of_overlong_name(value) == 0)
    if (const toml::parse_result read = toml::parse("value = " + value); read && read.table().size() == 1)
      node = convert(*read.table().get("value"), "");  // else it is text
  const auto mark = [](TomlNode& toml_node, const auto& again) -> void {
    toml_node.line = set_by_option;
    for (TomlNode& child : toml_node.children) again(child, again);
  };
  mark(node, mark);
  return node;
}

Reading<TomlFile> read_toml_text(std::string name, std::string text) {
  const auto fault_in = [&](int line, TomlNode::Columns columns, std::string rule) {
    return std::vector{Fault{name, line, "", "", std::move(rule), excerpt_of(text, line, columns)}};
  };
  if (const int line = line_of_overlong_name(text))
    return fault_in(line, {}, fmt::format("a name has more than {} dots; text needs quotes", max_dots));
  const toml::parse_result read = toml::parse(text);
  if (!read) {
    const toml::parse_error& error = read.error();
    const int line = static_cast<int>(error.source().begin.line);
    return fault_in(line, columns_of(error.source(), line),
                    fmt::format("is not valid TOML: {}", error.description()));
  }
  TomlNode root = convert(read.table(), "");
  root.line = 0;  // a missing key at the top has no line
  return TomlFile{std::move(name), std::move(text), std::move(root)};
}

Reading<TomlFile> read_toml(const std::filesystem::path& file) {
  Reading<std::string> text = read_text_file(file);
  if (!text) return text.faults();
  return read_toml_text(file.string(), *std::move(text));
}

Excerpt excerpt_of(std::string_view text, int line, TomlNode::Columns columns) {
  if (line <= 0) return {};
  for (int before = 1; before < line; ++before) {
    const auto end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  text = text.substr(0, text.find('\n'));
  if (text.ends_with('\r')) text.remove_suffix(1);
  if (text.size() > longest_excerpt) return {};
  const auto byte_of = [&](std::size_t column) {
    std::size_t byte = 0;
    for (std::size_t at = 1; at < column && byte < text.size(); ++at)
      byte += std::max<std::size_t>(character_length(text.substr(byte)), 1);
    return byte;
  };
  const std::size_t begin = byte_of(columns.begin), end = byte_of(columns.end);
  return {std::string(text), begin, columns.begin > 0 && end > begin ? end - begin : 0};
}

}  // namespace dashpad::input
