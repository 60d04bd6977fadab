#pragma once
/// A permutation of 0 to count - 1 that is a function of the number: what gives each draw its stratum.

#include <array>
#include <cstdint>

namespace dashpad::study {

/// A keyed Feistel network on the smallest power of 4 that is not below `count`; a number that it puts
/// outside is led through again until it is inside (cycle walking: Black, Rogaway, Ciphers with arbitrary
/// finite domains, CT-RSA 2002), fewer than four times on the average.
class Permutation {
 public:
  /// `count` in [1, 2^62].
  Permutation(std::uint64_t count, std::uint64_t seed, std::uint32_t dimension);
  [[nodiscard]] std::uint64_t at(std::uint64_t number) const;

 private:
  static constexpr std::size_t rounds = 8;
  [[nodiscard]] std::uint64_t encrypted(std::uint64_t number) const;

  std::uint64_t count_;
  unsigned half_bits_ = 1;
  std::array<std::uint64_t, rounds> keys_{};
};

}  // namespace dashpad::study
