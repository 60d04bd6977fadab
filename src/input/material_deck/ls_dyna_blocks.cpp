// *KEYWORD input of LS-DYNA as blocks: "*" in the first column begins a keyword, "$" a comment.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "input/material_deck/deck_blocks.hpp"

namespace dashpad::input {

namespace {

constexpr std::array<std::string_view, 8> names_of_foams{
    "057", "LOW_DENSITY_FOAM", "063", "CRUSHABLE_FOAM",
    "083", "FU_CHANG_FOAM",    "163", "MODIFIED_CRUSHABLE_FOAM"};
constexpr std::size_t most_materials_listed = 10;

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  for (char& c : capitals)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return capitals;
}

/// "*MAT_057_TITLE +": the keyword, and whether its fields are long.
DeckBlock begun_block(const DeckLine& line, bool all_long) {
  DeckBlock block;
  block.head = line;
  block.long_format = all_long;
  std::string text = in_capitals(line.text.substr(1));
  const auto end = text.find_first_of(" \t,");
  std::string options = end == std::string::npos ? "" : text.substr(end);
  block.keyword = text.substr(0, end);
  if (block.keyword.ends_with('+') || block.keyword.ends_with('-')) {
    options += block.keyword.back();
    block.keyword.pop_back();
  }
  if (options.find('+') != std::string::npos) block.long_format = true;
  if (options.find('-') != std::string::npos) block.long_format = false;
  return block;
}

bool is_foam(const std::string& keyword) {
  return keyword.starts_with("MAT_") && std::ranges::any_of(names_of_foams, [&](std::string_view name) {
           const std::string_view rest = std::string_view(keyword).substr(4);
           return rest.starts_with(name) && (rest.size() == name.size() || rest[name.size()] == '_');
         });
}

bool says_long(const std::string& head) {
  const std::string text = in_capitals(head);
  const auto at = text.find("LONG=");
  return at != std::string::npos && text.substr(at + 5, 1) != "S";
}

/// The number in the first field; absent where there is none. Curves that no foam asks for may be anything.
std::optional<long> number_of_block(const DeckBlock& block) {
  const std::vector<DeckLine> lines = lines_behind_title(block);
  if (lines.empty()) return std::nullopt;
  const std::string_view line = lines.front().text;
  const auto comma = line.find(',');
  const std::size_t width = comma != std::string_view::npos ? comma : block.long_format ? 20 : 10;
  const ReadNumber read = read_deck_number(line.substr(0, width), {});
  if (read.kind != NumberKind::number || !(std::abs(read.value) < 1e10)) return std::nullopt;
  return static_cast<long>(read.value);
}

}  // namespace

void NumberedBlocks::add(long id, DeckBlock block, MeasurementFaults& faults) {
  const auto found = blocks_.find(id);
  if (found != blocks_.end()) {
    faults.add(block.head.number, fmt::format("{} {}", kind_, id), "",
               fmt::format("stands twice; first in line {}", found->second.head.number));
    return;
  }
  places_.emplace(block.place, id);
  blocks_.emplace(id, std::move(block));
}

const DeckBlock* NumberedBlocks::find(long id) const {
  const auto found = blocks_.find(id);
  return found == blocks_.end() ? nullptr : &found->second;
}

const DeckBlock* NumberedBlocks::at_place(std::size_t place) const {
  const auto found = places_.find(place);
  return found == places_.end() ? nullptr : find(found->second);
}

std::vector<DeckLine> lines_behind_title(const DeckBlock& block) {
  const bool has_title = block.keyword.find("_TITLE") != std::string::npos && !block.lines.empty();
  return {block.lines.begin() + (has_title ? 1 : 0), block.lines.end()};
}

std::string title_of(const DeckBlock& block) {
  if (block.keyword.find("_TITLE") == std::string::npos || block.lines.empty()) return "";
  return to_utf8(without_blanks(block.lines.front().text.substr(0, 80)));
}

std::string keyword_of(const DeckBlock& block) {
  std::string keyword = block.keyword;
  if (const auto at = keyword.find("_TITLE"); at != std::string::npos) keyword.erase(at, 6);
  return keyword;
}

LsDynaBlocks ls_dyna_blocks(std::string_view text, MeasurementFaults& faults) {
  LsDynaBlocks deck;
  LineReader lines(text);
  std::string_view line;
  std::size_t place = 0;
  bool all_long = false, more = lines.next(line);
  while (more) {
    if (!line.starts_with('*')) {
      more = lines.next(line);
      continue;
    }
    DeckBlock block = begun_block({lines.number(), line}, all_long);
    block.place = place++;
    const std::string keyword = keyword_of(block);
    if (keyword == "END") break;
    if (keyword == "KEYWORD" && says_long(std::string(line))) all_long = true;
    const bool foam = is_foam(keyword);
    const bool curve = keyword == "DEFINE_CURVE";
    const bool table = keyword == "DEFINE_TABLE" || keyword == "DEFINE_TABLE_2D";
    while ((more = lines.next(line)) && !line.starts_with('*'))
      if ((foam || curve || table) && !line.starts_with('$')) block.lines.push_back({lines.number(), line});
    while (!block.lines.empty() && without_blanks(block.lines.back().text).empty() && !foam)
      block.lines.pop_back();
    if (foam) {
      if (deck.foams.size() == most_foams_of_deck)
        faults.refuse(block.head.number, "", "", fmt::format("more than {} foams", most_foams_of_deck));
      deck.foams.push_back(std::move(block));
    } else if (keyword.starts_with("MAT_") && deck.other_materials.size() < most_materials_listed)
      deck.other_materials.push_back("*" + to_utf8(keyword));
    else if (keyword.starts_with("INCLUDE"))
      deck.includes_files = true;
    if (!curve && !table) continue;
    if (const auto id = number_of_block(block))
      (curve ? deck.curves : deck.tables).add(*id, std::move(block), faults);
  }
  return deck;
}

}  // namespace dashpad::input
