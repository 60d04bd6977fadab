// Cushion curves, and all questions about a store.

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/study/answers.hpp"
#include "dashpad/study/design.hpp"
#include "dashpad/study/study_file.hpp"

namespace dashpad::study {

namespace {

std::optional<std::size_t> place_of(const std::vector<std::string>& names, const char* name) {
  const auto place = std::ranges::find(names, name);
  return place == names.end() ? std::nullopt : std::optional{static_cast<std::size_t>(place - names.begin())};
}

bool is_of_cushion_curves(const Study& study) {
  bool has_mass = false;
  for (const Factor& factor : study.factors) {
    std::string_view key = factor.key;
    for (const OtherWay& way : other_ways())
      if (key == way.key) key = way.instead_of;
    const bool is_mass = key == "impactor.mass";
    has_mass = has_mass || is_mass;
    if (factor.is_sampled() || (!is_mass && key != "impactor.speed" && key != "pad.thickness")) return false;
  }
  return has_mass;
}

std::size_t number_of(const Study& study, const std::string& response) {
  const auto place = std::ranges::find(study.responses, response);
  if (place == study.responses.end())
    throw std::invalid_argument("the study keeps no response \"" + response + "\"");
  return static_cast<std::size_t>(place - study.responses.begin());
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
  for (const StudyLimit& limit : answers.limits) {
    const std::size_t response = number_of(answers.study, limit.response);
    of.exceedances.push_back(exceedance(readings_of(answers.study, answers.records, of.group, response),
                                        limit.value, of.group.drawn));
  }
  return of;
}

}  // namespace

std::optional<std::size_t> least_peak(const CushionCurve& curve) {
  const std::vector<double>& peaks = curve.peak_deceleration;
  std::optional<std::size_t> least;
  for (std::size_t i = 0; i < peaks.size(); ++i)
    if (std::isfinite(peaks[i]) && (!least || peaks[i] < peaks[*least])) least = i;
  return least;
}

std::optional<CushionCurves> cushion_curves(const Study& study, const Records& records) {
  const auto deceleration = place_of(study.responses, "peak_acceleration");
  const auto penetration = place_of(study.responses, "peak_penetration");
  if (!is_of_cushion_curves(study) || !deceleration || !penetration) return std::nullopt;

  // By speed and thickness, then by mass.
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
  for (const std::string& name : questions.responses.empty() ? answers.study.responses : questions.responses)
    answers.responses.push_back(number_of(answers.study, name));
  answers.records = read_records(answers.study, store);
  const Design design{answers.study};
  std::vector<Group> groups = study::groups(answers.study, design, answers.records);
  for (std::size_t i = 0; i < groups.size(); ++i)
    answers.groups.push_back(of_group(answers, design, std::move(groups[i]), i));
  answers.cushion_curves = cushion_curves(answers.study, answers.records);
  return answers;
}

}  // namespace dashpad::study
