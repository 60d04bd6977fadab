#pragma once
/// The foams of Radioss, each from its lines: what stands in which field, and what becomes of it.

#include "input/material_deck/radioss_lines.hpp"

namespace dashpad::input {

/// Crushable foam with closed cells (FOAM_PLAS), Ogden with branches (VISC_HYP), tabulated foam (FOAM_TAB)
/// and tabulated foam with a loss of energy. False where a line is missing or at fault.
bool read_law_33(LawLines& lines, const RadiossSource& from, DeckFoam& foam);
bool read_law_62(LawLines& lines, const RadiossSource& from, DeckFoam& foam);
bool read_law_70(LawLines& lines, const RadiossSource& from, DeckFoam& foam);
bool read_law_90(LawLines& lines, const RadiossSource& from, DeckFoam& foam);

}  // namespace dashpad::input
