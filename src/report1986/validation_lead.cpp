// The verdict at the top of the page: whether Dashpad meets the tests of 1986.

#include <algorithm>

#include <fmt/format.h>

#include "output/layout.hpp"
#include "quantities/text.hpp"
#include "report1986/validation_figures.hpp"
#include "report1986/validation_tables.hpp"

namespace dashpad::report1986 {

namespace {

std::string answer_of(const Tally& by_law, const Tally& held_out) {
  const std::string foam =
      held_out.all == 0 ? ""
                        : fmt::format(", and a foam fitted with the predicted test left out meets {} of {}",
                                      held_out.passed, held_out.all);
  const char* const met = by_law.passes_all() ? "meets" : "does not meet";
  return fmt::format("The report's foam law {} all the rules for the 1986 tests: it meets {} of {}{}", met,
                     by_law.passed, by_law.all, foam);
}

output::Tone tone_of(const Tally& by_law, const Tally& held_out) {
  if (by_law.passes_all()) return output::Tone::good;
  return held_out.passes_all() ? output::Tone::doubtful : output::Tone::bad;
}

/// The score of the accurate solver with the report's law, at the favoured radius.
const Score* score_by_law(const Study& study, TestSupport support, Quantity quantity) {
  for (const Verdict& verdict : study.verdicts)
    if (const Score& score = verdict.score;
        score.program == Program::accurate && score.support == support && score.quantity == quantity)
      return &score;
  return nullptr;
}

/// "15 %", or "0.05" for strain.
std::string limit_text(const Rule& rule, double value) {
  return rule.logarithmic ? brief(100 * value) + " %" : brief(value);
}

/// "-2.6 ± 3.9 %", with a no-break space before the unit.
std::string bias_with_error(const HeldOutScore& score) {
  if (score.errors.empty()) return "none";
  if (!score.standard_error) return bias_text(score.bias, score.quantity);
  return rule_of(score.quantity).logarithmic
             ? fmt::format("{:+.1f} ± {:.1f}\u00a0%", 100 * score.bias, 100 * *score.standard_error)
             : fmt::format("{:+.3f} ± {:.3f}", score.bias, *score.standard_error);
}

/// Bias with its standard error, or scatter: whichever is nearer to its limit; the other is the remark.
output::ValueRow score_figure(const Study& study, const HeldOutScore& score) {
  const Rule& rule = rule_of(score.quantity);
  const Score* const by_law = score_by_law(study, score.support, score.quantity);
  // Rules are symmetric about zero.
  const double share_of_bias = score.bias > 0 ? score.bias / rule.high : score.bias / rule.low;
  const double share_of_scatter = score.scatter.value_or(0) / rule.scatter;
  const bool is_scatter = share_of_scatter > share_of_bias;
  const std::string bias = bias_with_error(score), max_bias = "limit ±" + limit_text(rule, rule.high);
  const std::string scatter = score.scatter ? scatter_text(*score.scatter, score.quantity) : "";
  const std::string max_scatter = "limit " + limit_text(rule, rule.scatter);
  output::ValueRow figure{.label = fmt::format("{} in {}, {}", is_scatter ? "Scatter" : "Bias",
                                               to_string(score.quantity), to_string(score.support)),
                          .value = is_scatter ? scatter : bias,
                          .remark = (is_scatter ? max_scatter : max_bias) + "; ",
                          .share = std::max(share_of_bias, share_of_scatter),
                          .tone = score.passed ? output::Tone::good : output::Tone::bad};
  figure.remark += is_scatter        ? fmt::format("bias {}, {}", bias, max_bias)
                   : scatter.empty() ? "too few tests to determine the scatter"
                                     : fmt::format("scatter {}, {}", scatter, max_scatter);
  if (by_law != nullptr && !by_law->errors.empty())
    figure.remark += "; with the report's law the bias is " + bias_text(by_law->bias, score.quantity);
  return figure;
}

Series compared(const std::string& label, std::size_t palette_index, const std::vector<TestError>& errors) {
  Series points{.label = label, .style = SeriesStyle::points, .palette_index = palette_index};
  for (const TestError& error : errors) points.add(error.measured, error.predicted);
  return points;
}

/// Adds the line "predicted = measured" and the band of bias that the rule allows.
void add_equality(Panel& panel, double low, double high) {
  const Rule& rule = rule_of(Quantity::peak_force);
  panel.add(Series{.label = "bias allowed by the rule",
                   .style = SeriesStyle::band,
                   .x = {low, high},
                   .y = {(1 + rule.low) * low, (1 + rule.low) * high},
                   .y2 = {(1 + rule.high) * low, (1 + rule.high) * high},
                   .palette_index = palette_index::measured});
  panel.add(Series{.label = "predicted = measured",
                   .style = SeriesStyle::dashed_line,
                   .x = {low, high},
                   .y = {low, high},
                   .palette_index = palette_index::measured});
}

/// The peak forces on the load cell, for which there are the most readings.
output::Plot predicted_over_measured(const Study& study) {
  Panel panel{.x = {.label = "Measured peak force (lb)", .logarithmic = true},
              .y = {.label = "Predicted peak force (lb)", .logarithmic = true}};
  std::vector<Series> points;
  for (const HeldOutScore& score : study.held_out.scores)
    if (score.quantity == Quantity::peak_force && score.support == TestSupport::load_cell)
      points.push_back(compared("foam fitted to the other tests", palette_index::accurate, score.errors));
  if (const Score* const score = score_by_law(study, TestSupport::load_cell, Quantity::peak_force))
    points.push_back(compared(fmt::format("report's law, {:.2f} in", study.radius.favoured_in()),
                              palette_index::printed_1984, score->errors));
  Interval forces = nowhere;
  for (const Series& series : points)
    for (const std::vector<double>* const values : {&series.x, &series.y})
      for (const double value : *values) forces.include(value);
  if (forces.high > 0) {
    constexpr double room = 1.1;
    const double low = forces.low / room, high = forces.high * room;
    add_equality(panel, low, high);
    panel.x.low = panel.y.low = low;
    panel.x.high = panel.y.high = high;
  }
  for (Series& series : points) panel.add(std::move(series));
  return {.panels = {std::move(panel)}};
}

}  // namespace

output::Lead validation_lead(const Study& study, output::Pictures pictures) {
  const Tally by_law = tally(study, Program::accurate);
  Tally held_out;
  for (const HeldOutScore& score : study.held_out.scores) held_out.count(score.passed);
  output::Lead lead{
      .answer = answer_of(by_law, held_out),
      .tone = tone_of(by_law, held_out),
      .subject = {
          fmt::format("The {} tests in Table 3-1 of Crash Padding Research, Volume III (1986); the rules "
                      "were fixed before the first run",
                      study.data.measured.tests.size()),
          fmt::format("The figures below are for a foam with {} fitted parameters and a {} in nose radius, "
                      "with each test held out of the fit that predicts it; ± is one standard error",
                      fitted_numbers, brief(held_out_radius_in))}};
  if (pictures == output::Pictures::drawn) lead.curve = predicted_over_measured(study);
  for (const HeldOutScore& score : study.held_out.scores)
    if (lead.figures.size() + 1 < output::max_key_figures) lead.figures.push_back(score_figure(study, score));
  lead.figures.push_back(
      {.label = "Rules met by the report's law",
       .value = fmt::format("{} of {}", by_law.passed, by_law.all),
       .remark = fmt::format("the accurate solver at a nose radius of {:.2f} in", study.radius.favoured_in()),
       .tone = by_law.passes_all() ? output::Tone::good : output::Tone::bad});
  return lead;
}

}  // namespace dashpad::report1986
