#include "output/result_rows.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "output/text/capitals.hpp"
#include "quantities/text.hpp"
#include "result/possible_range.hpp"

namespace dashpad::output {

namespace {

/// Digits that tell two numbers apart: three, up to five.
int digits_between(double low, double high) {
  int digits = 3;
  while (digits < 5 && rounded_to(low, digits) == rounded_to(high, digits)) ++digits;
  return digits;
}

const FigureInterval* first_asked(const Intervals& intervals) {
  for (const char* key : {"hic15", "peak_acceleration", "peak_penetration"})
    if (const FigureInterval* interval = intervals.find(key)) return interval;
  return nullptr;
}

/// The range of a figure: an end that the figure cannot pass anyway is no information.
std::string words_between(double low, double high, const ResultQuantity& quantity, const UnitSystem& units) {
  if (!(low < high)) return range_words(low, high, quantity.si_unit, units);
  const PossibleRange range = possible_range(quantity);
  const bool has_low = low > range.least;
  const bool has_high = std::isfinite(high) && !(range.most == Most::one && high >= 1);
  if (!has_low && !has_high) return "unbounded";
  if (!has_low) {
    const auto [scale, unit] = shown_as(quantity.si_unit, units);
    return "at most " + with_unit(brief(rounded_to(scale * high, 3)), unit);
  }
  return range_words(low, has_high ? high : infinite, quantity.si_unit, units);
}

std::string joined(const std::vector<std::string>& parts) {
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::string figure_words(const FigureInterval& interval, const Intervals& intervals,
                         const UnitSystem& units) {
  const ResultQuantity& quantity = result_quantity(interval.key);
  const std::string value = brief_quantity(interval.nominal, quantity.si_unit, units, 4);
  if (interval.sources.empty())
    return fmt::format("{} {}, unaffected by the uncertainties considered.", quantity.title, value);
  const char* const each = interval.sources.size() == 1 ? "The only contributing source of uncertainty is"
                                                        : "Each source of uncertainty by itself would give:";
  return fmt::format("{} {}, 95 % interval {}. {} {}.", quantity.title, value,
                     interval_words(interval, units), each, joined(source_words(interval, intervals, units)));
}

}  // namespace

std::string range_words(double low, double high, const std::string& si_unit, const UnitSystem& units) {
  const ScaledUnit unit = shown_as(si_unit, units);
  const std::string name = unit.unit.empty() ? "" : " " + unit.unit;
  low *= unit.scale;
  high *= unit.scale;
  if (!std::isfinite(high)) return brief(rounded_to(low, 3)) + name + " or more";
  const int digits = digits_between(low, high);
  return brief(rounded_to(low, digits)) + " to " + brief(rounded_to(high, digits)) + name;
}

std::string interval_words(const FigureInterval& interval, const UnitSystem& units) {
  return words_between(interval.low, interval.high, result_quantity(interval.key), units);
}

std::vector<std::string> source_words(const FigureInterval& interval, const Intervals& intervals,
                                      const UnitSystem& units) {
  std::vector<std::string> all;
  for (const Contribution& each : interval.sources) {
    const OpenSource* const source = intervals.find(each.source);
    all.push_back(source ? one_line(source->words) : to_string(each.source));
    if (interval.sources.size() > 1)  // a single one has the interval of the figure
      all.back() += ", " + words_between(each.low, each.high, result_quantity(interval.key), units);
  }
  return all;
}

void add_intervals(std::vector<ValueRow>& rows, const Summary& summary, const UnitSystem& units) {
  if (!summary.intervals) return;
  for (ValueRow& row : rows)
    if (const FigureInterval* interval = summary.intervals->find(row.key);
        interval && !interval->sources.empty())
      row.interval = interval_words(*interval, units);
}

Table interval_table(const Summary& summary, const UnitSystem& units, std::vector<std::string> asked) {
  const Intervals& intervals = *summary.intervals;
  Table table{.caption = "Uncertainty of each figure by source", .columns = {"Figure", "Combined"}};
  std::vector<Source> open;
  for (const OpenSource& source : intervals.sources)
    if (source.why_not.empty() && std::ranges::find(open, source.source) == open.end())
      open.push_back(source.source);
  for (const Source source : open)
    table.columns.push_back(source == Source::continuation ? "Extrapolated strain"
                            : source == Source::rate       ? "Extrapolated rate"
                            : source == Source::way_back   ? "Unloading"
                                                           : capitalised(to_string(source)));
  for (const char* key : {"peak_acceleration", "hic15", "clip_3ms", "peak_penetration", "rebound_speed"})
    if (std::ranges::find(asked, key) == asked.end()) asked.emplace_back(key);
  for (const std::string& key : asked) {
    const FigureInterval* const figure = intervals.find(key);
    if (figure == nullptr) continue;
    const ResultQuantity& quantity = result_quantity(key);
    table.rows.push_back({quantity.title, interval_words(*figure, units)});
    for (const Source source : open) {
      const auto of = std::ranges::find(figure->sources, source, &Contribution::source);
      table.rows.back().push_back(
          of == figure->sources.end() ? "-" : words_between(of->low, of->high, quantity, units));
    }
  }
  return table;
}

std::vector<std::string> interval_paragraphs(const Summary& summary, const UnitSystem& units) {
  const Intervals& intervals = *summary.intervals;
  std::vector<std::string> all, unknown;
  if (const FigureInterval* interval = first_asked(intervals))
    all.push_back(figure_words(*interval, intervals, units));
  for (const OpenSource& source : intervals.sources)
    if (!source.why_not.empty())
      unknown.push_back(fmt::format("{} ({})", one_line(source.words), one_line(source.why_not)));
  if (!unknown.empty()) all.push_back(fmt::format("Not included in the intervals: {}.", joined(unknown)));
  return all;
}

}  // namespace dashpad::output
