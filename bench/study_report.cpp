// What studies cost, on 1 to all cores and by their size.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "report.hpp"

namespace dashpad::bench {
namespace {

/// The least of the repetitions; memory and store their largest.
struct Cost {
  double wall = 0, cpu = 0, memory = 0, store = 0;
};
/// By study, launcher, workers and samples.
using Key = std::tuple<std::string, std::string, int, double>;
using Costs = std::map<Key, Cost>;

Costs costs_of(const RawResults& results, const std::string& part) {
  Costs costs;
  for (std::size_t row = 0; row < results.size(); ++row) {
    if (results.text(row, "part") != part) continue;
    const Cost cost{results.number(row, "wall_s"), results.number(row, "cpu_s"),
                    results.number(row, "peak_memory_bytes"), results.number(row, "store_bytes")};
    const Key key{results.text(row, "study"), results.text(row, "launcher"),
                  static_cast<int>(results.number(row, "workers")), results.number(row, "samples")};
    const auto [place, fresh] = costs.emplace(key, cost);
    if (fresh) continue;
    Cost& known = place->second;
    known = {std::min(known.wall, cost.wall), std::min(known.cpu, cost.cpu),
             std::max(known.memory, cost.memory), std::max(known.store, cost.store)};
  }
  return costs;
}

std::string law_of(const std::string& study) {
  return study == "law-4" ? "9-parameter law" : "21-parameter law";
}

/// Speed-up over one worker of the same kind, and what it is of the ideal, in wall and in CPU time.
struct Scaling {
  double speed_up = 1, wall_efficiency = 1, cpu_efficiency = 1;
};
Scaling scaling_of(const Costs& costs, const Key& key) {
  Key alone = key;
  std::get<int>(alone) = 1;
  const Cost &one = costs.at(alone), &all = costs.at(key);
  const double speed_up = one.wall / all.wall;
  return {speed_up, speed_up / std::get<int>(key), one.cpu / all.cpu};
}

output::Table scaling_table(const Costs& costs) {
  output::Table table{.caption = "",
                      .columns = {"law", "workers", "rows a second", "speed-up", "efficiency, wall time",
                                  "efficiency, CPU time", "CPU time a row"},
                      .rows = {}};
  for (const auto& [key, cost] : costs) {
    const auto& [study, launcher, workers, samples] = key;
    const Scaling scaling = scaling_of(costs, key);
    table.rows.push_back(
        {law_of(study),
         fmt::format("{} {}", workers, workers == 1 ? launcher.substr(0, launcher.size() - 1) : launcher),
         fmt::format("{:.0f}", samples / cost.wall), fmt::format("{:.2f}", scaling.speed_up),
         fmt::format("{:.0f} %", 100 * scaling.wall_efficiency),
         fmt::format("{:.0f} %", 100 * scaling.cpu_efficiency),
         fmt::format("{:.0f} us", 1e6 * cost.cpu / samples)});
  }
  return table;
}

output::Table samples_table(const Costs& costs) {
  output::Table table{.caption = "",
                      .columns = {"law", "samples", "wall time", "CPU time a row", "peak memory", "store"},
                      .rows = {}};
  for (const auto& [key, cost] : costs) {
    const auto& [study, launcher, workers, samples] = key;
    table.rows.push_back({law_of(study), fmt::format("{:.0f}", samples), fmt::format("{:.2f} s", cost.wall),
                          fmt::format("{:.0f} us", 1e6 * cost.cpu / samples),
                          fmt::format("{:.1f} MB", cost.memory / 1e6),
                          fmt::format("{:.1f} MB", cost.store / 1e6)});
  }
  return table;
}

/// Lines with their points; the label stands at the points.
void add(output::Panel& panel, const std::string& label, std::size_t turn, double x, double y) {
  for (output::Series& series : panel.series)
    if (series.palette_index == turn) {
      series.x.push_back(x);
      series.y.push_back(y);
    }
  if (std::ranges::any_of(panel.series,
                          [&](const output::Series& series) { return series.palette_index == turn; }))
    return;
  panel.series.push_back(
      {.style = output::SeriesStyle::solid_line, .x = {x}, .y = {y}, .palette_index = turn});
  panel.series.push_back(
      {.label = label, .style = output::SeriesStyle::points, .x = {x}, .y = {y}, .palette_index = turn});
}

output::CaptionedPlot scaling_figure(const RawResults& results, const Costs& costs) {
  double most = 1;
  for (const auto& [key, cost] : costs) most = std::max<double>(most, std::get<int>(key));
  output::Panel speed_up{.title = "Speed-up",
                         .x = {.label = "Cores", .low = 0.5, .high = most + 0.5},
                         .y = {.label = "Times one worker", .low = 0},
                         .series = {}};
  output::Panel wall{.title = "Efficiency in wall time",
                     .x = speed_up.x,
                     .y = {.label = "Efficiency (%)", .low = 0},
                     .series = {}};
  output::Panel cpu{.title = "Efficiency in CPU time", .x = speed_up.x, .y = wall.y, .series = {}};
  for (const auto& [key, cost] : costs) {
    const auto& [study, launcher, workers, samples] = key;
    const std::string label = fmt::format("{}, {}", law_of(study), launcher);
    const std::size_t turn = (study == "law-4" ? 0U : 1U) + (launcher == "threads" ? 0U : 2U);
    const Scaling scaling = scaling_of(costs, key);
    add(speed_up, label, turn, workers, scaling.speed_up);
    add(wall, label, turn, workers, 100 * scaling.wall_efficiency);
    add(cpu, label, turn, workers, 100 * scaling.cpu_efficiency);
  }
  speed_up.series.push_back({.label = "ideal",
                             .style = output::SeriesStyle::dashed_line,
                             .x = {1, most},
                             .y = {1, most},
                             .palette_index = 6});
  return {
      .name = "Scaling",
      .plot = {.title = "A study on 1 to all cores",
               .panels = {speed_up, wall, cpu},
               .source = facts_text(results)},
      .note =
          "Wall time of the whole command, against one worker of the same kind. CPU time does not see other "
          "programs on the machine."};
}

output::CaptionedPlot samples_figure(const RawResults& results, const Costs& costs) {
  const output::Axis samples_axis{.label = "Samples", .logarithmic = true, .low = 50, .high = 2e6};
  output::Panel wall{.title = "Wall time, all cores",
                     .x = samples_axis,
                     .y = {.label = "Time (s)", .logarithmic = true},
                     .series = {}};
  output::Panel cpu{
      .title = "CPU time a row", .x = samples_axis, .y = {.label = "Time (us)", .low = 0}, .series = {}};
  output::Panel memory{.title = "Peak memory by law, and the store on disk",
                       .x = samples_axis,
                       .y = {.label = "Size (MB)", .logarithmic = true},
                       .series = {}};
  for (const auto& [key, cost] : costs) {
    const std::string law = law_of(std::get<0>(key));
    const std::size_t turn = std::get<0>(key) == "law-4" ? 0 : 1;
    const double samples = std::get<3>(key);
    add(wall, law, turn, samples, cost.wall);
    add(cpu, law, turn, samples, 1e6 * cost.cpu / samples);
    add(memory, law, turn, samples, cost.memory / 1e6);
    if (turn == 0) add(memory, "store on disk", 2, samples, cost.store / 1e6);
  }
  return {.name = "Size",
          .plot = {.title = "The cost of a study and its size",
                   .panels = {wall, cpu, memory},
                   .source = facts_text(results)},
          .note = "Of the whole command: start, sampling, all responses, store."};
}

}  // namespace

Chapter study_chapter(const RawResults& results) {
  const Costs scaling = costs_of(results, "scaling"), samples = costs_of(results, "samples");
  Chapter chapter;
  chapter.section.heading = "Studies";
  chapter.section.paragraphs = {facts_text(results)};
  chapter.section.tables = {scaling_table(scaling), samples_table(samples)};
  chapter.section.tables[0].caption = "On 1 to all cores";
  chapter.section.tables[1].caption = "By number of samples, on all cores";
  chapter.table_names = {"scaling", "samples"};
  chapter.section.figures = {scaling_figure(results, scaling), samples_figure(results, samples)};
  chapter.figure_names = {"scaling", "samples"};
  return chapter;
}

}  // namespace dashpad::bench
