#include "output/plot/foam_figures.hpp"

#include <cmath>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "output/plot/axis_with_unit.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t turn_of_model = 0, turn_of_data = 1, turn_of_way_back = 2;

Series zero_line() { return {.style = SeriesStyle::horizontal_line, .y = {0}}; }

/// A quantity of a test: a series for loading and one for unloading.
struct BothWays {
  Series up, down;

  Series& way(int course) { return course > 0 ? up : down; }
  void add_to(Panel& panel) {
    for (Series* series : {&up, &down})
      if (!series->x.empty()) panel.series.push_back(std::move(*series));
  }
};

/// The lines of the model, each with a gap before a new cycle.
BothWays model_of(const fit::MetTest& test, double offset, const UnitSystem& units) {
  BothWays model{
      {.label = "model, loading", .style = SeriesStyle::solid_line, .palette_index = turn_of_model},
      {.label = "model, unloading", .style = SeriesStyle::dashed_line, .palette_index = turn_of_model}};
  for (std::size_t i = 0; i < test.computed.size(); ++i) {
    Series& own = model.way(test.course[i]);
    const auto add = [&](std::size_t k) {
      own.add(test.strain[k], value_in(units, test.computed[k] + offset, "Pa"));
    };
    if (i > 0 && test.course[i] != test.course[i - 1]) {
      own.add(NAN, NAN);
      add(i - 1);  // the turning point belongs to both ways
    }
    add(i);
  }
  return model;
}

}  // namespace

CaptionedPlot fit_test_figure(const fit::MetTest& test, const UnitSystem& units) {
  const Axis strain{.label = "Strain", .low = 0};
  Panel stress{"Stress", strain, axis_with_unit("Stress", "Pa", units), {}};
  Panel off{"Model minus test", strain, axis_with_unit("Stress", "Pa", units), {zero_line()}};
  BothWays measured{
      {.label = "test, loading", .style = SeriesStyle::points, .palette_index = turn_of_data},
      {.label = "test, unloading", .style = SeriesStyle::points, .palette_index = turn_of_way_back}};
  BothWays difference = measured;
  difference.up.label = "loading";
  difference.down.label = "unloading";
  const double offset = test.offset.value_or(0);
  for (std::size_t i = 0; i < test.strain.size(); ++i) {
    measured.way(test.course[i]).add(test.strain[i], value_in(units, test.measured[i], "Pa"));
    difference.way(test.course[i])
        .add(test.strain[i], value_in(units, test.computed[i] + offset - test.measured[i], "Pa"));
  }
  measured.add_to(stress);
  model_of(test, offset, units).add_to(stress);  // over the points
  difference.add_to(off);
  const std::string lowest = brief(test.lowest_rate, 3), highest = brief(test.highest_rate, 3);
  CaptionedPlot figure;
  figure.plot = {one_line(test.file) + (test.is_held_out ? " (predicted, not fitted)" : ""),
                 {std::move(stress), std::move(off)},
                 fmt::format("dashpad {}; strain rate {} 1/s", version(),
                             lowest == highest ? lowest : lowest + " to " + highest)};
  if (test.offset)
    figure.note = fmt::format("The model curve includes the fitted zero offset of the stress, {}.",
                              brief_quantity(*test.offset, "Pa", units, 3));
  return figure;
}

CaptionedPlot fit_pulse_figure(const fit::MetPulse& pulse, const UnitSystem& units) {
  Panel over_time{"Deceleration", axis_of("time", units), axis_of("deceleration", units), {}};
  Panel off{"Model minus pulse", over_time.x, over_time.y, {}};
  Series model{.label = "model", .style = SeriesStyle::solid_line, .palette_index = turn_of_model},
      measured{.label = "pulse", .style = SeriesStyle::points, .palette_index = turn_of_data};
  Series rest = measured;
  for (std::size_t i = 0; i < pulse.time.size(); ++i) {
    const double time = value_in(units, pulse.time[i], "s");
    measured.add(time, pulse.measured[i] / standard_gravity);
    if (pulse.computed.empty()) continue;
    model.add(time, pulse.computed[i] / standard_gravity);
    rest.add(time, (pulse.computed[i] - pulse.measured[i]) / standard_gravity);
  }
  over_time.series.push_back(std::move(measured));
  CaptionedPlot figure;
  figure.plot = {fmt::format("{}, case {}{}", one_line(pulse.pulse_file), one_line(pulse.file),
                             pulse.is_held_out ? " (predicted, not fitted)" : ""),
                 {},
                 fmt::format("dashpad {}; time from the onset of the pulse", version())};
  if (pulse.computed.empty()) {
    figure.note = "With the fitted material, this impact has no complete pulse.";
    figure.plot.panels = {std::move(over_time)};
    return figure;
  }
  over_time.series.push_back(std::move(model));
  off.series = {zero_line(), std::move(rest)};
  figure.plot.panels = {std::move(over_time), std::move(off)};
  return figure;
}

}  // namespace dashpad::output
