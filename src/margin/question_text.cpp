#include "margin/question_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/study/responses.hpp"
#include "input/measurement/measurement_text.hpp"
#include "input/option_values.hpp"
#include "input/spelling.hpp"

namespace dashpad::margin {

input::Reading<Limit> read_limit(const std::string& text) {
  const std::size_t sign = text.find_first_of("<>=");
  const auto refused = [&](const std::string& rule) {
    return input::fault_of_file(fmt::format(R"(--until "{}")", text), rule);
  };
  if (sign == std::string::npos)
    return refused(R"(must compare a figure with a value, as in "hic15 <= 700")");
  const std::size_t behind = text.find_first_not_of("<>=", sign);
  const std::string comparison = text.substr(sign, behind == std::string::npos ? behind : behind - sign);
  const std::string name(input::without_blanks(text.substr(0, sign)));
  std::vector<std::string> names;
  for (const ResultQuantity& kind : study::response_kinds()) names.emplace_back(kind.key);
  const ResultQuantity* const figure = study::find_response_kind(name);
  if (figure == nullptr || name != figure->key)
    return refused("no such figure" + input::meant_or_listed(name, names));
  constexpr std::array comparisons{"<=", "<", "=", "==", ">=", ">"};
  if (behind == std::string::npos || std::ranges::find(comparisons, comparison) == comparisons.end())
    return refused(R"(the comparison must be <=, >= or =, followed by a value)");
  const auto value =
      input::read_option("--until", std::string(input::without_blanks(text.substr(behind))), figure->si_unit);
  if (!value) return value.faults();
  if (!(std::abs(*value) > 0)) return refused("the value must not be 0");
  if (*value < 0 && !figure->role.is_signed) return refused("the figure is never below 0");
  return Limit{.figure = figure,
               .value = *value,
               .at_least = comparison.front() == '>',
               .is_aim = comparison.front() == '=',
               .title = figure->title};
}

std::vector<input::Fault> faults_of_aims(const std::vector<Limit>& limits, std::size_t others) {
  if (limits.size() + others < 2 || std::ranges::none_of(limits, &Limit::is_aim)) return {};
  return input::fault_of_file(
      "--until", "= asks where one figure has a value, without other limits and --vary; use <= or >=");
}

Judged judged_by(std::vector<Limit> limits, const ImpactCase& impact, const std::string& key) {
  Judged judged{.impact = impact, .limits = std::move(limits)};
  if (key == "impactor.drop_height" && judged.impact.impactor.gravity == 0)
    judged.impact.impactor.gravity = standard_gravity;
  return judged;
}

std::vector<input::Fault> faults_of(const Question& question) {
  std::vector<input::Fault> faults;
  for (const Violation& violation : violations(question)) {
    constexpr std::string_view factors = "factors.";
    std::string name = violation.key, rule = violation.rule;
    if (name.starts_with(factors)) name.erase(0, factors.size());
    // The rule of a case names its number and value itself.
    if (const std::size_t end = rule.find(": "); rule.starts_with(name) && end != std::string::npos) {
      name = rule.substr(0, end);
      rule.erase(0, end + 2);
    }
    faults.push_back({.file = name, .key = "", .value = "", .rule = rule});
  }
  return faults;
}

}  // namespace dashpad::margin
