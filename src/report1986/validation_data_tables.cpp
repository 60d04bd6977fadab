// Constants, claims, nose radius and lost readings as tables; tables as text.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "output/text/table.hpp"
#include "quantities/text.hpp"
#include "report1986/validation_tables.hpp"

namespace dashpad::report1986 {

namespace {

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() || unit == "1" ? text : text + " " + shown_unit(unit);
}

std::string short_number(double value) { return fmt::format("{:.4g}", value); }

std::string span(const Interval& interval) {
  return short_number(interval.low) + " to " + short_number(interval.high);
}

/// Columns as people call them.
std::string column_words(const std::string& column) {
  if (column == "rebound_mph") return "rebound speed (mph)";
  if (column == "time_to_peak_ms") return "time to peak (ms)";
  if (column == "total_time_ms") return "duration (ms)";
  if (column == "peak_force_lb") return "peak force (lb)";
  if (column == "plug_strain") return "peak strain, clay plug";
  if (column == "diameter_strain") return "peak strain, contact diameter";
  return column;
}

}  // namespace

output::Table constants_table(const Study& study) {
  output::Table table{.columns = {"constant", "printed", "fitted again", "95 % interval", "printed within it",
                                  "tests", "over all placings", "printed within them",
                                  "95 % intervals over all placings"}};
  for (const FittedConstant& constant : study.constants) {
    const bool has_placings = constant.placings > 1;
    table.rows.push_back({constant.title, with_unit(brief(constant.printed), constant.unit),
                          with_unit(short_number(constant.value), constant.unit), span(constant.confidence),
                          constant.printed_in_confidence ? "yes" : "NO",
                          fmt::format("{}", constant.tests.size()),
                          has_placings ? span(constant.over_placings) : "-",
                          has_placings ? (constant.printed_in_placings ? "yes" : "NO") : "-",
                          has_placings ? span(constant.confidence_over_placings) : "-"});
  }
  return table;
}

output::Table radius_table(const Study& study) {
  output::Table table{
      .columns = {"criterion", "readings", "favoured radius (in)", "95 % range (in)", "remark"}};
  for (const RadiusCriterion& criterion : study.radius.criteria) {
    const char* bound = !criterion.at_an_end                                                 ? ""
                        : criterion.favoured_in < (least_radius_in + greatest_radius_in) / 2 ? "at most "
                                                                                             : "at least ";
    const bool has_one = std::isfinite(criterion.favoured_in);
    table.rows.push_back(
        {criterion.name, fmt::format("{}", criterion.readings),
         has_one ? fmt::format("{}{:.2f}", bound, criterion.favoured_in) : "-",
         has_one ? fmt::format("{:.2f} to {:.2f}", criterion.admitted.low, criterion.admitted.high) : "-",
         criterion.remark});
  }
  return table;
}

output::Table unplaced_table(const Study& study) {
  output::Table table{.columns = {"column", "tests", "readings, in their order"}};
  for (const UnplacedReadings& group : study.data.measured.unplaced) {
    std::string readings;
    for (const double reading : group.readings) readings += (readings.empty() ? "" : ", ") + brief(reading);
    table.rows.push_back(
        {column_words(group.column), fmt::format("{} to {}", group.first_test, group.last_test), readings});
  }
  return table;
}

std::vector<NamedTable> validation_tables(const Study& study) {
  return {{"verdict", verdict_table(study)},
          {"verdict-at-the-reports-radius", reports_radius_table(study)},
          {"over-radii", score_over_radius_table(study)},
          {"by-projectile", by_projectile_table(study)},
          {"placed", placed_table(study)},
          {"rebound", rebound_table(study)},
          {"anomaly", anomaly_table(study, study.anomaly)},
          {"anomaly-rules", anomaly_rules_table(study.anomaly)},
          {"anomaly-at-the-reports-radius", anomaly_table(study, study.anomaly_at_the_reports_radius)},
          {"anomaly-rules-at-the-reports-radius", anomaly_rules_table(study.anomaly_at_the_reports_radius)},
          {"errors-peak-force", error_table(study, Quantity::peak_force)},
          {"errors-time-to-peak", error_table(study, Quantity::time_to_peak)},
          {"errors-rebound-speed", error_table(study, Quantity::rebound_speed)},
          {"errors-peak-strain", error_table(study, Quantity::peak_strain)},
          {"held-out", held_out_table(study)},
          {"held-out-errors", held_out_errors_table(study)},
          {"fitted-foam", fitted_foam_table(study)},
          {"constants", constants_table(study)},
          {"claims", claims_table(study)},
          {"nose-radius", radius_table(study)},
          {"lost-readings", unplaced_table(study)}};
}

std::map<std::string, std::string> validation_markdown_tables(const Study& study) {
  std::map<std::string, std::string> texts;
  for (const NamedTable& named : validation_tables(study)) texts[named.name] = output::markdown(named.table);
  return texts;
}

}  // namespace dashpad::report1986
