// JSON of one impact, and of an impact between two bodies.

#include <cmath>

#include "dashpad/output/impact.hpp"
#include "json/curves_json.hpp"
#include "model/parameter_values.hpp"
#include "output/json/parts.hpp"
#include "result/summary_values.hpp"

namespace dashpad::output {

namespace {

Json moment(const EstimatedValue& estimate) {
  return {{"time_s", number(estimate.value)}, {"velocity_m_per_s", number(estimate.velocity)}};
}

/// Every figure of the table, and the errors of those that have an estimate; null where it is absent.
void add_figures(Json& result, Json& errors, const Summary& summary) {
  for (const SummaryQuantity& entry : summary_quantities()) {
    const ResultQuantity& quantity = *entry.quantity;
    const EstimatedValue estimate = entry.of(summary);
    const bool absent = std::isnan(estimate.value);
    if (quantity.part == Part::moment)
      result[quantity.key] = absent ? Json(nullptr) : moment(estimate);
    else
      result[key_with_unit(quantity)] =
          number(scaled_unit(quantity.si_unit, plain_si()).scale * estimate.value);
    if (quantity.has_estimate()) errors[quantity.key] = number_if(!absent, estimate.error);
  }
}

/// The key in files of a quantity in the table of results.
std::string in_table(const char* key) { return key_with_unit(result_quantity(key)); }

Json energy(const EnergyLedger& ledger) {
  return {{in_table("impact_energy"), number(ledger.impact)},
          {in_table("weight_work"), number(ledger.weight)},
          {in_table("kinetic_energy"), number(ledger.kinetic)},
          {in_table("support_energy"), number(ledger.support)},
          {in_table("support_loss"), number(ledger.support_loss)},
          {in_table("moving_energy"), number(ledger.moving)},
          {in_table("pad_energy"), number(ledger.pad)},
          {in_table("sheet_energy"), number(ledger.sheet)},
          {in_table("residual_energy"), number(ledger.residual)}};
}

Json solver(const Summary& summary) {
  return {{"steps", summary.steps},
          {"stations", summary.stations},
          {"runs", summary.runs},
          {"tolerance", number(summary.tolerance)},
          {"wall_time_s", number(summary.wall_time)}};
}

/// All numbers of an owner by key and unit; absent ones are null.
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
Json pad(const Pad& pad) {
  Json json = numbers_of(pad);
  json["floor"] = name_of(pad.floor);
  json.update(numbers_of(pad.condition));
  json.update(material_json(pad.material));
  json["layers"] = array_of(pad.layers, [](const PadLayer& layer) {
    Json entry = numbers_of(layer);
    entry.update(numbers_of(layer.condition));
    entry.update(material_json(layer.material));
    return entry;
  });
  if (!pad.layers.empty())
    for (const char* key : {"material", "title", "source", "law", "parameters"}) json[key] = nullptr;
  return json;
}

Json layers(const Pad& pad, const Summary& summary) {
  Json all = Json::array();
  for (std::size_t i = 0; i < summary.layers.size(); ++i) {
    const LayerSummary& layer = summary.layers[i];
    const Material& material = pad.layers[i].material;
    const auto tested = [](const FittedRange& range) { return number(range.highest_strain); };
    all.push_back({{"layer", i + 1},
                   {"material", material.name},
                   {"peak_strain", number(layer.peak_strain)},
                   {"peak_strain_rate_per_s", number(layer.peak_strain_rate)},
                   {"highest_tested_strain", made_of(range_of(material), tested)},
                   {"time_beyond_tested_s", number(layer.beyond_tested)},
                   {"time_struck_through_s", number(layer.struck_through)}});
  }
  return all;
}

Json curve_of(const Support& support) {
  const bool is_linear = !support.is_rigid() && support.points().size() == 1;
  const auto stiffness = [&] { return support.points().front().force / support.points().front().deflection; };
  return {{"type", support.is_rigid() ? "rigid"
                   : is_linear        ? "linear"
                                      : "curve"},
          {"stiffness_N_per_m", is_linear ? number(stiffness()) : Json(nullptr)},
          {"points", array_of(support.points(), [](const Support::Point& point) {
             return Json{{"deflection_m", number(point.deflection)}, {"force_N", number(point.force)}};
           })}};
}

Json support(const ImpactCase& impact) {
  Json json = curve_of(impact.support);
  json.update(numbers_of(impact.backing));
  return json;
}

Json impactor(const Impactor& impactor) {
  Json json = numbers_of(impactor);
  json["nose"] = name_of(impactor.nose);
  for (const ParameterValue& value : parameter_values(impactor.nose))
    json[name_with_unit(value.key, value.unit)] = number(value.value);
  if (const auto* profile = std::get_if<Profile>(&impactor.nose)) {
    const char* const size = profile->of == Profile::Of::radius ? "radius_m" : "area_m2";
    json["points"] = array_of(profile->points, [&](const Profile::Point& point) {
      return Json{{"depth_m", number(point.depth)}, {size, number(point.size)}};
    });
  }
  return json;
}

Json echo(const ImpactCase& impact) {
  return {{"title", impact.title},
          {"impactor", impactor(impact.impactor)},
          {"pad", pad(impact.pad)},
          {"support", support(impact)},
          {"blows", made_of(impact.blows, numbers_of<Blows>)}};
}

/// The figures of a blow that change from blow to blow; the last blow has all its figures at the top level.
Json blow_json(const BlowResult& blow) {
  const Summary& summary = blow.summary;
  return {{"blow", summary.blow},
          {"status", to_string(summary.status)},
          {"earlier_penetration_m", number(blow.earlier_penetration)},
          {in_table("peak_acceleration"), number(summary.peak_acceleration.value_or(NAN) / standard_gravity)},
          {in_table("hic15"), number(blow.injury ? blow.injury->hic15.value : NAN)},
          {in_table("peak_force"), number(summary.peak_force)},
          {in_table("peak_penetration"), number(summary.peak_penetration)},
          {in_table("rebound_speed"), number(summary.rebound_speed)},
          {in_table("energy_absorbed_fraction"), number(summary.energy_absorbed_fraction)}};
}

/// The sources of uncertainty, then the interval of each figure.
Json intervals_json(const Intervals& intervals) {
  Json figures = Json::object();
  for (const FigureInterval& figure : intervals.figures)
    if (figure.key != "dwell_time")
      figures[key_with_unit(result_quantity(figure.key))] = interval_json(figure);
  const Json sources = array_of(intervals.sources, [](const OpenSource& source) {
    return Json{{"source", to_string(source.source)},
                {"words", source.words},
                {"why_no_interval", text_if_any(source.why_not)}};
  });
  return {{"sources", sources}, {"figures", figures}, {"impacts", intervals.impacts}};
}

Json fitted_json(const FittedRange& range) {
  return {{"highest_strain", number(range.highest_strain)},
          {"lowest_rate_per_s", number(range.lowest_rate)},
          {"highest_rate_per_s", number(range.highest_rate)}};
}

/// One of the two bodies before and after the impact.
Json body_json(const Body& body, double after, double error) {
  return {{"mass_kg", number(body.mass)},
          {"velocity_m_per_s", number(body.velocity)},
          {"velocity_after_m_per_s", number(after)},
          {"velocity_after_error_m_per_s", number(error)}};
}

}  // namespace

Json flags_json(const std::vector<Flag>& flags) {
  return array_of(flags, [](const Flag& flag) {
    Json figures = Json::object();
    for (const FlagFigure& figure : flag.figures) figures[figure.key] = number(figure.value);
    return Json{{"name", flag.name},
                {"severity", to_string(severity_of(flag.name))},
                {"text", flag.text},
                {"figures", figures}};
  });
}

Json interval_json(const FigureInterval& interval) {
  const double scale = scaled_unit(result_quantity(interval.key).si_unit, plain_si()).scale;
  const Json sources = array_of(interval.sources, [&](const Contribution& each) {
    return Json{{"source", to_string(each.source)},
                {"low", number(scale * each.low)},
                {"high", number(scale * each.high)}};
  });
  return {
      {"low", number(scale * interval.low)}, {"high", number(scale * interval.high)}, {"sources", sources}};
}

Json injury_json(const injury::InjuryFigures& figures, bool with_errors) {
  Json all = Json::object();
  for (const injury::InjuryValue& figure : injury::injury_values(figures)) {
    const ScaledUnit unit = scaled_unit(figure.quantity->si_unit, plain_si());
    Json& entry = all[figure.quantity->key];
    entry[name_with_unit("value", unit.unit)] = number(unit.scale * figure.value);
    if (figure.time) entry["time_s"] = number(*figure.time);
    if (figure.begin) entry["begin_s"] = number(*figure.begin);
    if (figure.end) entry["end_s"] = number(*figure.end);
    if (with_errors) entry["error"] = number(figure.error);
  }
  return all;
}

Json material_json(const Material& material) {
  Json parameters = Json::object();
  for (const ParameterValue& parameter : parameter_values(material.law))
    parameters[parameter.key] = {
        {"value", number(parameter.value)}, {"unit", parameter.unit}, {"symbol", parameter.symbol}};
  Json json{{"material", material.name}, {"title", material.title},
            {"source", material.source}, {"law", name_of(material.law)},
            {"parameters", parameters},  {"fitted", made_of(range_of(material), fitted_json)}};
  json["curves"] = curves_json(material.law);
  return json;
}

std::string case_json(const ImpactCase& impact, const Options& options) {
  return result_json_text(
      {{"program", program_json()}, {"case", echo(impact)}, {"solver", numbers_of(options)}});
}

std::string result_json(const ImpactCase& impact, const Summary& summary,
                        const std::optional<injury::InjuryFigures>& injury,
                        const std::vector<BlowResult>& blows) {
  Json result, errors;
  result["status"] = to_string(summary.status);
  add_figures(result, errors, summary);
  result["blows"] = blows.empty() ? Json(nullptr) : array_of(blows, blow_json);
  result["energy"] = energy(summary.energy);
  result["flags"] = flags_json(flags(summary));
  result["extrapolated"] = !summary.extrapolations.empty();
  result["extrapolated_strain"] = summary.is_beyond(Beyond::strain);
  result["extrapolated_rate"] = summary.is_beyond(Beyond::rate);
  result["extrapolations"] =
      array_of(summary.extrapolations, [](const Extrapolation& extrapolation) { return extrapolation.text; });
  result["intervals"] = made_of(summary.intervals, intervals_json);
  result["softening_rates_per_s"] = numbers(summary.softening_rates);
  result["layers"] = layers(impact.pad, summary);
  result["injury"] =
      made_of(injury, [](const injury::InjuryFigures& figures) { return injury_json(figures, true); });
  result["errors"] = errors;
  result["solver"] = solver(summary);
  result["case"] = echo(impact);
  result["program"] = program_json();
  return result_json_text(result);
}

std::string post_impact_json(const Body& first, const Body& second, const ImpactCase& impact,
                             const Solution& solution) {
  const PostImpact after = post_impact(first, second, solution);
  const EnergySplit split = energy_split(impact, solution);
  const Summary& summary = solution.summary;
  return result_json_text(
      {{"status", to_string(summary.status)},
       {"extrapolated", !summary.extrapolations.empty()},
       {"bottomed", summary.bottomed.has_value()},
       {"flags", flags_json(flags(summary))},
       {"bodies",
        {body_json(first, after.first_velocity, after.errors.first_velocity),
         body_json(second, after.second_velocity, after.errors.second_velocity)}},
       {"energy_coefficient_C", number(after.energy_coefficient)},
       {"restitution_sqrt_C", number(after.restitution)},
       {"restitution_error", number(after.errors.restitution)},
       {"absorbed_fraction_error", number(summary.errors.energy_absorbed)},
       {"available_energy_J", number(after.available_energy)},
       {"at_peak_force",
        {{"kinetic_J", number(split.kinetic_at_peak)},
         {"support_J", number(split.support_at_peak)},
         {"pad_J", number(split.pad_at_peak)}}},
       {"at_the_end",
        {{"rebound_J", number(split.rebound)},
         {"support_J", number(split.support_at_end)},
         {"pad_J", number(split.pad)}}},
       {"solved_as",
        {{"mass_kg", number(impact.impactor.mass)}, {"speed_m_per_s", number(impact.impactor.speed)}}},
       {"program", program_json()}});
}

}  // namespace dashpad::output
