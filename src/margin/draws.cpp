// Draws at a value of the key: the excess of each, quantiles, and what explains the scatter.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <boost/math/distributions/binomial.hpp>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/study/run_study.hpp"
#include "margin/evaluation.hpp"

namespace dashpad::margin {

namespace {

/// Ranks of values, from 0.
std::vector<double> ranks_of(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
  std::vector<double> ranks(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) ranks[order[i]] = static_cast<double>(i);
  return ranks;
}

/// The squared correlation of ranks (Spearman).
double squared_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const double middle = static_cast<double>(a.size() - 1) / 2;
  double both = 0, one = 0, other = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    both += (a[i] - middle) * (b[i] - middle);
    one += (a[i] - middle) * (a[i] - middle);
    other += (b[i] - middle) * (b[i] - middle);
  }
  return both * both / (one * other);
}

}  // namespace

Draws draws_at(const Question& question, double value) {
  const std::vector<Limit> limits = limits_of(question);
  Draws draws;
  draws.excess.assign(question.chance->draws, -infinite);
  std::size_t first_limit = 0;
  for (const Judged& judged : question.impacts) {
    const study::Study study = study_of(question, judged, {value});
    const study::Design design(study);
    const std::size_t count = study.responses.size();
    for (std::size_t j = 0; j < count; ++j) draws.figures.emplace_back(design.rows(), no_value);
    const bool is_first = draws.factors.empty();
    if (is_first) draws.factors.resize(design.rows());
    constexpr std::uint64_t batch = 32;
    oneapi::tbb::enumerable_thread_specific<study::Worker> workers(
        [&] { return study::Worker(study, design); });
    oneapi::tbb::parallel_for(
        std::uint64_t{0}, (design.rows() + batch - 1) / batch, [&](std::uint64_t number) {
          for (study::StoredRow& row : workers.local().compute(number, batch)) {
            for (std::size_t j = 0; j < count; ++j) {
              const Limit& limit = limits[first_limit + j];
              double figure = row.outcome.values[j];
              if (row.outcome.status == Status::tolerance_not_met) figure = no_value;
              const Growth growth = limit.figure->role.growth;
              if (row.outcome.status == Status::bottomed_out && growth == Growth::with_force)
                figure = infinite;
              if (row.outcome.status == Status::time_limit && growth != Growth::none)
                figure = known_part(limit, figure, true);
              draws.figures[first_limit + j][row.row] = figure;
              double excess = excess_of(limit, figure);
              if (std::isnan(excess)) excess = infinite;
              draws.excess[row.row] = std::max(draws.excess[row.row], excess);
            }
            if (is_first) draws.factors[row.row] = std::move(row.factors);
          }
        });
    first_limit += count;
  }
  return draws;
}

Place place_of(const Question& question, double value, const Draws& draws) {
  const std::vector<Limit> limits = limits_of(question);
  const std::size_t count = draws.excess.size();
  const double probability = question.chance->probability;
  // Of `count` sorted values that with the given number of them at or below it.
  const auto ranked = [count](std::vector<double> values, double rank) {
    const auto place = static_cast<std::size_t>(std::clamp(rank, 1.0, static_cast<double>(count)) - 1);
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(place));
    return values[place];
  };
  const double rank = std::ceil(probability * static_cast<double>(count) - 1e-9);
  const boost::math::binomial_distribution<> below(static_cast<double>(count), probability);
  Place place{.value = value};
  place.excess = ranked(draws.excess, rank);
  // The ranks between which the quantile lies with 95 % (independent draws); too few draws have none.
  const double low_rank = std::floor(quantile(below, 0.025));
  const double high_rank = std::ceil(quantile(complement(below, 0.025))) + 1;
  place.low = low_rank < 1 ? -infinite : ranked(draws.excess, low_rank);
  place.high = high_rank > static_cast<double>(count) ? infinite : ranked(draws.excess, high_rank);
  place.share =
      static_cast<double>(std::ranges::count_if(draws.excess, [](double excess) { return excess <= 0; })) /
      static_cast<double>(count);
  double worst = -infinite;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    std::vector<double> excess(count);
    std::ranges::transform(draws.figures[i], excess.begin(), [&](double figure) {
      return std::isnan(figure) ? infinite : excess_of(limits[i], figure);
    });
    // Back to the figure, so that it is the quantile on the side of the limit.
    const double at = ranked(std::move(excess), rank);
    const double share = std::sinh(at) * (limits[i].at_least ? -1 : 1);
    place.figures.push_back(limits[i].value + share * std::abs(limits[i].value));
    if (at > worst) worst = at, place.worst = i;
  }
  return place;
}

std::vector<Contributor> contributors_of(const Question& question, double value, const Draws& draws) {
  const study::Study study = study_of(question, question.impacts.front(), {value});
  const std::vector<double> excess = ranks_of(draws.excess);
  std::vector<Contributor> contributors;
  for (std::size_t factor = 1; factor < study.factors.size(); ++factor) {
    std::vector<double> values;
    for (const std::vector<double>& row : draws.factors) values.push_back(row[factor]);
    contributors.push_back({study.factors[factor].key, squared_correlation(ranks_of(values), excess)});
  }
  std::ranges::stable_sort(contributors, std::ranges::greater{}, &Contributor::share);
  return contributors;
}

}  // namespace dashpad::margin
