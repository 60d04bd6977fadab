#include "output/text/margin_words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/output/margin.hpp"
#include "injury/short_spike.hpp"
#include "margin/evaluation.hpp"
#include "output/text/capitals.hpp"
#include "output/text/study_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr int key_digits = 4;

std::string joined(const std::vector<std::string>& parts, const char* word) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? word : ", ") + parts[i];
  return text;
}

/// " (95 % interval 28.1 to 31 mm)"; "" without one.
std::string interval_text(const margin::Answer& answer, const margin::Turn& turn, const UnitSystem& units) {
  if (!turn.interval) return "";
  const auto& [low, high] = *turn.interval;
  const bool has_low = std::isfinite(low), has_high = std::isfinite(high);
  const std::string from = key_text(answer, low, units), to = key_text(answer, high, units);
  if (!has_low && !has_high) return " (95 % interval: the whole range)";
  if (!has_low) return fmt::format(" (95 % interval: at most {})", to);
  if (!has_high) return fmt::format(" (95 % interval: at least {})", from);
  if (from == to) return "";
  const std::string unit = shown_as(answer.question.unit, units).unit;
  const bool same_unit = !unit.empty() && from.ends_with(" " + unit);
  return fmt::format(" (95 % interval {} to {})",
                     same_unit ? from.substr(0, from.size() - unit.size() - 1) : from, to);
}

/// A bound of what passes, rounded into it: with the interval of its turn where that is due to the number of
/// draws alone.
std::string bound_text(const margin::Answer& answer, double bound, bool up, const UnitSystem& units) {
  const ScaledUnit shown = shown_as(answer.question.unit, units);
  const double value = shown.scale * bound;
  const double step = std::pow(10, std::floor(std::log10(std::abs(value))) + 1 - key_digits);
  double inside = value;
  if (value != 0) inside = step * (up ? std::ceil(value / step - 1e-6) : std::floor(value / step + 1e-6));
  const std::string text = with_unit(brief(rounded_to(inside, key_digits), key_digits), shown.unit);
  if (!answer.question.chance) return text;
  for (const margin::Turn& turn : answer.turns)
    if (turn.value == bound) return text + interval_text(answer, turn, units);
  return text;
}

/// ", with its 95 % interval from 31 mm on": where the whole interval keeps the limits; "" without intervals.
std::string certain_text(const margin::Answer& answer, const UnitSystem& units) {
  if (answer.question.chance || !answer.question.intervals) return "";
  std::vector<std::string> parts;
  bool is_everywhere = false;
  for (const auto& [from, to, zone] : answer.stretches) {
    if (zone != margin::Zone::pass) continue;
    const bool from_begin = from <= answer.question.low, to_end = to >= answer.question.high;
    is_everywhere = is_everywhere || (from_begin && to_end);
    parts.push_back(from_begin ? "up to " + bound_text(answer, to, false, units)
                    : to_end   ? fmt::format("from {} on", bound_text(answer, from, true, units))
                               : fmt::format("from {} to {}", bound_text(answer, from, true, units),
                                             bound_text(answer, to, false, units)));
  }
  if (is_everywhere) return ", and that with its 95 % interval";
  return parts.empty() ? ", but nowhere in this range with its 95 % interval"
                       : ", with its 95 % interval " + joined(parts, " and ");
}

/// "; a spike may go unseen from 8 to 12 mm: at 8 mm the pad is crushed through, with a peak of 412 g too
/// short for the 3 ms clip to see"; "" without one.
std::string spike_text(const margin::Answer& answer, const UnitSystem& units) {
  const auto spike = std::ranges::find(answer.reservations, injury::short_spike_name, &Flag::name);
  if (spike == answer.reservations.end()) return "";
  std::string where;
  const margin::Place *first = nullptr, *last = nullptr, *highest = nullptr;
  for (const margin::Place& place : answer.places)
    if (const Flag* const of = margin::spike_unseen_at(place)) {
      if (first == nullptr) first = &place;
      last = &place;
      if (highest == nullptr && of->text == spike->text) highest = &place;
    }
  if (first != last)
    where = fmt::format(" from {} to {}", bound_text(answer, first->value, true, units),
                        bound_text(answer, last->value, false, units));
  if (highest != nullptr)
    where += ": at " + bound_text(answer, highest->value, highest != last, units);
  else if (!answer.turns.empty())  // of draws the case as it is has a spike, at the turn
    where += ": at " + key_text(answer, answer.turns.front().value, units);
  return fmt::format("; a spike may go unseen{} {}", where.empty() ? ":" : where, injury::words_of(*spike));
}

/// "is at least 29.4 mm", "is between 21 and 44 mm": where the limits are kept, within the range.
std::vector<std::string> kept_stretches(const margin::Answer& answer, const UnitSystem& units) {
  std::vector<std::string> parts;
  for (const auto& [from, to, zone] : answer.kept) {
    if (zone != margin::Zone::pass) continue;
    const std::string low = bound_text(answer, from, true, units),
                      high = bound_text(answer, to, false, units);
    parts.push_back(from <= answer.question.low  ? "is at most " + high
                    : to >= answer.question.high ? "is at least " + low
                                                 : fmt::format("is between {} and {}", low, high));
  }
  return parts;
}

