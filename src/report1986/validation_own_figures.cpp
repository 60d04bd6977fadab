// Two figures that the report does not have, and the list of all.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "quantities/text.hpp"
#include "report1986/validation_figure_list.hpp"

namespace dashpad::report1986 {

namespace {

using FigureOf = ValidationFigure (*)(const Study&);

struct ListedFigure {
  const char* slug;
  FigureOf figure;
};

constexpr ListedFigure list[] = {{"figure-3-3", support_curves},
                                 {"figure-3-4", time_to_peak},
                                 {"figure-3-5", nominal_stress},
                                 {"figure-3-6", force_over_speed},
                                 {"figure-3-7", rebound_over_speed},
                                 {"figure-3-8", force_over_energy},
                                 {"figure-3-9", curves_a_and_b},
                                 {"figure-4-1", predicted_time},
                                 {"figure-4-2", predicted_force_on_load_cell},
                                 {"figure-4-3", predicted_force_on_plate},
                                 {"figure-4-4", predicted_rebound_on_load_cell},
                                 {"figure-4-5", predicted_rebound_on_plate},
                                 {"nose-radius", misfit_over_radius},
                                 {"force-ratio", force_ratio}};

/// Predicted over measured force of each test, at the report's radius.
output::Series ratios(const Study& study, Program program, Projectile projectile, std::size_t turn) {
  output::Series points{.label = to_string(program), .style = output::SeriesStyle::points, .turn = turn};
  for (const Verdict& verdict : study.at_the_reports_radius) {
    const Score& score = verdict.score;
    if (score.program != program || score.support != TestSupport::load_cell ||
        score.quantity != Quantity::peak_force)
      continue;
    for (const TestError& error : score.errors) {
      const MeasuredTest& test = test_of(study, error.test);
      if (test.projectile != projectile) continue;
      points.x.push_back(test.speed_mph);
      points.y.push_back(error.predicted / error.measured);
    }
  }
  return points;
}

/// What the report found: from the ratio at the low end of its speeds to that at the high end.
output::Series printed_ratio(const Study& study, const std::string& projectile, double greatest) {
  return {.label = "report: predictions over its trend",
          .style = output::SeriesStyle::dashed_line,
          .x = {10, greatest},
          .y = {study.data.constant("force_ratio_" + projectile + "_low_speed"),
                study.data.constant("force_ratio_" + projectile + "_high_speed")},
          .turn = turn::measured};
}

output::Panel ratio_panel(const Study& study, const char* title, Projectile projectile,
                          output::Series printed) {
  const Rule& rule = rule_of(Quantity::peak_force);
  output::Panel panel{.title = title,
                      .x = {.label = "Initial speed (mph)", .low = least_speed, .high = greatest_speed},
                      .y = {.label = "Predicted / measured peak force", .low = 0, .high = 4},
                      .series = {{.label = "bias that the rule admits",
                                  .style = output::SeriesStyle::band,
                                  .x = {least_speed, greatest_speed},
                                  .y = {1 + rule.low, 1 + rule.low},
                                  .y2 = {1 + rule.high, 1 + rule.high},
                                  .turn = turn::measured},
                                 std::move(printed)}};
  for (const auto& [program, turn] : {std::pair{Program::printed_1984, turn::printed_1984},
                                      std::pair{Program::mended_support_1984, turn::mended_1984},
                                      std::pair{Program::accurate_first_slope, turn::first_slope},
                                      std::pair{Program::accurate, turn::accurate}})
    panel.series.push_back(ratios(study, program, projectile, turn));
  return panel;
}

/// The program that a criterion is about: the second part of its remark.
std::string program_of(const RadiusCriterion& criterion) {
  const std::size_t place = criterion.remark.find("; ");
  if (place == std::string::npos) return criterion.remark;
  const std::string rest = criterion.remark.substr(place + 2);
  return rest.substr(0, rest.find("; "));
}

}  // namespace

ValidationFigure misfit_over_radius(const Study& study) {
  output::Panel panel{.x = {.label = "Nose radius (in)", .low = least_radius_in, .high = greatest_radius_in},
                      .y = {.label = "Misfit / least misfit", .low = 0, .high = 5},
                      .series = {}};
  for (const RadiusCriterion& criterion : study.radius.criteria) {
    double least = HUGE_VAL;
    for (const double misfit : criterion.misfit)
      if (misfit < least) least = misfit;  // never if it is NaN
    if (!std::isfinite(least) || least <= 0) continue;
    output::Series line{
        .label = fmt::format("{} ({}); {}", criterion.name, criterion.readings, program_of(criterion)),
        .x = study.radius.radii_in,
        .y = criterion.misfit};
    for (double& misfit : line.y) misfit /= least;
    panel.series.push_back(line);
  }
  return {
      .name = "Nose radius",
      .slug = "nose-radius",
      .plot = {.title = "What each set of readings says of the nose radius",
               .panels = {panel},
               .source = source_line("Table 3-1 and section 4")},
      .note = fmt::format("Root mean square of the residuals over its least value; in brackets the number "
                          "of readings. The first criterion decides: {:.2f} in.",
                          study.radius.favoured_in())};
}

ValidationFigure force_ratio(const Study& study) {
  return {.name = "Force ratio",
          .slug = "force-ratio",
          .plot = {.title = "The anomaly of section 4: predicted over measured peak force, load cell",
                   .panels = {ratio_panel(study, "Aluminium projectile, 4.13 lb", Projectile::aluminium,
                                          printed_ratio(study, "aluminium", 20)),
                              ratio_panel(study, "Steel projectile, 7.7 lb", Projectile::steel,
                                          printed_ratio(study, "steel", 15))},
                   .source = source_line("Table 3-1 and section 4")},
          .note = lost_readings(study, {"peak_force_lb"}, "peak force") +
                  fmt::format("Predictions at a nose radius of {:.2f} in. The report compares with its trend "
                              "(curve A), we with each test.",
                              study.radius.of_the_report_in())};
}

std::vector<std::string> validation_figure_slugs() {
  std::vector<std::string> slugs;
  for (const ListedFigure& listed : list) slugs.emplace_back(listed.slug);
  return slugs;
}

std::vector<ValidationFigure> validation_figures(const Study& study) {
  std::vector<ValidationFigure> figures;
  for (const ListedFigure& listed : list) figures.push_back(listed.figure(study));
  return figures;
}

}  // namespace dashpad::report1986
