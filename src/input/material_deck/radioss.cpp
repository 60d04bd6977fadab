// The materials of a deck of Radioss: which are foams, by which law, in which units.

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/quantities/quantity.hpp"
#include "input/material_deck/radioss_laws.hpp"

namespace dashpad::input {

namespace {

struct RadiossLaw {
  std::array<const char*, 2> names;
  bool crushable;
  bool (*read)(LawLines&, const RadiossSource&, DeckFoam&);
};
constexpr RadiossLaw radioss_laws[]{{{"LAW90", "LAW90"}, false, read_law_90},
                                    {{"LAW70", "FOAM_TAB"}, false, read_law_70},
                                    {{"LAW62", "VISC_HYP"}, false, read_law_62},
                                    {{"LAW33", "FOAM_PLAS"}, true, read_law_33}};

/// Whether the units that a line of the deck states, as codes or as numbers, are those of the system.
void compare_units(const DeckLine& line, const UnitSystem& system, MeasurementFaults& faults) {
  const std::array<std::array<std::string, 2>, 3> wanted{
      {{system.mass, "kg"}, {system.length, "m"}, {system.time, "s"}}};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (line.text.size() <= 20 * i) return;
    const std::string stated(without_blanks(line.text.substr(20 * i, 20)));
    if (stated.empty()) return;
    const ReadNumber number = read_deck_number(stated, {});
    double in_si = number.value;
    try {
      if (number.kind != NumberKind::number) in_si = to_si("1 " + stated, wanted[i][1]);
      if (std::abs(in_si / to_si("1 " + wanted[i][0], wanted[i][1]) - 1) < 1e-6) continue;
    } catch (const UnitError&) {
      return;  // no units after all
    }
    faults.add(line.number, "units", to_utf8(stated),
               fmt::format("is not {}, as the unit system {} has it", wanted[i][0], system.name));
  }
}

}  // namespace

std::vector<DeckFoam> read_radioss(std::string_view text, const UnitSystem& system, const DeckUnits& units,
                                   MeasurementFaults& faults) {
  const RadiossBlocks deck = radioss_blocks(text, faults);
  if (deck.begin && deck.begin->lines.size() > 2) compare_units(deck.begin->lines[2], system, faults);
  if (deck.foams.empty()) {
    std::string none =
        "holds no /MAT/LAW33 (FOAM_PLAS), /MAT/LAW62 (VISC_HYP), /MAT/LAW70 (FOAM_TAB) or /MAT/LAW90";
    for (std::size_t i = 0; i < deck.other_materials.size(); ++i)
      none += (i == 0 ? "; there are " : ", ") + deck.other_materials[i];
    faults.add(0, "", "", none);
  }
  std::vector<DeckFoam> foams;
  for (const DeckBlock& block : deck.foams) {
    const std::vector<std::string> parts = parts_of(block.keyword);
    const auto* const law = std::ranges::find_if(radioss_laws, [&](const RadiossLaw& each) {
      return parts[1] == each.names[0] || parts[1] == each.names[1];
    });
    DeckFoam foam;
    foam.card = std::string("/MAT/") + law->names[0];
    foam.id = number_in(parts, 2);
    foam.line = block.head.number;
    foam.crushable = law->crushable;
    if (const DeckBlock* const own = deck.units.find(number_in(parts, 3));
        own != nullptr && own->lines.size() > 1)
      compare_units(own->lines[1], system, faults);
    LawLines lines(block, foam.card, faults);
    foam.title = lines.title();
    if (law->read(lines, {deck, units, faults}, foam)) foams.push_back(std::move(foam));
  }
  return foams;
}

}  // namespace dashpad::input
