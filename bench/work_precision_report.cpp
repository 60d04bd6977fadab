// Work against precision: a figure and a table for each case, and how far it is to the goal.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "front.hpp"
#include "report.hpp"

namespace dashpad::bench {
namespace {

struct CaseText {
  const char* id;
  const char* title;
  double goal_us;  ///< 0: none
};
constexpr std::array cases{CaseText{"c1", "dashboard example, 9-parameter law", 10},
                           CaseText{"c2", "dashboard example, 21-parameter law", 20},
                           CaseText{"c3", "hard case, 9-parameter law", 10},
                           CaseText{"v1", "dashboard example, linear viscoelastic pad", 0}};

/// Families have a colour, their members shapes.
struct Solver {
  const char* name;
  std::size_t turn;
};
constexpr std::array solvers{
    Solver{"Dashpad", 0},         Solver{"Dashpad (called once)", 5}, Solver{"one run", 2},
    Solver{"two runs", 9},        Solver{"CVODE (best settings)", 1}, Solver{"CVODE (own columns)", 4},
    Solver{"1984 as printed", 6}, Solver{"1984 mended", 20},          Solver{"SciPy script", 3}};

constexpr double goal_error = 1e-3;

enum class Measure { all_figures, force_and_rebound };

double error_of(const RawResults& results, std::size_t row, Measure measure) {
  const double error = std::max(results.number(row, "error_force"), results.number(row, "error_rebound"));
  return measure == Measure::all_figures ? std::max(error, results.number(row, "error_penetration")) : error;
}

/// Times in us.
std::vector<WorkPoint> front_of(const RawResults& results, const std::string& id, const std::string& solver,
                                Measure measure) {
  std::vector<WorkPoint> points;
  for (std::size_t row = 0; row < results.size(); ++row)
    if (results.text(row, "case") == id && results.text(row, "solver") == solver &&
        results.number(row, "failures") == 0)
      points.push_back({error_of(results, row, measure), results.number(row, "median_us")});
  return front_of(points);
}

/// The fastest point of a front that is as accurate as that.
std::optional<WorkPoint> fastest(const std::vector<WorkPoint>& front, double error) {
  std::optional<WorkPoint> last;
  for (const WorkPoint& point : front)
    if (point.error <= error) last = point;
  return last;
}

std::string in_words(double time_us) {
  if (time_us < 1000) return fmt::format("{:.3g} us", time_us);
  return time_us < 1e6 ? fmt::format("{:.3g} ms", time_us / 1000) : fmt::format("{:.3g} s", time_us / 1e6);
}

output::Panel panel_of(const RawResults& results, const CaseText& case_text, Measure measure,
                       const char* title, const char* axis) {
  output::Panel panel{.title = title,
                      .x = {.label = axis, .logarithmic = true},
                      .y = {.label = "CPU time an impact (us)", .logarithmic = true, .low = 1},
                      .series = {}};
  for (const Solver& solver : solvers) {
    output::Series line{.style = output::SeriesStyle::solid_line, .palette_index = solver.turn};
    for (const WorkPoint& point : front_of(results, case_text.id, solver.name, measure)) {
      line.x.push_back(point.error);
      line.y.push_back(point.time);
    }
    output::Series points = line;
    points.style = output::SeriesStyle::points;
    points.label = solver.name;
    panel.series.push_back(std::move(line));
    panel.series.push_back(std::move(points));
  }
  if (case_text.goal_us > 0 && measure == Measure::force_and_rebound) {
    panel.series.push_back({.label = fmt::format("goal: {} us at {}", case_text.goal_us, goal_error),
                            .style = output::SeriesStyle::horizontal_line,
                            .y = {case_text.goal_us}});
    panel.series.push_back({.style = output::SeriesStyle::vertical_line, .x = {goal_error}});
  }
  return panel;
}

output::CaptionedPlot figure_of(const RawResults& results, const CaseText& case_text) {
  return {
      .name = case_text.id,
      .plot = {.title = fmt::format("Work and precision: {}", case_text.title),
               .panels = {panel_of(results, case_text, Measure::all_figures,
                                   "Peak force, penetration, rebound", "Largest relative error of the three"),
                          panel_of(results, case_text, Measure::force_and_rebound,
                                   "Peak force and rebound alone", "Largest relative error of the two")},
               .source = facts_text(results)},
      .note =
          "Each point is a setting that no other setting of its solver beats. Errors are the largest over "
          "five speeds."};
}

output::Table precision_table(const RawResults& results, const CaseText& case_text) {
  constexpr std::array wanted{1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};
  output::Table table{.caption = fmt::format("{}: {}. Fastest setting with at most this true error",
                                             case_text.id, case_text.title),
                      .columns = {"solver"},
                      .rows = {}};
  for (const double error : wanted) table.columns.push_back(fmt::format("{:.0e}", error));
  for (const Solver& solver : solvers) {
    const auto front = front_of(results, case_text.id, solver.name, Measure::all_figures);
    if (front.empty()) continue;
    std::vector<std::string> row{solver.name};
    for (const double error : wanted) {
      const auto point = fastest(front, error);
      row.push_back(point ? in_words(point->time) : "-");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string ratio(const std::vector<WorkPoint>& cvode, const WorkPoint& point) {
  if (cvode.empty()) return "-";
  const FrontTime other = time_on(cvode, point.error);
  return fmt::format("{}{:.3g}", other.relation == '=' ? "" : std::string(1, other.relation),
                     other.time / point.time);
}

output::Table goal_table(const RawResults& results) {
  output::Table table{
      .caption = "Fastest setting with a true error of at most 1e-3 in peak force and rebound speed",
      .columns = {"case", "goal", "with estimate", "error", "CVODE takes", "one run", "error", "CVODE takes"},
      .rows = {}};
  for (const CaseText& case_text : cases) {
    const auto cvode = front_of(results, case_text.id, "CVODE (best settings)", Measure::force_and_rebound);
    std::vector<std::string> row{fmt::format("{}: {}", case_text.id, case_text.title),
                                 case_text.goal_us > 0 ? in_words(case_text.goal_us) : "-"};
    for (const char* solver : {"Dashpad", "one run"}) {
      const auto point =
          fastest(front_of(results, case_text.id, solver, Measure::force_and_rebound), goal_error);
      row.push_back(point ? in_words(point->time) : "-");
      row.push_back(point ? fmt::format("{:.1e}", point->error) : "-");
      row.push_back(point ? ratio(cvode, *point) + " times" : "-");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

Chapter work_precision_chapter(const RawResults& results) {
  Chapter chapter;
  chapter.section.heading = "Work and precision";
  chapter.section.paragraphs = {facts_text(results)};
  for (const auto& fact : results.facts())
    if (std::ranges::any_of(cases, [&](const CaseText& case_text) { return fact.first == case_text.id; }))
      chapter.section.paragraphs.push_back(fmt::format("{}: {}", fact.first, fact.second));
  chapter.section.tables.push_back(goal_table(results));
  chapter.table_names.emplace_back("goal");
  for (const CaseText& case_text : cases) {
    const auto measured = results.values("case");
    if (std::ranges::find(measured, case_text.id) == measured.end()) continue;
    chapter.section.tables.push_back(precision_table(results, case_text));
    chapter.table_names.push_back(fmt::format("precision-{}", case_text.id));
    chapter.section.figures.push_back(figure_of(results, case_text));
    chapter.figure_names.push_back(fmt::format("work-precision-{}", case_text.id));
  }
  return chapter;
}

}  // namespace dashpad::bench
