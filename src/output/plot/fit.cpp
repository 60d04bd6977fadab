#include "output/plot/foam_figures.hpp"

#include <cmath>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "output/plot/axis_with_unit.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t turn_of_model = 0, turn_of_data = 1, turn_of_way_back = 2;

Series data_points(const char* label, std::size_t palette_index) {
  Series series{.label = label, .style = SeriesStyle::points};
  series.palette_index = palette_index;
  return series;
}

Series zero_line() {
  Series series{.style = SeriesStyle::horizontal_line};
  series.y = {0};
  return series;
}

/// The model as it is compared: its line on the way up, and on the way down, with a gap where it turns.
void add_model(Panel& panel, const fit::MetTest& test, const UnitSystem& units) {
  Series up{.label = "model, loading", .style = SeriesStyle::solid_line};
  Series down{.label = "model, unloading", .style = SeriesStyle::dashed_line};
  up.palette_index = down.palette_index = turn_of_model;
  const double offset = test.offset.value_or(0);
  for (std::size_t i = 0; i < test.computed.size(); ++i) {
    const double stress = value_in(units, test.computed[i] + offset, "Pa");
    Series& own = test.course[i] > 0 ? up : down;
    if (i > 0 && test.course[i] != test.course[i - 1]) {
      // The turning point belongs to both; what was drawn of this way before is another cycle.
      own.add(NAN, NAN);
      own.add(test.strain[i - 1], value_in(units, test.computed[i - 1] + offset, "Pa"));
    }
    own.add(test.strain[i], stress);
  }
  for (Series* series : {&up, &down})
    if (!series->x.empty()) panel.series.push_back(std::move(*series));
}

}  // namespace

CaptionedPlot fit_test_figure(const fit::MetTest& test, const UnitSystem& units) {
  Panel stress{"Stress", {.label = "Strain"}, axis_with_unit("Stress", "Pa", units), {}};
  Panel off{"Model minus test", {.label = "Strain"}, axis_with_unit("Stress", "Pa", units), {}};
  stress.x.low = off.x.low = 0;
  Series up = data_points("test, loading", turn_of_data),
         down = data_points("test, unloading", turn_of_way_back);
  Series off_up = up, off_down = down;
  const double offset = test.offset.value_or(0);
  for (std::size_t i = 0; i < test.strain.size(); ++i) {
    (test.course[i] > 0 ? up : down).add(test.strain[i], value_in(units, test.measured[i], "Pa"));
    (test.course[i] > 0 ? off_up : off_down)
        .add(test.strain[i], value_in(units, test.computed[i] + offset - test.measured[i], "Pa"));
  }
  off.series.push_back(zero_line());
  for (Series* series : {&up, &down})
    if (!series->x.empty()) stress.series.push_back(std::move(*series));
  add_model(stress, test, units);  // over the points
  for (Series* series : {&off_up, &off_down})
    if (!series->x.empty()) off.series.push_back(std::move(*series));
  CaptionedPlot figure;
  figure.plot = {
      one_line(test.file) + (test.is_held_out ? ", predicted, not fitted" : ""),
      {std::move(stress), std::move(off)},
      fmt::format("dashpad {}; {:.3g} to {:.3g} 1/s", version(), test.lowest_rate, test.highest_rate)};
  if (test.offset)
    figure.note = fmt::format("The model is shown with the shift of the force zero that was found, {}.",
                              brief_quantity(*test.offset, "Pa", units, 3));
  return figure;
}

CaptionedPlot fit_pulse_figure(const fit::MetPulse& pulse, const UnitSystem& units) {
  Panel over_time{"Deceleration", axis_of("time", units), axis_of("deceleration", units), {}};
  Panel off{"Model minus pulse", axis_of("time", units), axis_of("deceleration", units), {}};
  Series model{.label = "model", .style = SeriesStyle::solid_line},
      measured = data_points("pulse", turn_of_data);
  model.palette_index = turn_of_model;
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
  figure.plot = {fmt::format("{} in {}{}", one_line(pulse.pulse_file), one_line(pulse.file),
                             pulse.is_held_out ? ", predicted, not fitted" : ""),
                 {},
                 fmt::format("dashpad {}; time since the onset of the pulse", version())};
  if (pulse.computed.empty()) {
    figure.note = "This impact has no whole pulse with the material that was found.";
    figure.plot.panels = {std::move(over_time)};
    return figure;
  }
  over_time.series.push_back(std::move(model));
  off.series = {zero_line(), std::move(rest)};
  figure.plot.panels = {std::move(over_time), std::move(off)};
  return figure;
}

}  // namespace dashpad::output
