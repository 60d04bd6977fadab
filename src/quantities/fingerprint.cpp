#include "quantities/fingerprint.hpp"

#include <cstdint>

#include <fmt/format.h>

namespace dashpad {

std::string fingerprint(const std::vector<std::string>& texts) {
  std::uint64_t hash = 14695981039346656037U;
  const auto add = [&hash](char c) { hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U; };
  for (const std::string& text : texts) {
    for (const char c : text) add(c);
    add('\0');
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace dashpad
