// The document of several measured pulses: a table, all of them in one plot, then each by itself.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dashpad/injury/figures.hpp"
#include "dashpad/output/pulse.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "output/documents/assessment.hpp"
#include "output/documents/pulse.hpp"
#include "output/plot/axis_with_unit.hpp"
#include "output/result_rows.hpp"
#include "output/text/capitals.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

using Reports = std::vector<injury::PulseReport>;

/// The columns of the table.
constexpr std::array shown_figures{"peak_acceleration", "clip_3ms",       "hic15", "hic36",
                                   "hic_unlimited",     "velocity_change"};

double value_of(const injury::PulseReport& report, const char* key) {
  return injury::injury_value(report.figures, result_quantity(key)).value().value;
}

std::vector<double> values_over(const Reports& reports, const char* key) {
  std::vector<double> values;
  for (const injury::PulseReport& report : reports) values.push_back(value_of(report, key));
  return values;
}

/// The name of the file, with its folders if another pulse has the same name.
std::string pulse_name(const injury::PulseReport& report, const Reports& reports) {
  const auto name = [](const injury::PulseReport& each) {
    return std::filesystem::path{each.file}.filename().string();
  };
  return one_line(std::ranges::count(reports, name(report), name) > 1 ? report.file : name(report));
}

/// Mean and deviation of the sample; of one value the deviation is 0.
std::pair<double, double> mean_and_deviation(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  double mean = 0, squares = 0;
  for (const double value : values) mean += value / count;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, values.size() > 1 ? std::sqrt(squares / (count - 1)) : 0};
}

Table table_of(const Reports& reports, const UnitSystem& units) {
  Table table{.columns = {"Pulse"}};
  for (const injury::PulseReport& report : reports) table.rows.push_back({pulse_name(report, reports)});
  std::vector<std::string> means{"Mean"}, deviations{"Standard deviation"};
  for (const char* const key : shown_figures) {
    const ResultQuantity& quantity = result_quantity(key);
    const std::vector<double> values = values_over(reports, key);
    table.columns.emplace_back(quantity.title);
    for (std::size_t i = 0; i < values.size(); ++i)
      table.rows[i].push_back(brief_quantity(values[i], quantity.si_unit, units));
    const auto [mean, deviation] = mean_and_deviation(values);
    means.push_back(brief_quantity(mean, quantity.si_unit, units));
    deviations.push_back(brief_quantity(deviation, quantity.si_unit, units, 2));
  }
  table.rows.push_back(std::move(means));
  table.rows.push_back(std::move(deviations));
  return table;
}

/// The range of the figure that decides over the limits, with its limit, or of peak and HIC15.
std::string deciding_figures(const Reports& reports, const UnitSystem& units) {
  const auto range = [&](const std::vector<double>& values, const ResultQuantity& quantity) {
    const auto [least, most] = std::ranges::minmax(values);
    return range_words(least, most, quantity.si_unit, units);
  };
  const auto of = [&](const char* key) { return range(values_over(reports, key), result_quantity(key)); };
  std::vector<injury::CriterionResult> results;
  for (const injury::PulseReport& report : reports)
    if (report.limits)
      results.insert(results.end(), report.limits->results.begin(), report.limits->results.end());
  const injury::CriterionResult* const decides = closest(results);
  if (decides == nullptr) return fmt::format("peak {}, HIC15 {}", of("peak_acceleration"), of("hic15"));
  const std::string title = injury::title_of(decides->criterion);
  std::vector<double> values;
  for (const injury::CriterionResult& result : results)
    if (injury::title_of(result.criterion) == title && result.value) values.push_back(*result.value);
  return fmt::format("{} {} (must be {})", uncapitalised(title), range(values, *decides->criterion.quantity),
                     criterion_row(*decides, units, Detail::main).limit);
}

std::string answer_of(const Reports& reports, const UnitSystem& units) {
  const std::string figures = deciding_figures(reports, units);
  if (!reports.front().limits) return fmt::format("{} pulses: {}", reports.size(), figures);
  const auto within = std::ranges::count_if(reports, [](const injury::PulseReport& report) {
    return injury::verdict_of(report.limits->results) == injury::Verdict::pass;
  });
  return fmt::format("{} of {} pulses within the limits: {}", within == 0 ? "None" : std::to_string(within),
                     reports.size(), figures);
}

