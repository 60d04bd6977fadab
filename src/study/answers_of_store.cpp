// Cushion curves, and all questions about a store.

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/study/answers.hpp"
#include "dashpad/study/study.hpp"
#include "dashpad/study/study_file.hpp"

namespace dashpad::study {
namespace {

std::optional<std::size_t> place_of(const std::vector<std::string>& names, const std::string& name) {
  const auto place = std::ranges::find(names, name);
  return place == names.end() ? std::nullopt : std::optional{static_cast<std::size_t>(place - names.begin())};
}

bool is_of_cushion_curves(const Study& study) {
  bool has_mass = false;
  for (const Factor& factor : study.factors) {
    const std::string key = decided_by(factor.key);
    const bool is_mass = key == "impactor.mass";
    has_mass = has_mass || is_mass;
    if (factor.is_sampled() || (!is_mass && key != "impactor.speed" && key != "pad.thickness")) return false;
  }
  return has_mass;
}

/// The first response of a kind: that of the last blow, or of others.
std::optional<std::size_t> place_of_kind(const Study& study, const std::string& key) {
  for (std::size_t i = 0; i < study.responses.size(); ++i)
    if (const ResultQuantity* kind = find_response_kind(study.responses[i]); kind && kind->key == key)
      return i;
  return std::nullopt;
}

std::size_t number_of(const Study& study, const std::string& response) {
  const std::optional<std::size_t> place = place_of(study.responses, response);
  if (!place) throw std::invalid_argument("the study does not store the response \"" + response + "\"");
  return *place;
}

StudyAnswers::OfGroup of_group(const StudyAnswers& answers, const Design& design, Group group,
                               std::size_t combination) {
  StudyAnswers::OfGroup of;
  of.group = std::move(group);
  for (const std::size_t response : answers.responses) {
    of.distributions.push_back(
        distribution(values_of(answers.study, answers.records, of.group, response), of.group.drawn));
    of.sensitivities.push_back(sensitivity(answers.study, design, answers.records, combination, response));
  }
  std::vector<Reading> largest(of.group.places.size(), {-infinite, -infinite});
  for (const StudyLimit& limit : answers.limits) {
    const std::size_t response = number_of(answers.study, limit.response);
    const std::vector<Reading> rows = readings_of(answers.study, answers.records, of.group, response);
    of.exceedances.push_back(exceedance(rows, limit.value, of.group.drawn));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      largest[i].low = std::max(largest[i].low, rows[i].low / limit.value);
      largest[i].high = std::max(largest[i].high, rows[i].high / limit.value);
    }
  }
  if (answers.limits.size() > 1) of.any = exceedance(largest, 1, of.group.drawn);
  return of;
}

std::vector<std::string> names_of(const std::vector<StoredColumn>& columns) {
  std::vector<std::string> names;
  for (const StoredColumn& column : columns) names.push_back(column.name);
  return names;
}

bool grows_with_force(const Study& study, std::size_t response) {
  const ResultQuantity* kind = find_response_kind(study.responses[response]);
  return kind != nullptr && kind->role.growth == Growth::with_force;
}

/// The levels of each factor, or its values in a table of rows, in order; none of one that is sampled.
std::vector<std::vector<double>> sorted_levels(const Study& study) {
  std::vector<std::vector<double>> all;
  for (const Factor& factor : study.factors) {
    const std::vector<double>* const given = factor.given_values();
    all.push_back(given ? *given : std::vector<double>{});
    std::ranges::sort(all.back());
  }
  return all;
}

}  // namespace

std::optional<std::size_t> min_peak(const CushionCurve& curve) {
  const std::vector<double>& peaks = curve.peak_deceleration;
  std::optional<std::size_t> least;
  for (std::size_t i = 0; i < peaks.size(); ++i)
    if (std::isfinite(peaks[i]) && (!least || peaks[i] < peaks[*least])) least = i;
  return least;
}

std::optional<CushionCurves> cushion_curves(const Study& study, const Records& records) {
  const auto deceleration = place_of_kind(study, "peak_acceleration");
  const auto penetration = place_of_kind(study, "peak_penetration");
  if (!is_of_cushion_curves(study) || !deceleration || !penetration) return std::nullopt;

  // Rows by speed and thickness, then by mass.
  std::map<double, std::map<double, std::map<double, std::size_t>>> places;
  ImpactCase impact = study.base;
  std::vector<double> factors(study.factors.size());
  const Application apply{study};
  for (std::size_t place = 0; place < records.rows.size(); ++place) {
    for (std::size_t i = 0; i < factors.size(); ++i) factors[i] = records.factors[i][place];
    apply(factors, impact);
    places[impact.impactor.speed][impact.pad.thickness][impact.impactor.mass] = place;
  }
  CushionCurves curves;
  curves.whole_cushion = study.base.pad.area && sections_of(study.base).tip == *study.base.pad.area;
  for (const auto& [speed, by_thickness] : places) {
    CushionCurves::Drop drop{.height = speed * speed / (2 * standard_gravity), .speed = speed, .curves = {}};
    for (const auto& [thickness, by_mass] : by_thickness) {
      CushionCurve curve{.thickness = thickness, .static_stress = {}, .peak_deceleration = {}};
      for (const auto& [mass, place] : by_mass) {
        const double area = sections_of(study.base).area(records.responses[*penetration][place]);
        curve.static_stress.push_back(mass * standard_gravity / area);
        curve.peak_deceleration.push_back(records.responses[*deceleration][place]);
      }
      drop.curves.push_back(std::move(curve));
    }
    curves.drops.push_back(std::move(drop));
  }
  return curves;
}

