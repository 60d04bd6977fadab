#include "dashpad/study/study_file.hpp"

#include <algorithm>
#include <stdexcept>

#include "json/curves_json.hpp"
#include "model/parameter_values.hpp"

namespace dashpad::study {
namespace {

using Numbers = std::vector<double>;

/// Nothing else than what is written for an unsigned integer: no fraction, no sign, no more than 64 bits.
std::uint64_t count_of(const Json& json) {
  if (!json.is_number_unsigned()) throw std::runtime_error("no count");
  return json.get<std::uint64_t>();
}

Sampling sampling_of(const Json& json) {
  for (const Sampling method : {Sampling::monte_carlo, Sampling::latin_hypercube, Sampling::sobol})
    if (count_of(json) == static_cast<std::uint64_t>(method)) return method;
  throw std::runtime_error("no such sampling");
}

Spread spread_of(const Json& json) {
  if (json.contains("levels")) return Levels{json["levels"].get<Numbers>()};
  if (json.contains("empirical")) return Empirical{json["empirical"].get<Numbers>()};
  const auto values = [&](const char* name) { return json.at(name).get<Numbers>(); };
  if (json.contains("normal")) return Normal{values("normal").at(0), values("normal").at(1)};
  if (json.contains("lognormal")) return Lognormal{values("lognormal").at(0), values("lognormal").at(1)};
  if (json.contains("uniform")) return Uniform{values("uniform").at(0), values("uniform").at(1)};
  const Numbers corners = values("triangular");
  return Triangular{corners.at(0), corners.at(1), corners.at(2)};
}

std::optional<double> bound_of(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional{json.get<double>()};
}

Factor factor_of(const Json& json) {
  return {.key = json.at("key"),
          .unit = json.at("unit"),
          .spread = spread_of(json),
          .lowest = bound_of(json.at("lowest")),
          .highest = bound_of(json.at("highest"))};
}

/// A law or a nose.
template <class Variant>
Variant alternative_of(const std::string& name, const Json& numbers) {
  auto result = alternative_named<Variant>(name);
  if (!result) throw std::runtime_error("nothing is called \"" + name + "\"");
  std::visit(
      [&]<class Of>(Of& of) {
        for (const Parameter<Of>& parameter : Of::parameters)
          parameter.set(of, numbers.at(parameter.key).template get<double>());
      },
      *result);
  return *result;
}

Material material_of(const Json& json) {
  Material material;
  material.name = json.at("name");
  material.title = json.at("title");
  material.law = alternative_of<PadLaw>(json.at("law"), json.at("parameters"));
  if (json.contains("density")) material.density = json["density"].get<double>();
  if (json.contains("density_exponent")) material.density_exponent = json["density_exponent"].get<double>();
  if (json.contains("temperature"))
    material.temperature_table = {json["temperature"].at(0).get<Numbers>(),
                                  json["temperature"].at(1).get<Numbers>()};
  if (json.contains("curves")) set_curves(material.law, json["curves"]);
  if (json.contains("nose_over_pad")) material.nose_over_pad = json["nose_over_pad"].get<double>();
  if (json.contains("fitted")) {
    const Numbers range = json["fitted"].get<Numbers>();
    material.fitted = FittedRange{range.at(0), range.at(1), range.at(2)};
  }
  return material;
}

/// Studies of earlier versions have none.
PadCondition condition_of(const Json& json) {
  if (!json.contains("condition")) return {};
  const Json& of = json["condition"];
  return {of.at(0), bound_of(of.at(1)), bound_of(of.at(2))};
}

Nose nose_of(const Json& json) {
  Nose nose = alternative_of<Nose>(json.at("shape"), json);
  if (auto* profile = std::get_if<Profile>(&nose)) {
    profile->of = json.contains("radii") ? Profile::Of::radius : Profile::Of::area;
    for (const Json& point : json.at(profile->of == Profile::Of::radius ? "radii" : "areas"))
      profile->points.push_back({point.at(0), point.at(1)});
  }
  return nose;
}

std::optional<Blows> blows_of(const Json& json) {
  if (!json.contains("blows")) return std::nullopt;
  return Blows{static_cast<int>(std::min<std::uint64_t>(count_of(json["blows"].at(0)), 101)),
               json["blows"].at(1)};
}

Backing backing_of(const Json& json) {
  Backing backing;
  if (!json.contains("backing")) return backing;
  for (const Parameter<Backing>& parameter : Backing::parameters)
    parameter.set(backing, json["backing"].at(parameter.key).get<double>());
  return backing;
}

std::vector<PadLayer> layers_of(const Json& json) {
  std::vector<PadLayer> layers;
  if (!json.contains("layers")) return layers;
  for (const Json& layer : json["layers"])
    layers.push_back({layer.at("thickness"), material_of(layer.at("material")), condition_of(layer)});
  return layers;
}

ImpactCase case_of(const Json& json) {
  const Json& impactor = json.at("impactor");
  const Json& nose = impactor.at("nose");
  std::vector<Support::Point> points;
  for (const Json& point : json.at("support")) points.push_back({point.at(0), point.at(1)});
  return {.title = json.at("title"),
          .impactor = {.mass = impactor.at("mass"),
                       .nose = nose_of(nose),
                       .speed = impactor.at("speed"),
                       .gravity = impactor.value("gravity", 0.0)},
          .pad = {json.at("thickness"), material_of(json.at("material")), condition_of(json),
                  json.contains("area") ? bound_of(json["area"]) : std::nullopt,
                  json.value("earlier_penetration", 0.0), json.value("sheet", 0.0),
                  floor_named(json.value("floor", "")).value_or(Floor::bonded), json.value("neighbours", 0.0),
                  layers_of(json)},
          .support = points.empty() ? Support::rigid() : Support::through(points),
          .backing = backing_of(json),
          .blows = blows_of(json)};
}

Study study_of(const Json& json) {
  Study study;
  study.title = json.at("title");
  study.base = case_of(json.at("case"));
  const Json& options = json.at("options");
  study.options = {
      .tolerance = options.at(0), .time_limit = options.at(1), .most_steps = count_of(options.at(2))};
  for (const Json& factor : json.at("factors")) study.factors.push_back(factor_of(factor));
  for (const Json& material : json.at("materials")) study.materials.push_back(material_of(material));
  const Json& sampling = json.at("sampling");
  for (const Json& pair : sampling.at("correlations"))
    study.correlations.push_back({count_of(pair.at(0)), count_of(pair.at(1)), pair.at(2)});
  study.sampling = sampling_of(sampling.at("method"));
  study.samples = count_of(sampling.at("samples"));
  study.seed = count_of(sampling.at("seed"));
  study.indices = sampling.at("indices");
  study.responses = json.at("responses").get<std::vector<std::string>>();
  return study;
}

/// Whether the columns of the store are those of its study: readers go by both.
bool has_columns_of(const Store& store, const Study& study) {
  const auto same = [](const StoredColumn& column, const std::string& name, const std::string& unit) {
    return column.name == name && column.unit == unit;
  };
  const std::vector<FactorKey> keys = factor_keys(study.base);
  const bool factors_fit = std::ranges::equal(
      store.factors(), study.factors, [&](const StoredColumn& column, const Factor& factor) {
        const auto key = std::ranges::find(keys, factor.key, &FactorKey::key);
        return key != keys.end() && factor.unit == key->unit && same(column, factor.key, factor.unit);
      });
  return factors_fit &&
         std::ranges::equal(store.responses(), study.responses,
                            [&](const StoredColumn& column, const std::string& name) {
                              return same(column, name, find_response_kind(name)->si_unit);
                            }) &&
         store.rows() == Design{study}.rows();
}

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

Study stored_study(const Store& store) {
  const std::string damaged =
      store.file() + ": it is damaged, or another version made it: it does not tell its study any more";
  try {
    Study study = study_of(Json::parse(store.resolved_text()));
    study.text = store.study_text();
    if (resolved_text(study) == store.resolved_text() && violations(study).empty() &&
        has_columns_of(store, study))
      return study;
  } catch (const std::exception&) {
    throw DamagedStore(damaged);
  }
  throw DamagedStore(damaged);
}

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