ValueRow row_of(const injury::PulseReport& report, std::string name, const UnitSystem& units) {
  ValueRow row{.label = std::move(name), .value = pulse_answer(report, units), .tone = pulse_tone(report)};
  if (!report.limits) return row;
  if (const injury::CriterionResult* const next = closest(report.limits->results)) {
    const std::string label = std::exchange(row.label, "");
    row = criterion_row(*next, units, Detail::main);
    row.label = label + ": " + row.label;
  }
  return row;
}

/// Each text once, and texts that differ in their numbers as the first of them, with the pulses of it.
std::vector<std::string> reservations_of(const Reports& reports) {
  const auto without_numbers = [](std::string text) {
    std::erase_if(text, [](char c) { return c == '.' || (c >= '0' && c <= '9'); });
    return text;
  };
  std::vector<std::string> texts, pulses;
  for (const injury::PulseReport& report : reports)
    for (const std::string& text : reservations(report)) {
      const auto known = std::ranges::find(texts, without_numbers(text), without_numbers);
      const std::string name = pulse_name(report, reports);
      if (known == texts.end())
        texts.push_back(text), pulses.push_back(name);
      else
        pulses[static_cast<std::size_t>(known - texts.begin())] +=
            (*known == text ? ", " : ", and with other values ") + name;
    }
  for (std::size_t i = 0; i < texts.size(); ++i) texts[i] += " (" + pulses[i] + ")";
  return texts;
}

}  // namespace

Plot pulses_plot(const std::vector<injury::PulseReport>& reports, const UnitSystem& units) {
  Panel panel{.title = "Accelerations, each from the start of contact",
              .x = axis_of("time", units),
              .y = axis_of("acceleration", units)};
  const double time_factor = value_in(units, 1, "s");
  for (const injury::PulseReport& report : reports) {
    const double length = report.contact.end - report.contact.begin;
    Series series{.label = pulse_name(report, reports)};
    for (std::size_t i = 0; i < report.pulse.time.size(); ++i) {
      const double time = report.pulse.time[i] - report.contact.begin;
      if (time < -0.2 * length || time > 1.5 * length) continue;
      series.add(time_factor * time, report.pulse.acceleration[i] / standard_gravity);
    }
    panel.series.push_back(std::move(series));
  }
  if (reports.front().limits) panel.add(acceleration_limits(reports.front().limits->results, units));
  return {.panels = {std::move(panel)}};
}

Document pulses_document(const std::vector<injury::PulseReport>& reports, const UnitSystem& units,
                         Pictures pictures) {
  Document document{.title = answer_of(reports, units), .lead = Lead{.answer = answer_of(reports, units)}};
  Lead& lead = *document.lead;
  for (const auto& [what, words] : reports.front().about)
    lead.subject.push_back(fmt::format("{}: {}", what, one_line(words)));
  if (reports.front().impact) lead.subject.push_back("All " + impact_words(*reports.front().impact, units));
  if (reports.front().limits)
    lead.subject.push_back("Limits of " + one_line(reports.front().limits->standard));
  for (const injury::PulseReport& report : reports) {
    lead.figures.push_back(row_of(report, pulse_name(report, reports), units));
    lead.tone = std::max(lead.tone, pulse_tone(report));  // the more serious comes later
  }
  document.warnings = reservations_of(reports);
  if (pictures == Pictures::drawn) lead.curve = pulses_plot(reports, units);
  document.sections = {{.heading = "The pulses", .seen = Seen::always, .tables = {table_of(reports, units)}}};
  for (const injury::PulseReport& report : reports) {
    Document one = pulse_document(report, units, pictures);
    Section section{.heading = pulse_name(report, reports),
                    .rows = {{"", one.lead->figures}},
                    .paragraphs = {one.lead->answer + "."}};
    section.tables = {{.columns = {"", ""}, .rows = pulse_basis(report, units)}};
    if (one.lead->curve)
      section.figures.push_back({.name = "Acceleration", .plot = *std::move(one.lead->curve)});
    document.sections.push_back(std::move(section));
  }
  return document;
}

}  // namespace dashpad::output
