#include "dashpad/study/design.hpp"

#include <stdexcept>

#include "study/cholesky.hpp"
#include "study/distribution.hpp"
#include "study/fraction_source.hpp"

namespace dashpad::study {
namespace {

std::uint64_t blocks_of(const Study& study) { return study.indices ? 2 + sampled_factors(study).size() : 1; }

}  // namespace

struct Design::Plan {
  /// The second matrix of Saltelli's design has dimensions of its own.
  explicit Plan(const Study& study)
      : samples(study.samples),
        blocks(blocks_of(study)),
        sampled(sampled_factors(study)),
        source(study, (study.indices ? 2 : 1) * sampled.size()) {
    if (!study.correlations.empty()) root = *root_of_correlations(study);
    for (const std::size_t i : sampled) quantiles.emplace_back(study.factors[i]);
    for (const Factor& factor : study.factors) {
      const auto* of = std::get_if<Levels>(&factor.spread);
      levels.push_back(of ? of->values : std::vector<double>());
      if (of) combinations *= of->values.size();
    }
  }

  /// The factors that lie on a grid; the last one changes fastest.
  void write_levels(std::uint64_t combination, std::span<double> values) const {
    for (std::size_t i = levels.size(); i-- > 0;) {
      if (levels[i].empty()) continue;
      values[i] = levels[i][combination % levels[i].size()];
      combination /= levels[i].size();
    }
  }

  [[nodiscard]] double fraction(std::uint64_t draw, std::uint64_t block, std::size_t which) const {
    const bool from_second = block == 1 || block == 2 + which;
    return source.at(draw, which + (from_second ? sampled.size() : 0));
  }

  /// Gaussian copula: the fraction of a sum of independent normal scores.
  [[nodiscard]] double correlated_fraction(std::uint64_t draw, std::size_t which) const {
    double score = 0;
    for (std::size_t k = 0; k <= which; ++k)
      if (root[which][k] != 0) score += root[which][k] * quantile(StandardNormal(), source.at(draw, k));
    return cdf(StandardNormal(), score);
  }

  std::uint64_t samples, blocks, combinations = 1;
  std::vector<std::size_t> sampled;
  FractionSource source;
  Matrix root;  ///< empty without correlations
  std::vector<Quantiles> quantiles;
  std::vector<std::vector<double>> levels;  ///< of each factor; empty for a sampled one
};

Design::Design(const Study& study) {
  const auto broken = violations(study);
  if (!broken.empty()) throw std::invalid_argument(broken.front().key + ": " + broken.front().rule);
  plan_ = std::make_unique<const Plan>(study);
}

Design::~Design() = default;
Design::Design(Design&&) noexcept = default;
Design& Design::operator=(Design&&) noexcept = default;

std::uint64_t Design::rows() const { return plan_->combinations * plan_->samples * plan_->blocks; }

int Design::block_of(std::uint64_t row) const { return static_cast<int>(row % plan_->blocks); }

std::uint64_t Design::draw_of(std::uint64_t row) const { return row / plan_->blocks % plan_->samples; }

void Design::factors_of(std::uint64_t row, std::span<double> values) const {
  if (row >= rows() || values.size() != plan_->levels.size())
    throw std::out_of_range("no such row of the study");
  plan_->write_levels(row / plan_->blocks / plan_->samples, values);
  const std::uint64_t draw = draw_of(row), block = row % plan_->blocks;
  for (std::size_t k = 0; k < plan_->sampled.size(); ++k) {
    const double fraction =
        plan_->root.empty() ? plan_->fraction(draw, block, k) : plan_->correlated_fraction(draw, k);
    values[plan_->sampled[k]] = plan_->quantiles[k].at(fraction);
  }
}

}  // namespace dashpad::study
