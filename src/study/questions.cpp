// Asks the library all questions about a store.

#include <algorithm>
#include <stdexcept>

#include "dashpad/study/questions.hpp"
#include "dashpad/study/stored_study.hpp"

namespace dashpad::study {

namespace {

std::size_t number_of(const Study& study, const std::string& response) {
  const auto place = std::ranges::find(study.responses, response);
  if (place == study.responses.end())
    throw std::invalid_argument("the study keeps no response \"" + response + "\"");
  return static_cast<std::size_t>(place - study.responses.begin());
}

StudyAnswers::OfGroup of_group(const StudyAnswers& answers, const Design& design, Group group,
                               std::size_t combination) {
  StudyAnswers::OfGroup of{
      .group = std::move(group), .distributions = {}, .exceedances = {}, .sensitivities = {}};
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

StudyAnswers study_answers(const Store& store, const StudyQuestions& questions) {
  StudyAnswers answers{.study = stored_study(store),
                       .program = store.program(),
                       .rows = store.rows(),
                       .records = {},
                       .responses = {},
                       .limits = questions.limits,
                       .groups = {},
                       .cushion_curves = {}};
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
