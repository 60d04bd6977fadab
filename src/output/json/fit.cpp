// A fit for programs.

#include "dashpad/output/fit.hpp"

#include <cmath>

#include "dashpad/fit/fit.hpp"
#include "json/json_values.hpp"
#include "output/json/parts.hpp"

namespace dashpad::output {

namespace {

Json unknown_json(const fit::FittedUnknown& of) {
  return {{"key", of.key},
          {"unit", of.unit},
          {"value", number(of.value)},
          {"standard_error", number(of.standard_error)},
          {"interval", {{"low", number(of.low)}, {"high", number(of.high)}, {"open", of.open()}}},
          {"bounds", {{"lowest", number(of.lowest)}, {"highest", number(of.highest)}}},
          {"at_bound", of.is_at_lowest    ? "lowest"
                       : of.is_at_highest ? "highest"
                                          : "no"},
          {"mostly_from_prior", of.rests_on_prior()},
          {"nuisance", of.is_nuisance}};
}

Json loop_json(const fit::Loop& of) {
  return {{"largest_strain", number(of.largest_strain)},
          {"measured_return", number(of.measured_return)},
          {"computed_return", number(of.computed_return)}};
}

Json met_test_json(const fit::MetTest& of) {
  return {{"file", of.file},
          {"held_out", of.is_held_out},
          {"points", of.points},
          {"largest_stress_Pa", number(of.largest_stress)},
          {"lowest_rate_per_s", number(of.lowest_rate)},
          {"highest_rate_per_s", number(of.highest_rate)},
          {"noise_Pa", number_if(of.noise > 0, of.noise)},
          {"noise_stated", of.noise_is_stated},
          {"offset_Pa", number(of.offset)},
          {"rms_loading_Pa", number(of.rms_loading)},
          {"rms_unloading_Pa", number(of.rms_unloading)},
          {"loops", array_of(of.loops, loop_json)},
          {"autocorrelation", number_if(!of.is_held_out, of.autocorrelation)},
          {"effective_points", number(of.effective_points)},
          {"strain", numbers(of.strain)},
          {"measured_stress_Pa", numbers(of.measured)},
          {"computed_stress_Pa", numbers(of.computed)}};
}

Json comparison_json(const fit::ImpactComparison& of) {
  const fit::ImpactFigureName& name = name_of(of.figure);
  return {{"case", of.file},
          {"figure", name.key},
          {"unit", name.quantity->si_unit},
          {"held_out", of.is_held_out},
          {"from_pulse", of.is_of_pulse},
          {"measured", number(of.measured)},
          {"computed", number(of.computed)},
          {"share", number(of.share())}};
}

Json met_figure_json(const fit::MetFigure& of) {
  const fit::ImpactFigureName& name = name_of(of.figure);
  return {{"case", of.file},
          {"figure", name.key},
          {"unit", name.quantity->si_unit},
          {"held_out", of.is_held_out},
          {"measured", number(of.measured)},
          {"deviation", number(of.deviation)},
          {"computed", number(of.computed)},
          {"prediction_deviation", number(of.prediction_deviation)}};
}

Json met_pulse_json(const fit::MetPulse& of) {
  const auto in_g = [](double value) { return number(value / standard_gravity); };
  return {{"case", of.file},
          {"file", of.pulse_file},
          {"held_out", of.is_held_out},
          {"samples", of.samples},
          {"points", of.time.size()},
          {"deviation_g", in_g(of.deviation)},
          {"measured_peak_g", in_g(of.measured_peak)},
          {"computed_peak_g", made_of(of.computed_peak, in_g)},
          {"rms_g", made_of(of.rms, in_g)},
          {"rms_share_of_peak", number_if(of.rms.has_value(), of.rms.value_or(0) / of.measured_peak)},
          {"shift_s", number(of.shift)},
          {"autocorrelation", number_if(!of.is_held_out, of.autocorrelation)},
          {"effective_points", number(of.effective_points)},
          {"time_s", numbers(of.time)},
          {"measured_g", array_of(of.measured, in_g)},
          {"computed_g", array_of(of.computed, in_g)}};
}

Json left_open_json(const fit::FitReport& report) {
  return {
      {"correlations",
       array_of(report.correlations,
                [](const fit::StrongCorrelation& of) {
                  return Json{{"first", of.first}, {"second", of.second}, {"correlation", number(of.value)}};
                })},
      {"flat_directions", report.flat_directions}};
}

}  // namespace

std::string fit_json(const fit::FitReport& report) {
  return result_json_text(
      {{"title", report.title},
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
       {"program", program_json()}});
}

}  // namespace dashpad::output
