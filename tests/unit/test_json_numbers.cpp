// Every number of the JSON of results, each against the value that it is of: no two of those are equal, so
// that none can stand in another's place.

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dashpad/output/fit.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/output/pulse.hpp"
#include "dashpad/output/study.hpp"
#include "distinct_numbers.hpp"
#include "example_result.hpp"
#include "json/json_values.hpp"
#include "shared/gravity.hpp"
#include "shown_values.hpp"

namespace dashpad::test {
namespace {

using Numbers = std::map<std::string, double>;

void expect_result(const std::string& written, Numbers expected) {
  expected["/format"] = result_format;
  expect_numbers(nlohmann::json::parse(written), std::move(expected));
}

void add(Numbers& to, const std::string& place, const study::Estimate& estimate, double scale = 1) {
  to[place + "/value"] = estimate.value * scale;
  to[place + "/low"] = estimate.low * scale;
  to[place + "/high"] = estimate.high * scale;
}

void add(Numbers& to, const std::string& place, const std::vector<double>& values, double scale = 1) {
  for (std::size_t i = 0; i < values.size(); ++i) to[place + "/" + std::to_string(i)] = values[i] * scale;
}

TEST(JsonNumbers, OfAnImpactOfTwoBodies) {
  const Body first{3, 8}, second{11, -2};
  Solution solution;
  solution.summary = example_summary();
  solution.summary.energy = {.impact = 180, .kinetic = 101, .support = 7, .pad = 71, .residual = 0};
  solution.summary.energy_absorbed_fraction = 0.4;
  solution.history.force = {0, 4000, 3000, 0};
  solution.history.velocity = {9, 3, 1, -5};
  const ImpactCase impact = relative_motion(example_case(), first, second);
  const PostImpact after = post_impact(first, second, solution);
  const EnergySplit split = energy_split(impact, solution);
  expect_result(output::post_impact_json(first, second, impact, solution),
                {{"/bodies/0/mass_kg", 3},
                 {"/bodies/0/velocity_m_per_s", 8},
                 {"/bodies/0/velocity_after_m_per_s", after.first_velocity},
                 {"/bodies/0/velocity_after_error_m_per_s", after.errors.first_velocity},
                 {"/bodies/1/mass_kg", 11},
                 {"/bodies/1/velocity_m_per_s", -2},
                 {"/bodies/1/velocity_after_m_per_s", after.second_velocity},
                 {"/bodies/1/velocity_after_error_m_per_s", after.errors.second_velocity},
                 {"/energy_coefficient_C", 0.6},
                 {"/restitution_sqrt_C", std::sqrt(0.6)},
                 {"/restitution_error", after.errors.restitution},
                 {"/absorbed_fraction_error", 2e-5},
                 {"/available_energy_J", after.available_energy},
                 {"/at_peak_force/kinetic_J", split.kinetic_at_peak},
                 {"/at_peak_force/support_J", split.support_at_peak},
                 {"/at_peak_force/pad_J", split.pad_at_peak},
                 {"/at_the_end/rebound_J", 101},
                 {"/at_the_end/support_J", 7},
                 {"/at_the_end/pad_J", 71},
                 {"/solved_as/mass_kg", 33. / 14},
                 {"/solved_as/speed_m_per_s", 10}});
  // The text has the same: both bodies, what becomes of them, and energies with their shares of the impact.
  const std::string text = output::to_terminal(
      output::post_impact_document(first, second, impact, solution, unit_system("si")), output::Detail::main);
  std::vector<double> expected{after.first_velocity,
                               after.second_velocity,
                               3,
                               8,
                               11,
                               -2,
                               33. / 14,
                               10,
                               after.first_velocity,
                               after.errors.first_velocity,
                               after.second_velocity,
                               after.errors.second_velocity,
                               std::sqrt(0.6),
                               after.errors.restitution,
                               1,
                               3,  // of the report's Eqs. 1 to 3
                               0.6,
                               100 * 2e-5,
                               after.available_energy};
  for (const double energy : {split.kinetic_at_peak, split.support_at_peak, split.pad_at_peak, 101., 7., 71.})
    expected.insert(expected.end(), {energy, 100 * energy / 180});
  const std::vector<double> shown = numbers_in(text);
  ASSERT_EQ(shown.size(), expected.size()) << text;
  for (std::size_t i = 0; i < shown.size(); ++i)  // errors and shares have few digits
    EXPECT_NEAR(shown[i], expected[i], (expected[i] < 1e-2 ? 0.05 : 2e-3) * std::abs(expected[i]))
        << "number " << i + 1 << "\n"
        << text;
}

/// Of a series of two blows on layers, on a support that moves.
TEST(JsonNumbers, OfAnImpact) {
  Distinct made;
  const auto moment = [&] {
    const double time = made.next();
    return Moment{time, made.next()};
  };
  Summary of;
  of.status = Status::released;
  of.peak_force = made.next();
  of.peak_acceleration = made.next();
  of.time_of_peak_force = made.next();
  of.peak_motion = made.next();
  of.peak_penetration = made.next();
  of.peak_strain = made.next();
  of.peak_strain_rate = made.next();
  of.rebound_speed = made.next();
  of.restitution = made.next();
  of.contact_end = moment();
  of.release = moment();
  of.force_below_weight = moment();
  of.bottomed = moment();
  of.rest = moment();
  of.support = SupportFigures{made.next(), made.next(), made.next(), made.next(), made.next()};
  of.energy_absorbed_fraction = made.next();
  of.energy = {made.next(), made.next(), made.next(), made.next(), made.next(),
               made.next(), made.next(), made.next(), made.next()};
  of.softening_rates = made.list(2);
  of.layers = {{made.next(), made.next(), made.next(), made.next()},
               {made.next(), made.next(), made.next(), made.next()}};
  of.errors = {made.next(), made.next(), made.next(), made.next(), made.next(),
               made.next(), made.next(), made.next(), made.next(), made.next()};
  of.steps = 1001;
  of.stations = 1002;
  of.runs = 1003;
  of.tolerance = made.next();
  of.wall_time = made.next();
  ImpactCase impact = example_case();
  set_layers(impact.pad, {{.thickness = 0.01, .material = impact.pad.material},
                          {.thickness = 0.02, .material = impact.pad.material}});
  std::vector<output::BlowResult> blows(2);
  for (output::BlowResult& blow : blows) {
    blow.summary.blow = static_cast<int>(made.next());
    blow.summary.peak_acceleration = made.next();
    blow.summary.peak_force = made.next();
    blow.summary.peak_motion = made.next();
    blow.summary.peak_penetration = made.next();
    blow.summary.rebound_speed = made.next();
    blow.summary.restitution = made.next();
    blow.summary.energy_absorbed_fraction = made.next();
    blow.injury = figures_with_numbers(made);
    blow.earlier_penetration = made.next();
  }
  Numbers expected{{"/peak_force_N", *of.peak_force},
                   {"/peak_acceleration_g", *of.peak_acceleration / g},
                   {"/time_to_peak_force_s", *of.time_of_peak_force},
                   {"/peak_motion_m", of.peak_motion},
                   {"/peak_penetration_m", of.peak_penetration},
                   {"/peak_strain", of.peak_strain},
                   {"/peak_strain_rate_per_s", of.peak_strain_rate},
                   {"/rebound_speed_m_per_s", *of.rebound_speed},
                   {"/rebound_height_m", *of.rebound_speed * *of.rebound_speed / (2 * standard_gravity)},
                   {"/restitution", *of.restitution},
                   {"/peak_transmitted_force_N", *of.support->peak_transmitted},
                   {"/peak_support_deflection_m", of.support->peak_deflection},
                   {"/support_set_m", *of.support->set},
                   {"/body_speed_m_per_s", *of.support->body_speed},
                   {"/energy_absorbed_fraction", of.energy_absorbed_fraction},
                   {"/energy_residual_fraction", of.energy.residual / of.energy.impact},
                   {"/energy/impact_energy_J", of.energy.impact},
                   {"/energy/weight_work_J", of.energy.weight},
                   {"/energy/kinetic_energy_J", of.energy.kinetic},
                   {"/energy/support_energy_J", of.energy.support},
                   {"/energy/support_loss_J", of.energy.support_loss},
                   {"/energy/moving_energy_J", of.energy.moving},
                   {"/energy/pad_energy_J", of.energy.pad},
                   {"/energy/sheet_energy_J", of.energy.sheet},
                   {"/energy/residual_energy_J", of.energy.residual},
                   {"/errors/peak_force", of.errors.peak_force},
                   {"/errors/peak_acceleration", of.errors.peak_force},
                   {"/errors/time_to_peak_force", of.errors.time_of_peak_force},
                   {"/errors/peak_motion", of.errors.peak_motion},
                   {"/errors/peak_penetration", of.errors.peak_penetration},
                   {"/errors/peak_strain", of.errors.peak_penetration},
                   {"/errors/rebound_speed", of.errors.rebound_speed},
                   {"/errors/restitution", of.errors.rebound_speed},
                   {"/errors/rebound_height", 2 * of.errors.rebound_speed},
                   {"/errors/contact_end", of.errors.contact_end},
                   {"/errors/force_below_weight", of.errors.force_below_weight},
                   {"/errors/bottomed", of.errors.bottomed},
                   {"/errors/energy_absorbed_fraction", of.errors.energy_absorbed},
                   {"/solver/steps", 1001},
                   {"/solver/stations", 1002},
                   {"/solver/runs", 1003},
                   {"/solver/tolerance", of.tolerance},
                   {"/solver/wall_time_s", of.wall_time},
                   {"/format", result_format}};
  for (const char* key : {"peak_transmitted_force", "peak_support_deflection", "support_set", "body_speed"})
    expected[std::string("/errors/") + key] = of.errors.support;
  for (const auto& [key, at] : {std::pair{"contact_end", of.contact_end},
                                {"release", of.release},
                                {"force_below_weight", of.force_below_weight},
                                {"bottomed", of.bottomed},
                                {"rest", of.rest}}) {
    expected["/" + std::string(key) + "/time_s"] = at->time;
    expected["/" + std::string(key) + "/velocity_m_per_s"] = at->velocity;
  }
  add(expected, "/softening_rates_per_s", of.softening_rates);
  expected["/flags/0/figures/time_s"] = of.bottomed->time;
  expected["/flags/0/figures/velocity_m_per_s"] = of.bottomed->velocity;
  expected["/flags/1/figures/layer_1_s"] = *of.layers[0].struck_through;
  expected["/flags/1/figures/layer_2_s"] = *of.layers[1].struck_through;
  expected["/flags/2/figures/rate_per_s"] = of.softening_rates[0];
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string layer = "/layers/" + std::to_string(i), blow = "/blows/" + std::to_string(i);
    expected[layer + "/layer"] = static_cast<double>(i + 1);
    expected[layer + "/peak_strain"] = of.layers[i].peak_strain;
    expected[layer + "/peak_strain_rate_per_s"] = of.layers[i].peak_strain_rate;
    expected[layer + "/highest_tested_strain"] = 0.9;
    expected[layer + "/time_beyond_tested_s"] = *of.layers[i].beyond_tested;
    expected[layer + "/time_struck_through_s"] = *of.layers[i].struck_through;
    const Summary& summary = blows[i].summary;
    expected[blow + "/blow"] = summary.blow;
    expected[blow + "/earlier_penetration_m"] = blows[i].earlier_penetration;
    expected[blow + "/peak_acceleration_g"] = *summary.peak_acceleration / g;
    expected[blow + "/hic15"] = blows[i].injury->hic15.value;
    expected[blow + "/peak_force_N"] = *summary.peak_force;
    expected[blow + "/peak_penetration_m"] = summary.peak_penetration;
    expected[blow + "/rebound_speed_m_per_s"] = *summary.rebound_speed;
    expected[blow + "/energy_absorbed_fraction"] = summary.energy_absorbed_fraction;
  }
  nlohmann::json written = nlohmann::json::parse(output::result_json(impact, of, std::nullopt, blows));
  written.erase("case");  // it is another test's
  expect_numbers(written, expected);
}

TEST(JsonNumbers, OfAStudy) {
  const study::StudyAnswers study_answers = answers_with_numbers();
  const study::Records& records = study_answers.records;
  Numbers expected{{"/rows", 3},
                   {"/rows_of_study", 1001},
                   {"/rows_doubtful", static_cast<double>(records.doubtful)},
                   {"/rows_extrapolated", static_cast<double>(records.extrapolated)},
                   {"/rows_extrapolated_strain", static_cast<double>(records.beyond_strain)},
                   {"/rows_extrapolated_rate", static_cast<double>(records.beyond_rate)},
                   {"/rows_bottomed", static_cast<double>(records.bottomed)},
                   {"/rows_struck_through", static_cast<double>(records.struck_through)},
                   {"/rows_at_time_limit", static_cast<double>(records.time_limit)},
                   {"/interval", 0.95}};
  for (std::size_t i = 0; i < 2; ++i) {
    const study::StudyAnswers::OfGroup& group = study_answers.groups[i];
    const std::string at = "/groups/" + std::to_string(i);
    expected[at + "/levels/0/value"] = group.group.levels[0];
    for (std::size_t k = 0; k < 2; ++k) {
      const std::string k_of = "/" + std::to_string(k);
      const double scale = k == 0 ? 1 : 1 / g;  // N, then g
      const study::Distribution& distribution = group.distributions[k];
      const std::string to = at + "/distributions" + k_of;
      expected[to + "/rows"] = static_cast<double>(distribution.rows);
      expected[to + "/rows_struck_through"] = static_cast<double>(distribution.struck_through);
      expected[to + "/rows_without"] = static_cast<double>(distribution.without);
      add(expected, to + "/mean", distribution.mean, scale);
      expected[to + "/deviation"] = scale * distribution.deviation;
      expected[to + "/least"] = scale * distribution.least;
      expected[to + "/greatest"] = scale * distribution.greatest;
      for (std::size_t q = 0; q < distribution.quantiles.size(); ++q) {
        const std::string quantile = to + "/quantiles/" + std::to_string(q);
        expected[quantile + "/probability"] = distribution.quantiles[q].probability;
        add(expected, quantile, distribution.quantiles[q].value, scale);
      }
      const study::Exceedance& exceedance = group.exceedances[k];
      const std::string above = at + "/exceedances" + k_of;
      expected[above + "/limit"] =
          study_answers.limits[k].value * (k == 0 ? 1 / g : 1);  // the other way round
      add(expected, above + "/probability", exceedance.probability);
      expected[above + "/rows_above"] = static_cast<double>(exceedance.exceeding);
      expected[above + "/rows_struck_through"] = static_cast<double>(exceedance.struck_through);
      expected[above + "/rows"] = static_cast<double>(exceedance.rows);
      expected[above + "/rows_undecided"] = static_cast<double>(exceedance.undecided);
      const study::Sensitivity& sensitivity = *group.sensitivities[k];
      const std::string by = at + "/sobol_indices" + k_of;
      expected[by + "/draws"] = static_cast<double>(sensitivity.draws);
      expected[by + "/draws_left_out"] = static_cast<double>(sensitivity.left_out);
      add(expected, by + "/indices/0/first_order", sensitivity.indices[0].first);
      add(expected, by + "/indices/0/total", sensitivity.indices[0].total);
    }
  }
  const study::CushionCurves::Drop& drop = study_answers.cushion_curves->drops[0];
  expected["/cushion_curves/curves/0/drop_height_m"] = drop.height;
  expected["/cushion_curves/curves/0/speed_m_per_s"] = drop.speed;
  expected["/cushion_curves/curves/0/thickness_m"] = drop.curves[0].thickness;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string point = "/cushion_curves/curves/0/points/" + std::to_string(i);
    expected[point + "/static_stress_Pa"] = drop.curves[0].static_stress[i];
    expected[point + "/peak_acceleration_g"] = drop.curves[0].peak_deceleration[i] / g;
  }
  expect_result(output::study_json(study_answers), expected);
}

