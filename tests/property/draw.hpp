#pragma once
/// Random numbers of a seed, the same on every platform.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>

namespace dashpad::test {

/// How many random cases a test draws and from which seed, where somebody wants more of them.
inline std::uint64_t environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr || *text == '\0' ? otherwise : std::strtoull(text, nullptr, 10);
}

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : generator_(seed) {}
  double uniform(double low, double high) {
    // 53 bits of the generator: the same on every platform, unlike the distributions of the standard library.
    return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1p-53;
  }
  double decades(double low, double high) { return std::pow(10, uniform(std::log10(low), std::log10(high))); }
  int choice(int count) { return static_cast<int>(generator_() % static_cast<std::uint64_t>(count)); }

 private:
  std::mt19937_64 generator_;
};

}  // namespace dashpad::test
