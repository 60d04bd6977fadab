#include "dashpad/input/material_deck.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "input/material_deck/deck_foam.hpp"

namespace dashpad::input {
namespace {

enum class Solver { abaqus, ls_dyna, radioss, unknown };

/// Decides by the first line that begins a keyword.
Solver solver_of(std::string_view text) {
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    if (line.starts_with('*')) return is_abaqus(text) ? Solver::abaqus : Solver::ls_dyna;
    if (line.starts_with('/')) return Solver::radioss;
  }
  return Solver::unknown;
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
                                                      const UnitSystem& units, Includes includes) {
  DeckText deck;
  deck.files = {file};
  auto read = reading_of([&]() -> std::vector<DeckMaterial> {
    MeasurementFaults faults(file.string());
    const std::string content = read_measurement(file, largest_deck);
    std::string_view text = text_in(content, faults);
    if (without_blanks(text).empty()) faults.refuse(0, "", "", "is empty");
    if (includes == Includes::allowed) {
      deck = with_includes(file, text, faults);
      faults.throw_if_any();
      text = deck.text;
      faults.are_in(text);
    }
    const Solver solver = solver_of(text);
    if (solver == Solver::unknown)
      faults.refuse(0, "", "", "is not a deck: no line begins with * (LS-DYNA, Abaqus) or / (Radioss)");
    const DeckUnits deck_units(units);
    std::vector<DeckFoam> foams = solver == Solver::abaqus    ? read_abaqus(text, deck_units, faults)
                                  : solver == Solver::ls_dyna ? read_ls_dyna(text, deck_units, faults)
                                                              : read_radioss(text, units, deck_units, faults);
    std::vector<DeckMaterial> materials;
    for (DeckFoam& foam : foams) {
      const DeckPlace place = deck.place_of(static_cast<int>(foam.line));
      foam.source = fmt::format("{} {} from the deck {} (line {}; units {})", foam.card, foam.id,
                                to_utf8(deck.files[place.file].filename().string()), place.line, units.name);
      auto material = material_of(foam, faults);
      if (!material) continue;
      material->line = place.line;
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
