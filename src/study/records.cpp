// The rows of a store in memory, and which of them belong together.

#include <algorithm>

#include "dashpad/study/answers.hpp"

namespace dashpad::study {

namespace {

bool is_doubtful(Status status) { return status == Status::tolerance_not_met || status == Status::not_run; }

std::uint64_t combinations(const Study& study) {
  std::uint64_t count = 1;
  for (const Factor& factor : study.factors)
    if (const auto* levels = std::get_if<Levels>(&factor.spread)) count *= levels->values.size();
  return count;
}

}  // namespace

Records read_records(const Study& study, const Store& store) {
  Records records;
  records.factors.resize(study.factors.size());
  records.responses.resize(study.responses.size());
  store.visit_rows([&](const StoredRow& row) {
    records.rows.push_back(row.row);
    for (std::size_t i = 0; i < records.factors.size(); ++i) records.factors[i].push_back(row.factors[i]);
    for (std::size_t i = 0; i < records.responses.size(); ++i)
      records.responses[i].push_back(row.outcome.values[i]);
    if (is_doubtful(row.outcome.status)) ++records.doubtful;
    if (row.outcome.extrapolated) ++records.extrapolated;
    if (row.outcome.bottomed) ++records.bottomed;
  });
  return records;
}

std::uint64_t doubtful_rows(const Store& store) {
  std::uint64_t count = 0;
  store.visit_rows([&](const StoredRow& row) {
    if (is_doubtful(row.outcome.status)) ++count;
  });
  return count;
}

std::vector<Group> groups(const Study& study, const Design& design, const Records& records) {
  const bool drawn =
      std::ranges::any_of(study.factors, [](const Factor& factor) { return factor.is_sampled(); });
  const std::uint64_t count = drawn ? combinations(study) : 1;
  const std::uint64_t each = design.rows() / count;
  std::vector<Group> result(count);
  std::vector<double> values(study.factors.size());
  for (std::uint64_t i = 0; i < count; ++i) {
    result[i].drawn = drawn;
    if (!drawn) break;
    design.factors_of(i * each, values);
    for (std::size_t factor = 0; factor < values.size(); ++factor)
      if (!study.factors[factor].is_sampled()) result[i].levels.push_back(values[factor]);
  }
  for (std::size_t place = 0; place < records.rows.size(); ++place)
    if (design.block_of(records.rows[place]) < 2) result[records.rows[place] / each].places.push_back(place);
  return result;
}

std::vector<double> values_of(const Records& records, const Group& group, std::size_t response) {
  std::vector<double> values;
  values.reserve(group.places.size());
  for (const std::size_t place : group.places) values.push_back(records.responses[response][place]);
  return values;
}

}  // namespace dashpad::study
