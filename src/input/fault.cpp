#include "dashpad/input/fault.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

constexpr std::size_t longest_key = 120, longest_value = 70;  // bytes that are quoted
constexpr std::size_t most_of_a_kind = 5;
constexpr std::size_t max_lines = 200;  // of a message

/// The first line without its value, with # for every number.
std::string kind_of(std::string_view line) {
  line = line.substr(0, line.find('\n'));
  std::string kind;
  const auto value = line.find(" = "), rule = line.rfind(": ");
  if (value < rule && rule != std::string_view::npos) {
    kind = line.substr(0, value);
    line.remove_prefix(rule);
  }
  kind += line;
  std::string numberless;
  for (const char c : kind) {
    const bool is_digit = (c >= '0' && c <= '9') || (c == '.' && numberless.ends_with('#'));
    if (!is_digit) numberless += c;
    if (is_digit && !numberless.ends_with('#')) numberless += '#';
  }
  return numberless;
}

std::string message(const std::vector<Fault>& faults) {
  std::vector<std::string> lines;
  std::ranges::transform(faults, std::back_inserter(lines),
                         [](const Fault& fault) { return to_string(fault); });
  lines = abridged(lines);
  if (lines.size() > max_lines) {
    lines.resize(max_lines);
    lines.emplace_back("...");
  }
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

/// The number of characters shown of a line, and before the marked part of a longer one.
constexpr std::size_t widest = 90, max_before = 30;

/// Up to `count` characters of a text, from number `first` on.
std::string_view characters(std::string_view text, std::size_t first, std::size_t count) {
  const auto without = [](std::string_view rest, std::size_t so_many) {
    for (; so_many > 0 && !rest.empty(); --so_many)
      rest.remove_prefix(std::max<std::size_t>(character_length(rest), 1));
    return rest;
  };
  const std::string_view from = without(text, first);
  return from.substr(0, from.size() - without(from, count).size());
}

}  // namespace

std::string to_string(const Fault& fault) {
  std::string line = fault.file;
  if (fault.line > 0) line += fmt::format(":{}", fault.line);
  std::string what;
  if (!fault.key.empty()) what += ": " + quoted_part(fault.key, longest_key);
  if (!fault.value.empty()) what += " = " + quoted_part(fault.value, longest_value);
  return one_line(line + without_endless_words(what + ": " + fault.rule));
}

std::vector<std::string> abridged(const std::vector<std::string>& lines) {
  std::vector<std::string> kinds;
  std::ranges::transform(lines, std::back_inserter(kinds), kind_of);
  std::map<std::string_view, std::size_t> all_of;
  for (const std::string& kind : kinds) ++all_of[kind];
  std::map<std::string_view, std::size_t> shown;
  std::vector<std::string> text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t count = ++shown[kinds[i]];
    if (count <= most_of_a_kind) text.push_back(lines[i]);
    if (count == most_of_a_kind && all_of[kinds[i]] > most_of_a_kind)
      text.push_back(fmt::format("and {} more of this kind", all_of[kinds[i]] - most_of_a_kind));
  }
  return text;
}

InputError::InputError(std::vector<Fault> faults)
    : std::runtime_error(message(faults)), faults_(std::move(faults)) {}

std::vector<Fault> fault_of_file(const std::filesystem::path& file, const std::string& rule, int line) {
  return {Fault{file.string(), line, "", "", rule}};
}

[[noreturn]] void refuse_file(const std::filesystem::path& file, const std::string& rule, int line) {
  throw InputError(fault_of_file(file, rule, line));
}

std::string with_excerpt(const Fault& fault) {
  std::string text = to_string(fault);
  const std::string_view line = fault.excerpt.line;
  if (line.find_first_not_of(" \t\r") == std::string_view::npos || fault.excerpt.begin > line.size())
    return text;
  const std::string shown = one_line(line);
  const std::size_t begin = width_of(one_line(line.substr(0, fault.excerpt.begin)));
  const std::size_t length = width_of(one_line(line.substr(fault.excerpt.begin, fault.excerpt.length)));
  const std::size_t left_out = begin + length > widest ? begin - std::min(begin, max_before) : 0;
  const std::string_view dots = "...", before = left_out > 0 ? dots : "";
  const std::string_view after = width_of(shown) > left_out + widest ? dots : "";
  const std::string number = fmt::format("{}", fault.line);
  text += fmt::format("\n  {} | {}{}{}", number, before, characters(shown, left_out, widest), after);
  if (length == 0) return text;
  const std::size_t blanks = before.size() + begin - left_out;
  const std::size_t marks = std::min(length, widest - (begin - left_out));
  return text + fmt::format("\n  {:{}} | {:{}}{:^<{}}", "", number.size(), "", blanks, "", marks);
}

}  // namespace dashpad::input
