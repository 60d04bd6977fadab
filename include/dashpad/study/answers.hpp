#pragma once
/// What a finished study says: location, spread, probabilities with intervals, and which factor matters.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dashpad/study/design.hpp"
#include "dashpad/study/store.hpp"
#include "dashpad/study/study.hpp"

namespace dashpad::study {

struct Estimate {
  double value = 0;
  double low = 0, high = 0;  ///< 95 % interval
};

/// Of one response over the rows that have it.
struct Distribution {
  std::string response;
  std::string unit;
  std::uint64_t rows = 0;      ///< with a value
  std::uint64_t without = 0;   ///< without one (the impactor did not leave, tolerance not met ...)
  Estimate mean;               ///< normal interval
  double deviation = 0;
  double least = 0, greatest = 0;
  struct Quantile { double probability = 0; Estimate value; };
  std::vector<Quantile> quantiles;  ///< 1, 5, 25, 50, 75, 95, 99 %: order statistics with distribution-free intervals
};

/// The probability that a response exceeds a limit, with its Clopper-Pearson interval.
struct Exceedance {
  std::string response;
  double limit = 0;  ///< SI
  Estimate probability;
  std::uint64_t exceeding = 0, rows = 0;
};

/// Sobol' indices of a response (Saltelli's design, Jansen's estimators), with bootstrap intervals.
struct Sensitivity {
  std::string response;
  struct Index { std::string factor; Estimate first, total; };
  std::vector<Index> indices;
  std::uint64_t draws = 0;      ///< used: those with all their rows
};

Distribution distribution(const Store& store, const std::string& response);
Exceedance exceedance(const Store& store, const std::string& response, double limit);
/// Absent where the study has no `indices`.
std::optional<Sensitivity> sensitivity(const Study& study, const Design& design, const Store& store,
                                       const std::string& response);

/// The estimators themselves, on plain numbers: `a`, `b` and, for each factor, `mixed`.
struct SaltelliSample {
  std::vector<double> a, b;
  std::vector<std::vector<double>> mixed;  ///< the first matrix with factor i of the second
};
std::vector<Sensitivity::Index> jansen_indices(const SaltelliSample& sample, std::uint64_t bootstrap_seed);

}  // namespace dashpad::study
