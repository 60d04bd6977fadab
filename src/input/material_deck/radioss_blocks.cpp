// Blocks of starter decks of Radioss: "/" in the first column begins a block, "#" a comment.

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "input/material_deck/include_statements.hpp"
#include "input/material_deck/radioss.hpp"

namespace dashpad::input {
namespace {

/// Whether blocks that begin so are kept.
bool is_wanted(const std::string& keyword) {
  constexpr std::array beginnings{"MAT/", "FUNCT", "MOVE_FUNCT", "UNIT/", "PARAMETER/GLOBAL/"};
  return keyword == "BEGIN" || std::ranges::any_of(beginnings, [&](const char* beginning) {
           return keyword.starts_with(beginning);
         });
}

/// Defines the parameter of a block; its lines hold a title, then a name in 10 columns and its value, which
/// may go on in the lines below if it is an expression.
void define_radioss_parameter(const DeckBlock& block, DeckParameters& parameters, MeasurementFaults& faults) {
  constexpr std::size_t width = 10;
  const std::vector<std::string> parts = parts_of(block);
  const std::string& type = parts[2];
  const bool is_expression = type == "REAL_EXPR" || type == "INT_EXPR";
  if ((type != "REAL" && type != "INTEGER" && !is_expression) || block.lines.size() < 2) return;
  const std::string_view line = block.lines[1].text;
  const std::string_view name = without_blanks(line.substr(0, width));
  std::string value(without_blanks(line.substr(std::min(width, line.size()))));
  for (std::size_t i = 2; i < block.lines.size() && is_expression; ++i)
    value += " " + std::string(without_blanks(block.lines[i].text));
  if (name.empty()) return;
  define_parameter({.name = name,
                    .value = value,
                    .line = block.lines[1].number,
                    .is_expression = is_expression,
                    .is_whole = type.starts_with("INT")},
                   parameters, parameters, faults);
}

void keep_radioss_block(DeckBlock block, const DeckText& text, RadiossBlocks& deck,
                        MeasurementFaults& faults) {
  const std::vector<std::string> parts = parts_of(block);
  const std::string& kind = parts.front();
  const long number = number_in(parts, 1);
  while (!block.lines.empty() && without_blanks(block.lines.back().text).empty()) block.lines.pop_back();
  if (kind == "MAT" && parts.size() > 2 && radioss_law(parts[1]) != nullptr) {
    if (deck.foams.size() == max_foams_of_deck)
      faults.refuse(block.head.number, "", "", fmt::format("has more than {} foams", max_foams_of_deck));
    deck.foams.push_back(std::move(block));
  } else if (kind == "MAT" && parts.size() > 2) {
    deck.out_of_reach.add_material("/MAT/" + parts[1]);
  } else if (kind == "BEGIN") {
    deck.begins.push_back(std::move(block));
  } else if (kind == "PARAMETER" && parts.size() > 2) {
    if (!text.is_repeated(text.place_of(block.head.number).file))
      define_radioss_parameter(block, *deck.parameters, faults);
  } else if (number == 0) {
    if (kind == "MOVE_FUNCT")
      faults.add(block.head.number, "/" + to_utf8(block.keyword), "",
                 "must have the number of a function, as in /MOVE_FUNCT/3");
  } else if (kind == "FUNCT") {
    deck.functions.add(number, std::move(block), text, faults);
  } else if (kind == "MOVE_FUNCT") {
    deck.moves[number].push_back(std::move(block));
  } else if (kind == "UNIT") {
    deck.units.add(number, std::move(block), text, faults);
  } else if (kind.starts_with("FUNCT")) {
    deck.other_functions.emplace(number, "/" + to_utf8(kind));
  }
}

/// A move of a function that is not there is a fault, unless the function may be where nothing is read.
void judge_moves(const RadiossBlocks& deck, MeasurementFaults& faults) {
  if (!deck.out_of_reach.include.empty()) return;
  for (const auto& [number, moves] : deck.moves)
    if (deck.functions.find(number) == nullptr && !deck.other_functions.contains(number))
      faults.add(moves.front().head.number, fmt::format("/MOVE_FUNCT/{}", number), "",
                 missing(fmt::format("/FUNCT/{}", number), deck.out_of_reach));
}

}  // namespace

const RadiossLaw* radioss_law(std::string_view name) {
  const auto* const found = std::ranges::find_if(
      radioss_laws, [&](const RadiossLaw& each) { return name == each.number || name == each.words; });
  return found == std::end(radioss_laws) ? nullptr : found;
}

std::vector<std::string> parts_of(const DeckBlock& block) { return split_at(block.keyword, '/'); }

long number_in(const std::vector<std::string>& parts, std::size_t place) {
  if (place >= parts.size()) return 0;
  const ReadNumber read = read_deck_number(parts[place], {});
  const bool is_number = read.kind == NumberKind::number && read.value > 0 && read.value < 1e10 &&
                         read.value == std::floor(read.value);
  return is_number ? static_cast<long>(read.value) : 0;
}

RadiossBlocks radioss_blocks(const DeckText& text, MeasurementFaults& faults) {
  RadiossBlocks deck;
  deck.parameters = std::make_unique<DeckParameters>(radioss_language);
  LineReader lines(text.text);
  DeckBlock block;
  bool wanted = false;
  const auto finish = [&] {
    if (wanted) keep_radioss_block(std::exchange(block, {}), text, deck, faults);
    wanted = false;
  };
  for (std::string_view line; lines.next(line);) {
    if (is_word(line, "#ENDDATA")) break;
    if (begins_with_word(line, "#INCLUDE")) deck.out_of_reach.include = "#include";
    if (line.starts_with('#') || line.starts_with('$')) continue;
    if (!line.starts_with('/')) {
      if (wanted) block.lines.push_back({lines.number(), line, deck.parameters.get()});
      continue;
    }
    finish();
    block.keyword = upper_case(without_blanks(line.substr(1, line.find_first_of(" \t") - 1)));
    block.head = {lines.number(), line};
    if (block.keyword == "END") break;
    wanted = is_wanted(block.keyword);
  }
  finish();
  judge_moves(deck, faults);
  return deck;
}

}  // namespace dashpad::input
