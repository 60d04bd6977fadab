#include "dashpad/study/batch.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace dashpad::study {

Worker::Worker(const Study& study, const Design& design)
    : study_(study),
      design_(design),
      application_(study),
      responses_(study.responses),
      impact_(study.base),
      factors_(study.factors.size()) {}

const ImpactCase& Worker::case_of(std::uint64_t row) {
  design_.factors_of(row, factors_);
  application_(factors_, impact_);
  return impact_;
}

Solution Worker::replay(std::uint64_t row) { return solver_.solve(case_of(row), study_.options); }

void Worker::compute_row(std::uint64_t row, StoredRow& result) {
  result.row = row;
  try {
    responses_(solver_.solve(case_of(row), study_.options), result.outcome);
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
