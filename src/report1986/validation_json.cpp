#include <fmt/format.h>

#include "dashpad/report1986/validation/energy.hpp"
#include "json/json_values.hpp"
#include "report1986/validation/placings.hpp"
#include "report1986/validation_tables.hpp"

namespace dashpad::report1986 {

namespace {

Json interval(const Interval& interval) {
  return {{"low", number(interval.low)}, {"high", number(interval.high)}};
}

Json measured_test_json(const MeasuredTest& test) {
  Json result{{"test", test.number},
              {"projectile", to_string(test.projectile)},
              {"weight_lbf", number(test.weight_lb)},
              {"support", to_string(test.support)},
              {"speed_mph", number(test.speed_mph)},
              {"energy_in_lbf", number(test.energy_in_lb)}};
  for (const MeasuredColumn& column : measured_columns) {
    const std::string name = column.name;
    result[name.ends_with("_lb") ? name + "f" : name] = number(test.*column.reading);
  }
  return result;
}

Json unplaced_json(const UnplacedReadings& group) {
  return {{"column", group.column},
          {"first_test", group.first_test},
          {"last_test", group.last_test},
          {"readings", numbers(group.readings)}};
}

Json constant_json(const FittedConstant& constant) {
  return {{"name", constant.name},
          {"title", constant.title},
          {"unit", constant.unit},
          {"printed", number(constant.printed)},
          {"value", number(constant.value)},
          {"confidence_95", interval(constant.confidence)},
          {"tests", constant.tests},
          {"scatter", number(constant.scatter)},
          {"scatter_unit", constant.residual_unit},
          {"over_placings", interval(constant.over_placings)},
          {"confidence_95_over_placings", interval(constant.confidence_over_placings)},
          {"placings", constant.placings},
          {"printed_in_confidence", constant.printed_in_confidence},
          {"printed_in_placings", constant.printed_in_placings},
          {"method", constant.method}};
}

Json nominal_stress_json(const NominalStressFit& fit) {
  return {{"points", array_of(fit.points,
                              [](const NominalStressPoint& point) -> Json {
                                return {{"test", point.test == 0 ? Json(nullptr) : Json(point.test)},
                                        {"stress_psi", number(point.stress_psi)},
                                        {"force_lbf", number(point.force_lb)}};
                              })},
          {"area_in2", number(fit.area_in2)},
          {"area_over_placings_in2", interval(fit.area_over_placings)},
          {"scatter", number(fit.scatter)},
          {"scatter_over_placings", interval(fit.scatter_over_placings)},
          {"slope", number(fit.slope)},
          {"slope_confidence_95", interval(fit.slope_confidence)},
          {"remark", fit.remark}};
}

Json criterion_json(const RadiusCriterion& criterion) {
  return {{"name", criterion.name},
          {"remark", criterion.remark},
          {"unit", criterion.unit},
          {"misfit", numbers(criterion.misfit)},
          {"favoured_in", number(criterion.favoured_in)},
          {"at_an_end", criterion.at_an_end},
          {"admitted_95_in", interval(criterion.admitted)},
          {"readings", criterion.readings},
          {"of_the_report", criterion.of_the_report}};
}

Json error_json(const TestError& error) {
  return {{"test", error.test},
          {"measured", number(error.measured)},
          {"predicted", number(error.predicted)},
          {"error", number(error.error)}};
}

Json verdict_json(const Verdict& verdict) {
  const Score& score = verdict.score;
  return {{"program", to_string(score.program)},
          {"support", to_string(score.support)},
          {"projectile", score.projectile ? Json(to_string(*score.projectile)) : Json(nullptr)},
          {"quantity", to_string(score.quantity)},
          {"radius_in", number(score.radius_in)},
          {"bias", number(score.bias)},
          {"scatter", number(score.scatter)},
          {"bias_over_radii", interval(verdict.bias_over_radii)},
          {"scatter_over_radii", interval(verdict.scatter_over_radii)},
          {"radii_passed", verdict.radii_passed},
          {"radii", verdict.radii},
          {"passed", score.passed},
          {"missing", score.missing},
          {"errors", array_of(score.errors, error_json)}};
}

Json placed_json(const PlacedScore& placed) {
  return {{"program", to_string(placed.program)},
          {"quantity", to_string(placed.quantity)},
          {"radius_in", number(placed.radius_in)},
          {"first_test", placed.group.first_test},
          {"last_test", placed.group.last_test},
          {"placings", placed.placings},
          {"placings_passed", placed.placings_passed},
          {"bias", number(placed.bias)},
          {"bias_over_placings", interval(placed.bias_over_placings)},
          {"scatter_over_placings", interval(placed.scatter_over_placings)}};
}

Json rebound_json(const Admissible& rebound) {
  return {{"program", to_string(rebound.program)},
          {"radius_in", number(rebound.radius_in)},
          {"missing", rebound.missing},
          {"tests", rebound.tests},
          {"admissible", rebound.admissible},
          {"too_low", rebound.too_low},
          {"too_high", rebound.too_high},
          {"passed", rebound.passed}};
}

Json foam_json(const FittedFoam& foam) {
  return {{"plateau_stress_psi", number(foam.plateau_stress_psi)},
          {"densification_stress_psi", number(foam.densification_stress_psi)},
          {"densification_exponent", number(foam.densification_exponent)},
          {"unloading_shape", number(foam.unloading_shape)},
          {"misfit", number(foam.misfit)},
          {"converged", foam.converged}};
}

Json held_out_json(const HeldOut& held_out) {
  Json result{{"note", seen_data},
              {"radius_in", number(held_out_radius_in)},
              {"foam", foam_json(held_out.foam)},
              {"folds", array_of(held_out.folds, foam_json)}};
  for (const HeldOutScore& score : held_out.scores)
    result[score.name] = {{"bias", score.errors.empty() ? Json(nullptr) : number(score.bias)},
                          {"standard_error", number(score.standard_error)},
                          {"scatter", number(score.scatter)},
                          {"tests", score.errors.size()},
                          {"missing", score.missing},
                          {"passed", score.passed},
                          {"errors", array_of(score.errors, error_json)}};
  return result;
}

Json trend_json(const ForceTrend& trend) {
  Json result{{"program", to_string(trend.program)},
              {"slope", number(trend.slope)},
              {"slope_confidence_95", interval(trend.slope_confidence)},
              {"tests", trend.tests},
              {"slope_aluminium", number(trend.aluminium_slope)},
              {"slope_aluminium_confidence_95", interval(trend.aluminium_slope_confidence)}};
  for (const PrintedRatio& printed : printed_ratios)
    result[fmt::format("ratio_{}_{}_mph", to_string(printed.projectile), printed.speed_mph)] =
        number(trend.*printed.ours);
  return result;
}

Json claim_json(const ReportClaim& claim) {
  return {{"where", claim.where},
          {"claim", claim.claim},
          {"unit", claim.unit},
          {"printed", number(claim.printed)},
          {"computed", number(claim.computed)},
          {"tolerance", number(claim.tolerance)},
          {"agrees", claim.agrees},
          {"remark", claim.remark}};
}

Json prediction_json(const Prediction& prediction) {
  const Setup& setup = prediction.setup;
  return {{"program", to_string(prediction.program)},
          {"projectile", to_string(setup.projectile)},
          {"support", to_string(setup.support)},
          {"speed_mph", number(setup.speed_mph)},
          {"radius_in", number(setup.radius_in)},
          {"peak_force_lbf", number(prediction.peak_force_lb)},
          {"time_to_peak_ms", number(prediction.time_to_peak_ms)},
          {"rebound_mph", number(prediction.rebound_mph)},
          {"peak_strain", number(prediction.peak_strain)},
          {"bottomed", prediction.bottomed},
          {"error_of_peak_force", number(prediction.error)},
          {"remark", prediction.remark}};
}

}  // namespace

std::string validation_json(const Study& study) {
  const AnomalyVerdict& anomaly = study.anomaly;
  const Json result{{"source", "Crash Padding Research, Volume III (1986), sections 3 and 4"},
                    {"favoured_radius_in", number(study.radius.favoured_in())},
                    {"passed", passes(study)},
                    {"verdicts", array_of(study.verdicts, verdict_json)},
                    {"radius_of_the_report_in", number(study.radius.of_the_report_in())},
                    {"verdicts_at_the_reports_radius", array_of(study.at_the_reports_radius, verdict_json)},
                    {"verdicts_by_projectile", array_of(study.by_projectile, verdict_json)},
                    {"lost_readings_placed", array_of(study.placed, placed_json)},
                    {"rebounds", array_of(study.rebounds, rebound_json)},
                    {"anomaly",
                     {{"trends", array_of(anomaly.trends, trend_json)},
                      {"first_slope_gives_the_fall", anomaly.first_slope_gives_the_fall},
                      {"curve_removes_the_fall", anomaly.curve_removes_the_fall},
                      {"slope_halves", anomaly.slope_halves},
                      {"the_support_defect", words(anomaly.explanation)}}},
                    {"radius",
                     {{"radii_in", numbers(study.radius.radii_in)},
                      {"criteria", array_of(study.radius.criteria, criterion_json)}}},
                    {"held_out", held_out_json(study.held_out)},
                    {"constants", array_of(study.constants, constant_json)},
                    {"nominal_stress", nominal_stress_json(study.nominal_stress)},
                    {"claims", array_of(check_claims(study.data), claim_json)},
                    {"tests", array_of(study.data.measured.tests, measured_test_json)},
                    {"lost_readings", array_of(study.data.measured.unplaced, unplaced_json)},
                    {"predictions_of_the_tests", array_of(study.at_tests, prediction_json)},
                    {"predictions_over_speed", array_of(study.on_curves, prediction_json)},
                    {"program", program_json()}};
  return result_json_text(result);
}

}  // namespace dashpad::report1986
