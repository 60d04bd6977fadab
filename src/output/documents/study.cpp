// The document of a study, and its leading figure as a still.

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dashpad/output/study.hpp"
#include "output/layout.hpp"
#include "output/plot/study_figures.hpp"
#include "output/text/study_answer.hpp"
#include "output/text/study_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t max_panels_of_still = 4;

void add(Document& document, const char* heading, std::vector<CaptionedPlot> figures) {
  if (!figures.empty())
    document.sections.push_back({.heading = heading, .seen = Seen::on_pages, .figures = std::move(figures)});
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
      if (plot.panels.size() < max_panels_of_still) plot.panels.push_back(std::move(panel));
  return plot;
}

/// The figures of the kind that answers the study, those of the response with a limit first.
std::vector<CaptionedPlot> leading_figures(const study::StudyAnswers& answers, const UnitSystem& units) {
  using Make = std::vector<CaptionedPlot> (*)(const study::StudyAnswers&, const UnitSystem&);
  constexpr Make indices = [](const study::StudyAnswers& study_answers, const UnitSystem&) {
    return index_figures(study_answers);
  };
  const bool asks_for_limit = !answers.limits.empty();
  std::vector<Make> kinds{cushion_figures, named_figures, map_figures, curve_figures, distribution_figures};
  if (!asks_for_limit) kinds.insert(kinds.begin() + 1, indices);
  for (const Make make : kinds) {
    std::vector<CaptionedPlot> figures = make(answers, units);
    if (figures.empty()) continue;
    if (asks_for_limit)
      // std::ranges::stable_partition does not compile with clang 14 and libstdc++ 12.
      std::stable_partition(figures.begin(), figures.end(), [&](const CaptionedPlot& figure) {
        return figure.plot.panels.front().title ==
               title_of(answers.limits[strictest_limit(answers)].response);
      });
    // A map stands alone: other maps would compete with its legend.
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

void add_pictures(Document& document, const study::StudyAnswers& answers, const UnitSystem& units) {
  if (document.lead)
    if (Plot plot = answering_plot(answers, units); !plot.panels.empty())
      document.lead->curve = std::move(plot);
  add(document, "Cushion curves", cushion_figures(answers, units));
  add(document, "By name", named_figures(answers, units));
  add(document, "Curves", curve_figures(answers, units));
  std::vector<CaptionedPlot> maps = map_figures(answers, units);
  for (CaptionedPlot& figure : coloured_scatter_figures(answers, units)) maps.push_back(std::move(figure));
  add(document, "Maps", std::move(maps));
  add(document, "Effect of the factors", index_figures(answers));
  if (answers.groups.front().group.drawn)
    add(document, "Distributions", distribution_figures(answers, units));
  add(document, "Scatter", scatter_figures(answers, units));
}

}  // namespace

Document study_document(const study::StudyAnswers& answers, const UnitSystem& units, Pictures pictures) {
  Document document{
      .title = answers.study.title.empty() ? "Study" : one_line(answers.study.title),
      .summary = {fmt::format("{} of {} rows, computed by Dashpad {}.", answers.records.rows.size(),
                              answers.rows, one_line(answers.program))},
      .warnings = study_warnings(answers)};
  if (std::string answer = study_answer(answers, units); !answer.empty())
    document.lead = Lead{.answer = std::move(answer),
                         .tone = tone_of(answers),
                         .subject = {document.title},
                         .figures = study_key_figures(answers, units)};
  if (!answers.records.rows.empty())
    document.sections = {{.heading = "Study", .seen = Seen::always, .tables = {factor_table(answers, units)}},
                         {.heading = "Answers",
                          .seen = Seen::always,
                          .paragraphs = {interval_note(answers)},
                          .tables = study_tables(answers, units)}};
  if (pictures == Pictures::drawn) add_pictures(document, answers, units);
  return document;
}

Plot study_plot(const study::StudyAnswers& answers, const UnitSystem& units) {
  const std::string title = answers.study.title.empty() ? "Study" : one_line(answers.study.title);
  std::vector<CaptionedPlot> figures = leading_figures(answers, units);
  return figures.empty() ? Plot{} : together(std::move(figures), title);
}

}  // namespace dashpad::output
