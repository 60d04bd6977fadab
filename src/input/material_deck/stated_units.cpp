#include "input/material_deck/stated_units.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/quantity.hpp"

namespace dashpad::input {
namespace {

using Sizes = std::array<double, 3>;  // of the units of mass, length and time, SI
constexpr std::array<const char*, 3> si_units{"kg", "m", "s"};

/// A unit in SI: a number, or a name, in which Radioss writes mu for micro; 0 if it is neither.
double size_of_unit(std::string_view text, const char* si_unit) {
  const ReadNumber number = read_deck_number(text, {});
  if (number.kind == NumberKind::number) return number.value;
  const std::string name = text.starts_with("mu") ? "u" + std::string(text.substr(2)) : std::string(text);
  return read_si("1 " + name, si_unit).value;
}

bool are_of(const UnitSystem& system, const Sizes& sizes) {
  const std::array<const std::string*, 3> units{&system.mass, &system.length, &system.time};
  for (std::size_t i = 0; i < units.size(); ++i)
    if (!(std::abs(sizes[i] / to_si("1 " + *units[i], si_units[i]) - 1) < 1e-6)) return false;
  return true;
}

/// The units with these words and sizes, of which a size of 0 is unknown.
StatedUnits units_of_sizes(std::size_t line, const std::array<std::string, 3>& words, const Sizes& sizes) {
  constexpr std::array<const char*, 3> quantities{"mass", "length", "time"};
  StatedUnits result{line, to_utf8(fmt::format("{}, {}, {}", words[0], words[1], words[2]))};
  for (std::size_t i = 0; i < sizes.size() && result.unknown.empty(); ++i)
    if (!(sizes[i] > 0))
      result.unknown = fmt::format("{} is not a unit of {} that is known", to_utf8(words[i]), quantities[i]);
  if (!result.unknown.empty()) return result;
  for (const UnitSystem& system : consistent_systems())
    if (are_of(system, sizes)) result.system = &system;
  return result;
}

bool are_same(const StatedUnits& one, const StatedUnits& other) {
  return one.system == other.system && (one.system != nullptr || one.words == other.words);
}

std::string names_of_systems() {
  std::string names;
  for (const UnitSystem& system : consistent_systems()) names += (names.empty() ? "" : ", ") + system.name;
  return names;
}

}  // namespace

StatedUnits stated_units(std::size_t line, const std::array<std::string_view, 3>& units) {
  Sizes sizes{};
  for (std::size_t i = 0; i < sizes.size(); ++i) sizes[i] = size_of_unit(units[i], si_units[i]);
  const bool is_unset =
      std::ranges::all_of(units, [](std::string_view unit) { return read_deck_number(unit, {}).value == 1; });
  if (is_unset || std::ranges::any_of(units, [](std::string_view unit) { return unit.empty(); })) return {};
  return units_of_sizes(line, {std::string(units[0]), std::string(units[1]), std::string(units[2])}, sizes);
}

StatedUnits units_by_words(std::size_t line, const std::array<std::string_view, 3>& words) {
  constexpr std::array<std::pair<std::string_view, const char*>, 3> other_names{
      {{"micro_s", "us"}, {"mtrc_ton", "t"}, {"slinch", "lbf.s2/in"}}};
  if (std::ranges::all_of(words, [](std::string_view word) { return word.empty(); })) return {};
  Sizes sizes{};
  std::array<std::string, 3> shown;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const std::string& word = shown[i] = words[i].empty() ? si_units[i] : lower_case(words[i]);
    const auto other = std::ranges::find(other_names, word, &decltype(other_names)::value_type::first);
    sizes[i] = size_of_unit(other == other_names.end() ? word : other->second, si_units[i]);
  }
  return units_of_sizes(line, shown, sizes);
}

std::string UnitChoice::rule_for(const StatedUnits& stated) const {
  if (stated.line == 0) return "is required, as in --units t-mm-s; the deck does not state its units";
  if (!stated.unknown.empty()) return stated.unknown + "; give the units, as in --units t-mm-s";
  if (given_ && stated.system)
    return fmt::format("are those of {}, but --units is {}; leave out --units to use what the deck states",
                       stated.system->name, given_->name);
  if (given_) return fmt::format("are not those of --units {}", given_->name);
  return fmt::format("are those of no system that can be read: {}", names_of_systems());
}

std::optional<StatedUnits> UnitChoice::agreed(const std::vector<StatedUnits>& statements) {
  StatedUnits first;
  for (const StatedUnits& each : statements) {
    if (first.line == 0) first = each;
    if (each.line == 0 || are_same(first, each)) continue;
    if (told_.insert(each.line).second)
      faults_.add(each.line, "units", each.words,
                  fmt::format("contradict {} on {}", first.words, deck_.words_for(first.line)));
    return std::nullopt;
  }
  return first;
}

std::optional<ChosenUnits> UnitChoice::for_numbers(const StatedUnits& stated) {
  const bool is_stated = stated.line > 0;
  if (given_ &&
      (!is_stated || !stated.unknown.empty() || (stated.system && stated.system->name == given_->name)))
    return ChosenUnits{DeckUnits(*given_), given_->name};
  if (!given_ && stated.system)
    return ChosenUnits{
        DeckUnits(*stated.system),
        fmt::format("{}, as the deck states on {}", stated.system->name, deck_.words_for(stated.line))};
  if (told_.insert(stated.line).second)
    faults_.add(stated.line, is_stated ? "units" : "--units", stated.words, rule_for(stated));
  return std::nullopt;
}

}  // namespace dashpad::input
