// Where, along a factor, the limits come to be kept in most draws.

#include <algorithm>
#include <cmath>
#include <map>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/study/answers.hpp"

namespace dashpad::study {

namespace {

/// The largest ratio of a response to its limit in each draw of a group; NaN where one is missing.
std::map<std::uint64_t, double> ratios_of(const StudyAnswers& answers, const Design& design,
                                          const Group& group) {
  std::vector<double> largest(group.places.size(), -infinite);
  for (const StudyLimit& limit : answers.limits) {
    const auto response =
        std::ranges::find(answers.study.responses, limit.response) - answers.study.responses.begin();
    const std::vector<double> values =
        values_of(answers.study, answers.records, group, static_cast<std::size_t>(response));
    for (std::size_t i = 0; i < values.size(); ++i)
      largest[i] = std::isnan(values[i]) || std::isnan(largest[i])
                       ? no_value
                       : std::max(largest[i], values[i] / limit.value);
  }
  std::map<std::uint64_t, double> ratios;
  for (std::size_t i = 0; i < largest.size(); ++i) {
    const std::uint64_t row = answers.records.rows[group.places[i]];
    if (design.block_of(row) == 0 && !std::isnan(largest[i])) ratios[design.draw_of(row)] = largest[i];
  }
  return ratios;
}

/// A level with the ratios of its draws.
struct AtLevel {
  double level = 0;
  std::size_t group = 0;
  std::map<std::uint64_t, double> ratios;
};

/// Where the ratios of a draw, by ascending place, fall below 1 for good; the first place if they always are,
/// infinite if they are not at the last one. From an infinite ratio the next place counts.
double turn_of(const std::vector<double>& places, const std::vector<double>& ratios) {
  if (ratios.back() > 1) return infinite;
  std::size_t last_above = ratios.size();
  for (std::size_t i = 0; i < ratios.size(); ++i)
    if (ratios[i] > 1) last_above = i;
  if (last_above == ratios.size()) return places.front();
  const double above = ratios[last_above], below = ratios[last_above + 1];
  const double share = std::isinf(above) ? 1 : (above - 1) / (above - below);
  return places[last_above] + share * (places[last_above + 1] - places[last_above]);
}

/// The turn along a line of levels in ascending order.
std::optional<TurningLevel> turn_along(const std::vector<AtLevel>& line) {
  const auto kept = [](const AtLevel& at) {
    return std::ranges::count_if(at.ratios, [](const auto& draw) { return draw.second <= 1; });
  };
  const auto at_first = kept(line.front()), at_last = kept(line.back());
  if (at_first == at_last && (at_first > 0 || std::ranges::any_of(line, kept))) return std::nullopt;
  TurningLevel turn{.example = line.front().group,
                    .kept_above = at_last >= at_first,
                    .first = line.front().level,
                    .last = line.back().level};
  // Downwards, places are levels with the opposite sign.
  const double sign = turn.kept_above ? 1 : -1;
  std::vector<double> places, turns;
  for (const AtLevel& at : line) places.push_back(sign * at.level);
  if (!turn.kept_above) std::ranges::reverse(places);
  for (const auto& [draw, first] : line.front().ratios) {
    std::vector<double> ratios;
    for (const AtLevel& at : line)
      if (const auto found = at.ratios.find(draw); found != at.ratios.end()) ratios.push_back(found->second);
    if (ratios.size() < line.size()) continue;
    if (!turn.kept_above) std::ranges::reverse(ratios);
    turns.push_back(turn_of(places, ratios));
  }
  const std::optional<Estimate> level = quantile(distribution(turns), turning_probability);
  if (!level) return std::nullopt;
  turn.level = {sign * level->value, sign * level->low, sign * level->high};
  if (!turn.kept_above) std::swap(turn.level.low, turn.level.high);
  turn.draws = turns.size();
  return turn;
}

}  // namespace

std::vector<TurningLevel> turning_levels(const StudyAnswers& answers, const Design& design) {
  if (answers.limits.empty() || answers.groups.empty() || !answers.groups.front().group.drawn) return {};
  // The place of a factor among Group::levels.
  std::size_t place = 0, along = 0, factor = answers.study.factors.size(), most = 1;
  for (std::size_t i = 0; i < answers.study.factors.size(); ++i) {
    const Factor& of = answers.study.factors[i];
    if (of.is_sampled()) continue;
    const auto* const levels = std::get_if<Levels>(&of.spread);
    if (levels != nullptr && !of.unit.empty() && levels->values.size() > most) {
      most = levels->values.size();
      factor = i;
      along = place;
    }
    ++place;
  }
  if (factor == answers.study.factors.size()) return {};
  std::map<std::vector<double>, std::vector<AtLevel>> lines;
  for (std::size_t i = 0; i < answers.groups.size(); ++i) {
    const Group& group = answers.groups[i].group;
    std::vector<double> others = group.levels;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(along));
    lines[others].push_back({group.levels[along], i, ratios_of(answers, design, group)});
  }
  std::vector<TurningLevel> turns;
  for (auto& [others, line] : lines) {
    std::ranges::sort(line, {}, &AtLevel::level);
    if (auto turn = turn_along(line)) {
      turn->factor = factor;
      turns.push_back(*turn);
    }
  }
  std::ranges::stable_sort(turns, {}, [](const TurningLevel& turn) { return turn.level.value; });
  return turns;
}

}  // namespace dashpad::study
