#pragma once
/// The lower triangular root of a correlation matrix.

#include <optional>
#include <vector>

#include "dashpad/study/study.hpp"

namespace dashpad::study {

using Matrix = std::vector<std::vector<double>>;

/// L with L L^T = C, where C has the study's correlations between its sampled factors, in their order. Absent
/// where C is not positive definite.
std::optional<Matrix> root_of_correlations(const Study& study);

/// The indices of the sampled factors.
std::vector<std::size_t> sampled_factors(const Study& study);

}  // namespace dashpad::study
