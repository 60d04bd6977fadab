#pragma once
/// Which row of a study has which factors: a function of the row's number alone, so that the order of the
/// work, the number of threads or machines, and interruptions change nothing.
///
///   row = (combination of levels * samples + draw) * blocks + block
///
/// with the levels of the first factor changing most slowly. Random numbers are counter-based (Philox
/// 4x32-10, Salmon et al. 2011): of the seed, the draw and the factor.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "dashpad/study/study.hpp"

namespace dashpad::study {

class Design {
 public:
  /// Throws std::invalid_argument for violations() of the study.
  explicit Design(const Study& study);
  ~Design();
  Design(Design&&) noexcept;
  Design& operator=(Design&&) noexcept;

  [[nodiscard]] std::uint64_t rows() const;
  /// SI values of all factors in row `row` (0 to rows() - 1), in the order of Study::factors. Several threads
  /// may call it at once. Throws std::out_of_range for another row, and for `values` of another length.
  void factors_of(std::uint64_t row, std::span<double> values) const;
  /// What a row is in Saltelli's design: 0 the first matrix, 1 the second, 2 + i the first with sampled
  /// factor i of the second. 0 without `indices`.
  [[nodiscard]] int block_of(std::uint64_t row) const;
  /// The draw that a row belongs to.
  [[nodiscard]] std::uint64_t draw_of(std::uint64_t row) const;

 private:
  struct Plan;
  std::unique_ptr<const Plan> plan_;
};

/// Writes the factors of a row into a copy of the base case. For many rows: class Application.
void apply(const Study& study, std::span<const double> values, ImpactCase& into);

}  // namespace dashpad::study
