#pragma once
/// The units of measured columns, and the ways in which headers name them.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/injury/measured_pulse.hpp"
#include "dashpad/input/measurement/tables.hpp"

namespace dashpad::input {

enum class ColumnKind { time, acceleration };

/// One `unit` in SI. Of accelerations, g is standard gravity; the gram is no acceleration. Throws UnitError.
double pulse_unit_factor(ColumnKind kind, const std::string& unit);
bool is_pulse_unit(ColumnKind kind, const std::string& unit);
bool is_voltage(const std::string& unit);
/// Whether a header means a unit by this where it does not put it in brackets: "ms", "g", "m_per_s2".
bool is_customary_unit(std::string_view text);

/// A header in two: "Time [ms]", "Acc (g)", "t_ms", "Time / s", "Acc, g", "Acc g", "a_m_per_s2". The unit is
/// empty where there is none.
struct HeaderText {
  std::string name;
  std::string unit;
};
HeaderText split_header(std::string_view header);

/// How many of that unit a strain of 1 is: 1 without a unit, 100 in %. Nothing for a unit that is none of a
/// strain.
std::optional<double> units_in_strain_one(const std::string& unit);

/// Whether a column is of this kind: by its unit where it has one of time or acceleration, else by its name.
bool looks_like(ColumnKind kind, const injury::MeasuredColumn& column);

/// Fills in unit, origin and factor of a column whose `unit` is that of the header, or empty. Returns the
/// rule that is broken, or "". `option` is how to give the unit: "--time-unit". A column in volts is an
/// acceleration with a `sensitivity`, and only such a column has one.
std::string settle_unit(injury::MeasuredColumn& column, ColumnKind kind, const std::string& given,
                        const std::string& option, const std::optional<Sensitivity>& sensitivity = {});

std::string wrong_number_of_sensitivities(std::size_t given, std::size_t accelerations);
/// Of the acceleration at `place`, from 0: the only sensitivity is that of all.
std::optional<Sensitivity> sensitivity_at(const std::vector<Sensitivity>& given, std::size_t place);

/// A sentence for the user where a given unit overrules that of the file.
std::optional<std::string> overruled_unit(const injury::MeasuredColumn& column,
                                          const std::string& unit_of_file);

}  // namespace dashpad::input
