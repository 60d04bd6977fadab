// The effect of 1 % of each number on a figure: a tornado.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/output/sensitivity.hpp"
#include "dashpad/version.hpp"
#include "output/text/sensitivity_words.hpp"
#include "output/text/study_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t max_drawn = 8;

}  // namespace

Plot sensitivity_plot(const sensitivity::Answer& answer, std::size_t figure) {
  const std::vector<std::size_t> drawn = seen_effects(answer, figure, max_drawn);
  Panel panel{.title = fmt::format("Change of the {} if one number grows by 1 %",
                                   title_in_sentence(*answer.figures[figure])),
              .x = {.label = "Change (%)"},
              .y = {.has_numbers = false, .low = 0.5, .high = static_cast<double>(drawn.size()) + 0.5}};
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const sensitivity::Input& input = answer.inputs[drawn[i]];
    const sensitivity::Elasticity& elasticity = input.elasticities[figure];
    const auto height = static_cast<double>(drawn.size() - i);
    panel.series.push_back(
        {.style = SeriesStyle::solid_line,
         .x = {0, elasticity.value},
         .y = {height, height},
         .palette_index = elasticity.value < 0 ? 1 : 0,
         .end_label = fmt::format("{:+.2f} {}", elasticity.value, factor_words(input.key))});
  }
  panel.add(Series{.label = "", .style = SeriesStyle::vertical_line, .x = {0}, .y = {0}});
  return {.title = sensitivity_answer(answer, figure),
          .panels = {std::move(panel)},
          .source = fmt::format("dashpad {}; {}", version(), one_line(answer.impact.title))};
}

}  // namespace dashpad::output
