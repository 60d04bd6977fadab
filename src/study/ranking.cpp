// Combinations of levels in the order of a response, compared draw by draw.

#include <algorithm>
#include <cmath>
#include <map>

#include "dashpad/study/answers.hpp"

namespace dashpad::study {

std::vector<Ranked> ranking(const StudyAnswers& answers, const Design& design, std::size_t response) {
  std::vector<Ranked> ranked;
  for (std::size_t i = 0; i < answers.groups.size(); ++i) {
    const std::optional<Estimate> median = quantile(answers.groups[i].distributions[response], 0.5);
    if (median && answers.groups[i].group.drawn) ranked.push_back({.group = i, .median = median->value});
  }
  if (ranked.size() < 2) return {};
  std::ranges::stable_sort(ranked, {}, &Ranked::median);
  const auto by_draw = [&](std::size_t group) {
    const Group& of = answers.groups[group].group;
    const std::vector<double> values =
        values_of(answers.study, answers.records, of, answers.responses[response]);
    std::map<std::pair<std::uint64_t, int>, double> draws;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::uint64_t row = answers.records.rows[of.places[i]];
      if (!std::isnan(values[i])) draws[{design.draw_of(row), design.block_of(row)}] = values[i];
    }
    return draws;
  };
  const auto first = by_draw(ranked.front().group);
  for (Ranked& one : ranked) {
    if (&one == &ranked.front()) continue;
    std::vector<double> differences;
    std::vector<Reading> readings;
    for (const auto& [draw, value] : by_draw(one.group)) {
      const auto same = first.find(draw);
      if (same == first.end() || (std::isinf(value) && std::isinf(same->second))) continue;
      differences.push_back(value - same->second);
      readings.push_back({differences.back(), differences.back()});
    }
    one.difference = distribution(differences).mean;
    one.higher = exceedance(readings, 0);
  }
  return ranked;
}

}  // namespace dashpad::study
