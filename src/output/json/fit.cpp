// A fit for programs.

#include "dashpad/output/fit.hpp"
#include "dashpad/output/proposal.hpp"

#include <cmath>

#include "dashpad/fit/fit.hpp"
#include "json/json_values.hpp"
#include "output/json/parts.hpp"

namespace dashpad::output {

namespace {

Json unknown_json(const fit::FittedUnknown& unknown) {
  return {
      {"key", unknown.key},
      {"unit", unknown.unit},
      {"value", number(unknown.value)},
      {"standard_error", number(unknown.standard_error)},
      {"interval", {{"low", number(unknown.low)}, {"high", number(unknown.high)}, {"open", unknown.open()}}},
      {"bounds", {{"lowest", number(unknown.lowest)}, {"highest", number(unknown.highest)}}},
      {"at_bound", unknown.is_at_lowest    ? "lowest"
                   : unknown.is_at_highest ? "highest"
                                           : "no"},
      {"mostly_from_prior", unknown.rests_on_prior()},
      {"nuisance", unknown.is_nuisance}};
}

Json loop_json(const fit::Loop& loop) {
  return {{"largest_strain", number(loop.largest_strain)},
          {"measured_return", number(loop.measured_return)},
          {"computed_return", number(loop.computed_return)}};
}

Json met_test_json(const fit::MetTest& test) {
  return {{"file", test.file},
          {"held_out", test.is_held_out},
          {"points", test.points},
          {"largest_stress_Pa", number(test.largest_stress)},
          {"lowest_rate_per_s", number(test.lowest_rate)},
          {"highest_rate_per_s", number(test.highest_rate)},
          {"noise_Pa", number_if(test.noise > 0, test.noise)},
          {"noise_stated", test.noise_is_stated},
          {"offset_Pa", number(test.offset)},
          {"rms_loading_Pa", number(test.rms_loading)},
          {"rms_unloading_Pa", number(test.rms_unloading)},
          {"loops", array_of(test.loops, loop_json)},
          {"autocorrelation", number_if(!test.is_held_out, test.autocorrelation)},
          {"effective_points", number(test.effective_points)},
          {"strain", numbers(test.strain)},
          {"measured_stress_Pa", numbers(test.measured)},
          {"computed_stress_Pa", numbers(test.computed)}};
}

Json comparison_json(const fit::ImpactComparison& comparison) {
  const fit::ImpactFigureName& name = name_of(comparison.figure);
  return {{"case", comparison.file},
          {"figure", name.key},
          {"unit", name.quantity->si_unit},
          {"held_out", comparison.is_held_out},
          {"from_pulse", comparison.is_of_pulse},
          {"measured", number(comparison.measured)},
          {"computed", number(comparison.computed)},
          {"share", number(comparison.share())}};
}

Json met_figure_json(const fit::MetFigure& figure) {
  const fit::ImpactFigureName& name = name_of(figure.figure);
  return {{"case", figure.file},
          {"figure", name.key},
          {"unit", name.quantity->si_unit},
          {"held_out", figure.is_held_out},
          {"measured", number(figure.measured)},
          {"deviation", number(figure.deviation)},
          {"computed", number(figure.computed)},
          {"prediction_deviation", number(figure.prediction_deviation)}};
}

Json met_pulse_json(const fit::MetPulse& pulse) {
  const auto in_g = [](double value) { return number(value / standard_gravity); };
  return {
      {"case", pulse.file},
      {"file", pulse.pulse_file},
      {"held_out", pulse.is_held_out},
      {"samples", pulse.samples},
      {"points", pulse.time.size()},
      {"deviation_g", in_g(pulse.deviation)},
      {"measured_peak_g", in_g(pulse.measured_peak)},
      {"computed_peak_g", made_of(pulse.computed_peak, in_g)},
      {"rms_g", made_of(pulse.rms, in_g)},
      {"rms_share_of_peak", number_if(pulse.rms.has_value(), pulse.rms.value_or(0) / pulse.measured_peak)},
      {"shift_s", number(pulse.shift)},
      {"autocorrelation", number_if(!pulse.is_held_out, pulse.autocorrelation)},
      {"effective_points", number(pulse.effective_points)},
      {"time_s", numbers(pulse.time)},
      {"measured_g", array_of(pulse.measured, in_g)},
      {"computed_g", array_of(pulse.computed, in_g)}};
}

Json left_open_json(const fit::FitReport& report) {
  return {{"correlations", array_of(report.correlations,
                                    [](const fit::StrongCorrelation& correlation) {
                                      return Json{{"first", correlation.first},
                                                  {"second", correlation.second},
                                                  {"correlation", number(correlation.value)}};
                                    })},
          {"flat_directions", report.flat_directions}};
}

Json evidence_json(const fit::Evidence& shown) {
  return {{"file", shown.file},
          {"rate_per_s", number(shown.rate)},
          {"highest_strain", number(shown.highest_strain)},
          {"largest_stress_Pa", number(shown.largest_stress)},
          {"loading_points", shown.loading_points},
          {"returned", number(shown.returned)},
          {"lost_while_held", number(shown.lost_held)},
          {"loaded_again", shown.has_cycles}};
}

Json tried_json(const fit::Tried& tried) {
  return {{"law", tried.law},           {"base", tried.base},
          {"rate", tried.rate},         {"misfit", number(tried.misfit)},
          {"unknowns", tried.unknowns}, {"open", tried.open}};
}

Json whole(const fit::FitReport& report) {
  return {{"title", report.title},
          {"converged", report.converged},
          {"why_not", report.why_not},
          {"unknowns", array_of(report.unknowns, unknown_json)},
          {"left_open", left_open_json(report)},
          {"misfit",
           {{"points", report.points},
            {"priors", report.priors},
            {"degrees_of_freedom", number(report.degrees_of_freedom)},
            {"sum_of_squares", number(report.misfit)},
            {"per_degree_of_freedom", number_if(report.degrees_of_freedom > 0, report.misfit_per_degree())},
            {"noise_stated", report.noise_is_stated},
            {"error_factor", number(std::sqrt(report.variance_scale))},
            {"largest_widening", number(report.largest_widening)}}},
          {"tests", array_of(report.tests, met_test_json)},
          {"impacts", array_of(report.figures, met_figure_json)},
          {"pulses", array_of(report.pulses, met_pulse_json)},
          {"comparison", array_of(report.comparison, comparison_json)},
          {"search",
           {{"starts", report.starts},
            {"starts_at_best", report.starts_at_best},
            {"starts_failed", report.starts_failed},
            {"solver_runs", report.solver_runs},
            {"evaluations", report.evaluations},
            {"wall_time_s", number(report.wall_time)}}},
          {"material", report.converged ? material_json(report.material) : Json(nullptr)},
          {"proposal", nullptr},
          {"program", program_json()}};
}

}  // namespace

std::string fit_json(const fit::FitReport& report) { return result_json_text(whole(report)); }

std::string proposal_json(const fit::AutoFit& result) {
  Json json = whole(result.report);
  json["proposal"] = {{"tests", array_of(result.proposal.tests, evidence_json)},
                      {"tried", array_of(result.tried, tried_json)},
                      {"chosen", result.chosen},
                      {"reasons", result.proposal.reasons},
                      {"left_open", result.open},
                      {"measure_next", result.next}};
  return result_json_text(json);
}

}  // namespace dashpad::output
