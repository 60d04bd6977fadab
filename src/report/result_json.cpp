#include "dashpad/report/result_json.hpp"

#include <cmath>
#include <optional>

#include "dashpad/version.hpp"
#include "io/json_values.hpp"
#include "report/material_json.hpp"

namespace dashpad {

namespace {

Json moment(const Moment& of) {
  return {{"time_s", number(of.time)}, {"velocity_m_per_s", number(of.velocity)}};
}

Json moment(const std::optional<Moment>& of) { return of ? moment(*of) : Json(nullptr); }

std::optional<double> in_g(const std::optional<double>& acceleration) {
  return acceleration ? std::optional{*acceleration / standard_gravity} : std::nullopt;
}

Json energy(const EnergyLedger& ledger) {
  return {{"initial_J", number(ledger.initial)},
          {"kinetic_J", number(ledger.kinetic)},
          {"support_J", number(ledger.support)},
          {"pad_J", number(ledger.pad)},
          {"residual_J", number(ledger.residual)}};
}

/// Null for the error of a figure that is absent.
Json errors(const Summary& summary) {
  const ErrorEstimates& of = summary.errors;
  return {{"peak_force", number_if(summary.peak_force.has_value(), of.peak_force)},
          {"time_of_peak_force", number_if(summary.time_of_peak_force.has_value(), of.time_of_peak_force)},
          {"peak_motion", number(of.peak_motion)},
          {"peak_penetration", number(of.peak_penetration)},
          {"rebound_speed", number_if(summary.rebound_speed.has_value(), of.rebound_speed)},
          {"contact_end", number_if(summary.contact_end.has_value(), of.contact_end)},
          {"weight", number_if(summary.weight.has_value(), of.weight)},
          {"bottomed", number_if(summary.bottomed.has_value(), of.bottomed)},
          {"energy_absorbed", number(of.energy_absorbed)}};
}

Json solver(const Summary& summary) {
  return {{"steps", summary.steps},
          {"stations", summary.stations},
          {"runs", summary.runs},
          {"tolerance", number(summary.tolerance)},
          {"wall_time_s", number(summary.wall_time)}};
}

Json pad(const Pad& of) {
  Json json{{"thickness_m", number(of.thickness)}};
  json.update(material_json(of.material));
  return json;
}

Json support(const Support& of) {
  Json points = Json::array();
  for (const Support::Point& point : of.points())
    points.push_back({{"deflection_m", number(point.deflection)}, {"force_N", number(point.force)}});
  if (of.is_rigid()) return {{"type", "rigid"}, {"stiffness_N_per_m", nullptr}, {"points", points}};
  if (of.points().size() > 1) return {{"type", "curve"}, {"stiffness_N_per_m", nullptr}, {"points", points}};
  const Support::Point& point = of.points().front();
  return {
      {"type", "linear"}, {"stiffness_N_per_m", number(point.force / point.deflection)}, {"points", points}};
}

Json impactor(const Impactor& of) {
  Json json = {{"mass_kg", number(of.mass)}, {"speed_m_per_s", number(of.speed)}};
  json["nose"] = name_of(of.nose);
  for (const ParameterValue& value : parameter_values(of.nose))
    json[value.key + (value.unit == "1" ? "" : "_" + value.unit)] = number(value.value);
  return json;
}

Json echo(const ImpactCase& impact) {
  return {{"title", impact.title},
          {"impactor", impactor(impact.impactor)},
          {"pad", pad(impact.pad)},
          {"support", support(impact.support)}};
}

Json hic_json(const Hic& of, double error) {
  return {{"value", number(of.value)},
          {"begin_s", number(of.begin)},
          {"end_s", number(of.end)},
          {"error", number(error)}};
}

Json clip_json(const Clip& of, double error) {
  return {{"level_g", number(of.level / standard_gravity)},
          {"begin_s", number(of.begin)},
          {"end_s", number(of.end)},
          {"error", number(error)}};
}

Json injury_json(const std::optional<InjuryFigures>& figures) {
  if (!figures) return nullptr;
  const InjuryFigures::Errors& errors = figures->errors;
  return {{"hic15", hic_json(figures->hic15, errors.hic15)},
          {"hic36", hic_json(figures->hic36, errors.hic36)},
          {"hic_unlimited", hic_json(figures->hic_unlimited, errors.hic_unlimited)},
          {"hic_d", {{"value", number(figures->hic_d)}, {"error", number(errors.hic_d)}}},
          {"clip_3ms_contiguous", clip_json(figures->contiguous_3ms, errors.contiguous_3ms)},
          {"clip_3ms_cumulative", clip_json(figures->cumulative_3ms, errors.cumulative_3ms)},
          {"severity_index",
           {{"value", number(figures->severity_index)}, {"error", number(errors.severity_index)}}}};
}

}  // namespace

std::string result_json(const ImpactCase& impact, const Summary& summary,
                        const std::optional<InjuryFigures>& injury) {
  Json result;
  result["status"] = to_string(summary.status);
  result["peak_force_N"] = number(summary.peak_force);
  result["time_of_peak_force_s"] = number(summary.time_of_peak_force);
  result["peak_motion_m"] = number(summary.peak_motion);
  result["peak_penetration_m"] = number(summary.peak_penetration);
  result["peak_strain"] = number(summary.peak_strain);
  result["peak_strain_rate_per_s"] = number(summary.peak_strain_rate);
  result["peak_acceleration_g"] = number(in_g(summary.peak_acceleration));
  result["weight"] = moment(summary.weight);
  result["contact_end"] = moment(summary.contact_end);
  result["release"] = moment(summary.release);
  result["rebound_speed_m_per_s"] = number(summary.rebound_speed);
  result["restitution"] = number(summary.restitution);
  result["energy_absorbed_fraction"] = number(summary.energy_absorbed_fraction);
  result["energy_residual_fraction"] = number(summary.energy.residual / summary.energy.initial);
  result["energy"] = energy(summary.energy);
  result["extrapolated"] = summary.extrapolated;
  result["extrapolations"] = summary.extrapolations;
  result["bottomed"] = summary.bottomed ? moment(*summary.bottomed) : Json(false);
  result["injury"] = injury_json(injury);
  result["errors"] = errors(summary);
  result["solver"] = solver(summary);
  result["case"] = echo(impact);
  result["program"] = program_json();
  return json_text(result);
}

}  // namespace dashpad
