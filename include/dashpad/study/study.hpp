#pragma once
/// Many impacts: a base case, the quantities of it that vary, and how.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad::study {

/// Given values, or a range cut into equal (or equal relative) parts: one level of a grid each.
struct Levels {
  std::vector<double> values;  ///< SI; for "pad.material" the numbers of Study::materials
};
struct Normal {
  double mean = 0, deviation = 0;
};
/// The logarithm is normal. `median` > 0; `spread` is the standard deviation of the logarithm.
struct Lognormal {
  double median = 0, spread = 0;
};
struct Uniform {
  double low = 0, high = 0;
};
struct Triangular {
  double low = 0, mode = 0, high = 0;
};
/// Measured values, sorted; between them the distribution function is linear.
struct Empirical {
  std::vector<double> values;
};

/// A column of the study's table of rows: all such factors change together, from row to row.
struct ByRow {
  std::vector<double> values;  ///< SI, one a row; for "pad.material" the numbers of Study::materials
};
/// A column of the study's table of draws: a draw takes the values of all such factors from one row.
struct ByDraw {
  std::vector<double> values;  ///< SI, one a row
};

using Spread = std::variant<Levels, Normal, Lognormal, Uniform, Triangular, Empirical, ByRow, ByDraw>;

/// A quantity of the case that varies. SI.
struct Factor {
  std::string key;   ///< key as in case files: "impactor.speed", "pad.curve.modulus", "pad.material"
  std::string unit;  ///< SI: "m/s"; "" for a material
  Spread spread = {};
  /// Values outside are never drawn: the distribution is cut off there and made whole again.
  std::optional<double> lowest = {}, highest = {};
  [[nodiscard]] bool is_sampled() const { return given_values() == nullptr; }
  /// The values of levels or rows; null for what is drawn.
  [[nodiscard]] const std::vector<double>* given_values() const;
};

/// A correlation between the normal scores of two sampled factors (Gaussian copula), in (-1, 1).
struct Correlation {
  std::size_t first = 0, second = 0;
  double value = 0;
};

/// A column of the table of rows that is no number of the case: kept for those who read the results.
struct RowLabel {
  std::string name;
  std::vector<std::string> texts;  ///< one a row
};

enum class Sampling { monte_carlo, latin_hypercube, sobol };

/// A study. Its rows are all combinations of the levels, at each row of the table of rows if there is one,
/// times `samples` draws of the sampled factors, the same draws at each combination. With `indices`, each
/// draw becomes 2 + (number of sampled factors) rows (Saltelli's design).
struct Study {
  std::string title;
  std::string text;  ///< the study file as it is, for the store
  ImpactCase base;
  Options options{.tolerance = 1e-3};
  std::vector<Factor> factors;
  std::vector<Material> materials;  ///< materials that "pad.material" chooses from; empty without that factor
  std::vector<Correlation> correlations;
  std::vector<RowLabel> labels;  ///< of the table of rows
  Sampling sampling = Sampling::sobol;
  std::uint64_t samples = 1;  ///< draws; 1 without sampled factors
  std::uint64_t seed = 1;
  bool indices = false;
  std::vector<std::string> responses;  ///< names of dashpad/study/responses.hpp
  /// Standards for which its summary answers, as the study file names them. The base case has their impactor.
  std::vector<std::string> standards = {};
};

/// The largest number of rows: a billion takes a day and some 100 GB.
inline constexpr std::uint64_t max_rows = 1'000'000'000;

/// The indices of the sampled factors.
std::vector<std::size_t> sampled_factors(const Study& study);

/// Rows of the table of rows; 1 without one.
std::size_t table_rows(const Study& study);

/// The place in the table of rows of a row of the study.
std::size_t table_row_of(const Study& study, std::uint64_t row);

/// Rows of the study, also where they are too many to count in an integer.
double row_count(const Study& study);

/// All rules that a study breaks, under keys of study files: "samples", "factors.impactor.speed",
/// "correlations[1]". If the factors are sound, they include the rules of the case that levels and ends of
/// distributions break (docs/studies.md). Rarer combinations that make no valid case become "not run" rows.
std::vector<Violation> violations(const Study& study);

// Which row of a study has which factors: a function of the row's number alone, so that the order of the
// work, the number of threads or machines, and interruptions change nothing.
//
//   row = (combination of levels * samples + draw) * blocks + block
//
// with the row of the table changing most slowly, then the levels of the first factor. Random numbers are
// counter-based (Philox 4x32-10, Salmon et al. 2011): of the seed, the draw and the factor.

/// A quantity that can be a factor.
struct FactorKey {
  std::string key;
  std::string unit;  ///< SI; "1" for a pure number, "" for a material
};

/// All factors of the study's case with this law and support: its quantities (case_quantity.hpp), its
/// material, and what the cards of its materials leave uncertain ("foam.scatter").
std::vector<FactorKey> factor_keys(const Study& study);
/// The same without what is uncertain, which a fit cannot seek.
std::vector<FactorKey> factor_keys(const ImpactCase& base);

/// The message for a factor that is none of `known`: what was meant, or what there is instead.
std::string rule_for_unknown(const std::string& key, const ImpactCase& base,
                             const std::vector<FactorKey>& known);

/// Adds a factor for all that the cards leave uncertain and the study does not vary already: a range is drawn
/// evenly, a statistical source is normal.
void draw_foam_uncertainty(Study& study);

/// Whether a key is that of a number of the pad's law or of its curves, which depend on the material.
bool is_of_law(const std::string& key);

/// Knows where each factor goes. Made once, used for many rows, by several threads at once if need be.
class Application {
 public:
  /// `study` must outlive it. Throws std::invalid_argument for a key that is none of factor_keys().
  explicit Application(const Study& study);

  /// Writes SI values, in the order of Study::factors, into a copy of Study::base that may have served other
  /// rows. Memory is allocated only for another material or a support that varies.
  void operator()(std::span<const double> values, ImpactCase& into) const;

 private:
  std::vector<std::function<void(ImpactCase&, double)>> steps_;
  std::size_t last_ = static_cast<std::size_t>(-1);  ///< place of the step that follows all others, if any
};

class Design {
 public:
  /// Throws std::invalid_argument for violations() of the study.
  explicit Design(const Study& study);
  ~Design();
  Design(Design&&) noexcept;
  Design& operator=(Design&&) noexcept;

  [[nodiscard]] std::uint64_t rows() const;
  [[nodiscard]] std::uint64_t rows_of_combination() const;  ///< rows for one combination of levels
  /// The SI values of all factors in a row, in the order of Study::factors. Safe for several threads. Throws
  /// std::out_of_range for a row from rows() on and for `values` of another length.
  void factors_of(std::uint64_t row, std::span<double> values) const;
  /// The block of a row in Saltelli's design: 0 for the first matrix, 1 for the second, 2 + i for the first
  /// with sampled factor i of the second. 0 without `indices`.
  [[nodiscard]] int block_of(std::uint64_t row) const;
  /// The draw that a row belongs to.
  [[nodiscard]] std::uint64_t draw_of(std::uint64_t row) const;

 private:
  struct Plan;
  std::unique_ptr<const Plan> plan_;
};

}  // namespace dashpad::study
