#pragma once
/// Flags as they stand in every JSON.

#include <vector>

#include "dashpad/impact/flags.hpp"
#include "json/json_values.hpp"

namespace dashpad {

inline Json flags_json(const std::vector<Flag>& flags) {
  Json all = Json::array();
  for (const Flag& flag : flags) {
    Json figures = Json::object();
    for (const FlagFigure& figure : flag.figures) figures[figure.key] = number(figure.value);
    all.push_back({{"name", flag.name},
                   {"severity", to_string(severity_of(flag.name))},
                   {"text", flag.text},
                   {"figures", figures}});
  }
  return all;
}

}  // namespace dashpad
