#pragma once
/// A variant whose alternatives have a name and a table of parameters (laws, noses), read from TOML.

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "dashpad/model/parameter.hpp"
#include "input/table_reader.hpp"
#include "model/parameter_values.hpp"

namespace dashpad::input {

/// NaN after a fault.
template <class Owner>
void read_parameter(TableReader& table, const Parameter<Owner>& parameter, Owner& into) {
  parameter.set(into, std::string_view(parameter.unit) == "1"
                          ? table.number(parameter.key)
                          : table.quantity(parameter.key, parameter.unit));
}

/// Numbers at fault are NaN.
template <class Owner>
Owner read_parameters(TableReader& table) {
  Owner result;
  for (const Parameter<Owner>& parameter : Owner::parameters)
    if (!parameter.may_be_left_out() || table.has(parameter.key)) read_parameter(table, parameter, result);
  return result;
}

/// The alternative that the text at `key` of `table` names, its numbers still to be read; nothing after a
/// fault.
template <class Variant>
std::optional<Variant> read_alternative(TableReader& table, const std::string& key) {
  return alternative_named<Variant>(table.choice(key, names_of_alternatives<Variant>()));
}

/// The numbers of an alternative that is known.
template <class Variant>
Variant with_parameters(const Variant& alternative, TableReader& table) {
  return std::visit([&]<class Of>(const Of&) { return Variant(read_parameters<Of>(table)); }, alternative);
}

}  // namespace dashpad::input
