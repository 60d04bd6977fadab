#include "study/sampling.hpp"

#include <bit>

#include <Random123/philox.h>
#include <boost/random/sobol.hpp>

namespace dashpad::study {

std::array<std::uint32_t, 4> random_words(std::uint64_t seed, std::uint64_t place, std::uint32_t dimension,
                                          Purpose purpose) {
  using Philox = r123::Philox4x32_R<10>;
  const Philox::ctr_type counter{{static_cast<std::uint32_t>(place), static_cast<std::uint32_t>(place >> 32),
                                  dimension, static_cast<std::uint32_t>(purpose)}};
  const Philox::key_type key{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
  const Philox::ctr_type words = Philox()(counter, key);
  return {words[0], words[1], words[2], words[3]};
}

namespace {

/// The finaliser of MurmurHash3 (Appleby): every bit of the result depends on every bit of the argument.
std::uint64_t mixed(std::uint64_t x) {
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdULL;
  x ^= x >> 33;
  x *= 0xc4ceb9fe1a85ec53ULL;
  x ^= x >> 33;
  return x;
}

using Engine = boost::random::sobol_engine<std::uint32_t, 32>;

/// Point `number` in all dimensions. Boost leaves out point 0, which is 0.
std::vector<std::uint32_t> point(std::size_t dimensions, std::uint64_t number) {
  std::vector<std::uint32_t> values(dimensions, 0);
  if (number == 0) return values;
  Engine engine(dimensions);
  engine.discard((number - 1) * dimensions);
  for (std::uint32_t& value : values) value = engine();
  return values;
}

std::uint32_t reversed(std::uint32_t x) {
  x = (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
  x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
  x = (x & 0x0f0f0f0fu) << 4 | (x >> 4 & 0x0f0f0f0fu);
  x = (x & 0x00ff00ffu) << 8 | (x >> 8 & 0x00ff00ffu);
  return x << 16 | x >> 16;
}

/// Each bit is flipped or not by what the bits below it are: the other way round, Owen's scrambling.
std::uint32_t laine_karras(std::uint32_t x, std::uint32_t seed) {
  x += seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return x;
}

}  // namespace

Permutation::Permutation(std::uint64_t count, std::uint64_t seed, std::uint32_t dimension) : count_(count) {
  while (half_bits_ < 31 && (std::uint64_t{1} << (2 * half_bits_)) < count) ++half_bits_;
  for (std::size_t round = 0; round < rounds; ++round) {
    const auto words = random_words(seed, round, dimension, Purpose::permutation);
    keys_[round] = std::uint64_t{words[1]} << 32 | words[0];
  }
}

std::uint64_t Permutation::encrypted(std::uint64_t number) const {
  const std::uint64_t mask = (std::uint64_t{1} << half_bits_) - 1;
  std::uint64_t left = number >> half_bits_, right = number & mask;
  for (const std::uint64_t key : keys_) {
    const std::uint64_t next = left ^ (mixed(right ^ key) & mask);
    left = right;
    right = next;
  }
  return left << half_bits_ | right;
}

std::uint64_t Permutation::at(std::uint64_t number) const {
  do number = encrypted(number);
  while (number >= count_);
  return number;
}

/// Boost follows the order of the Gray code: between points 2^j - 1 and 2^j only direction j changes.
Sobol::Sobol(std::size_t dimensions, std::uint64_t seed) : directions_(dimensions), seeds_(dimensions) {
  for (unsigned j = 0; j < 32; ++j) {
    const auto before = point(dimensions, (std::uint64_t{1} << j) - 1);
    const auto after = point(dimensions, std::uint64_t{1} << j);
    for (std::size_t i = 0; i < dimensions; ++i) directions_[i][j] = before[i] ^ after[i];
  }
  for (std::size_t i = 0; i < dimensions; ++i)
    seeds_[i] = random_words(seed, 0, static_cast<std::uint32_t>(i), Purpose::scrambling)[0];
}

std::uint32_t Sobol::plain(std::uint64_t number, std::size_t dimension) const {
  std::uint32_t value = 0;
  for (; number != 0; number &= number - 1)
    value ^= directions_[dimension][static_cast<std::size_t>(std::countr_zero(number))];
  return value;
}

double Sobol::at(std::uint64_t number, std::size_t dimension) const {
  const std::uint32_t scrambled =
      reversed(laine_karras(reversed(plain(number, dimension)), seeds_[dimension]));
  return (scrambled + 0.5) * 0x1p-32;
}

}  // namespace dashpad::study
