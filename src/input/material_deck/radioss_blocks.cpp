// A Radioss starter deck as blocks: "/" in the first column begins a block, "#" a comment.

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "input/material_deck/radioss.hpp"

namespace dashpad::input {

namespace {

constexpr std::size_t most_laws_listed = 10;

std::string keyword_in_capitals(std::string_view line) {
  return upper_case(without_blanks(line.substr(1, line.find_first_of(" \t") - 1)));
}

/// Sorts a block in.
void take(DeckBlock block, RadiossBlocks& deck, MeasurementFaults& faults) {
  const std::vector<std::string> parts = parts_of(block.keyword);
  while (!block.lines.empty() && without_blanks(block.lines.back().text).empty()) block.lines.pop_back();
  const bool material = parts.size() > 2 && parts[0] == "MAT";
  if (material && radioss_law(parts[1]) != nullptr) {
    if (deck.foams.size() == most_foams_of_deck)
      faults.refuse(block.head.number, "", "", fmt::format("more than {} foams", most_foams_of_deck));
    deck.foams.push_back(std::move(block));
  } else if (material) {
    if (deck.other_materials.size() < most_laws_listed)
      deck.other_materials.push_back(to_utf8("/MAT/" + parts[1]));
  } else if (parts[0] == "FUNCT" && number_in(parts, 1) != 0) {
    deck.functions.add(number_in(parts, 1), std::move(block), faults);
  } else if (parts[0] == "UNIT" && number_in(parts, 1) != 0) {
    deck.units.add(number_in(parts, 1), std::move(block), faults);
  } else if (parts[0] == "BEGIN" && !deck.begin) {
    deck.begin = std::move(block);
  }
}

}  // namespace

const RadiossLaw* radioss_law(std::string_view name) {
  const auto* const found = std::ranges::find_if(
      radioss_laws, [&](const RadiossLaw& each) { return name == each.number || name == each.words; });
  return found == std::end(radioss_laws) ? nullptr : found;
}

std::vector<std::string> parts_of(const std::string& keyword) {
  std::vector<std::string> parts{""};
  for (const char c : keyword)
    if (c == '/')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

long number_in(const std::vector<std::string>& parts, std::size_t place) {
  if (place >= parts.size()) return 0;
  const ReadNumber read = read_deck_number(parts[place], {});
  const bool is_number = read.kind == NumberKind::number && read.value > 0 && read.value < 1e10;
  return is_number ? static_cast<long>(read.value) : 0;
}

RadiossBlocks radioss_blocks(std::string_view text, MeasurementFaults& faults) {
  RadiossBlocks deck;
  LineReader lines(text);
  std::string_view line;
  DeckBlock block;
  bool wanted = false;  // only what is needed is kept
  const auto finish = [&] {
    if (wanted) take(std::exchange(block, {}), deck, faults);
    wanted = false;
  };
  while (lines.next(line)) {
    if (line.starts_with("#include")) deck.includes_files = true;
    if (line.starts_with('#') || line.starts_with('$')) continue;
    if (!line.starts_with('/')) {
      if (wanted) block.lines.push_back({lines.number(), line});
      continue;
    }
    finish();
    block.keyword = keyword_in_capitals(line);
    block.head = {lines.number(), line};
    if (block.keyword == "END") break;
    wanted = block.keyword.starts_with("MAT/") || block.keyword.starts_with("FUNCT/") ||
             block.keyword.starts_with("UNIT/") || block.keyword == "BEGIN";
  }
  finish();
  return deck;
}

}  // namespace dashpad::input
