#include "study/latin_hypercube.hpp"

#include "study/random.hpp"

namespace dashpad::study {
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

}  // namespace dashpad::study
