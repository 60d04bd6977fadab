#pragma once
/// Fractions in (0, 1) for each draw and dimension, by the sampling of the study.

#include <cstdint>
#include <optional>
#include <vector>

#include "dashpad/study/study.hpp"
#include "study/latin_hypercube.hpp"
#include "study/random.hpp"
#include "study/sobol.hpp"

namespace dashpad::study {

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