TEST(JsonNumbers, OfAPulse) {
  const injury::PulseReport pulse_report = pulse_with_numbers();
  const injury::InjuryFigures& figures = pulse_report.figures;
  Numbers expected{{"/figures/peak_acceleration/value_g", figures.peak.magnitude / g},
                   {"/figures/peak_acceleration/time_s", figures.peak.time},
                   {"/figures/hic_d/value", figures.hic_d},
                   {"/figures/severity_index/value", figures.severity_index},
                   {"/figures/velocity_change/value_m_per_s", figures.velocity_change},
                   {"/figures/velocity_change/begin_s", pulse_report.contact.begin},
                   {"/figures/velocity_change/end_s", pulse_report.contact.end},
                   {"/figures/hic_windows/0/value", pulse_report.windows[0].hic.value},
                   {"/figures/hic_windows/0/begin_s", pulse_report.windows[0].hic.begin},
                   {"/figures/hic_windows/0/end_s", pulse_report.windows[0].hic.end},
                   {"/figures/hic_windows/0/longest_window_s", pulse_report.windows[0].longest_window},
                   {"/figures/dwell_time/0/level_g", pulse_report.dwells[0].level / g},
                   {"/figures/dwell_time/0/value_s", pulse_report.dwells[0].cumulative},
                   {"/figures/dwell_time/0/longest_s", pulse_report.dwells[0].longest},
                   {"/impact/speed_m_per_s", pulse_report.impact->speed},
                   {"/impact/drop_height_m", *pulse_report.impact->drop_height},
                   {"/impact/gravity_m_per_s2", pulse_report.impact->gravity},
                   {"/impact/restitution",
                    (pulse_report.contact.velocity_change -
                     pulse_report.impact->gravity * (pulse_report.contact.end - pulse_report.contact.begin)) /
                            pulse_report.impact->speed -
                        1},
                   {"/impact/check/least_scale", *injury::speed_check(pulse_report)->min_scale},
                   {"/impact/check/greatest_scale", *injury::speed_check(pulse_report)->greatest_scale},
                   {"/uncertainty/coverage_factor", 2},
                   {"/source/time/number", 101},
                   {"/source/time/si_factor", pulse_report.measured.time.factor},
                   {"/source/acceleration/0/number", 102},
                   {"/source/acceleration/0/si_factor", pulse_report.measured.acceleration[0].factor},
                   {"/source/samples", 3},
                   {"/source/begin_s", 0.25},
                   {"/source/end_s", 0.75},
                   {"/offset/begin_s", pulse_report.offset->offset.begin},
                   {"/offset/end_s", pulse_report.offset->offset.end},
                   {"/offset/samples", 103},
                   {"/offset/hic15_with", pulse_report.offset->hic15_with},
                   {"/offset/hic15_without", pulse_report.offset->hic15_without},
                   {"/processing/resampled_to_s", *pulse_report.resampled_to},
                   {"/processing/filter/channel_frequency_class", 600},
                   {"/processing/samples", 4}};
  add(expected, "/offset/mean_g", pulse_report.offset->offset.mean, 1 / g);
  add(expected, "/offset/scatter_g", pulse_report.offset->offset.scatter, 1 / g);
  for (const auto& [key, hic] : {std::pair{"hic15", figures.hic15},
                                 {"hic36", figures.hic36},
                                 {"hic_unlimited", figures.hic_unlimited}}) {
    const std::string to = std::string("/figures/") + key;
    expected[to + "/value"] = hic.value;
    expected[to + "/begin_s"] = hic.begin;
    expected[to + "/end_s"] = hic.end;
  }
  for (const auto& [key, clip] :
       {std::pair{"clip_3ms", figures.clip_3ms}, {"cumulative_3ms", figures.cumulative_3ms}}) {
    const std::string to = std::string("/figures/") + key;
    expected[to + "/value_g"] = clip.level / g;
    expected[to + "/begin_s"] = clip.begin;
    expected[to + "/end_s"] = clip.end;
  }
  expect_result(output::pulse_json(pulse_report), expected);
}

