#include "output/text/fall_height_words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "output/text/capitals.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// " (95 % interval 1.93 to 2.01 m)", or "".
std::string in_brackets(const std::string& interval) {
  return interval.empty() ? "" : fmt::format(" (95 % interval {})", interval);
}

std::string measured_words(const fall_height::Answer& answer, const UnitSystem& units) {
  const fall_height::Place& place = answer.places[answer.lowest];
  const fall_height::Crossing& crossing = place.decides();
  const injury::Criterion& criterion = answer.standard.criteria[crossing.criterion];
  const std::string title = uncapitalised(injury::title_of(criterion));
  const std::string limit = brief_quantity(criterion.limit, criterion.quantity->si_unit, units);
  std::string text = "Critical fall height " + height_words(crossing, units);
  const std::string where = place_words(place);
  const std::string at = answer.places.size() > 1 && !where.empty() ? fmt::format(" ({})", where) : "";
  // A point of a series is a mean.
  const std::string point = answer.standard.drop_series ? "mean" : "drop";
  if (!crossing.is_enclosed())
    return text +
           (crossing.points.empty() ? ": no drop has a figure"
            : !crossing.is_exceeded ? fmt::format(": no {} exceeds {} {}", point, title, limit)
            : !crossing.is_kept     ? fmt::format(": even the lowest {} exceeds {} {}", point, title, limit)
                                    : fmt::format(": no curve meets {} {} between the drops", title, limit)) +
           at;
  return text + in_brackets(interval_words(crossing, units)) +
         fmt::format(", where {} reaches {}", title, limit) + at;
}

std::string computed_words(const margin::Answer& computed, bool is_alone, const UnitSystem& units) {
  const std::string lead = is_alone ? "Critical fall height by computation " : "computed ";
  if (const margin::Turn* const turn = critical_turn(computed)) {
    const margin::Limit& limit = computed.limits[turn->limit];
    const std::string interval =
        turn->interval ? height_range(turn->interval->first, turn->interval->second, units) : "";
    return lead + height_result(turn->value, units) + in_brackets(interval) +
           (is_alone ? fmt::format(", where {} {} {}", uncapitalised(limit.title),
                                   turn->jumps ? "jumps across" : "reaches",
                                   brief_quantity(limit.value, limit.figure->si_unit, units))
                     : "");
  }
  const bool passes = !computed.kept.empty() && computed.kept.front().zone == margin::Zone::pass;
  return lead + (passes ? "more than " + height_text(computed.question.high, units)
                        : "less than " + height_text(computed.question.low, units));
}

}  // namespace

const injury::Standard& standard_of(const FallHeightReport& report) {
  return report.measured ? report.measured->standard : *report.computed->question.impacts.front().standard;
}

ScaledUnit unit_of_heights(const UnitSystem& units) {
  constexpr double foot = 0.3048;  // m
  return units.length == "in" ? ScaledUnit{1 / foot, "ft"} : ScaledUnit{1, "m"};
}

std::string height_text(double height, const UnitSystem& units) {
  const ScaledUnit shown = unit_of_heights(units);
  return with_unit(brief(shown.scale * height, 4), shown.unit);
}

std::string height_result(double height, const UnitSystem& units) {
  const ScaledUnit shown = unit_of_heights(units);
  return with_unit(significant(shown.scale * height, 3), shown.unit);
}

std::string height_range(double low, double high, const UnitSystem& units) {
  const auto outwards = [&](double height, double (*rounded)(double)) {
    const double step = std::pow(10, std::floor(std::log10(height)) - 2);
    return height_result(step * rounded(height / step), units);
  };
  if (low <= 0 && std::isinf(high)) return "not bounded";
  if (low <= 0) return "at most " + outwards(high, std::ceil);
  if (std::isinf(high)) return "at least " + outwards(low, std::floor);
  const std::string from = outwards(low, std::floor);
  return fmt::format("{} to {}", from.substr(0, from.find(' ')), outwards(high, std::ceil));
}

const margin::Turn* critical_turn(const margin::Answer& computed) {
  const auto first = std::ranges::find(computed.turns, false, &margin::Turn::passes_above);
  const bool fails_before = !computed.kept.empty() && computed.kept.front().zone != margin::Zone::pass;
  return first == computed.turns.end() || fails_before ? nullptr : &*first;
}

std::string place_words(const fall_height::Place& place) {
  std::string text;
  for (const auto& [header, words] : place.remarks) {
    if (words.empty()) continue;
    const bool is_number = words.find_first_not_of("0123456789.,-+ ") == std::string::npos;
    text += (text.empty() ? "" : ", ") + (is_number ? one_line(header) + " " : "") + one_line(words);
  }
  return text;
}

std::string height_words(const fall_height::Crossing& crossing, const UnitSystem& units) {
  if (crossing.is_enclosed()) return height_result(*crossing.height, units);
  if (crossing.points.empty()) return "unknown";
  if (!crossing.is_exceeded) return "more than " + height_text(crossing.points.back().height, units);
  if (!crossing.is_kept) return "less than " + height_text(crossing.points.front().height, units);
  return "unknown";
}

std::string interval_words(const fall_height::Crossing& crossing, const UnitSystem& units) {
  return crossing.is_enclosed() && crossing.interval
             ? height_range(crossing.interval->first, crossing.interval->second, units)
             : "";
}

std::string fall_height_answer(const FallHeightReport& report, const UnitSystem& units) {
  if (!report.measured) return computed_words(*report.computed, true, units);
  const std::string text = measured_words(*report.measured, units);
  return report.computed ? text + "; " + computed_words(*report.computed, false, units) : text;
}

}  // namespace dashpad::output
