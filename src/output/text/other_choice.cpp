// The choice between a standard's nose or speed and the case's, where it turns the verdict.

#include <algorithm>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dashpad/output/assessment.hpp"
#include "output/text/capitals.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// The figure that decides the verdict: that of the criterion with the least relative margin.
std::string decisive_figure(const injury::Assessment& assessment, const UnitSystem& units) {
  const auto margin = [](const injury::CriterionResult& result) {
    return result.relative_margin.value_or(-std::numeric_limits<double>::infinity());
  };
  const injury::CriterionResult& result = *std::ranges::min_element(assessment.results, {}, margin);
  if (!result.value) return "the pad bottoms out";
  const std::string unit = result.criterion.quantity->si_unit;
  return uncapitalised(injury::title_of(result.criterion)) + " " +
         brief_quantity(*result.value, unit, units, 4);
}

std::string nose_text(const Nose& nose, const UnitSystem& units) {
  const auto* const sphere = std::get_if<Sphere>(&nose);
  return with_article(words_of(nose)) +
         (sphere == nullptr ? "" : " of radius " + brief_quantity(sphere->radius, "m", units));
}

}  // namespace

Flag other_choice(const injury::OtherChoice& choice, const injury::Standard& standard,
                  const ImpactCase& given, const UnitSystem& units) {
  std::vector<std::string> values, give, leave_out;
  const auto add = [&](const char* name, bool is_kept, const std::string& value) {
    values.push_back(fmt::format("{} {}, {}", is_kept ? "the case's" : "the standard's", name, value));
    (is_kept ? give : leave_out).push_back(fmt::format("--keep-{}", name));
  };
  if (choice.other.nose)
    add("nose", choice.kept.nose,
        nose_text(choice.kept.nose ? given.impactor.nose : Nose{Sphere{*standard.radius.value}}, units));
  if (choice.other.speed)
    add("speed", choice.kept.speed,
        brief_quantity(choice.kept.speed ? given.impactor.speed : *standard.speed.value, "m/s", units));
  std::string how = give.empty() ? "" : fmt::format("with {}", fmt::join(give, " "));
  if (!leave_out.empty())
    how += fmt::format("{}without {}", how.empty() ? "" : " and ", fmt::join(leave_out, " "));
  const char* const name = !choice.other.speed  ? "OTHER NOSE"
                           : !choice.other.nose ? "OTHER SPEED"
                                                : "OTHER NOSE AND SPEED";
  return {name, fmt::format("{}: with {}, the verdict would be {} ({}); to check, run {}", name,
                            fmt::join(values, ", and "), to_string(choice.assessment.verdict),
                            decisive_figure(choice.assessment, units), how)};
}

}  // namespace dashpad::output