TEST(JsonNumbers, OfAPulseBesideAnImpact) {
  const injury::PulseReport pulse = pulse_with_numbers();
  Distinct made;
  injury::PulseShape shapes[2];
  for (injury::PulseShape& shape : shapes) {
    shape.peak = {made.next(), 10 + made.next()};
    shape.onset = made.next() / 100;
    shape.width = made.next();
    shape.contact.begin = made.next();
    shape.contact.end = made.next();
    shape.contact.velocity_change = made.next();
    shape.hic15 = made.next();
    shape.restitution = made.next();
  }
  injury::PulseComparison of;
  of.shift = made.next();
  of.measured = shapes[0];
  of.computed = shapes[1];
  of.figures = injury::compared_figures(of.measured, of.computed, of.alignment);
  for (injury::ComparedFigure& figure : of.figures) figure.error = made.next();
  Solution solution;
  solution.summary = example_summary();
  Numbers expected{{"/alignment/shift_s", of.shift},
                   {"/alignment/measured_onset_s", *of.measured.onset},
                   {"/alignment/computed_onset_s", *of.computed->onset},
                   {"/case/tolerance", 1e-4},
                   {"/pulse/samples", 4},
                   {"/pulse/contact_begin_s", of.measured.contact.begin},
                   {"/pulse/contact_end_s", of.measured.contact.end},
                   {"/pulse/speed_m_per_s", pulse.impact->speed},
                   {"/pulse/resampled_to_s", *pulse.resampled_to}};
  const auto add_figure = [&](std::size_t i, const std::string& key, const std::string& unit, double measured,
                              double computed, double scale = 1) {
    const std::string to = "/figures/" + key;
    expected[to + "/measured" + unit] = scale * measured;
    expected[to + "/computed" + unit] = scale * computed;
    expected[to + "/error"] = of.figures[i].error;
    expected[to + "/difference" + unit] = scale * (computed - measured);
    expected[to + "/difference_share"] = (computed - measured) / measured;
  };
  const injury::PulseShape &a = shapes[0], &b = shapes[1];
  add_figure(0, "peak_acceleration", "_g", a.peak.magnitude, b.peak.magnitude, 1 / g);
  add_figure(1, "time_to_peak", "_s", a.peak.time - *a.onset, b.peak.time - *b.onset);
  add_figure(2, "half_peak_width", "_s", a.width, b.width);
  add_figure(3, "velocity_change", "_m_per_s", a.contact.velocity_change, b.contact.velocity_change);
  add_figure(4, "hic15", "", a.hic15, b.hic15);
  add_figure(5, "restitution", "", *a.restitution, *b.restitution);
  const ImpactCase impact = example_case();
  expect_result(output::pulse_comparison_json({"case.toml", impact, solution, pulse, of}), expected);
}

