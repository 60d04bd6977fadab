#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>

#include "dashpad/study/run_study.hpp"
#include "uncertainty/foam_factors.hpp"

namespace dashpad::study {

Worker::Worker(const Study& study, const Design& design)
    : study_(study),
      design_(design),
      application_(study),
      responses_(study.responses),
      impact_(study.base),
      factors_(study.factors.size()) {
  for (std::size_t i = 0; i < study.factors.size(); ++i)
    if (uncertainty::is_foam_factor(study.factors[i].key)) of_foam_.push_back(i);
}

Worker::~Worker() = default;
Worker::Worker(Worker&&) noexcept = default;

const ImpactCase& Worker::case_of(std::uint64_t row) {
  design_.factors_of(row, factors_);
  if (of_foam_.empty()) {
    application_(factors_, impact_);
    return impact_;
  }
  // A drawn foam is another material: the next row begins with the one of the card.
  impact_ = study_.base;
  application_(factors_, impact_);
  uncertainty::FoamDraw::Numbers numbers;
  for (const std::size_t i : of_foam_) numbers.emplace_back(study_.factors[i].key, factors_[i]);
  const Summary nominal = solver_.solve(impact_, study_.options).summary;
  draw_ = std::make_unique<const uncertainty::FoamDraw>(numbers, nominal, impact_);
  return impact_;
}

const Solution& Worker::solve(Outcome& outcome) {
  const Solution* last = nullptr;
  if (responses_.needs_blows()) {
    solver_.solve_each_blow(impact_, study_.options, [&](const ImpactCase&, const Solution& solution) {
      responses_(solution, outcome);
      last = &solution;
    });
  } else {
    last = &solver_.solve(impact_, study_.options);
    responses_(*last, outcome);
  }
  if (draw_)
    for (std::size_t i = 0; i < outcome.values.size(); ++i) {
      const ResultQuantity& kind = *find_response_kind(study_.responses[i]);
      const double drawn = draw_->figure(kind, outcome.values[i], last->summary);
      outcome.values[i] = is_possible(kind, drawn) ? drawn : no_value;
    }
  return *last;
}

Solution Worker::replay(std::uint64_t row, Outcome& outcome) {
  case_of(row);
  return solve(outcome);
}

void Worker::compute_row(std::uint64_t row, StoredRow& result) {
  result.row = row;
  try {
    case_of(row);
    solve(result.outcome);
  } catch (const std::invalid_argument&) {
    result.outcome = {};
    result.outcome.values.assign(study_.responses.size(), std::numeric_limits<double>::quiet_NaN());
  }
  result.factors = factors_;
}

void Worker::compute(std::uint64_t batch, std::uint64_t size, std::vector<StoredRow>& rows) {
  const std::uint64_t total = design_.rows();
  const std::uint64_t begin = size == 0 || batch > total / size ? total : batch * size;
  const std::uint64_t end = begin + std::min(size, total - begin);
  rows.resize(end - begin);
  for (std::uint64_t row = begin; row < end; ++row) compute_row(row, rows[row - begin]);
}

std::vector<StoredRow> Worker::compute(std::uint64_t batch, std::uint64_t size) {
  std::vector<StoredRow> rows;
  compute(batch, size, rows);
  return rows;
}

}  // namespace dashpad::study
