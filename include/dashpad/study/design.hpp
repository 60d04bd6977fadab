#pragma once
/// Which row of a study has which factors: a function of the row's number alone, so that the order of the
/// work, the number of threads or machines, and interruptions change nothing.
///
///   row = (combination of levels * samples + draw) * blocks + block
///
/// with the levels of the first factor changing most slowly. Random numbers are counter-based (Philox
/// 4x32-10, Salmon et al. 2011): of the seed, the draw and the factor.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "dashpad/study/study.hpp"

namespace dashpad::study {

/// A quantity that can be a factor.
struct FactorKey {
  std::string key;
  std::string unit;  ///< SI; "1" for a pure number, "" for a material
};

/// All that a case with this law and this support offers: its quantities (dashpad/case/case_quantity.hpp)
/// and its material.
std::vector<FactorKey> factor_keys(const ImpactCase& base);

/// What is said about a factor whose key is none of factor_keys(): what was meant, or what there is instead.
std::string rule_for_unknown(const std::string& key, const ImpactCase& base);

/// Whether a key is that of a number of the pad's law or of the curves it is made of. Which of them there are
/// depends on the material.
bool is_of_law(const std::string& key);

/// Knows where each factor goes. Made once, used for many rows, by several threads at once if need be.
class Application {
 public:
  /// `study` must outlive it. Throws std::invalid_argument for a key that is none of factor_keys().
  explicit Application(const Study& study);

  /// Writes SI values, in the order of Study::factors, into a copy of Study::base that may have been used for
  /// other rows. Memory is taken only where the material changes and for a support that varies.
  void operator()(std::span<const double> values, ImpactCase& into) const;

 private:
  std::vector<std::function<void(ImpactCase&, double)>> steps_;
};

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
