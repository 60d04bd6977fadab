// The document of a critical fall height.

#include "dashpad/output/fall_height.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "output/documents/basis.hpp"
#include "output/layout.hpp"
#include "output/text/fall_height_words.hpp"
#include "output/text/standard_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

std::string limit_words(const injury::Criterion& criterion, const UnitSystem& units) {
  return (criterion.strict ? "below " : "at most ") +
         brief_quantity(criterion.limit, criterion.quantity->si_unit, units);
}

/// How many drops on how many places, between which heights.
std::string drops_words(const fall_height::Answer& answer, const UnitSystem& units) {
  std::size_t drops = 0;
  for (const fall_height::Place& place : answer.places) drops += place.drops.size();
  const auto [low, high] = fall_height::heights_of(answer);
  return fmt::format("{} from {} to {}{}", plural(drops, "drop"), height_text(low, units),
                     height_text(high, units),
                     answer.places.size() > 1 ? " on " + plural(answer.places.size(), "place") : "");
}

std::vector<std::string> subject_of(const FallHeightReport& report, const UnitSystem& units) {
  const injury::Standard& standard = standard_of(report);
  std::vector<std::string> lines{
      fmt::format("Standard: {} ({})", one_line(standard.title), full_name(standard))};
  if (report.measured)
    lines.push_back(fmt::format("Measured: {}, {}", report.table_file, drops_words(*report.measured, units)));
  if (report.computed) {
    const margin::Question& question = report.computed->question;
    const std::string title = one_line(question.impacts.front().impact.title);
    lines.push_back(fmt::format("Computed: {}{}, from {} to {}", title.empty() ? "" : title + ", ",
                                report.case_file, height_text(question.low, units),
                                height_text(question.high, units)));
  }
  if (report.measured)
    for (const auto& [header, words] : report.measured->common)
      if (!words.empty()) lines.push_back(fmt::format("{}: {}", one_line(header), one_line(words)));
  for (const std::string& line : report.about) lines.push_back(one_line(line));
  return lines;
}

ValueRow row_of(const fall_height::Answer& answer, std::size_t which, const UnitSystem& units) {
  const fall_height::Place& place = fall_height::lowest_for(answer, which);
  const fall_height::Crossing& crossing = place.crossings[which];
  const injury::Criterion& criterion = answer.standard.criteria[which];
  ValueRow row{.label = injury::title_of(criterion),
               .value = height_words(crossing, units),
               .interval = interval_words(crossing, units),
               .limit = limit_words(criterion, units)};
  if (crossing.is_enclosed())
    row.remark = fmt::format("between drops from {} and {}", height_text(*crossing.below, units),
                             height_text(*crossing.above, units));
  else if (crossing.height)
    row.remark = "the curve reaches the limit at " + height_result(*crossing.height, units);
  if (const std::string where = place_words(place); answer.places.size() > 1 && !where.empty())
    row.remark = where + (row.remark.empty() ? "" : ", ") + row.remark;
  return row;
}

std::vector<ValueRow> rows_of(const FallHeightReport& report, const UnitSystem& units) {
  std::vector<ValueRow> rows;
  if (report.measured) {
    const fall_height::Answer& answer = *report.measured;
    const std::size_t decides = answer.decides().criterion;
    rows.push_back(row_of(answer, decides, units));
    for (std::size_t i = 0; i < answer.standard.criteria.size(); ++i)
      if (i != decides) rows.push_back(row_of(answer, i, units));
    if (const auto& series = answer.standard.drop_series; series && answer.decides().is_enclosed()) {
      const double count = std::floor(*answer.decides().height / series->step + 1e-6);
      rows.push_back({.label = "Rounded down",
                      .value = height_result(count * series->step, units),
                      .remark = fmt::format("{:.0f} steps of {}", count, height_text(series->step, units))});
    }
  }
  if (report.computed)
    if (const margin::Turn* const turn = critical_turn(*report.computed)) {
      ValueRow row{.label = "Computed", .value = height_result(turn->value, units)};
      if (turn->interval) row.interval = height_range(turn->interval->first, turn->interval->second, units);
      row.limit = report.computed->limits[turn->limit].title;
      rows.push_back(std::move(row));
    }
  return rows;
}

