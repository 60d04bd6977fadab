#include "dashpad/study/study_file.hpp"

#include "json/curves_json.hpp"
#include "model/parameter_values.hpp"

namespace dashpad::study {

namespace {

Json spread_json(const Levels& of) { return {{"levels", of.values}}; }
Json spread_json(const Normal& of) { return {{"normal", {of.mean, of.deviation}}}; }
Json spread_json(const Lognormal& of) { return {{"lognormal", {of.median, of.spread}}}; }
Json spread_json(const Uniform& of) { return {{"uniform", {of.low, of.high}}}; }
Json spread_json(const Triangular& of) { return {{"triangular", {of.low, of.mode, of.high}}}; }
Json spread_json(const Empirical& of) { return {{"empirical", of.values}}; }

Json factor_json(const Factor& of) {
  Json json = std::visit([](const auto& spread) { return spread_json(spread); }, of.spread);
  json["key"] = of.key;
  json["unit"] = of.unit;
  json["lowest"] = number(of.lowest);
  json["highest"] = number(of.highest);
  return json;
}

Json material_json(const Material& of) {
  Json json = {{"name", of.name}, {"title", of.title}, {"law", name_of(of.law)}};
  for (const ParameterValue& parameter : parameter_values(of.law))
    json["parameters"][parameter.key] = number(parameter.value);
  if (Json curves = curves_json(of.law); !curves.is_null()) json["curves"] = std::move(curves);
  if (of.density) json["density"] = *of.density;
  if (of.density_exponent) json["density_exponent"] = *of.density_exponent;
  if (const auto& [temperature, factor] = of.temperature_table; !temperature.empty())
    json["temperature"] = {numbers(temperature), numbers(factor)};
  if (of.nose_over_pad) json["nose_over_pad"] = *of.nose_over_pad;
  if (of.fitted)
    json["fitted"] = {of.fitted->highest_strain, of.fitted->lowest_rate, of.fitted->highest_rate};
  return json;
}

Json condition_json(const PadCondition& of) { return {of.scale, number(of.density), number(of.temperature)}; }

Json nose_json(const Nose& of) {
  Json json = {{"shape", name_of(of)}};
  for (const ParameterValue& value : parameter_values(of)) json[value.key] = number(value.value);
  if (const auto* profile = std::get_if<Profile>(&of)) {
    Json points = Json::array();
    for (const Profile::Point& point : profile->points) points.push_back({point.depth, point.size});
    json[profile->of == Profile::Of::radius ? "radii" : "areas"] = std::move(points);
  }
  return json;
}

Json case_json(const ImpactCase& of) {
  Json points = Json::array();
  for (const Support::Point& point : of.support.points()) points.push_back({point.deflection, point.force});
  Json json = {
      {"title", of.title},
      {"impactor",
       {{"mass", of.impactor.mass}, {"nose", nose_json(of.impactor.nose)}, {"speed", of.impactor.speed}}},
      {"thickness", of.pad.thickness},
      {"condition", condition_json(of.pad.condition)},
      {"material", material_json(of.pad.material)},
      {"support", points}};
  if (of.pad.area) json["area"] = *of.pad.area;
  if (of.pad.earlier_penetration > 0) json["earlier_penetration"] = of.pad.earlier_penetration;
  if (of.pad.sheet > 0) json["sheet"] = of.pad.sheet;
  if (of.pad.neighbours > 0) {
    json["floor"] = name_of(of.pad.floor);
    json["neighbours"] = of.pad.neighbours;
  }
  if (of.blows) json["blows"] = {of.blows->count, of.blows->recovery};
  if (of.impactor.gravity != 0) json["impactor"]["gravity"] = of.impactor.gravity;
  if (of.backing != Backing{})
    for (const Parameter<Backing>& parameter : Backing::parameters)
      json["backing"][parameter.key] = number(parameter.of(of.backing));
  for (const PadLayer& layer : of.pad.layers)
    json["layers"].push_back({{"thickness", layer.thickness},
                              {"condition", condition_json(layer.condition)},
                              {"material", material_json(layer.material)}});
  return json;
}

Json sampling_json(const Study& of) {
  Json correlations = Json::array();
  for (const Correlation& pair : of.correlations)
    correlations.push_back({pair.first, pair.second, pair.value});
  return {{"method", static_cast<int>(of.sampling)},
          {"samples", of.samples},
          {"seed", of.seed},
          {"indices", of.indices},
          {"correlations", correlations}};
}

}  // namespace

std::string resolved_text(const Study& study) {
  Json factors = Json::array(), materials = Json::array();
  for (const Factor& factor : study.factors) factors.push_back(factor_json(factor));
  for (const Material& material : study.materials) materials.push_back(material_json(material));
  return json_text(
      {{"title", study.title},
       {"case", case_json(study.base)},
       {"options", {study.options.tolerance, study.options.time_limit, study.options.most_steps}},
       {"factors", factors},
       {"materials", materials},
       {"sampling", sampling_json(study)},
       {"responses", study.responses}});
}

}  // namespace dashpad::study
