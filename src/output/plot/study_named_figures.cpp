// Each response of a study over one factor of names, such as that of the material: bars, the least on top.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "output/plot/study_figures.hpp"
#include "output/text/study_words.hpp"

namespace dashpad::output {

namespace {

/// The largest number of bars in a plot.
constexpr std::size_t max_bars = 24;

struct Bar {
  std::string name;
  double value = 0;  ///< SI; infinite where the pad bottomed out
};

std::vector<Bar> bars_of(const study::StudyAnswers& answers, std::size_t response, const UnitSystem& units) {
  const study::Group& group = answers.groups.front().group;
  const std::vector<double> values =
      study::values_of(answers.study, answers.records, group, answers.responses[response]);
  std::vector<Bar> bars;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isnan(values[i]))
      bars.push_back(
          {level_text(answers.study, 0, answers.records.factors.front()[group.places[i]], units), values[i]});
  std::ranges::stable_sort(bars, {}, &Bar::value);
  return bars;
}

/// The end of the axis, chosen so that one extreme bar does not hide the others.
double end_of_axis(const std::vector<Bar>& bars, const std::vector<study::StudyLimit>& limits,
                   const std::string& response) {
  constexpr double times_middle = 4;
  const double middle = bars[(bars.size() - 1) / 2].value;
  double end = std::isfinite(middle) ? times_middle * middle : 0, greatest = 0;
  for (const study::StudyLimit& limit : limits)
    if (limit.response == response) end = std::max(end, times_middle / 2 * limit.value);
  for (const Bar& bar : bars)
    if (std::isfinite(bar.value)) greatest = std::max(greatest, bar.value);
  return end > 0 ? std::min(end, 1.05 * std::max(greatest, end / times_middle)) : greatest;
}

Panel panel_of(const study::StudyAnswers& answers, const std::string& name, const std::vector<Bar>& bars,
               const UnitSystem& units) {
  const double scale = shown_as(si_unit_of(name), units).scale;
  const double end = scale * end_of_axis(bars, answers.limits, name);
  Panel panel{.title = title_of(name),
              .x = {.label = label(name, units), .low = 0},
              .y = {.has_numbers = false, .low = 0.5, .high = static_cast<double>(bars.size()) + 0.5}};
  if (end > 0) panel.x.high = end;
  Series struck = struck_through_marks();
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const auto height = static_cast<double>(bars.size() - i);
    const bool is_finite = std::isfinite(bars[i].value);
    panel.series.push_back(
        {.style = SeriesStyle::solid_line,
         .x = {0, is_finite ? std::min(scale * bars[i].value, end) : end},
         .y = {height, height},
         .palette_index = 0,
         .end_label = fmt::format("{}: {}", bars[i].name, three_digits(name, bars[i].value, units))});
    if (!is_finite) struck.add(end, height);
  }
  panel.add(limit_lines(answers, name, SeriesStyle::vertical_line, units));
  if (!struck.x.empty()) panel.series.push_back(std::move(struck));
  return panel;
}

}  // namespace

std::vector<CaptionedPlot> named_figures(const study::StudyAnswers& answers, const UnitSystem& units) {
  std::vector<CaptionedPlot> figures;
  const std::vector<study::Factor>& factors = answers.study.factors;
  if (factors.size() != 1 || !factors.front().unit.empty() || factors.front().is_sampled()) return figures;
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    const std::string& name = response_name(answers, i);
    const std::vector<Bar> bars = bars_of(answers, i, units);
    const bool has_value = std::ranges::any_of(bars, [](const Bar& bar) { return std::isfinite(bar.value); });
    if (bars.size() > max_bars || !has_value || bars.front().value < 0) continue;
    figures.push_back(study_figure(answers,
                                   fmt::format("{} by {}", title_of(name), factor_words(factors.front().key)),
                                   {panel_of(answers, name, bars, units)}));
  }
  return figures;
}

}  // namespace dashpad::output