/// The flags of answer, places, pulses and computation, each with what it is about.
std::vector<std::string> warnings_of(const FallHeightReport& report) {
  std::vector<Flag> flags;
  if (report.measured) {
    // Those about the computed pad name what is common to both.
    for (const Flag& flag : report.measured->reservations)
      if (!report.computed || std::ranges::find(report.computed->reservations, flag.name, &Flag::name) ==
                                  report.computed->reservations.end())
        flags.push_back(flag);
    for (const fall_height::Place& place : report.measured->places) {
      const std::string where = report.measured->places.size() > 1 ? place_words(place) : "";
      for (Flag flag : place.flags) {
        if (!where.empty()) flag.text += " (" + where + ")";
        flags.push_back(std::move(flag));
      }
      for (const fall_height::Drop& drop : place.drops)
        for (Flag flag : drop.flags) {
          flag.text += fmt::format(" ({}, line {})", one_line(drop.pulse), drop.line);
          flags.push_back(std::move(flag));
        }
    }
  }
  if (report.computed)
    flags.insert(flags.end(), report.computed->reservations.begin(), report.computed->reservations.end());
  return by_severity(std::move(flags));
}

Table drops_table(const fall_height::Answer& answer, const UnitSystem& units) {
  Table table;
  for (const auto& [header, words] : answer.places.front().drops.front().remarks)
    if (std::ranges::find(answer.common, header, &fall_height::Remark::first) == answer.common.end())
      table.columns.push_back(one_line(header));
  table.columns.insert(table.columns.end(), {"Fall height", "Drop"});
  for (const injury::Criterion& criterion : answer.standard.criteria)
    table.columns.push_back(injury::title_of(criterion));
  const bool has_pulses = std::ranges::any_of(answer.places, [](const fall_height::Place& place) {
    return std::ranges::any_of(place.drops,
                               [](const fall_height::Drop& drop) { return !drop.pulse.empty(); });
  });
  if (has_pulses) table.columns.emplace_back("Pulse");
  for (const fall_height::Place& place : answer.places)
    for (const fall_height::Drop& drop : place.drops) {
      std::vector<std::string> row;
      for (const auto& [header, words] : drop.remarks)
        if (std::ranges::find(answer.common, header, &fall_height::Remark::first) == answer.common.end())
          row.push_back(one_line(words));
      row.push_back(height_text(drop.height, units));
      row.push_back(std::to_string(drop.number));
      for (std::size_t i = 0; i < answer.standard.criteria.size(); ++i)
        row.push_back(
            std::isfinite(drop.figures[i])
                ? brief_quantity(drop.figures[i], answer.standard.criteria[i].quantity->si_unit, units, 4)
                : "-");
      if (has_pulses) row.push_back(one_line(drop.pulse));
      table.rows.push_back(std::move(row));
    }
  return table;
}

