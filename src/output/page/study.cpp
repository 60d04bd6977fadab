// A study as a page, and its leading figure as a still.

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dashpad/output/study.hpp"
#include "output/page/key_figures.hpp"
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

/// Bad where every row breaks the limit or strikes through, good where none does.
Tone tone_of(const study::StudyAnswers& answers) {
  if (answers.records.struck_through == answers.records.rows.size()) return Tone::bad;
  if (answers.limits.empty()) return Tone::plain;
  const LimitCount count = rows_above(answers, strictest_limit(answers));
  if (count.undecided > 0 || count.rows == 0) return Tone::plain;
  return count.exceeding == count.rows ? Tone::bad : count.exceeding == 0 ? Tone::good : Tone::plain;
}

/// Several figures of one kind, one below the other.
Plot together(std::vector<CaptionedPlot> figures, const std::string& title) {
  Plot plot{.title = title, .panels = {}, .source = figures.front().plot.source};
  for (CaptionedPlot& figure : figures)
    for (Panel& panel : figure.plot.panels)
      if (plot.panels.size() < most_panels_of_still) plot.panels.push_back(std::move(panel));
  return plot;
}

/// The figures of the kind that answers the study, those of the response with a limit first.
std::vector<CaptionedPlot> leading_figures(const study::StudyAnswers& answers, const UnitSystem& units) {
  using Make = std::vector<CaptionedPlot> (*)(const study::StudyAnswers&, const UnitSystem&);
  constexpr Make indices = [](const study::StudyAnswers& of, const UnitSystem&) { return index_figures(of); };
  const bool asks_for_limit = !answers.limits.empty();
  std::vector<Make> kinds{cushion_figures, named_figures, map_figures, curve_figures, distribution_figures};
  if (!asks_for_limit) kinds.insert(kinds.begin() + 1, indices);
  for (const Make make : kinds) {
    std::vector<CaptionedPlot> figures = make(answers, units);
    if (figures.empty()) continue;
    if (asks_for_limit)
      // Not std::ranges: clang 14 refuses what libstdc++ 12 returns there.
      std::stable_partition(figures.begin(), figures.end(), [&](const CaptionedPlot& of) {
        return of.plot.panels.front().title == title_of(answers.limits[strictest_limit(answers)].response);
      });
    // One map alone: its legend would be lost among those of others.
    if (make == Make{map_figures}) figures.resize(1);
    return figures;
  }
  return {};
}

/// The panel of which the answer speaks: of cushion curves that of the highest drop.
Plot answering_plot(const study::StudyAnswers& answers, const UnitSystem& units) {
  std::vector<CaptionedPlot> figures = leading_figures(answers, units);
  if (figures.empty()) return {};
  std::vector<Panel>& panels = figures.front().plot.panels;
  return {.panels = {std::move(answers.cushion_curves ? panels.back() : panels.front())}};
}

}  // namespace

FiguresPage study_page(const study::StudyAnswers& answers, const UnitSystem& units) {
  const bool drawn = answers.groups.front().group.drawn;
  FiguresPage page{
      .title = answers.study.title.empty() ? "Study" : one_line(answers.study.title),
      .summary = {fmt::format("{} of {} rows, computed by Dashpad {}.", answers.records.rows.size(),
                              answers.rows, one_line(answers.program))},
      .warnings = study_warnings(answers),
      .sections = {}};
  if (std::string answer = study_answer(answers, units); !answer.empty()) {
    page.lead = Lead{.answer = std::move(answer), .tone = tone_of(answers), .subject = {page.title}};
    page.lead->reservation = first_of(page.warnings);
    page.lead->figures = study_key_figures(answers, units);
    if (Plot plot = answering_plot(answers, units); !plot.panels.empty()) page.lead->curve = std::move(plot);
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
  add(page, "By name", named_figures(answers, units));
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
  std::vector<CaptionedPlot> figures = leading_figures(answers, units);
  return figures.empty() ? Plot{} : together(std::move(figures), title);
}

}  // namespace dashpad::output
