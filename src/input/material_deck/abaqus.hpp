#pragma once
/// Lines of Abaqus input files.

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "input/material_deck/deck_foam.hpp"

namespace dashpad::input {

struct AbaqusKeyword {
  std::string name;  ///< in capitals, single blanks: "LOW DENSITY FOAM"
  std::map<std::string, std::string> parameters;
  std::size_t line = 0;
};

/// The keyword in a text that begins with its star.
AbaqusKeyword abaqus_keyword(std::string_view text, std::size_t line);

/// Whether the line begins with the star of a keyword, before which may be blanks.
bool begins_abaqus_keyword(std::string_view line);

/// Calls one of the functions for each keyword, which goes on in the next line where it ends with a comma,
/// and for each line of data below it. Comments and blank lines are left out.
void each_abaqus_line(std::string_view text, const std::function<void(const AbaqusKeyword&)>& on_keyword,
                      const std::function<void(const DeckLine&)>& on_data);

/// The parameters of *PARAMETER: numbers and expressions. Texts are left out.
DeckParameters abaqus_parameters(std::string_view text, MeasurementFaults& faults);

}  // namespace dashpad::input
