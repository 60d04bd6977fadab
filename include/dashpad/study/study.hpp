#pragma once
/// Many impacts: a base case, the quantities of it that vary, and how.

#include <cstddef>
#include <cstdint>
#include <optional>
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

using Spread = std::variant<Levels, Normal, Lognormal, Uniform, Triangular, Empirical>;

/// A quantity of the case that varies. SI.
struct Factor {
  std::string key;   ///< as in case files: "impactor.speed", "pad.curve.modulus", "pad.material"
  std::string unit;  ///< SI: "m/s"; "" for a material
  Spread spread = {};
  /// Values outside are never drawn: the distribution is cut off there and made whole again.
  std::optional<double> lowest = {}, highest = {};
  [[nodiscard]] bool is_sampled() const { return !std::holds_alternative<Levels>(spread); }
};

/// Of the normal scores of two sampled factors (Gaussian copula), in (-1, 1).
struct Correlation {
  std::size_t first = 0, second = 0;
  double value = 0;
};

enum class Sampling { monte_carlo, latin_hypercube, sobol };

/// Rows are all combinations of the levels, times `samples` draws of the sampled factors: the same draws at
/// each combination. With `indices`, each draw becomes 2 + (number of sampled factors) rows (Saltelli's
/// design).
struct Study {
  std::string title;
  std::string text;  ///< the study file as it is, for the store
  ImpactCase base;
  Options options{.tolerance = 1e-3};
  std::vector<Factor> factors;
  std::vector<Material> materials;  ///< that "pad.material" chooses from; empty without that factor
  std::vector<Correlation> correlations;
  Sampling sampling = Sampling::sobol;
  std::uint64_t samples = 1;  ///< draws; 1 without sampled factors
  std::uint64_t seed = 1;
  bool indices = false;
  std::vector<std::string> responses;  ///< names of dashpad/study/responses.hpp
};

/// More are refused: a billion rows take a day and some 100 GB.
inline constexpr std::uint64_t most_rows = 1'000'000'000;

/// Rows of the study, also where they are too many to count in an integer.
double row_count(const Study& study);

/// Every rule that a study breaks, over all factors at once. Keys are those of study files: "samples",
/// "factors.impactor.speed", "correlations[1]", "responses[2]". Where the factors are sound in themselves,
/// also the rules of the case that their values break: of every combination of levels (up to 100,000, else of
/// every level), and of the ends of every distribution: its cut-offs, or 6 deviations out where a normal or
/// lognormal has none. A rarer combination that makes no valid case becomes a row that is "not run".
std::vector<Violation> violations(const Study& study);

}  // namespace dashpad::study
