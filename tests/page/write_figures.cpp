// Writes a page of figures with all that a plot can have: figures.test.mjs looks at it.
//   dashpad-page-figures FILE

#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "dashpad/output/document.hpp"

namespace {

using namespace dashpad;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::string attack = "</script><script>window.pwned=1</script><!-- <img src=x onerror=window.pwned=1>";

template <class Function>
std::vector<double> column(int count, Function&& value) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(value(i));
  return values;
}

/// Force over time as bands, lines and points, with a gap, and the motion below it.
output::Plot every_style() {
  const auto time = column(61, [](int i) { return 0.5 * i; });
  const auto pulse = [&](double high, double length) {
    return column(61, [=](int i) { return std::max(0.0, high * std::sin(M_PI * 0.5 * i / length)); });
  };
  output::Panel force{.title = "Force", .x = {.label = "Time (ms)"}, .y = {.label = "Force (kN)"}};
  auto gap = pulse(4, 27);
  gap[20] = gap[22] = nan;
  force.series = {
      {.label = "computed", .x = time, .y = gap},
      {.label = "range of the tests",
       .style = output::SeriesStyle::band,
       .x = time,
       .y = pulse(4, 24),
       .y2 = pulse(5.2, 28),
       .palette_index = 2},
      {.label = "mean of the tests",
       .style = output::SeriesStyle::solid_line,
       .x = time,
       .y = pulse(4.6, 26),
       .palette_index = 2},
      {.label = "test 1",
       .style = output::SeriesStyle::points,
       .x = {3, 7, 12, 17, 22},
       .y = {1.4, 3.2, 4.5, 4.1, 2.2}},
      {.label = "test 2",
       .style = output::SeriesStyle::points,
       .x = {4, 8, 13, 18, 23},
       .y = {2.0, 3.9, 5.0, 3.9, 1.5}},
      {.label = "model of 1984", .style = output::SeriesStyle::dashed_line, .x = time, .y = pulse(3.5, 29)},
      {.label = "limit", .style = output::SeriesStyle::horizontal_line, .y = {5.4}},
      {.label = "contact ends", .style = output::SeriesStyle::vertical_line, .x = {24, 27}},
  };
  output::Panel motion{
      .title = "Motion", .x = {.label = "Time (ms)", .low = 0, .high = 30}, .y = {.label = "Motion (mm)"}};
  motion.series = {
      {.label = "computed", .x = time, .y = pulse(48, 33)},
      {.label = "model of 1984", .style = output::SeriesStyle::dashed_line, .x = time, .y = pulse(44, 34)}};
  return {.title = "Every style",
          .panels = {force, motion},
          .source = "dashpad, an example; the tests are made up"};
}

output::Plot loop() {
  output::Panel panel{.x = {.label = "Penetration (mm)", .low = 0}, .y = {.label = "Force (N)", .low = 0}};
  const auto there = [](int i) { return 25 * std::sin(M_PI * i / 100); };
  for (int turn = 0; turn < 3; ++turn)
    panel.series.push_back(
        {.label = "impact at " + std::to_string(3 + turn) + " m/s",
         .x = column(101, there),
         .y = column(101, [&](int i) { return (i <= 50 ? 1 : 0.4) * (2 + turn) * std::pow(there(i), 2); })});
  return {.title = "A loop", .panels = {panel}, .source = "dashpad, an example"};
}

output::Plot logarithmic() {
  output::Panel panel{.title = "",
                      .x = {.label = "Rate of strain (1/s)", .logarithmic = true},
                      .y = {.label = "Stress (kPa)", .logarithmic = true, .low = 1}};
  const auto rate = column(50, [](int i) { return std::pow(10, -4 + 0.14 * i); });
  const auto power = [&](double times) {
    return column(50, [=](int i) {
      return i == 0 ? -1 : times * 20 * std::pow(rate[static_cast<std::size_t>(i)], 0.22);
    });
  };
  panel.series = {{.label = "95 %",
                   .style = output::SeriesStyle::band,
                   .x = rate,
                   .y = power(0.8),
                   .y2 = power(1.3),
                   .palette_index = 0},
                  {.label = "fit", .x = rate, .y = power(1), .palette_index = 0},
                  {.label = "measured",
                   .style = output::SeriesStyle::points,
                   .x = {1e-3, 0.1, 1, 10, 200},
                   .y = {4.4, 12.1, 21, 33, 62},
                   .palette_index = 0}};
  output::Panel narrow{.x = {.label = "Speed (m/s)", .logarithmic = true},
                       .y = {.label = "Error (1)", .logarithmic = true}};
  narrow.series = {{.label = "error", .x = {4, 5, 6, 7, 8.5}, .y = {2e-9, 5e-8, 3e-7, 8e-7, 9e-6}}};
  return {.title = "Logarithmic axes", .panels = {panel, narrow}, .source = "dashpad, an example"};
}

/// Many lines, long texts, small and large numbers.
output::Plot crowded() {
  output::Panel panel{
      .x = {.label = "Density of the pad as the report of 1986 gives it, converted to SI (kg/m³)"},
      .y = {.label = "Share of the energy (a number without a unit that is rather small)"}};
  for (int line = 0; line < 14; ++line)
    panel.series.push_back(
        {.label = "A rather long name of material number " + std::to_string(line + 1),
         .x = column(9, [](int i) { return 1e8 + 2e6 * i; }),
         .y = column(9, [&](int i) { return 1e-7 * (line + 1) * (1 + std::sin(0.5 * i)); })});
  return {
      .title = "Many series, long names, small and large numbers", .panels = {panel}, .source = "dashpad"};
}

output::Plot hostile() {
  output::Panel panel{.title = attack, .x = {.label = attack}, .y = {.label = attack}};
  panel.series = {{.label = attack, .x = {0, 1, 2}, .y = {0, 1, 0.5}}};
  return {.title = attack, .panels = {panel, {.title = "Nothing", .x = {"x"}, .y = {"y"}}}, .source = attack};
}

output::Document example() {
  const output::Table table{.caption = "Peaks of force",
                            .columns = {"Case", "Peak (kN)", "Error", "Remark"},
                            .rows = {{"first", "4.60", "0.02 %", "as in the report"},
                                     {"second", "12.1", "-", "extrapolated"},
                                     {attack, "-3.5e-4", "4.1 ± 0.2", attack}}};
  output::Table wide{.caption = "Wide", .columns = {"Quantity"}, .rows = {{"value"}}};
  for (int i = 0; i < 12; ++i) {
    wide.columns.push_back("column " + std::to_string(i));
    wide.rows[0].push_back(std::to_string(1000 * i));
  }
  return {
      .title = "Figures of an example",
      .summary = {"Everything that a page of figures can show.", "The numbers mean nothing."},
      .warnings = {"EXTRAPOLATED: beyond what was measured."},
      .sections = {{.heading = "Forces",
                    .paragraphs = {"A pulse."},
                    .tables = {table},
                    .figures = {{"Figure 1", every_style(), "A note below it."}, {"Figure 2", loop()}}},
                   {.heading = "Materials",
                    .tables = {wide},
                    .figures = {{"", logarithmic()}, {"Figure 4", crowded()}}},
                   {.heading = attack, .paragraphs = {attack}, .figures = {{attack, hostile(), attack}}}}};
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  try {
    std::ofstream file{arguments[1], std::ios::binary};
    file << output::to_html(example());
    return file.flush() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