StudyAnswers study_answers(const Store& store, const StudyQuestions& questions) {
  StudyAnswers answers;
  answers.study = stored_study(store);
  answers.program = store.program();
  answers.rows = store.rows();
  answers.limits = questions.limits;
  answers.reservations = questions.reservations;
  for (const std::string& name : questions.responses.empty() ? answers.study.responses : questions.responses)
    answers.responses.push_back(number_of(answers.study, name));
  answers.records = read_records(answers.study, store);
  const Design design{answers.study};
  std::vector<Group> groups = study::groups(answers.study, design, answers.records);
  for (std::size_t i = 0; i < groups.size(); ++i)
    answers.groups.push_back(of_group(answers, design, std::move(groups[i]), i));
  for (std::size_t i = 0; i < answers.responses.size(); ++i)
    answers.rankings.push_back(ranking(answers, design, i));
  answers.turns = turning_levels(answers, design);
  answers.cushion_curves = cushion_curves(answers.study, answers.records);
  return answers;
}

Records read_records(const Study& study, const Store& store) {
  const std::vector<std::vector<double>> levels = sorted_levels(study);
  Records records;
  records.factors.resize(study.factors.size());
  records.responses.resize(study.responses.size());
  store.visit_rows([&](const StoredRow& row) {
    records.rows.push_back(row.row);
    for (std::size_t i = 0; i < records.factors.size(); ++i) {
      if (!study.factors[i].is_sampled() && !std::ranges::binary_search(levels[i], row.factors[i]))
        throw DamagedStore(
            fmt::format("{}: the store is damaged ({} = {} in row {}, which is not one of its levels); "
                        "delete it and run the study again",
                        store.file(), study.factors[i].key, row.factors[i], row.row));
      records.factors[i].push_back(row.factors[i]);
    }
    for (std::size_t i = 0; i < records.responses.size(); ++i)
      records.responses[i].push_back(row.outcome.values[i]);
    records.statuses.push_back(row.outcome.status);
    if (is_doubtful(row.outcome, study.responses)) ++records.doubtful;
    if (row.outcome.extrapolated != 0) ++records.extrapolated;
    if ((row.outcome.extrapolated & extrapolated_strain) != 0) ++records.beyond_strain;
    if ((row.outcome.extrapolated & extrapolated_rate) != 0) ++records.beyond_rate;
    if (row.outcome.bottomed) ++records.bottomed;
    if (row.outcome.status == Status::bottomed_out) ++records.struck_through;
    if (row.outcome.status == Status::time_limit) ++records.time_limit;
  });
  return records;
}

bool is_doubtful(const Outcome& outcome, std::span<const std::string> responses) {
  if (outcome.status == Status::tolerance_not_met || outcome.status == Status::not_run) return true;
  for (std::size_t i = 0; i < responses.size(); ++i) {
    const ResultQuantity* kind = find_response_kind(responses[i]);
    if (kind != nullptr && std::isnan(outcome.values.at(i)) && has_response(*kind, outcome.status))
      return true;
  }
  return false;
}

RowCounts row_counts(const Store& store) {
  const std::vector<std::string> responses = names_of(store.responses());
  RowCounts counts;
  store.visit_rows([&](const StoredRow& row) {
    if (is_doubtful(row.outcome, responses)) ++counts.doubtful;
    if (row.outcome.status == Status::bottomed_out) ++counts.struck_through;
  });
  return counts;
}

std::vector<Group> groups(const Study& study, const Design& design, const Records& records) {
  const bool drawn = std::ranges::any_of(study.factors, &Factor::is_sampled);
  const std::uint64_t each = drawn ? design.rows_of_combination() : design.rows();
  const std::uint64_t count = design.rows() / each;
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

std::vector<double> values_of(const Study& study, const Records& records, const Group& group,
                              std::size_t response) {
  const bool unbounded = grows_with_force(study, response);
  const auto of = find_response(study.responses[response]);
  const bool is_of_last = !of || of->first_blow == 0;  // the blow that bottomed out
  std::vector<double> values;
  values.reserve(group.places.size());
  for (const std::size_t place : group.places) {
    const double value = records.responses[response][place];
    const bool has_bottomed = records.statuses[place] == Status::bottomed_out;
    values.push_back(unbounded && has_bottomed && (is_of_last || std::isnan(value)) ? infinite : value);
  }
  return values;
}

std::vector<Reading> readings_of(const Study& study, const Records& records, const Group& group,
                                 std::size_t response) {
  const ResultQuantity* kind = find_response_kind(study.responses[response]);
  const bool grows = kind != nullptr && kind->role.growth != Growth::none;
  const std::vector<double> values = values_of(study, records, group, response);
  std::vector<Reading> readings;
  readings.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Status status = records.statuses[group.places[i]];
    const bool is_final =
        status == Status::released || status == Status::at_rest || status == Status::bottomed_out;
    const bool is_known = !std::isnan(values[i]) && (is_final || (status == Status::time_limit && grows));
    const double value = values[i];
    readings.push_back({is_known ? value : -infinite, is_known && is_final ? value : infinite});
  }
  return readings;
}

}  // namespace dashpad::study
