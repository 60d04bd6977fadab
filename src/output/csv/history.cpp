#include "dashpad/output/csv/history.hpp"

#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "dashpad/result/result_quantity.hpp"

namespace dashpad::output {

namespace {

struct Column {
  std::string header;
  const std::vector<double>* values;
  double factor;  ///< from SI to the column's unit; these units have no offset
};

Column column(const char* key, const std::vector<double>& values, const UnitSystem& units) {
  const ResultQuantity& of = result_quantity(key);
  return {key_with_unit(of, units), &values, scaled_unit(of.si_unit, units).scale};
}

void append_number(fmt::memory_buffer& text, double value) {
  if (std::isfinite(value)) fmt::format_to(std::back_inserter(text), "{}", value);
}

}  // namespace

std::string history_csv(const History& history, const UnitSystem& units) {
  std::vector<Column> columns{
      column("time", history.time, units),
      column("force", history.force, units),
      column("acceleration", history.acceleration, units),
      column("velocity", history.velocity, units),
      column("motion", history.motion, units),
      column("penetration", history.penetration, units),
      column("support_deflection", history.support_deflection, units),
      column("contact_radius", history.contact_radius, units),
      column("axis_strain", history.axis_strain, units),
  };
  if (!history.pad_force.empty()) columns.push_back(column("pad_force", history.pad_force, units));
  if (!history.transmitted_force.empty()) {
    columns.push_back(column("transmitted_force", history.transmitted_force, units));
    columns.push_back(column("body_motion", history.body_motion, units));
  }
  for (std::size_t i = 0; i < history.layer_strain.size(); ++i) {
    columns.push_back(column("axis_strain", history.layer_strain[i], units));
    columns.back().header += fmt::format("_layer_{}", i + 1);
  }
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

}  // namespace dashpad::output
