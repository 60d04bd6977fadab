#pragma once
/// Variants of alternatives with names and parameter tables (laws, noses): checks, listing, choice by name.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "dashpad/model/parameter.hpp"

namespace dashpad {

struct ParameterValue {
  std::string key;
  std::string symbol;
  std::string unit;  ///< SI unit; "1" for a pure number
  double value = 0;  ///< value in `unit`
  std::string meaning;
};

/// Adds a violation if a number breaks its bounds, with `prefix` before its key; absent numbers break none.
template <class Owner>
void check_bounds(const Owner& owner, const Parameter<Owner>& parameter, const std::string& prefix,
                  std::vector<Violation>& broken) {
  const double value = parameter.of(owner);
  if (parameter.is_none(owner)) return;
  if (auto rule = broken_rule(value, parameter.bounds, parameter.unit))
    broken.push_back({prefix + parameter.key, value, *std::move(rule)});
}

/// The same for all numbers of an owner.
template <class Owner>
void check_bounds(const Owner& owner, const std::string& prefix, std::vector<Violation>& broken) {
  for (const Parameter<Owner>& parameter : Owner::parameters) check_bounds(owner, parameter, prefix, broken);
}

template <class... Alternatives>
std::vector<ParameterValue> parameter_values(const std::variant<Alternatives...>& variant) {
  return std::visit(
      []<class Of>(const Of& owner) {
        std::vector<ParameterValue> values;
        for (const Parameter<Of>& parameter : Of::parameters)
          values.push_back(
              {parameter.key, parameter.symbol, parameter.unit, parameter.of(owner), parameter.meaning});
        return values;
      },
      variant);
}

/// Calls visit(alternative) with a default-constructed one of each kind, in order.
template <class Variant, class Visit>
void for_each_alternative(Visit&& visit) {
  [&]<std::size_t... index>(std::index_sequence<index...>) {
    (visit(std::variant_alternative_t<index, Variant>()), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Variant>>());
}

template <class Variant>
std::vector<std::string> names_of_alternatives() {
  std::vector<std::string> names;
  for_each_alternative<Variant>([&](const auto& given) { names.emplace_back(given.name); });
  return names;
}

/// The alternative of that name, default-constructed; nothing for an unknown name.
template <class Variant>
std::optional<Variant> alternative_named(std::string_view name) {
  std::optional<Variant> result;
  for_each_alternative<Variant>([&](const auto& given) {
    if (name == given.name) result = given;
  });
  return result;
}

}  // namespace dashpad
