#pragma once
/// What a result is made of: the one table of names, symbols, units and signs. Text, page, still, JSON, CSV,
/// store, studies and standards take theirs from here.

#include <string>
#include <string_view>
#include <vector>

#include "dashpad/quantities/unit_system.hpp"

namespace dashpad {

/// A quantity of a result. Inside the program its values are SI.
struct ResultQuantity {
  const char* key;      ///< "peak_acceleration": in studies and standards, and with its unit in files
  const char* title;    ///< "Peak acceleration": for people, never the key
  const char* symbol;   ///< of docs/theory.md, or that of the field; "" without
  const char* si_unit;  ///< "m/s2"; "1" for a pure number, and for HIC and severity index, in g^2.5 s
  const char* meaning;  ///< with its sign, if it can have one: without that it is never below zero
  const char* source;   ///< equation of docs/theory.md, section of docs/injury.md; "" where `meaning` says it
  bool has_estimate;    ///< whether an estimate of its numerical error comes with it
};

/// All of them: figures of the impact, of the pulse, energies at the end, columns of the history.
const std::vector<ResultQuantity>& result_quantities();
/// Null for a key that the table does not have.
const ResultQuantity* find_result_quantity(std::string_view key);
/// Throws std::invalid_argument for a key that the table does not have.
const ResultQuantity& result_quantity(std::string_view key);

/// "peak acceleration", but "HIC15".
std::string title_in_sentence(const ResultQuantity& of);

/// The key of a quantity in a file that holds it in the units of a system: "peak_acceleration_g".
std::string key_with_unit(const ResultQuantity& of, const UnitSystem& units = plain_si());

}  // namespace dashpad
