#pragma once
/// Random numbers that are a function of their place: Philox 4x32-10 (Salmon, Moraes, Dror, Shaw: Parallel
/// random numbers: as easy as 1, 2, 3, SC11), of Random123.

#include <array>
#include <cstdint>

#include <Random123/philox.h>

namespace dashpad::study {

/// What a number is for; numbers for different purposes are independent.
enum class Purpose : std::uint32_t { draw, permutation, jitter, scrambling };

/// 128 random bits. `place` is the draw, `dimension` the factor.
inline std::array<std::uint32_t, 4> random_words(std::uint64_t seed, std::uint64_t place,
                                                 std::uint32_t dimension, Purpose purpose) {
  using Philox = r123::Philox4x32_R<10>;
  const Philox::ctr_type counter{{static_cast<std::uint32_t>(place), static_cast<std::uint32_t>(place >> 32),
                                  dimension, static_cast<std::uint32_t>(purpose)}};
  const Philox::key_type key{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
  const Philox::ctr_type words = Philox()(counter, key);
  return {words[0], words[1], words[2], words[3]};
}

/// In (0, 1), on the middles of 2^53 equal intervals.
inline double random_fraction(std::uint64_t seed, std::uint64_t place, std::uint32_t dimension,
                              Purpose purpose) {
  const auto words = random_words(seed, place, dimension, purpose);
  const std::uint64_t bits = std::uint64_t{words[1]} << 32 | words[0];
  // The last middle would round to 1.
  const double fraction = (static_cast<double>(bits >> 11) + 0.5) * 0x1p-53;
  return fraction < 1 ? fraction : 1 - 0x1p-53;
}

}  // namespace dashpad::study