/// A row for each place: the height of each limit with its interval.
Table places_table(const fall_height::Answer& answer, const UnitSystem& units) {
  Table table{.columns = {"Place"}};
  for (const injury::Criterion& criterion : answer.standard.criteria)
    table.columns.push_back(injury::title_of(criterion) + " " + limit_words(criterion, units));
  for (const fall_height::Place& place : answer.places) {
    std::vector<std::string> row{place_words(place)};
    for (const fall_height::Crossing& crossing : place.crossings) {
      const std::string interval = interval_words(crossing, units);
      row.push_back(height_words(crossing, units) + (interval.empty() ? "" : " (" + interval + ")"));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table curves_table(const fall_height::Answer& answer, const UnitSystem& units) {
  Table table{.columns = {"Limit", "Height", "95 % interval", "Points", "Exponent", "Scatter", "Instrument"}};
  if (answer.places.size() > 1) table.columns.insert(table.columns.begin(), "Place");
  for (const fall_height::Place& place : answer.places)
    for (const fall_height::Crossing& crossing : place.crossings) {
      const auto& curve = crossing.curve;
      std::vector<std::string> row;
      if (answer.places.size() > 1) row.push_back(place_words(place));
      row.push_back(injury::title_of(answer.standard.criteria[crossing.criterion]));
      row.push_back(height_words(crossing, units));
      row.push_back(crossing.interval ? interval_words(crossing, units) : "-");
      row.push_back(crossing.near.size() == crossing.points.size()
                        ? std::to_string(crossing.points.size())
                        : fmt::format("{} of {}", crossing.near.size(), crossing.points.size()));
      const bool has_height = curve && crossing.height;
      row.push_back(has_height ? fmt::format("{:.2f}", curve->coefficients[1] +
                                                           2 * curve->coefficients[2] *
                                                               std::log(*crossing.height / curve->middle))
                               : "-");
      row.push_back(curve && curve->freedom > 0 ? fmt::format("{:.2g} %", 100 * curve->deviation) : "-");
      row.push_back(crossing.doubt > 0 ? fmt::format("{:.2g} %", 100 * crossing.doubt) : "-");
      table.rows.push_back(std::move(row));
    }
  return table;
}

std::vector<std::string> method_words(const FallHeightReport& report) {
  std::vector<std::string> lines;
  if (report.measured) {
    lines.emplace_back(
        "The height is where a curve through the drops, ln f = c0 + c1 ln h + c2 (ln h)², first meets the "
        "limit; c2 is fitted only if there are enough drops to determine it. The lowest height of all limits "
        "and places counts. The interval covers the scatter of the drops about the curve (Student's t, 95 %) "
        "and what all drops share: calibration, sampling and filter of the instrument (k = 2).");
    if (const auto& series = report.measured->standard.drop_series)
      lines.push_back(fmt::format("Of several drops from one height, the mean of drops {} counts{}: {}. {}",
                                  fmt::join(series->counted, " and "),
                                  series->origin.verified ? "" : " (UNVERIFIED)",
                                  one_line(series->origin.source), one_line(series->origin.note)));
    else
      lines.emplace_back("Each drop counts by itself.");
  }
  if (report.computed)
    lines.push_back(
        fmt::format("Computed: the lowest fall height from which a limit is exceeded; {} solved in {:.2g} s. "
                    "Its interval covers the uncertainty of foam and model.",
                    plural(report.computed->impacts, "impact"), report.computed->seconds));
  return lines;
}

Tone tone_of(const FallHeightReport& report) {
  if (report.measured) return report.measured->is_sure() ? Tone::plain : Tone::doubtful;
  return critical_turn(*report.computed) ? Tone::plain : Tone::doubtful;
}

}  // namespace

Document fall_height_document(const FallHeightReport& report, const UnitSystem& units, Pictures pictures) {
  const injury::Standard& standard = standard_of(report);
  Document document{.title = fall_height_answer(report, units),
                    .lead = Lead{.answer = fall_height_answer(report, units),
                                 .tone = tone_of(report),
                                 .subject = subject_of(report, units),
                                 .figures = rows_of(report, units)},
                    .warnings = warnings_of(report)};
  if (report.measured && report.measured->places.size() > 1)
    document.sections.push_back({.heading = "Places, with 95 % intervals",
                                 .seen = Seen::always,
                                 .tables = {places_table(*report.measured, units)}});
  if (report.measured)
    document.sections.push_back(
        {.heading = "Drops", .seen = Seen::always, .tables = {drops_table(*report.measured, units)}});
  if (report.measured)
    document.sections.push_back({.heading = "Curves", .tables = {curves_table(*report.measured, units)}});
  std::vector<std::string> method = method_words(report);
  if (!standard.note.empty()) method.push_back("The standard: " + one_line(standard.note));
  document.sections.push_back({.heading = "Method", .paragraphs = std::move(method)});
  if (report.computed)
    document.sections.push_back(
        {.heading = basis_heading,
         .tables = {basis_table(case_basis(report.computed->question.impacts.front().impact, units))}});
  if (pictures == Pictures::drawn) document.lead->curve = untitled(fall_height_plot(report, units));
  return document;
}

}  // namespace dashpad::output
