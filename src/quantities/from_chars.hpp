#pragma once
/// std::from_chars for a double. If the standard library lacks it, as libc++ 19 does, fast_float takes its
/// place, which libstdc++ uses, too. And the number that a whole text is.

#include <charconv>
#include <optional>
#include <string_view>
#include <type_traits>

#ifndef __cpp_lib_to_chars
#include <algorithm>
#include <cmath>

#include <fast_float/fast_float.h>
#endif

namespace dashpad {

inline std::from_chars_result from_chars(const char* first, const char* last, double& number) {
#ifdef __cpp_lib_to_chars
  return std::from_chars(first, last, number);
#else
  double value = 0;
  const auto [end, error] = fast_float::from_chars(first, last, value);
  if (error != std::errc()) return {end, error};
  // Releases before 4 answer infinity or zero where the number is too large or too small.
  const std::string_view text(first, static_cast<std::size_t>(end - first));
  const std::string_view mantissa = text.substr(0, std::min(text.find_first_of("eE"), text.size()));
  if ((std::isinf(value) && text.find_first_of("0123456789") != std::string_view::npos) ||
      (value == 0 && mantissa.find_first_of("123456789") != std::string_view::npos))
    return {end, std::errc::result_out_of_range};
  number = value;
  return {end, error};
#endif
}

/// The number that a text is as a whole.
template <class Number>
std::optional<Number> parsed(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  std::from_chars_result read{};
  if constexpr (std::is_same_v<Number, double>)
    read = from_chars(text.data(), end, number);
  else
    read = std::from_chars(text.data(), end, number);
  return read.ec == std::errc() && read.ptr == end ? std::optional(number) : std::nullopt;
}

}  // namespace dashpad
