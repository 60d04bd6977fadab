#include "margin/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/study/responses.hpp"
#include "dashpad/uncertainty/intervals.hpp"
#include "injury/short_spike.hpp"
#include "model/parameter_values.hpp"

namespace dashpad::margin {

namespace {

/// A figure, and the ends of its interval.
struct Read {
  double value = no_value, low = no_value, high = no_value;
};

Read without_interval(double value) { return {value, value, value}; }

Read read_criterion(const Limit& limit, const injury::CriterionResult& result, const Summary& summary) {
  if (bottomed_on_rigid_support(summary)) return without_interval(infinite);
  if (!result.value) return {};
  Read read = without_interval(known_part(limit, *result.value, result.lower_bound));
  if (result.interval && !std::isnan(read.value))
    read.low = result.interval->low, read.high = result.interval->high;
  return read;
}

Read read_figure(const Limit& limit, const Solution& solution) {
  const std::vector<std::string> names{limit.figure->key};
  study::ResponseReader reader(names);
  study::Outcome outcome;
  reader(solution, outcome);
  const Growth growth = limit.figure->role.growth;
  const Summary& summary = solution.summary;
  if (bottomed_on_rigid_support(summary) && growth == Growth::with_force) return without_interval(infinite);
  Read read =
      without_interval(known_part(limit, outcome.values.front(), growth != Growth::none && is_cut(summary)));
  if (const auto& intervals = summary.intervals; intervals && !std::isnan(read.value))
    if (const FigureInterval* interval = intervals->find(limit.figure->key)) {
      read.low = interval->low;
      read.high = interval->high;
    }
  return read;
}

std::string why_none(const Limit& limit, const Summary& summary) {
  if (summary.status == Status::tolerance_not_met) return "the tolerance is not met";
  return fmt::format("the impact has no {} ({})", title_in_sentence(*limit.figure),
                     to_string(summary.status));
}

/// The limit that is exceeded by most, or else the first that is unknown, or that with the least to spare.
std::size_t worst_of(const std::vector<double>& excess) {
  const auto rank = [](double one) { return std::isnan(one) ? 0.0 : one; };
  const auto is_less = [&](double a, double b) {
    return rank(a) < rank(b) || (rank(a) == rank(b) && !std::isnan(a) && std::isnan(b));
  };
  return static_cast<std::size_t>(std::ranges::max_element(excess, is_less) - excess.begin());
}

/// Flags of an impact that none of those before it had.
void add_reservations(const Judged& judged, const std::optional<injury::Assessment>& assessment,
                      const Summary& summary, std::vector<Flag>& reservations) {
  std::vector<std::string> keys;
  for (const Limit& limit : judged.limits) keys.emplace_back(limit.figure->key);
  for (const Flag& flag : assessment ? assessment->reservations : flags(summary, keys))
    if (flag.name != injury::short_spike_name &&  // by the limits of the standard without those of the user
        std::ranges::find(reservations, flag.text, &Flag::text) == reservations.end())
      reservations.push_back(flag);
}

/// The reservation about a spike that none of these limits of one impact sees.
std::optional<Flag> short_spike(std::span<const Limit> limits, const Summary& summary) {
  std::vector<injury::UpperLimit> upper;
  for (const Limit& limit : limits)
    if (!limit.at_least && !limit.is_aim) upper.push_back({limit.figure, limit.level, limit.value});
  return injury::short_spike(summary, upper);
}

}  // namespace

double known_part(const Limit& limit, double value, bool is_lower_bound) {
  const bool is_decided = !limit.at_least && value > limit.value;
  return is_lower_bound && !is_decided ? no_value : value;
}

double excess_of(const Limit& limit, double figure) {
  double share = (figure - limit.value) / std::abs(limit.value);
  // What no solver tells is no excess: a figure that the key hardly moves may be the limit itself.
  constexpr double rounding = 1e-7;
  if (std::abs(share) < rounding) share = 0;
  return std::asinh(limit.at_least ? -share : share);
}

const Flag* spike_unseen_at(const Place& place) {
  const auto spike = std::ranges::find(place.reservations, injury::short_spike_name, &Flag::name);
  return place.excess <= 0 && spike != place.reservations.end() ? &*spike : nullptr;
}

Impacts::Impacts(const Question& question) : question_(question), limits_(limits_of(question)) {
  for (const Judged& judged : question.impacts) {
    studies_.push_back(study_of(question, judged, {question.low}));
    studies_.back().factors.resize(1);
  }
  for (const study::Study& study : studies_) applications_.emplace_back(study);
}

Place Impacts::look(double value, bool intervals) {
  Place place{.value = value};
  std::vector<double> excess, low, high;
  std::vector<Flag> spikes;
  for (std::size_t i = 0; i < studies_.size(); ++i) {
    const Judged& judged = question_.impacts[i];
    ImpactCase impact = judged.impact;
    const double values[]{value};
    applications_[i](values, impact);
    const std::vector<Violation> broken = dashpad::violations(impact);
    Solution solution;
    std::optional<injury::Assessment> assessment;
    if (broken.empty()) {
      solution = solve(impact, question_.options);
      ++solved_;
      if (intervals) {
        const std::vector<double> levels =
            judged.standard ? injury::dwell_levels(*judged.standard) : std::vector<double>{};
        uncertainty::add_intervals(impact, question_.options, solution, levels);
        if (solution.summary.intervals)
          solved_ += static_cast<std::uint64_t>(solution.summary.intervals->impacts);
      }
      if (judged.standard) assessment = injury::assess(*judged.standard, impact, solution);
      add_reservations(judged, assessment, solution.summary, place.reservations);
      place.is_doubtful = place.is_doubtful || !solution.summary.trustworthy();
    } else {
      place.why_unknown = fmt::format("{}: {}", broken.front().key, broken.front().rule);
    }
    const std::size_t criteria = judged.standard ? judged.standard->criteria.size() : 0;
    const std::span own = std::span(limits_).subspan(place.figures.size(), criteria + judged.limits.size());
    if (std::optional<Flag> spike = broken.empty() ? short_spike(own, solution.summary) : std::nullopt)
      spikes.push_back(*std::move(spike));
    for (std::size_t j = 0; j < own.size(); ++j) {
      const Limit& limit = limits_[place.figures.size()];
      Read read;
      if (broken.empty())
        read = j < criteria ? read_criterion(limit, assessment->results[j], solution.summary)
                            : read_figure(limit, solution);
      if (broken.empty() && std::isnan(read.value) && place.why_unknown.empty())
        place.why_unknown = why_none(limit, solution.summary);
      place.figures.push_back(read.value);
      excess.push_back(excess_of(limit, read.value));
      low.push_back(excess_of(limit, limit.at_least ? read.high : read.low));
      high.push_back(excess_of(limit, limit.at_least ? read.low : read.high));
    }
  }
  place.worst = worst_of(excess);
  place.excess = excess[place.worst];
  // Of a place that fails it would be no reservation; a turn may lie just beyond the limit.
  constexpr double at_limit = 1e-2;
  if (place.excess <= at_limit) std::ranges::move(spikes, std::back_inserter(place.reservations));
  place.low = low[worst_of(low)];
  place.high = high[worst_of(high)];
  return place;
}

}  // namespace dashpad::margin
