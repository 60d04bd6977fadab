#include "quantities/text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/quantity.hpp"

namespace dashpad {

namespace {

/// Whether a number has that many digits before its point, but too few for an exponent.
bool is_long(double value, int digits) {
  return std::abs(value) >= std::pow(10.0, digits - 1) - 0.05 && std::abs(value) < 1e9;
}

/// The length in bytes of a UTF-8 character at the front of `text` that a terminal obeys instead of showing:
/// C1 controls, line separators, and changes of the writing direction. 0 if there is none.
std::size_t unseen(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0; };
  if (byte(0) == 0xc2 && byte(1) >= 0x80 && byte(1) < 0xa0) return 2;
  if (byte(0) != 0xe2) return 0;
  if (byte(1) == 0x80 && (byte(2) == 0x8e || byte(2) == 0x8f || (byte(2) >= 0xa8 && byte(2) <= 0xae)))
    return 3;
  return byte(1) == 0x81 && byte(2) >= 0xa6 && byte(2) <= 0xa9 ? 3 : 0;
}

/// The text without characters that a terminal obeys instead of showing them, except those in `kept`. Bytes
/// that are not UTF-8 become `odd`, or stay if that is empty.
std::string shown_text(std::string_view text, std::string_view kept, std::string_view odd) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = character_length(text), hidden = unseen(text);
    const auto byte = static_cast<unsigned char>(text.front());
    if (length == 0)
      shown += odd.empty() ? text.substr(0, 1) : odd;
    else if (hidden > 0 ||
             ((byte < 0x20 || byte == 0x7f) && kept.find(text.front()) == std::string_view::npos))
      shown += ' ';
    else
      shown += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>({length, hidden, 1}));
  }
  return shown;
}

}  // namespace

std::string significant(double value, int digits) {
  if (!std::isfinite(value)) return "none";
  if (value == 0) return "0";
  if (is_long(value, digits)) return fmt::format("{:.0f}", value);
  return fmt::format("{:#.{}g}", value, digits);
}

std::string brief(double value, int digits) {
  if (!std::isfinite(value)) return "none";
  return is_long(value, digits) ? fmt::format("{:.0f}", value) : fmt::format("{:.{}g}", value, digits);
}

std::string plain_number(double value) { return fmt::format("{:g}", rounded_to(value, 3)); }

ScaledUnit shown_as(const std::string& si_unit, const UnitSystem& units) {
  if (si_unit == "rad") return {180 / std::numbers::pi, "deg"};
  ScaledUnit shown = scaled_unit(si_unit, units);
  if (units.name == "us")
    for (const auto& [si, us] : {std::pair{"m2", "in2"}, {"kg/m2", "lb/ft2"}, {"kg/m3", "lb/ft3"}})
      if (si_unit == si) shown = {from_si(1, si, us), us};
  shown.unit = shown_unit(shown.unit);
  return shown;
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : number + " " + unit;
}

std::string brief_quantity(double value, const std::string& si_unit, const UnitSystem& units, int digits) {
  const ScaledUnit shown = shown_as(si_unit, units);
  return with_unit(brief(shown.scale * value, digits), shown.unit);
}

std::string percentage(double fraction) {
  if (!std::isfinite(fraction)) return "unknown";
  const double percent = rounded_to(100 * fraction, 2);
  return std::abs(percent) >= 100 && std::abs(percent) < 1e6 ? fmt::format("{:.0f} %", percent)
                                                             : fmt::format("{:.2g} %", percent);
}

std::string shown_unit(const std::string& unit) {
  if (unit == "1") return "";
  std::string shown;
  for (const char character : unit) shown += character == '.' ? "·" : std::string(1, character);
  return shown;
}

double rounded_to(double value, int digits) {
  // std::stod would report a number below 2.2e-308 as an error.
  return std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr);
}

std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0) != 0x80; }));
}

void replace_all(std::string& text, std::string_view old, std::string_view fresh) {
  for (auto place = text.find(old); place != std::string::npos; place = text.find(old, place + fresh.size()))
    text.replace(place, old.size(), fresh);
}

std::string plural(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string with_article(const std::string& words) {
  const bool vowel =
      !words.empty() && std::string_view("aeiou").find(words.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + words;
}

std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (text.empty()) return 0;
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const unsigned char second = byte(1);  // longer than needed, half of a pair, or beyond Unicode
  if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f)) return 0;
  if ((first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f)) return 0;
  return length;
}

std::string one_line(std::string_view text) { return shown_text(text, "", ""); }

std::string without_controls(std::string_view text) { return shown_text(text, "\n\t", "\xef\xbf\xbd"); }

std::string quoted_part(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return std::string(text.substr(0, end)) + "...";
}

std::string without_endless_words(std::string_view line) {
  constexpr std::size_t longest_word = 300, longest_line = 2000;
  std::string text;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    text += end > longest_word ? quoted_part(line.substr(0, end)) : std::string(line.substr(0, end));
    line.remove_prefix(end);
    if (!line.empty()) {
      text += ' ';
      line.remove_prefix(1);
    }
  }
  return quoted_part(text, longest_line);
}

std::string wrapped(std::string_view line, std::size_t indent) {
  constexpr std::size_t widest = 100;
  const std::string margin(indent, ' ');
  std::string text;
  std::string rest(line);
  while (width_of(rest) > widest) {
    const auto first_word = std::min(rest.find_first_not_of(' '), rest.size());
    auto blank = rest.rfind(' ', widest);  // bytes, of which no column has less than one
    if (blank == std::string::npos || blank <= first_word) blank = rest.find(' ', first_word);
    if (blank == std::string::npos) break;
    text.append(rest, 0, blank).append("\n");
    rest.replace(0, blank + 1, margin);
  }
  return text + rest;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = text;
  replace_all(quoted, "\"", "\"\"");
  return '"' + quoted + '"';
}

std::string fingerprint(const std::vector<std::string>& texts) {
  std::uint64_t hash = 14695981039346656037U;
  const auto add = [&hash](char c) { hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U; };
  for (const std::string& text : texts) {
    for (const char c : text) add(c);
    add('\0');
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace dashpad
