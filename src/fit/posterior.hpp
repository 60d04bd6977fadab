#pragma once
/// Draws from the Laplace approximation of a posterior.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace dashpad::fit {

/// Normal about a minimum in [0, 1]^n with this precision (row by row) and gradient there, cut off at the
/// bounds. Coordinates of which the data say nothing are even between their bounds. By hit and run along the
/// eigenvectors of the precision.
std::vector<std::vector<double>> laplace_sample(std::span<const double> minimum,
                                                std::span<const double> precision,
                                                std::span<const double> gradient, std::size_t count,
                                                std::uint64_t seed);

}  // namespace dashpad::fit
