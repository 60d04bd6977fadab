#pragma once
/// The quantities of a result: the one table of their names, symbols, units and signs, used by text, page,
/// still, JSON, CSV, store, studies and standards.

#include <string>
#include <string_view>
#include <vector>

#include "dashpad/quantities/unit_system.hpp"

namespace dashpad {

/// The part of a result to which a quantity belongs.
enum class Part {
  impact,   ///< a figure of the impact
  moment,   ///< a moment of the impact, with the velocity at it
  pulse,    ///< a figure of the acceleration over time
  energy,   ///< at the end, or over time
  history,  ///< a column over time
};

/// How a figure grows during the impact, and so what is known of it if the impact is not computed to its end.
enum class Growth {
  none,         ///< unknown before the end
  with_force,   ///< a lower bound at the time limit; unbounded where the pad bottoms out on a rigid support
  with_motion,  ///< a lower bound at the time limit; final where the pad bottoms out on a rigid support
};

/// The property that an impact must have for a figure to exist.
enum class Needs { nothing, release, support };

/// The figure whose uncertainty, if it is known as a share (Eq. 58), gives the interval of a quantity.
enum class Doubt {
  none,  ///< the figure has no interval
  of_acceleration,
  of_hic,
  of_hic_d,  ///< the part of HIC(d) that is due to HIC36
  of_level,  ///< the acceleration, of which the quantity is a dwell time above a level
  of_penetration,
  of_rebound,
  of_rebound_height,  ///< the square of the rebound speed
};

/// The places where a quantity is shown, and its properties known beforehand.
struct ResultRole {
  int row = 0;              ///< number of its row in a result, from 1; 0: in files only
  bool is_main = false;     ///< whether people ask for it first
  bool in_studies = false;  ///< whether it is a response of studies
  bool is_signed = false;   ///< whether it may be below zero
  Growth growth = Growth::none;
  Needs needs = Needs::nothing;
  Doubt doubt = Doubt::none;
  const char* estimate = "";  ///< the reference of its error estimate; "" without an estimate
  const char* absent = "";    ///< when an impact does not have it, unless its meaning says so
};

/// A quantity of a result. Inside the program its values are in SI.
struct ResultQuantity {
  const char* key;      ///< "peak_acceleration": in studies and standards, and with its unit in files
  const char* title;    ///< "Peak acceleration": the name for people
  const char* symbol;   ///< symbol in docs/theory.md, or the usual one; "" without
  const char* si_unit;  ///< "m/s2"; "1" for a pure number, and for HIC and severity index, in g^2.5 s
  const char* meaning;  ///< includes the sign of a quantity that may be below zero
  const char* source;   ///< equation of docs/theory.md, section of docs/injury.md; "" if `meaning` suffices
  Part part;
  ResultRole role = {};

  [[nodiscard]] bool has_estimate() const { return *role.estimate != '\0'; }
  [[nodiscard]] bool has_interval() const { return role.doubt != Doubt::none; }
};

/// All quantities: figures of the impact, figures of the pulse, energies at the end, columns of the history.
const std::vector<ResultQuantity>& result_quantities();
/// The quantity with that key, or null.
const ResultQuantity* find_result_quantity(std::string_view key);
/// The quantity with that key; throws std::invalid_argument if there is none.
const ResultQuantity& result_quantity(std::string_view key);

/// The title within a sentence: "peak acceleration", but "HIC15".
std::string title_in_sentence(const ResultQuantity& result_quantity);

/// The key of a quantity in a file in the units of a system: "peak_acceleration_g".
std::string key_with_unit(const ResultQuantity& result_quantity, const UnitSystem& units = plain_si());

}  // namespace dashpad
