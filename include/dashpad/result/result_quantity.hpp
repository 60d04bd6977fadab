#pragma once
/// What a result is made of: the one table of names, symbols, units and signs. Text, page, still, JSON, CSV,
/// store, studies and standards take theirs from here.

#include <string>
#include <string_view>
#include <vector>

#include "dashpad/quantities/unit_system.hpp"

namespace dashpad {

/// Of which part of a result a quantity is.
enum class Part {
  impact,   ///< a figure of the impact
  moment,   ///< a moment of it, with the velocity then
  pulse,    ///< a figure of the acceleration over time
  energy,   ///< at the end, or over time
  history,  ///< a column over time
};

/// How a figure grows during the impact: what is known of it where the impact is not seen to its end.
enum class Growth {
  none,         ///< unknown before the end
  with_force,   ///< a lower bound at the time limit; unbounded where the pad bottoms out on a rigid support
  with_motion,  ///< a lower bound at the time limit; final where the pad bottoms out on a rigid support
};

/// Without what an impact has no such figure.
enum class Needs { nothing, release, support };

/// What a source of doubt that is known as a share (Eq. 58) is a share of, for the interval of a figure.
enum class Doubt {
  none,  ///< the figure has no interval
  of_acceleration,
  of_hic,
  of_hic_d,  ///< of what HIC(d) has of HIC36
  of_level,  ///< of the acceleration: a dwell time above a level
  of_penetration,
  of_rebound
};

/// Where a quantity is shown, and what is known of it before it is computed.
struct ResultRole {
  int row = 0;              ///< its place among the rows of a result, from 1; 0: in files alone
  bool is_main = false;     ///< of those that people ask for first
  bool in_studies = false;  ///< a response
  bool is_signed = false;   ///< may be below zero
  Growth growth = Growth::none;
  Needs needs = Needs::nothing;
  Doubt doubt = Doubt::none;
  const char* estimate = "";  ///< what the estimate of its numerical error counts from; "" without one
  const char* absent = "";    ///< where an impact does not have it, if that is not said by its meaning
};

/// A quantity of a result. Inside the program its values are SI.
struct ResultQuantity {
  const char* key;      ///< "peak_acceleration": in studies and standards, and with its unit in files
  const char* title;    ///< "Peak acceleration": for people, never the key
  const char* symbol;   ///< of docs/theory.md, or that of the field; "" without
  const char* si_unit;  ///< "m/s2"; "1" for a pure number, and for HIC and severity index, in g^2.5 s
  const char* meaning;  ///< with its sign, if it can have one: without that it is never below zero
  const char* source;   ///< equation of docs/theory.md, section of docs/injury.md; "" where `meaning` says it
  Part part;
  ResultRole role = {};

  [[nodiscard]] bool has_estimate() const { return *role.estimate != '\0'; }
  [[nodiscard]] bool has_interval() const { return role.doubt != Doubt::none; }
};

/// All of them: figures of the impact, of the pulse, energies at the end, columns of the history.
const std::vector<ResultQuantity>& result_quantities();
/// Null for a key that the table does not have.
const ResultQuantity* find_result_quantity(std::string_view key);
/// Throws std::invalid_argument for a key that the table does not have.
const ResultQuantity& result_quantity(std::string_view key);

/// "peak acceleration", but "HIC15".
std::string title_in_sentence(const ResultQuantity& result_quantity);

/// The key of a quantity in a file that holds it in the units of a system: "peak_acceleration_g".
std::string key_with_unit(const ResultQuantity& result_quantity, const UnitSystem& units = plain_si());

}  // namespace dashpad