std::string range_text(const margin::Answer& answer, const UnitSystem& units) {
  return fmt::format("between {} and {}", key_text(answer, answer.question.low, units),
                     key_text(answer, answer.question.high, units));
}

std::string chance_words(const margin::Answer& answer) {
  if (!answer.question.chance) return "";
  return fmt::format(" with a probability of {}", per_cent(answer.question.chance->probability));
}

/// "nearest at 60 mm, where HIC15 is 812 (at most 700)"
std::string nearest_text(const margin::Answer& answer, const UnitSystem& units) {
  if (!answer.nearest) return "no value in the range gives a figure to compare with a limit";
  const margin::Place& place = answer.places[*answer.nearest];
  const margin::Limit& limit = answer.limits[place.worst];
  if (answer.question.chance)
    return fmt::format("at best, at {}, {} of the draws pass", key_text(answer, place.value, units),
                       per_cent(place.share));
  return fmt::format("the nearest is {}, where {} is {} (limit: {})", key_text(answer, place.value, units),
                     limit_title(answer, place.worst), figure_text(limit, place.figures[place.worst], units),
                     limit_text(limit, units));
}

/// "HIC15 is 700 if the thickness of the pad is 29.4 mm or 71 mm".
std::string aim_answer(const margin::Answer& answer, const UnitSystem& units) {
  const std::string key = factor_words(answer.question.key);
  const std::string title = capitalised(limit_title(answer, 0)),
                    aim = limit_text(answer.limits.front(), units);
  std::vector<std::string> reached, leapt;
  for (const margin::Turn& turn : answer.turns)
    (turn.jumps ? leapt : reached).push_back(turn_text(answer, turn, units));
  if (answer.turns.empty())
    return fmt::format("{} is not {} for any {} {}: {}", title, aim, key, range_text(answer, units),
                       nearest_text(answer, units));
  std::string text;
  if (!reached.empty())
    text = fmt::format("{} is {} if the {} is {}", title, aim, key, joined(reached, " or "));
  if (!leapt.empty())
    text += fmt::format("{}{} jumps across {} at {}", text.empty() ? "" : "; ", text.empty() ? title : "it",
                        aim, joined(leapt, " and "));
  return text;
}

}  // namespace

std::string key_text(const margin::Answer& answer, double value, const UnitSystem& units) {
  return brief_quantity(value, answer.question.unit, units, key_digits);
}

std::string turn_text(const margin::Answer& answer, const margin::Turn& turn, const UnitSystem& units) {
  return key_text(answer, turn.value, units) + interval_text(answer, turn, units);
}

std::string limit_title(const margin::Answer& answer, std::size_t limit) {
  const margin::Limit& of = answer.limits[limit];
  const std::string title = uncapitalised(of.title);
  const auto same = std::ranges::count(answer.limits, of.title, &margin::Limit::title);
  return same > 1 && !of.origin.empty() ? fmt::format("{} of {}", title, of.origin) : title;
}

std::string limit_text(const margin::Limit& limit, const UnitSystem& units) {
  const std::string value = brief_quantity(limit.value, limit.figure->si_unit, units);
  return limit.is_aim ? value : (limit.at_least ? "at least " : "at most ") + value;
}

std::string figure_text(const margin::Limit& limit, double figure, const UnitSystem& units) {
  if (std::isnan(figure)) return "none";
  if (std::isinf(figure)) return "bottomed out";
  return brief_quantity(figure, limit.figure->si_unit, units, 4);
}

double share_of_limit(const margin::Limit& limit, double excess) {
  return (limit.value > 0 ? 1 : -1) * (limit.at_least ? -1 : 1) * std::sinh(excess) + 1;
}

std::string margin_answer(const margin::Answer& answer, const UnitSystem& units) {
  if (margin::is_aim(answer.question)) return aim_answer(answer, units);
  const std::string key = factor_words(answer.question.key);
  const bool is_everywhere = answer.kept.size() == 1 && answer.kept.front().zone == margin::Zone::pass;
  const std::vector<std::string> kept = kept_stretches(answer, units);
  if (kept.empty())
    return answer.question.chance ? fmt::format("No {} {} passes{}: {}", key, range_text(answer, units),
                                                chance_words(answer), nearest_text(answer, units))
                                  : fmt::format("Does not pass for any {} {}: {}", key,
                                                range_text(answer, units), nearest_text(answer, units));
  if (!is_everywhere)
    return fmt::format("Passes{} if the {} {}{}{}", chance_words(answer), key, joined(kept, " or "),
                       certain_text(answer, units), spike_text(answer, units));
  const auto where = std::ranges::max_element(answer.places, {}, &margin::Place::excess);
  return fmt::format("Passes{} for every {} {}{}: closest to its limit at {}, where {} is {} (limit: {}){}",
                     chance_words(answer), key, range_text(answer, units), certain_text(answer, units),
                     key_text(answer, where->value, units), limit_title(answer, where->worst),
                     figure_text(answer.limits[where->worst], where->figures[where->worst], units),
                     limit_text(answer.limits[where->worst], units), spike_text(answer, units));
}

}  // namespace dashpad::output
