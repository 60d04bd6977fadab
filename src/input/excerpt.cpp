#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "dashpad/input/fault.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {
namespace {

/// Characters of a line that are shown, and of those before what is meant where the line is longer.
constexpr std::size_t widest = 90, most_before = 30;

/// So many characters of a text from the one with that number on, or what there is.
std::string_view characters(std::string_view text, std::size_t first, std::size_t count) {
  const auto without = [](std::string_view of, std::size_t so_many) {
    for (; so_many > 0 && !of.empty(); --so_many)
      of.remove_prefix(std::max<std::size_t>(character_length(of), 1));
    return of;
  };
  const std::string_view from = without(text, first);
  return from.substr(0, from.size() - without(from, count).size());
}

}  // namespace

std::string with_excerpt(const Fault& fault) {
  std::string text = to_string(fault);
  const std::string_view line = fault.excerpt.line;
  if (line.find_first_not_of(" \t\r") == std::string_view::npos || fault.excerpt.begin > line.size())
    return text;
  const std::string shown = one_line(line);
  const std::size_t begin = width_of(one_line(line.substr(0, fault.excerpt.begin)));
  const std::size_t length = width_of(one_line(line.substr(fault.excerpt.begin, fault.excerpt.length)));
  const std::size_t left_out = begin + length > widest ? begin - std::min(begin, most_before) : 0;
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
