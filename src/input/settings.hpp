#pragma once
/// Values in place of those of a case file, or beside them: --set KEY=VALUE.

#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "input/table_reader.hpp"

namespace dashpad::input {

/// What is left to be set when the case has been read: numbers that its file does not hold, but a card, or a
/// support that is known as a whole.
struct LaterSetting {
  std::string key, value;
};

/// Puts each "KEY=VALUE" into the tree, over what is there and over what it excludes (a weight under a mass,
/// a drop height under a speed, a law in the case under a card), and gives back what waits for the case. A
/// fault is one of "--set", under its key.
std::vector<LaterSetting> put_settings(const std::vector<std::string>& settings, TomlNode& root,
                                       FaultList& faults);

/// Into the case, with a unit. A material of which a number is set has it in its name.
void put_later(const std::vector<LaterSetting>& settings, ImpactCase& impact, FaultList& faults);

}  // namespace dashpad::input
