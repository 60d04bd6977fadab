#include "dashpad/input/measurement/sensitivity.hpp"

#include "dashpad/quantities/quantity.hpp"
#include "input/measurement/column_units.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

Sensitivity sensitivity_of(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos)
    throw UnitError("must be a voltage per acceleration, such as \"10 mV/g\" or \"1.02 mV/(m/s2)\"");
  std::string_view unit = without_blanks(std::string_view(text).substr(slash + 1));
  if (unit.starts_with('(') && unit.ends_with(')')) unit = unit.substr(1, unit.size() - 2);
  const double volts = to_si(std::string_view(text).substr(0, slash), "V");
  const double acceleration = pulse_unit_factor(ColumnKind::acceleration, std::string(unit));
  const double sensitivity = volts / acceleration;
  if (!(sensitivity > 0)) throw UnitError("must be more than 0");
  return {text, sensitivity};
}

}  // namespace dashpad::input
