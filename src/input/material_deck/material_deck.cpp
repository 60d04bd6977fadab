#include "dashpad/input/material_deck.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "input/material_deck/abaqus.hpp"
#include "input/material_deck/deck_foam.hpp"
#include "input/material_deck/include_statements.hpp"

namespace dashpad::input {
namespace {

enum class Solver { abaqus, ls_dyna, radioss, unknown };

/// Decides by the first line that begins a keyword.
Solver solver_of(std::string_view text) {
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    if (line.starts_with('*') || begins_abaqus_keyword(line))
      return is_abaqus(text) ? Solver::abaqus : Solver::ls_dyna;
    if (line.starts_with('/') || begins_with_word(line, "#INCLUDE")) return Solver::radioss;
  }
  return Solver::unknown;
}

std::vector<DeckFoam> foams_in(const DeckText& deck, const std::optional<UnitSystem>& units,
                               MeasurementFaults& faults) {
  const Solver solver = solver_of(deck.text);
  if (solver == Solver::unknown)
    faults.refuse(0, "", "", "is not a deck: no line begins with * (LS-DYNA, Abaqus) or / (Radioss)");
  UnitChoice choice(units, deck, faults);
  if (solver == Solver::abaqus) return read_abaqus(deck, choice, faults);
  return solver == Solver::ls_dyna ? read_ls_dyna(deck, choice, faults) : read_radioss(deck, choice, faults);
}

/// The units that a system is named after, in alphabetical order.
std::vector<std::string> sorted_units(std::string_view name) {
  std::vector<std::string> units = split_at(name, '-');
  std::ranges::sort(units);
  return units;
}

/// Makes the names of cards unique.
void make_names_differ(std::vector<DeckMaterial>& materials) {
  std::map<std::string, int> count;
  for (const DeckMaterial& each : materials) ++count[each.material.name];
  std::map<std::string, int> taken;
  for (DeckMaterial& each : materials) {
    std::string& name = each.material.name;
    if (count[name] > 1) name += fmt::format("-{}", each.id);
    const std::string numbered = name;
    for (int i = 2; taken[name]++ > 0; ++i) name = fmt::format("{}-{}", numbered, i);
  }
}

}  // namespace

const UnitSystem& deck_system(std::string_view name) {
  for (const UnitSystem& system : consistent_systems())
    if (sorted_units(name) == sorted_units(system.name)) return system;
  return consistent_system(name);
}

Reading<std::vector<DeckMaterial>> read_material_deck(const std::filesystem::path& file,
                                                      const std::optional<UnitSystem>& units,
                                                      Includes includes) {
  DeckText deck = without_includes(file, "");
  auto read = reading_of([&]() -> std::vector<DeckMaterial> {
    MeasurementFaults faults(file.string());
    const std::string content = read_measurement(file, largest_deck);
    const std::string_view text = text_in(content, faults);
    if (without_blanks(text).empty()) faults.refuse(0, "", "", "is empty");
    std::vector<Fault> of_includes;
    deck =
        includes == Includes::allowed ? with_includes(file, text, of_includes) : without_includes(file, text);
    faults.are_in(deck.text);
    faults.add(std::move(of_includes));
    faults.throw_if_any();
    std::vector<DeckFoam> foams = foams_in(deck, units, faults);
    std::vector<DeckMaterial> materials;
    for (DeckFoam& foam : foams) {
      const DeckPlace place = deck.place_of(foam.line);
      foam.source = fmt::format("{} {} from the deck {} (line {}; units {})", foam.card, foam.id,
                                to_utf8(deck.files[place.file].filename().string()), place.line, foam.units);
      auto material = material_of(foam, faults);
      if (!material) continue;
      material->line = static_cast<int>(place.line);
      materials.push_back(*std::move(material));
    }
    faults.throw_if_any();
    make_names_differ(materials);
    return materials;
  });
  if (read) return read;
  std::vector<Fault> faults = read.faults();
  deck.place(faults);
  return faults;
}

}  // namespace dashpad::input
