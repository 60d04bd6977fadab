#include "dashpad/output/json/result.hpp"

#include <cmath>

#include "dashpad/impact/flags.hpp"
#include "json/flags_json.hpp"
#include "json/json_values.hpp"
#include "output/json/injury.hpp"
#include "output/json/interval.hpp"
#include "output/json/material.hpp"
#include "result/summary_values.hpp"

namespace dashpad::output {

namespace {

Json moment(const EstimatedValue& of) {
  return {{"time_s", number(of.value)}, {"velocity_m_per_s", number(of.velocity)}};
}

/// Every figure of the table, and the errors of those that have an estimate; null where it is absent.
void add_figures(Json& result, Json& errors, const Summary& summary) {
  for (const SummaryQuantity& entry : summary_quantities()) {
    const ResultQuantity& quantity = *entry.quantity;
    const EstimatedValue of = entry.of(summary);
    const bool absent = std::isnan(of.value);
    if (quantity.part == Part::moment)
      result[quantity.key] = absent ? Json(nullptr) : moment(of);
    else
      result[key_with_unit(quantity)] = number(scaled_unit(quantity.si_unit, plain_si()).scale * of.value);
    if (quantity.has_estimate()) errors[quantity.key] = number_if(!absent, of.error);
  }
}

Json energy(const EnergyLedger& ledger) {
  const auto key = [](const char* of) { return key_with_unit(result_quantity(of)); };
  return {{key("impact_energy"), number(ledger.impact)},
          {key("weight_work"), number(ledger.weight)},
          {key("kinetic_energy"), number(ledger.kinetic)},
          {key("support_energy"), number(ledger.support)},
          {key("support_loss"), number(ledger.support_loss)},
          {key("moving_energy"), number(ledger.moving)},
          {key("pad_energy"), number(ledger.pad)},
          {key("sheet_energy"), number(ledger.sheet)},
          {key("residual_energy"), number(ledger.residual)}};
}

Json solver(const Summary& summary) {
  return {{"steps", summary.steps},
          {"stations", summary.stations},
          {"runs", summary.runs},
          {"tolerance", number(summary.tolerance)},
          {"wall_time_s", number(summary.wall_time)}};
}

/// All numbers of an owner, null where it has none, under their keys and units.
template <class Owner>
Json numbers_of(const Owner& owner) {
  Json json = Json::object();
  for (const Parameter<Owner>& parameter : Owner::parameters) {
    const double value = parameter.of(owner);
    json[name_with_unit(parameter.key, parameter.unit)] =
        parameter.member.is_count() ? Json(static_cast<int>(value)) : number(value);
  }
  return json;
}

/// A pad of layers has no material of its own.
Json pad(const Pad& of) {
  Json json = numbers_of(of);
  json["floor"] = name_of(of.floor);
  json.update(numbers_of(of.condition));
  json.update(material_json(of.material));
  json["layers"] = Json::array();
  for (const PadLayer& layer : of.layers) {
    Json entry = numbers_of(layer);
    entry.update(numbers_of(layer.condition));
    entry.update(material_json(layer.material));
    json["layers"].push_back(std::move(entry));
  }
  if (!of.layers.empty())
    for (const char* key : {"material", "title", "source", "law", "parameters"}) json[key] = nullptr;
  return json;
}

Json layers(const Pad& pad, const Summary& summary) {
  Json all = Json::array();
  for (std::size_t i = 0; i < summary.layers.size(); ++i) {
    const LayerSummary& layer = summary.layers[i];
    const auto tested = range_of(pad.layers[i].material);
    all.push_back(
        {{"layer", i + 1},
         {"material", pad.layers[i].material.name},
         {"peak_strain", number(layer.peak_strain)},
         {"peak_strain_rate_per_s", number(layer.peak_strain_rate)},
         {"highest_tested_strain", number_if(tested.has_value(), tested ? tested->highest_strain : 0)},
         {"time_beyond_tested_s", number(layer.beyond_tested)},
         {"time_struck_through_s", number(layer.struck_through)}});
  }
  return all;
}

Json curve_of(const Support& of) {
  Json points = Json::array();
  for (const Support::Point& point : of.points())
    points.push_back({{"deflection_m", number(point.deflection)}, {"force_N", number(point.force)}});
  if (of.is_rigid()) return {{"type", "rigid"}, {"stiffness_N_per_m", nullptr}, {"points", points}};
  if (of.points().size() > 1) return {{"type", "curve"}, {"stiffness_N_per_m", nullptr}, {"points", points}};
  const Support::Point& point = of.points().front();
  return {
      {"type", "linear"}, {"stiffness_N_per_m", number(point.force / point.deflection)}, {"points", points}};
}

Json support(const ImpactCase& of) {
  Json json = curve_of(of.support);
  json.update(numbers_of(of.backing));
  return json;
}

Json impactor(const Impactor& of) {
  Json json = numbers_of(of);
  json["nose"] = name_of(of.nose);
  for (const ParameterValue& value : parameter_values(of.nose))
    json[name_with_unit(value.key, value.unit)] = number(value.value);
  if (const auto* profile = std::get_if<Profile>(&of.nose)) {
    const char* const size = profile->of == Profile::Of::radius ? "radius_m" : "area_m2";
    json["points"] = Json::array();
    for (const Profile::Point& point : profile->points)
      json["points"].push_back({{"depth_m", number(point.depth)}, {size, number(point.size)}});
  }
  return json;
}

Json blows_asked(const std::optional<Blows>& of) { return of ? numbers_of(*of) : Json(nullptr); }

Json echo(const ImpactCase& impact) {
  return {{"title", impact.title},
          {"impactor", impactor(impact.impactor)},
          {"pad", pad(impact.pad)},
          {"support", support(impact)},
          {"blows", blows_asked(impact.blows)}};
}

/// What grows from blow to blow; the last has all its figures at the top.
Json blow_json(const BlowResult& of) {
  const Summary& summary = of.summary;
  return {{"blow", summary.blow},
          {"status", to_string(summary.status)},
          {"earlier_penetration_m", number(of.earlier_penetration)},
          {"peak_acceleration_g", number_if(summary.peak_acceleration.has_value(),
                                            summary.peak_acceleration.value_or(0) / standard_gravity)},
          {"hic15", of.injury ? number(of.injury->hic15.value) : Json(nullptr)},
          {"peak_force_N", number(summary.peak_force)},
          {"peak_penetration_m", number(summary.peak_penetration)},
          {"rebound_speed_m_per_s", number(summary.rebound_speed)},
          {"energy_absorbed_fraction", number(summary.energy_absorbed_fraction)}};
}

Json series(const std::vector<BlowResult>& blows) {
  if (blows.empty()) return nullptr;
  Json all = Json::array();
  for (const BlowResult& blow : blows) all.push_back(blow_json(blow));
  return all;
}

/// What is not known, then the figures with it; `high` is null where there is no bound.
Json intervals_json(const Intervals& of) {
  Json sources = Json::array(), figures = Json::object();
  for (const OpenSource& source : of.sources)
    sources.push_back({{"source", to_string(source.source)},
                       {"words", source.words},
                       {"why_no_interval", source.why_not.empty() ? Json(nullptr) : Json(source.why_not)}});
  for (const FigureInterval& figure : of.figures)
    if (figure.key != "dwell_time")
      figures[key_with_unit(result_quantity(figure.key))] = interval_json(figure);
  return {{"sources", sources}, {"figures", figures}, {"impacts", of.impacts}};
}

}  // namespace

Json interval_json(const FigureInterval& of) {
  const double scale = scaled_unit(result_quantity(of.key).si_unit, plain_si()).scale;
  Json sources = Json::array();
  for (const Contribution& each : of.sources)
    sources.push_back({{"source", to_string(each.source)},
                       {"low", number(scale * each.low)},
                       {"high", number(scale * each.high)}});
  return {{"low", number(scale * of.low)}, {"high", number(scale * of.high)}, {"sources", sources}};
}

std::string result_json(const ImpactCase& impact, const Summary& summary,
                        const std::optional<injury::InjuryFigures>& injury,
                        const std::vector<BlowResult>& blows) {
  Json result, errors;
  result["status"] = to_string(summary.status);
  add_figures(result, errors, summary);
  result["blows"] = series(blows);
  result["energy"] = energy(summary.energy);
  result["flags"] = flags_json(flags(summary));
  result["extrapolated"] = !summary.extrapolations.empty();
  result["extrapolated_strain"] = summary.is_beyond(Beyond::strain);
  result["extrapolated_rate"] = summary.is_beyond(Beyond::rate);
  result["extrapolations"] = Json::array();
  for (const Extrapolation& of : summary.extrapolations) result["extrapolations"].push_back(of.text);
  result["intervals"] = summary.intervals ? intervals_json(*summary.intervals) : Json(nullptr);
  result["softening_rates_per_s"] = numbers(summary.softening_rates);
  result["layers"] = layers(impact.pad, summary);
  result["injury"] = injury ? injury_json(*injury, true) : Json(nullptr);
  result["errors"] = errors;
  result["solver"] = solver(summary);
  result["case"] = echo(impact);
  result["program"] = program_json();
  return result_json_text(result);
}

}  // namespace dashpad::output
