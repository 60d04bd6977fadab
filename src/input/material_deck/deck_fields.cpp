#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "input/material_deck/deck_foam.hpp"
#include "input/spelling.hpp"

namespace dashpad::input {
namespace {

constexpr double highest_number_of_anything = 2'147'483'647;

std::string rule_for_deck_number(NumberKind kind) {
  if (kind == NumberKind::not_finite) return "must be a finite number";
  if (kind == NumberKind::out_of_range) return "is too large or too small a number";
  return "is not a number";
}

/// "; *INCLUDE files are read only with --allow-includes": where something may be that was not found.
std::string elsewhere(const OutOfReach& why) {
  std::string text;
  if (!why.include.empty())
    text += fmt::format("; {} files are read only with --allow-includes", why.include);
  if (!why.other_include.empty()) text += fmt::format("; {} is not read", why.other_include);
  return text;
}

}  // namespace

Widths equal_widths(std::size_t count, bool long_format) { return Widths(count, long_format ? 20 : 10); }

DeckFields::DeckFields(const DeckLine& line, const Widths& widths, bool free, MeasurementFaults& faults)
    : line_(line), faults_(faults) {
  std::string_view rest = line.text;
  if (free && rest.find(',') != std::string_view::npos) {
    while (fields_.size() < widths.size()) {
      const auto comma = rest.find(',');
      fields_.push_back(without_blanks(rest.substr(0, comma)));
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
    return;
  }
  if (rest.find('\t') != std::string_view::npos)
    faults.add(line.number, "", "",
               "contains a tab, which makes its columns ambiguous; replace it with spaces");
  widths_ = widths;
  for (const std::size_t width : widths) {
    fields_.push_back(without_blanks(rest.substr(0, width)));
    rest.remove_prefix(std::min(width, rest.size()));
  }
}

std::string DeckFields::place_of(std::size_t field) const {
  if (widths_.empty()) return fmt::format("comma-separated field {}", field + 1);
  std::size_t first = 1;
  for (std::size_t i = 0; i < field; ++i) first += widths_[i];
  return fmt::format("columns {} to {}", first, first + widths_[field] - 1);
}

double DeckFields::number(std::size_t field, const std::string& key, const DeckUnit& unit) {
  const std::string_view written = text(field);
  if (line_.parameters != nullptr)
    if (const auto use = parameter_use(written, *line_.parameters)) {
      if (!use->rule.empty()) faults_.add(line_.number, key, to_utf8(written), use->rule);
      if (!use->rule.empty() || std::isnan(use->value)) return std::numeric_limits<double>::quiet_NaN();
      return read_deck_number(fmt::format("{}", use->value), unit).value;
    }
  const ReadNumber read = read_deck_number(written, unit);
  if (read.kind == NumberKind::number) return read.value;
  if (read.kind == NumberKind::empty) return 0;
  faults_.add(line_.number, key, to_utf8(written),
              rule_for_deck_number(read.kind) + " (" + place_of(field) + ")");
  return std::numeric_limits<double>::quiet_NaN();
}

std::optional<long> DeckFields::whole(std::size_t field, const std::string& key) {
  const double value = number(field, key);
  if (std::isnan(value)) return std::nullopt;
  if (value != std::floor(value) || std::abs(value) > highest_number_of_anything) {
    faults_.add(line_.number, key, to_utf8(text(field)), "must be a whole number (" + place_of(field) + ")");
    return std::nullopt;
  }
  return static_cast<long>(value);
}

void NumberedBlocks::add(long id, DeckBlock block, const DeckText& deck, MeasurementFaults& faults) {
  const auto found = blocks_.find(id);
  if (found != blocks_.end()) {
    const std::size_t first = found->second.head.number;
    const DeckPlace here = deck.place_of(block.head.number);
    const bool is_of_repeated = deck.is_repeated(here.file) && here.line == deck.place_of(first).line;
    if (is_of_repeated && !told_files_.insert(here.file).second) return;
    faults.add(block.head.number, fmt::format("{} {}", kind_, id), "",
               is_of_repeated
                   ? fmt::format("is defined twice because {} is included twice", deck.name_of(here.file))
                   : "is defined twice, first on " + deck.words_for(first));
    return;
  }
  blocks_.emplace(id, std::move(block));
}

const DeckBlock* NumberedBlocks::find(long id) const {
  const auto found = blocks_.find(id);
  return found == blocks_.end() ? nullptr : &found->second;
}

const DeckBlock* NumberedBlocks::at_place(std::size_t place) const {
  const auto found =
      std::ranges::find_if(blocks_, [&](const auto& block) { return block.second.place == place; });
  return found == blocks_.end() ? nullptr : &found->second;
}

void tell_if_set(double value, const DeckField& field, DeckFoam& foam) {
  constexpr double no_cut_off = 1e19;  // a larger tension cut-off is none
  if (value == value && value != 0 && std::abs(value) < no_cut_off)
    foam.differences.push_back(fmt::format("{} = {:g}: {}.", field.name, value, field.lost));
}

double or_one(double given, const char* name, DeckFoam& foam, const char* consequence) {
  if (given != 0) return given;
  foam.assumptions.push_back(fmt::format("{} is blank or 0{}.", name, consequence));
  return 1;
}

void tell_of_exponent(double exponent, const char* name, DeckFoam& foam) {
  if (exponent == exponent && exponent != 0 && exponent != 1)
    foam.differences.push_back(
        fmt::format("{} = {:g}: the unloading exponent in Dashpad is 1, so the foam dissipates a "
                    "different fraction of the work.",
                    name, exponent));
}

std::vector<std::string> split_at(std::string_view text, char separator) {
  std::vector<std::string> parts{""};
  for (const char c : text)
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

std::string unquoted(std::string_view text) {
  text = without_blanks(text);
  if (text.starts_with('"') || text.starts_with('\'')) text = text.substr(1, text.find(text.front(), 1) - 1);
  return std::string(text);
}

void OutOfReach::add_material(const std::string& keyword) {
  constexpr std::size_t most = 10;
  const std::string shown = to_utf8(keyword);
  if (other_materials.size() < most && std::ranges::find(other_materials, shown) == other_materials.end())
    other_materials.push_back(shown);
}

std::string missing(const std::string& block, const OutOfReach& why) {
  if (!why.encrypted.empty())
    return fmt::format("part of the deck is encrypted, from {} on, so {} cannot be read", why.encrypted,
                       block);
  return fmt::format("there is no {}{}", block, elsewhere(why));
}

std::string contains_no(const char* materials, const OutOfReach& why) {
  std::string text = fmt::format("contains no {}", materials);
  if (!why.other_materials.empty()) text += "; it contains " + listing(why.other_materials);
  if (!why.encrypted.empty()) text += fmt::format("; part of it is encrypted, from {} on", why.encrypted);
  return text + elsewhere(why);
}

}  // namespace dashpad::input
