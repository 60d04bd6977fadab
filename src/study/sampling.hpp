#pragma once
/// Fractions in (0, 1) for each draw and dimension: random numbers that are a function of their place, Latin
/// hypercubes, Sobol points. Random numbers are Philox 4x32-10 (Salmon, Moraes, Dror, Shaw: Parallel random
/// numbers: as easy as 1, 2, 3, SC11), of Random123.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Random123/philox.h>

#include "dashpad/study/study.hpp"

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

/// Direction numbers of Boost.Random (Joe, Kuo 2008). Owen's nested uniform scrambling by hashing: Laine,
/// Karras, Stratified sampling for stochastic transparency, EGSR 2011; Burley, Practical hash-based Owen
/// scrambling, JCGT 9(4), 2020. Each dimension has a seed of its own, from Philox.
class Sobol {
 public:
  static constexpr std::size_t most_dimensions = 1000;

  Sobol(std::size_t dimensions, std::uint64_t seed);
  /// In (0, 1), on the middles of 2^32 equal intervals; `number` below 2^32.
  [[nodiscard]] double at(std::uint64_t number, std::size_t dimension) const;
  /// Before scrambling, in units of 2^-32. Number 0 is 0 in all dimensions.
  [[nodiscard]] std::uint32_t plain(std::uint64_t number, std::size_t dimension) const;

 private:
  std::vector<std::array<std::uint32_t, 32>> directions_;  ///< of each dimension
  std::vector<std::uint32_t> seeds_;
};

class FractionSource {
 public:
  FractionSource(const Study& study, std::size_t dimensions)
      : sampling_(study.sampling), seed_(study.seed), count_(study.samples) {
    if (sampling_ == Sampling::sobol && dimensions > 0) sobol_.emplace(dimensions, seed_);
    if (sampling_ == Sampling::latin_hypercube)
      for (std::uint32_t i = 0; i < dimensions; ++i) strata_.emplace_back(count_, seed_, i);
  }

  [[nodiscard]] double at(std::uint64_t draw, std::size_t dimension) const {
    const auto i = static_cast<std::uint32_t>(dimension);
    switch (sampling_) {
      case Sampling::sobol: return sobol_->at(draw, dimension);
      case Sampling::latin_hypercube: {
        const double within = random_fraction(seed_, draw, i, Purpose::jitter);
        const double place = static_cast<double>(strata_[dimension].at(draw)) + within;
        const double fraction = place / static_cast<double>(count_);
        return fraction < 1 ? fraction : 1 - 0x1p-53;
      }
      case Sampling::monte_carlo: break;
    }
    return random_fraction(seed_, draw, i, Purpose::draw);
  }

 private:
  Sampling sampling_;
  std::uint64_t seed_, count_;
  std::optional<Sobol> sobol_;
  std::vector<Permutation> strata_;
};

}  // namespace dashpad::study
