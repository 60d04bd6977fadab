// A study as a page, and its leading figure as a still.

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dashpad/output/study.hpp"
#include "dashpad/version.hpp"
#include "output/page/study_key_figures.hpp"
#include "output/plot/study_figures.hpp"
#include "output/text/study_answer.hpp"
#include "output/text/study_tables.hpp"
#include "output/text/study_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t most_panels_of_still = 4;

void add(FiguresPage& page, const char* heading, std::vector<CaptionedPlot> figures,
         std::vector<std::string> paragraphs = {}) {
  if (!figures.empty())
    page.sections.push_back({.heading = heading,
                             .paragraphs = std::move(paragraphs),
                             .tables = {},
                             .figures = std::move(figures)});
}

/// Several figures of one kind, one below the other.
Plot together(std::vector<CaptionedPlot> figures, const std::string& title) {
  Plot plot{.title = title, .panels = {}, .source = figures.front().plot.source};
  for (CaptionedPlot& figure : figures)
    for (Panel& panel : figure.plot.panels)
      if (plot.panels.size() < most_panels_of_still) plot.panels.push_back(std::move(panel));
  return plot;
}

/// One panel alone: that of the response with a limit, or of the highest drop, of which the answer speaks.
void keep_the_answer(std::vector<Panel>& panels, const study::StudyAnswers& answers) {
  if (panels.size() < 2) return;
  Panel kept = answers.cushion_curves ? panels.back() : panels.front();
  if (!answers.limits.empty())
    if (const auto limited =
            std::ranges::find(panels, title_of(answers.limits.front().response), &Panel::title);
        limited != panels.end())
      kept = *limited;
  panels = {std::move(kept)};
}

}  // namespace

FiguresPage study_page(const study::StudyAnswers& answers, const UnitSystem& units) {
  const bool drawn = answers.groups.front().group.drawn;
  FiguresPage page{
      .title = answers.study.title.empty() ? "Study" : one_line(answers.study.title),
      .summary = {fmt::format("{} of {} rows, computed by Dashpad {}.", answers.records.rows.size(),
                              answers.rows, one_line(answers.program)),
                  fmt::format("dashpad {}, commit {}", version(), build_facts().git_commit)},
      .warnings = study_warnings(answers),
      .sections = {}};
  if (std::string answer = study_answer(answers, units); !answer.empty()) {
    page.lead = Lead{.answer = std::move(answer), .subject = {page.title}};
    if (!page.warnings.empty()) page.lead->reservation = page.warnings.front();
    page.lead->figures = study_key_figures(answers, units);
    page.lead->curve = study_plot(answers, units);
    page.lead->curve->title.clear();
    page.lead->curve->source.clear();
    keep_the_answer(page.lead->curve->panels, answers);
  }
  page.sections.push_back({.heading = "What was studied",
                           .paragraphs = {},
                           .tables = {factor_table(answers, units)},
                           .figures = {}});
  page.sections.push_back({.heading = "Answers",
                           .paragraphs = {interval_note(answers)},
                           .tables = study_tables(answers, units),
                           .figures = {}});
  add(page, "Cushion curves", cushion_figures(answers, units));
  add(page, "Curves", curve_figures(answers, units));
  std::vector<CaptionedPlot> maps = map_figures(answers, units);
  for (CaptionedPlot& figure : coloured_scatter_figures(answers, units)) maps.push_back(std::move(figure));
  add(page, "Maps", std::move(maps));
  add(page, "Which factor matters", index_figures(answers));
  if (drawn) add(page, "Distributions", distribution_figures(answers, units));
  add(page, "Scatter", scatter_figures(answers, units));
  return page;
}

Plot study_plot(const study::StudyAnswers& answers, const UnitSystem& units) {
  const std::string title = answers.study.title.empty() ? "Study" : one_line(answers.study.title);
  // One map alone: its legend would be lost among those of others.
  std::vector<CaptionedPlot> maps = map_figures(answers, units);
  if (maps.size() > 1) maps.erase(maps.begin() + 1, maps.end());
  for (std::vector<CaptionedPlot> figures :
       {cushion_figures(answers, units), index_figures(answers), maps, curve_figures(answers, units),
        distribution_figures(answers, units)})
    if (!figures.empty()) return together(std::move(figures), title);
  return {};
}

}  // namespace dashpad::output
