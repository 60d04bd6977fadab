// Two figures that the report does not have, and the list of all figures.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "report1986/validation_figures.hpp"

namespace dashpad::report1986 {

namespace {

/// The ratio of predicted to measured force of each test, at the report's radius.
Series ratios(const Study& study, Program program, Projectile projectile, std::size_t palette_index) {
  Series points{.label = to_string(program), .style = SeriesStyle::points, .palette_index = palette_index};
  for (const Verdict& verdict : study.at_the_reports_radius) {
    const Score& score = verdict.score;
    if (score.program != program || score.support != TestSupport::load_cell ||
        score.quantity != Quantity::peak_force)
      continue;
    for (const TestError& error : score.errors) {
      const MeasuredTest& test = test_of(study, error.test);
      if (test.projectile != projectile) continue;
      points.add(test.speed_mph, error.predicted / error.measured);
    }
  }
  return points;
}

Panel ratio_panel(const Study& study, const char* title, TestGroup group) {
  const Rule& rule = rule_of(Quantity::peak_force);
  Panel panel = speed_panel(title, "Predicted / measured peak force");
  panel.y.high = 4;
  // The report's result, from the low to the high end of its speeds.
  Series report{.label = "report: its predictions divided by its trend",
                .style = SeriesStyle::dashed_line,
                .palette_index = palette_index::measured};
  for (const PrintedRatio& printed : printed_ratios)
    if (printed.projectile == group.projectile)
      report.add(printed.speed_mph, study.data.constant(printed.constant));
  panel.series = {{.label = "bias allowed by the rule",
                   .style = SeriesStyle::band,
                   .x = {min_speed, greatest_speed},
                   .y = {1 + rule.low, 1 + rule.low},
                   .y2 = {1 + rule.high, 1 + rule.high},
                   .palette_index = palette_index::measured},
                  std::move(report)};
  for (const auto& [program, palette_index] :
       {std::pair{Program::printed_1984, palette_index::printed_1984},
        std::pair{Program::mended_support_1984, palette_index::mended_1984},
        std::pair{Program::accurate_first_slope, palette_index::first_slope},
        std::pair{Program::accurate, palette_index::accurate}})
    panel.add(ratios(study, program, group.projectile, palette_index));
  return panel;
}

/// The program of a criterion: the second part of its remark.
std::string program_of(const RadiusCriterion& criterion) {
  const std::size_t place = criterion.remark.find("; ");
  if (place == std::string::npos) return criterion.remark;
  const std::string rest = criterion.remark.substr(place + 2);
  return rest.substr(0, rest.find("; "));
}

Drawing misfit_over_radius(const Study& study) {
  Panel panel{.x = {.label = "Nose radius (in)", .low = min_radius_in, .high = greatest_radius_in},
              .y = {.label = "Misfit / smallest misfit", .low = 0, .high = 5}};
  for (const RadiusCriterion& criterion : study.radius.criteria) {
    double least = HUGE_VAL;
    for (const double misfit : criterion.misfit)
      if (misfit < least) least = misfit;  // false for NaN
    if (!std::isfinite(least) || least <= 0) continue;
    Series line{
        .label = fmt::format("{} ({}); {}", criterion.name, criterion.readings, program_of(criterion)),
        .x = study.radius.radii_in,
        .y = criterion.misfit};
    for (double& misfit : line.y) misfit /= least;
    panel.add(line);
  }
  return {{panel},
          fmt::format("Root mean square of the residuals, divided by its smallest value; the number of "
                      "readings is in brackets. The first criterion is decisive and gives {:.2f} in.",
                      study.radius.favoured_in())};
}

Drawing force_ratio(const Study& study) {
  return {both_projectiles(study, ratio_panel),
          lost_readings(study, "peak_force_lb", "peak force") +
              fmt::format("Predictions for a nose radius of {:.2f} in. The report compares them with its "
                          "trend (curve A), Dashpad with the individual tests.",
                          study.radius.of_the_report_in())};
}

struct ListedFigure {
  const char* name;
  const char* title;
  const char* source;  ///< in the report
  Drawing (*drawing)(const Study&);
};

constexpr ListedFigure list[] = {
    {"Figure 3-3", "Static curves of the supports", "section 3.3, Table 3-2", support_curves},
    {"Figure 3-4", "Time to peak force against initial speed, load cell", "Table 3-1 and section 3.3",
     time_to_peak},
    {"Figure 3-5", "Nominal stress (Eq. 33) against peak force, load cell", "Table 3-1 and Eq. 33",
     nominal_stress},
    {"Figure 3-6", "Peak force against initial speed, load cell", "Table 3-1", force_over_speed},
    {"Figure 3-7", "Rebound speed against initial speed", "Table 3-1 and section 3.3", rebound_over_speed},
    {"Figure 3-8", "Peak force against energy", "Table 3-1 and Eqs. 35 and 36", force_over_energy},
    {"Figure 3-9", "Peak force against initial speed, aluminium projectile", "Table 3-1 and Eqs. 36 and 37",
     curves_a_and_b},
    {"Figure 4-1", "Predicted time to peak force, load cell", "section 4", predicted_time},
    {"Figure 4-2", "Predicted peak force, load cell", "Table 3-1 and section 4",
     predicted_force_on_load_cell},
    {"Figure 4-3", "Predicted peak force, flexible plate, aluminium projectile", "section 4",
     predicted_force_on_plate},
    {"Figure 4-4", "Predicted rebound speed, load cell", "Tables 3-1 and 3-2, section 4",
     predicted_rebound_on_load_cell},
    {"Figure 4-5", "Predicted rebound speed, flexible plate, aluminium projectile", "Table 3-1 and section 4",
     predicted_rebound_on_plate},
    {"Nose radius", "What each set of readings says about the nose radius", "Table 3-1 and section 4",
     misfit_over_radius},
    {"Force ratio", "The anomaly in section 4: ratio of predicted to measured peak force, load cell",
     "Table 3-1 and section 4", force_ratio}};

/// "figure-3-3" for "Figure 3-3".
std::string slug_of(std::string name) {
  name.front() += 'a' - 'A';
  std::ranges::replace(name, ' ', '-');
  return name;
}

}  // namespace

std::vector<std::string> validation_figure_slugs() {
  std::vector<std::string> slugs;
  for (const ListedFigure& listed : list) slugs.push_back(slug_of(listed.name));
  return slugs;
}

std::vector<ValidationFigure> validation_figures(const Study& study) {
  std::vector<ValidationFigure> figures;
  for (const auto& [name, title, source, drawing] : list) {
    auto [panels, note] = drawing(study);
    figures.push_back(
        {.name = name,
         .slug = slug_of(name),
         .plot = {.title = title,
                  .panels = std::move(panels),
                  .source = fmt::format("Crash Padding Research, Volume III (1986), {}; dashpad {}", source,
                                        version())},
         .note = std::move(note)});
  }
  return figures;
}

}  // namespace dashpad::report1986
