#pragma once
/// Functions and entries that all JSON of Dashpad shares.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "dashpad/version.hpp"

namespace dashpad {

using Json = nlohmann::ordered_json;

/// The number, or null if it is not finite.
inline Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
/// The number, or null if it is absent or not finite.
inline Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }
/// The number, or null if it is not `present`.
inline Json number_if(bool present, double value) { return present ? number(value) : Json(nullptr); }
inline Json numbers(const std::vector<double>& values) {
  Json array = Json::array();
  for (const double value : values) array.push_back(number(value));
  return array;
}

/// An array of what is made of each.
template <class List, class Make>
Json array_of(const List& list, const Make& make) {
  Json array = Json::array();
  for (const auto& each : list) array.push_back(make(each));
  return array;
}

/// The value converted by `make`, or null if it is absent.
template <class Value, class Make>
Json made_of(const std::optional<Value>& value, const Make& make) {
  return value ? Json(make(*value)) : Json(nullptr);
}
/// The text, or null if it is empty.
inline Json text_if_any(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

/// The program that made it.
inline Json program_json() {
  return {{"name", "dashpad"}, {"version", version()}, {"commit", build_facts().git_commit}};
}

/// The text with a final line break. Bytes that are not UTF-8 are replaced, so that they prevent no result.
inline std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// The layout of all JSON results; it increases when a key is removed or changes its meaning.
constexpr int result_format = 3;

/// A result, with its format before everything else.
inline Json result_with_format(const Json& result) {
  Json whole{{"format", result_format}};
  whole.update(result);
  return whole;
}
inline std::string result_json_text(const Json& result) { return json_text(result_with_format(result)); }

}  // namespace dashpad
