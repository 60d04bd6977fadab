#include "dashpad/study/study.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/study/responses.hpp"
#include "input/spelling.hpp"
#include "model/parameter_values.hpp"
#include "study/checked_cases.hpp"
#include "study/foam_factors.hpp"
#include "study/sampling.hpp"

namespace dashpad::study {
namespace {

void check_key(const Study& study, const Factor& factor, const std::vector<FactorKey>& known,
               std::vector<Violation>& broken) {
  if (!std::ranges::count(known, factor.key, &FactorKey::key))
    broken.push_back({"factors." + factor.key, no_value, rule_for_unknown(factor.key, study.base, known)});
  const auto first = std::ranges::find(study.factors, factor.key, &Factor::key);
  if (&*first != &factor) broken.push_back({"factors." + factor.key, no_value, "is given twice"});
}

void check_conflicts(const Study& study, std::vector<Violation>& broken) {
  const auto has = [&](const std::string& key) {
    return std::ranges::any_of(study.factors,
                               [&](const Factor& factor) { return factor.key.starts_with(key); });
  };
  for (const OtherWay& way : other_ways())
    if (has(way.key) && has(way.instead_of))
      broken.push_back({std::string("factors.") + way.key, no_value,
                        fmt::format("give {} or {}, not both", way.instead_of, way.key)});
  if (has("impactor.gravity") && has("impactor.drop_height"))
    broken.push_back({"factors.impactor.drop_height", no_value,
                      "the impact speed depends on both drop height and gravity: vary only one of them"});
  if (has(static_stress) && (has("impactor.mass") || has("impactor.weight")))
    broken.push_back({std::string("factors.") + static_stress, no_value,
                      "the mass follows from it: vary one or the other"});
  if (has("support.stiffness") && has("support.scale"))
    broken.push_back(
        {"factors.support.scale", no_value, "give support.stiffness or support.scale, not both"});
  const bool varies_law = std::ranges::any_of(study.factors, is_of_law, &Factor::key);
  if (has("pad.material") && varies_law)
    broken.push_back({"factors.pad.material", no_value,
                      "parameters and curves belong to the material of the case: vary the material or its "
                      "numbers, not both"});
}

void check_materials(const Study& study, const Factor& factor, std::vector<Violation>& broken) {
  const std::string key = "factors." + factor.key;
  const std::vector<double>* const given = factor.given_values();
  if (!given) {
    broken.push_back({key, no_value, "give the materials as values = [\"name\", ...]"});
    return;
  }
  for (const double value : *given)
    if (!(value >= 0 && value < static_cast<double>(study.materials.size()) && value == std::floor(value)))
      broken.push_back({key, value, "is not the number of a material"});
  for (std::size_t i = 0; i < study.materials.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (study.materials[i].name == study.materials[j].name) {
        broken.push_back(
            {key, no_value, fmt::format("contains two materials called {}", study.materials[i].name)});
        break;
      }
}

void check_factor(const Study& study, const Factor& factor, const std::vector<FoamFactor>& of_foam,
                  std::vector<Violation>& broken) {
  const std::string key = "factors." + factor.key;
  if (factor.key == "pad.material") check_materials(study, factor, broken);
  if (const auto* levels = std::get_if<Levels>(&factor.spread)) {
    if (levels->values.empty()) broken.push_back({key, no_value, "must have at least one level"});
    if (std::ranges::any_of(levels->values, [](double value) { return !std::isfinite(value); }))
      broken.push_back({key, no_value, "the levels must be finite numbers"});
  }
  const std::string rule = rule_broken_by(factor);
  if (!rule.empty()) return broken.push_back({key, no_value, rule});
  const auto found = std::ranges::find(of_foam, factor.key, &FoamFactor::key);
  if (found != of_foam.end()) check_foam_factor(factor, *found, broken);
}

void check_factors(const Study& study, std::vector<Violation>& broken) {
  const std::vector<FactorKey> known = factor_keys(study);
  const std::vector<FoamFactor> of_foam = foam_factors(study);
  for (const Factor& factor : study.factors) {
    check_key(study, factor, known, broken);
    check_factor(study, factor, of_foam, broken);
  }
}

/// The columns of a table are equally long and hold finite numbers.
template <class Column>
void check_table(const Study& study, const char* key, std::vector<Violation>& broken) {
  std::size_t rows = 0;
  for (const Factor& factor : study.factors) {
    const auto* const column = std::get_if<Column>(&factor.spread);
    if (column == nullptr) continue;
    const std::vector<double>& values = column->values;
    if (rows == 0) rows = values.size();
    if (values.empty() || values.size() != rows ||
        std::ranges::any_of(values, [](double value) { return !std::isfinite(value); }))
      broken.push_back({key, no_value, fmt::format("{} must have a finite number in each row", factor.key)});
  }
}

void check_tables(const Study& study, std::vector<Violation>& broken) {
  check_table<ByRow>(study, "rows", broken);
  check_table<ByDraw>(study, "samples_from", broken);
  for (const RowLabel& label : study.labels)
    if (label.texts.size() != table_rows(study))
      broken.push_back({"rows", no_value, fmt::format("{} must have a text in each row", label.name)});
  const bool draws_together = std::ranges::any_of(
      study.factors, [](const Factor& factor) { return std::holds_alternative<ByDraw>(factor.spread); });
  if (draws_together && study.indices)
    broken.push_back(
        {"indices", no_value,
         "Sobol' indices are defined for independent factors: leave out samples_from or indices"});
}

void check_correlations(const Study& study, std::vector<Violation>& broken) {
  const auto& all = study.correlations;
  const auto sampled = [&](std::size_t i) {
    return i < study.factors.size() && study.factors[i].is_sampled();
  };
  // Each is compared with all before it: of thousands, there would be millions of faults.
  if (const std::size_t pairs = study.factors.size() * study.factors.size() / 2; all.size() > pairs) {
    broken.push_back({"correlations", no_value,
                      fmt::format("there are {} correlations, but fewer pairs of factors", all.size())});
    return;
  }
  bool good = true;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto add = [&](double value, const char* rule) {
      broken.push_back({fmt::format("correlations[{}]", i + 1), value, rule});
      good = false;
    };
    const auto drawn_together = [&](std::size_t factor) {
      return std::holds_alternative<ByDraw>(study.factors[factor].spread);
    };
    if (!sampled(all[i].first) || !sampled(all[i].second))
      add(no_value, "must name two factors that have a distribution");
    else if (drawn_together(all[i].first) || drawn_together(all[i].second))
      add(no_value, "factors of samples_from have the correlations of its rows");
    else if (all[i].first == all[i].second)
      add(no_value, "must name two different factors");
    if (!(all[i].value > -1 && all[i].value < 1)) add(all[i].value, "must be more than -1 and less than 1");
    for (std::size_t j = 0; j < i; ++j)
      if (std::minmax(all[i].first, all[i].second) == std::minmax(all[j].first, all[j].second))
        add(no_value, "the correlation between these two is given twice");
  }
  if (good && !root_of_correlations(study))
    broken.push_back({"correlations", no_value,
                      "contradict one another: their matrix is not positive definite, so no quantities can "
                      "have these correlations"});
  if (study.indices && !all.empty())
    broken.push_back(
        {"correlations", no_value,
         "Sobol' indices are defined only for independent factors: leave out correlations or indices"});
}

void check_responses(const Study& study, std::vector<Violation>& broken) {
  std::vector<std::string> known;
  for (const ResultQuantity& kind : response_kinds()) known.emplace_back(kind.key);
  if (study.responses.empty()) broken.push_back({"responses", no_value, "must name at least one response"});
  if (study.responses.size() > 2 * known.size()) {
    broken.push_back({"responses", no_value,
                      fmt::format("contains {} names, but there are only {} responses",
                                  study.responses.size(), known.size())});
    return;
  }
  for (std::size_t i = 0; i < study.responses.size(); ++i) {
    const std::string key = fmt::format("responses[{}]", i + 1), &name = study.responses[i];
    const int blows = study.base.blows ? study.base.blows->count : 1;
    const auto response = find_response(name);
    if (!response)
      broken.push_back(
          {key, no_value,
           find_response(name.substr(0, name.find('.'))) && name.find('.') != std::string::npos
               ? name + " is not a response; of repeated blows write NAME.blow_2 or NAME.mean_2_5"
               : name + " is not a response" + input::meant_or_listed(name, known)});
    else if (response->last_blow > blows)
      broken.push_back({key, no_value,
                        fmt::format("{}: the case has {}", name,
                                    study.base.blows ? fmt::format("only {} blows", blows)
                                                     : "no [blows], that is a single blow")});
    if (std::find(study.responses.begin(), study.responses.begin() + static_cast<std::ptrdiff_t>(i), name) !=
        study.responses.begin() + static_cast<std::ptrdiff_t>(i))
      broken.push_back({key, no_value, name + " is given twice"});
  }
}

void check_size(const Study& study, std::vector<Violation>& broken) {
  const std::size_t sampled = sampled_factors(study).size();
  if (study.samples < 1) broken.push_back({"samples", 0, "must be at least 1"});
  if (sampled == 0 && study.samples > 1)
    broken.push_back(
        {"samples", static_cast<double>(study.samples), "no factor has a distribution to draw from"});
  if (sampled == 0 && study.indices)
    broken.push_back({"indices", no_value, "Sobol' indices need at least one factor with a distribution"});
  if (study.sampling == Sampling::sobol && 2 * sampled > Sobol::max_dimensions)
    broken.push_back({"factors", static_cast<double>(sampled), "too many sampled factors for Sobol points"});
  const double rows = row_count(study);
  if (rows > static_cast<double>(max_rows))
    broken.push_back({sampled ? "samples" : "factors", rows,
                      fmt::format("the study would have {:.4g} rows; at most {:.0e} are allowed", rows,
                                  static_cast<double>(max_rows))});
}

}  // namespace

const std::vector<double>* Factor::given_values() const {
  if (const auto* levels = std::get_if<Levels>(&spread)) return &levels->values;
  const auto* by_row = std::get_if<ByRow>(&spread);
  return by_row ? &by_row->values : nullptr;
}

std::size_t table_rows(const Study& study) {
  for (const Factor& factor : study.factors)
    if (const auto* by_row = std::get_if<ByRow>(&factor.spread)) return by_row->values.size();
  return 1;
}

std::size_t table_row_of(const Study& study, std::uint64_t row) {
  const auto each = static_cast<std::uint64_t>(row_count(study)) / table_rows(study);
  return static_cast<std::size_t>(row / each);
}

double row_count(const Study& study) {
  const std::size_t sampled = sampled_factors(study).size();
  double rows = static_cast<double>(study.samples) * static_cast<double>(study.indices ? 2 + sampled : 1) *
                static_cast<double>(table_rows(study));
  for (const Factor& factor : study.factors)
    if (const auto* levels = std::get_if<Levels>(&factor.spread))
      rows *= static_cast<double>(levels->values.size());
  return rows;
}

std::vector<Violation> violations(const Study& study) {
  std::vector<Violation> broken;
  if (study.factors.empty()) broken.push_back({"factors", no_value, "a study needs at least one factor"});
  check_factors(study, broken);
  check_tables(study, broken);
  check_conflicts(study, broken);
  check_correlations(study, broken);
  check_responses(study, broken);
  check_size(study, broken);
  check_bounds(study.options, "", broken);
  if (broken.empty()) broken = violations_of_cases(study);
  return broken;
}

}  // namespace dashpad::study
