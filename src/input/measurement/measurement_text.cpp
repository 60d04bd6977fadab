#include "input/measurement/measurement_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "input/disk.hpp"
#include "quantities/from_chars.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

constexpr std::size_t longest_number = 100;

/// The line, with the value or else the key of the fault marked.
Excerpt excerpt_in(std::string_view line, const Fault& fault) {
  const std::string& meant = fault.value.empty() ? fault.key : fault.value;
  const auto begin = meant.empty() ? std::string_view::npos : line.find(meant);
  if (begin == std::string_view::npos) return {std::string(line)};
  return {std::string(line), begin, meant.size()};
}

}  // namespace

void MeasurementFaults::add(std::size_t line, std::string key, std::string_view value, std::string rule) {
  faults_.push_back({file_, static_cast<int>(line), std::move(key), quoted_part(value), std::move(rule)});
  if (faults_.size() == max_measurement_faults) {
    faults_.back().rule += fmt::format("; reading stopped here, after {} errors", max_measurement_faults);
    throw_all();
  }
}

std::vector<Fault> MeasurementFaults::split_off(std::size_t first) {
  const auto begin = faults_.begin() + static_cast<std::ptrdiff_t>(first);
  std::vector<Fault> later(std::make_move_iterator(begin), std::make_move_iterator(faults_.end()));
  faults_.erase(begin, faults_.end());
  return later;
}

void MeasurementFaults::add(std::vector<Fault> faults) {
  for (Fault& fault : faults)
    add(static_cast<std::size_t>(fault.line), std::move(fault.key), fault.value, std::move(fault.rule));
}

void MeasurementFaults::refuse(std::size_t line, std::string key, std::string_view value, std::string rule) {
  add(line, std::move(key), value, std::move(rule));
  throw_all();
}

void MeasurementFaults::throw_all() const {
  std::vector<Fault> faults = faults_;
  int last = 0;
  for (const Fault& fault : faults) last = std::max(last, fault.line);
  LineReader lines(text_);
  for (std::string_view line; lines.number() < static_cast<std::size_t>(last) && lines.next(line);)
    for (Fault& fault : faults)
      if (static_cast<std::size_t>(fault.line) == lines.number() && line.size() <= longest_excerpt)
        fault.excerpt = excerpt_in(line, fault);
  throw InputError(std::move(faults));
}

std::string_view text_in(std::string_view content, MeasurementFaults& faults) {
  if (content.starts_with("\xff\xfe") || content.starts_with("\xfe\xff"))
    faults.refuse(1, "", "", "is UTF-16; save it as UTF-8");
  const auto is_binary = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f' && c != '\x1a';
  };
  const auto found = std::ranges::find_if(content, is_binary);
  if (found == content.end()) {
    faults.are_in(without_mark(content));
    return without_mark(content);
  }
  const auto line = static_cast<std::size_t>(std::count(content.begin(), found, '\n')) + 1;
  faults.refuse(line, "", "",
                fmt::format("is not text: it contains the byte {}", static_cast<unsigned char>(*found)));
}

bool LineReader::next(std::string_view& line) {
  if (rest_.empty()) return false;
  ++number_;
  const char* const begin = rest_.data();
  const char* const text_end = begin + rest_.size();
  if (line_feed_ == nullptr || line_feed_ < begin) {  // searched once per line feed, not per line
    const auto* const found = static_cast<const char*>(std::memchr(begin, '\n', rest_.size()));
    line_feed_ = found == nullptr ? text_end : found;
  }
  const auto size_to_line_feed = static_cast<std::size_t>(line_feed_ - begin);
  const auto* const cr = static_cast<const char*>(std::memchr(begin, '\r', size_to_line_feed));
  const char* const end = cr == nullptr ? line_feed_ : cr;
  const bool is_cr_lf = cr != nullptr && cr + 1 == line_feed_ && line_feed_ != text_end;
  if (is_cr_lf)
    cr_lf_ = true;
  else if (end != text_end)
    (cr != nullptr ? cr_ : lf_) = true;
  line = {begin, static_cast<std::size_t>(end - begin)};
  const auto taken = line.size() + (is_cr_lf ? 2 : end == text_end ? 0 : 1);
  rest_.remove_prefix(taken);
  return true;
}

std::string_view without_blanks(std::string_view text) {
  if (!text.empty() && text.front() > ' ' && text.back() > ' ') return text;  // most fields
  constexpr std::string_view blanks = " \t\f\x1a";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string to_utf8(std::string_view text) {
  if (is_utf8(text)) return std::string(text);
  std::string converted;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80) converted += static_cast<char>(0xc0 | (byte >> 6));
    converted += static_cast<char>(byte < 0x80 ? byte : 0x80 | (byte & 0x3f));
  }
  return converted;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

std::string upper_case(std::string_view text) {
  std::string upper(text);
  for (char& c : upper)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return upper;
}

ReadNumber read_number(std::string_view text, char decimal) {
  text = without_blanks(text);
  if (text.empty()) return {};
  if (text.size() > longest_number) return {NumberKind::text};
  std::array<char, longest_number> with_point{};
  if (decimal != '.') {
    if (text.find('.') != std::string_view::npos) return {NumberKind::text};
    std::ranges::replace_copy(text, with_point.begin(), decimal, '.');
    text = {with_point.data(), text.size()};
  }
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || end != text.data() + text.size()) return {NumberKind::text};
  if (error == std::errc::result_out_of_range) return {NumberKind::out_of_range};
  return std::isfinite(value) ? ReadNumber{NumberKind::number, value} : ReadNumber{NumberKind::not_finite};
}

std::string rule_for(NumberKind kind) {
  switch (kind) {
    case NumberKind::number: break;
    case NumberKind::not_finite: return "must be a finite number";
    case NumberKind::out_of_range: return "is too large or too small to compute with";
    case NumberKind::text: return "must be a number";
    case NumberKind::empty: return "is missing; gaps are not allowed";
  }
  return "";
}

}  // namespace dashpad::input
