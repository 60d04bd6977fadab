#include "study/cholesky.hpp"

#include <algorithm>
#include <cmath>

namespace dashpad::study {
namespace {

/// A smaller pivot is one factor that the others determine.
constexpr double least_pivot = 1e-10;

Matrix correlation_matrix(const Study& study) {
  const auto sampled = sampled_factors(study);
  const auto place = [&](std::size_t factor) {
    return static_cast<std::size_t>(std::ranges::find(sampled, factor) - sampled.begin());
  };
  Matrix matrix(sampled.size(), std::vector<double>(sampled.size(), 0.));
  for (std::size_t i = 0; i < sampled.size(); ++i) matrix[i][i] = 1;
  for (const Correlation& of : study.correlations) {
    const std::size_t i = place(of.first), j = place(of.second);
    if (i < sampled.size() && j < sampled.size()) matrix[i][j] = matrix[j][i] = of.value;
  }
  return matrix;
}

}  // namespace

std::vector<std::size_t> sampled_factors(const Study& study) {
  std::vector<std::size_t> sampled;
  for (std::size_t i = 0; i < study.factors.size(); ++i)
    if (study.factors[i].is_sampled()) sampled.push_back(i);
  return sampled;
}

std::optional<Matrix> root_of_correlations(const Study& study) {
  const Matrix of = correlation_matrix(study);
  Matrix root(of.size(), std::vector<double>(of.size(), 0.));
  for (std::size_t i = 0; i < of.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = of[i][j];
      for (std::size_t k = 0; k < j; ++k) rest -= root[i][k] * root[j][k];
      if (i == j && !(rest > least_pivot)) return std::nullopt;
      root[i][j] = i == j ? std::sqrt(rest) : rest / root[j][j];
    }
  return root;
}

}  // namespace dashpad::study
