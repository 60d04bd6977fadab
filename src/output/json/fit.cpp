// A fit for programs.

#include "dashpad/output/fit.hpp"

#include <cmath>

#include "dashpad/fit/fit.hpp"
#include "json/json_values.hpp"
#include "output/json/parts.hpp"

namespace dashpad::output {

namespace {

Json unknown_json(const fit::FittedUnknown& fitted_unknown) {
  return {
      {"key", fitted_unknown.key},
      {"unit", fitted_unknown.unit},
      {"value", number(fitted_unknown.value)},
      {"standard_error", number(fitted_unknown.standard_error)},
      {"interval",
       {{"low", number(fitted_unknown.low)},
        {"high", number(fitted_unknown.high)},
        {"open", fitted_unknown.open()}}},
      {"bounds", {{"lowest", number(fitted_unknown.lowest)}, {"highest", number(fitted_unknown.highest)}}},
      {"at_bound", fitted_unknown.is_at_lowest    ? "lowest"
                   : fitted_unknown.is_at_highest ? "highest"
                                                  : "no"},
      {"mostly_from_prior", fitted_unknown.rests_on_prior()},
      {"nuisance", fitted_unknown.is_nuisance}};
}

Json loop_json(const fit::Loop& loop) {
  return {{"largest_strain", number(loop.largest_strain)},
          {"measured_return", number(loop.measured_return)},
          {"computed_return", number(loop.computed_return)}};
}

Json met_test_json(const fit::MetTest& met_test) {
  return {{"file", met_test.file},
          {"held_out", met_test.is_held_out},
          {"points", met_test.points},
          {"largest_stress_Pa", number(met_test.largest_stress)},
          {"lowest_rate_per_s", number(met_test.lowest_rate)},
          {"highest_rate_per_s", number(met_test.highest_rate)},
          {"noise_Pa", number_if(met_test.noise > 0, met_test.noise)},
          {"noise_stated", met_test.noise_is_stated},
          {"offset_Pa", number(met_test.offset)},
          {"rms_loading_Pa", number(met_test.rms_loading)},
          {"rms_unloading_Pa", number(met_test.rms_unloading)},
          {"loops", array_of(met_test.loops, loop_json)},
          {"autocorrelation", number_if(!met_test.is_held_out, met_test.autocorrelation)},
          {"effective_points", number(met_test.effective_points)},
          {"strain", numbers(met_test.strain)},
          {"measured_stress_Pa", numbers(met_test.measured)},
          {"computed_stress_Pa", numbers(met_test.computed)}};
}

Json comparison_json(const fit::ImpactComparison& impact_comparison) {
  const fit::ImpactFigureName& name = name_of(impact_comparison.figure);
  return {{"case", impact_comparison.file},
          {"figure", name.key},
          {"unit", name.quantity->si_unit},
          {"held_out", impact_comparison.is_held_out},
          {"from_pulse", impact_comparison.is_of_pulse},
          {"measured", number(impact_comparison.measured)},
          {"computed", number(impact_comparison.computed)},
          {"share", number(impact_comparison.share())}};
}

Json met_figure_json(const fit::MetFigure& met_figure) {
  const fit::ImpactFigureName& name = name_of(met_figure.figure);
  return {{"case", met_figure.file},
          {"figure", name.key},
          {"unit", name.quantity->si_unit},
          {"held_out", met_figure.is_held_out},
          {"measured", number(met_figure.measured)},
          {"deviation", number(met_figure.deviation)},
          {"computed", number(met_figure.computed)},
          {"prediction_deviation", number(met_figure.prediction_deviation)}};
}

Json met_pulse_json(const fit::MetPulse& met_pulse) {
  const auto in_g = [](double value) { return number(value / standard_gravity); };
  return {{"case", met_pulse.file},
          {"file", met_pulse.pulse_file},
          {"held_out", met_pulse.is_held_out},
          {"samples", met_pulse.samples},
          {"points", met_pulse.time.size()},
          {"deviation_g", in_g(met_pulse.deviation)},
          {"measured_peak_g", in_g(met_pulse.measured_peak)},
          {"computed_peak_g", made_of(met_pulse.computed_peak, in_g)},
          {"rms_g", made_of(met_pulse.rms, in_g)},
          {"rms_share_of_peak",
           number_if(met_pulse.rms.has_value(), met_pulse.rms.value_or(0) / met_pulse.measured_peak)},
          {"shift_s", number(met_pulse.shift)},
          {"autocorrelation", number_if(!met_pulse.is_held_out, met_pulse.autocorrelation)},
          {"effective_points", number(met_pulse.effective_points)},
          {"time_s", numbers(met_pulse.time)},
          {"measured_g", array_of(met_pulse.measured, in_g)},
          {"computed_g", array_of(met_pulse.computed, in_g)}};
}

Json left_open_json(const fit::FitReport& report) {
  return {{"correlations", array_of(report.correlations,
                                    [](const fit::StrongCorrelation& strong_correlation) {
                                      return Json{{"first", strong_correlation.first},
                                                  {"second", strong_correlation.second},
                                                  {"correlation", number(strong_correlation.value)}};
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
