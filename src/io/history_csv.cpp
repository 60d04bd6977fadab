#include "dashpad/io/history_csv.hpp"

#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace dashpad {

namespace {

struct Column {
  std::string header;
  const std::vector<double>* values;
  double factor;  ///< from SI to the column's unit; these units have no offset
};

/// "m/s" as part of a name: "m_per_s".
std::string in_name(const std::string& unit) {
  std::string name;
  for (const char character : unit) name += character == '/' ? "_per_" : std::string(1, character);
  return name;
}

Column column(const std::string& name, const std::vector<double>& values, const std::string& si_unit,
              const UnitSystem& units) {
  return {name + "_" + in_name(unit_for(units, si_unit)), &values, value_in(units, 1, si_unit)};
}

void append_number(fmt::memory_buffer& text, double value) {
  if (std::isfinite(value)) fmt::format_to(std::back_inserter(text), "{}", value);
}

}  // namespace

std::string history_csv(const History& history, const UnitSystem& units) {
  const std::array<Column, 9> columns{
      column("time", history.time, "s", units),
      column("force", history.force, "N", units),
      Column{"acceleration_g", &history.acceleration, 1 / standard_gravity},
      column("velocity", history.velocity, "m/s", units),
      column("motion", history.motion, "m", units),
      column("penetration", history.penetration, "m", units),
      column("support_deflection", history.support_deflection, "m", units),
      column("contact_radius", history.contact_radius, "m", units),
      Column{"largest_strain", &history.largest_strain, 1},
  };
  fmt::memory_buffer text;
  const auto end_field = [&](const Column& of) { text.push_back(&of == &columns.back() ? '\n' : ','); };
  for (const Column& of : columns) {
    if (of.values->size() != history.size())
      throw std::invalid_argument("history: " + of.header + " has gaps");
    text.append(of.header);
    end_field(of);
  }
  for (std::size_t row = 0; row < history.size(); ++row) {
    for (const Column& of : columns) {
      append_number(text, of.factor * (*of.values)[row]);
      end_field(of);
    }
  }
  return fmt::to_string(text);
}

}  // namespace dashpad
