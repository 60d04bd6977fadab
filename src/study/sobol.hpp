#pragma once
/// Points of the Sobol sequence by their number, scrambled.

#include <array>
#include <cstdint>
#include <vector>

namespace dashpad::study {

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

}  // namespace dashpad::study