TEST(JsonNumbers, OfAFit) {
  const fit::FitReport fit_report = fit_with_numbers();
  const fit::FittedUnknown& unknown = fit_report.unknowns[0];
  const fit::MetTest& test = fit_report.tests[0];
  const fit::MetFigure& figure = fit_report.figures[0];
  const fit::MetPulse& pulse = fit_report.pulses[0];
  const fit::ImpactComparison& compared = fit_report.comparison[0];
  Numbers expected{{"/unknowns/0/value", unknown.value},
                   {"/unknowns/0/standard_error", *unknown.standard_error},
                   {"/unknowns/0/interval/low", *unknown.low},
                   {"/unknowns/0/interval/high", *unknown.high},
                   {"/unknowns/0/bounds/lowest", unknown.lowest},
                   {"/unknowns/0/bounds/highest", unknown.highest},
                   {"/left_open/correlations/0/correlation", fit_report.correlations[0].value},
                   {"/misfit/points", 103},
                   {"/misfit/priors", 104},
                   {"/misfit/degrees_of_freedom", fit_report.degrees_of_freedom},
                   {"/misfit/sum_of_squares", fit_report.misfit},
                   {"/misfit/per_degree_of_freedom", fit_report.misfit / fit_report.degrees_of_freedom},
                   {"/misfit/error_factor", std::sqrt(fit_report.variance_scale)},
                   {"/misfit/largest_widening", fit_report.largest_widening},
                   {"/tests/0/points", 101},
                   {"/tests/0/largest_stress_Pa", test.largest_stress},
                   {"/tests/0/lowest_rate_per_s", test.lowest_rate},
                   {"/tests/0/highest_rate_per_s", test.highest_rate},
                   {"/tests/0/noise_Pa", test.noise},
                   {"/tests/0/offset_Pa", *test.offset},
                   {"/tests/0/rms_loading_Pa", *test.rms_loading},
                   {"/tests/0/rms_unloading_Pa", *test.rms_unloading},
                   {"/tests/0/loops/0/largest_strain", test.loops[0].largest_strain},
                   {"/tests/0/loops/0/measured_return", test.loops[0].measured_return},
                   {"/tests/0/loops/0/computed_return", test.loops[0].computed_return},
                   {"/tests/0/autocorrelation", test.autocorrelation},
                   {"/tests/0/effective_points", test.effective_points},
                   {"/impacts/0/measured", figure.measured},
                   {"/impacts/0/deviation", figure.deviation},
                   {"/impacts/0/computed", *figure.computed},
                   {"/impacts/0/prediction_deviation", *figure.prediction_deviation},
                   {"/pulses/0/samples", 102},
                   {"/pulses/0/points", 3},
                   {"/pulses/0/deviation_g", pulse.deviation / g},
                   {"/pulses/0/measured_peak_g", pulse.measured_peak / g},
                   {"/pulses/0/computed_peak_g", *pulse.computed_peak / g},
                   {"/pulses/0/rms_g", *pulse.rms / g},
                   {"/pulses/0/rms_share_of_peak", *pulse.rms / pulse.measured_peak},
                   {"/pulses/0/shift_s", *pulse.shift},
                   {"/pulses/0/autocorrelation", pulse.autocorrelation},
                   {"/pulses/0/effective_points", pulse.effective_points},
                   {"/comparison/0/measured", compared.measured},
                   {"/comparison/0/computed", *compared.computed},
                   {"/comparison/0/share", (*compared.computed - compared.measured) / compared.measured},
                   {"/search/starts", 105},
                   {"/search/starts_at_best", 106},
                   {"/search/starts_failed", 107},
                   {"/search/solver_runs", 108},
                   {"/search/evaluations", 109},
                   {"/search/wall_time_s", fit_report.wall_time}};
  add(expected, "/tests/0/strain", test.strain);
  add(expected, "/tests/0/measured_stress_Pa", test.measured);
  add(expected, "/tests/0/computed_stress_Pa", test.computed);
  add(expected, "/pulses/0/time_s", pulse.time);
  add(expected, "/pulses/0/measured_g", pulse.measured, 1 / g);
  add(expected, "/pulses/0/computed_g", pulse.computed, 1 / g);
  expect_result(output::fit_json(fit_report), expected);
}

}  // namespace
}  // namespace dashpad::test
