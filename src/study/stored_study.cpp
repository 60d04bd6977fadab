#include "dashpad/study/study_file.hpp"

#include <algorithm>
#include <stdexcept>

#include "json/curves_json.hpp"
#include "model/parameter_values.hpp"
#include "study/stored_uncertainty.hpp"
#include "uncertainty/foam_factors.hpp"

namespace dashpad::study {
namespace {

using Numbers = std::vector<double>;

/// Reads an unsigned integer of at most 64 bits, without fraction or sign.
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
  if (json.contains("rows")) return ByRow{json["rows"].get<Numbers>()};
  if (json.contains("draws")) return ByDraw{json["draws"].get<Numbers>()};
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
      [&]<class Of>(Of& owner) {
        for (const Parameter<Of>& parameter : Of::parameters)
          parameter.set(owner, numbers.at(parameter.key).template get<double>());
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
  if (json.contains("uncertainty")) material.uncertainty = uncertainty_of(json["uncertainty"]);
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

std::vector<RowLabel> labels_of(const Json& json) {
  std::vector<RowLabel> labels;
  if (json.contains("labels"))
    for (const Json& label : json["labels"])
      labels.push_back({label.at(0), label.at(1).get<std::vector<std::string>>()});
  return labels;
}

Study study_of(const Json& json) {
  Study study;
  study.title = json.at("title");
  study.base = case_of(json.at("case"));
  const Json& options = json.at("options");
  study.options = {
      .tolerance = options.at(0), .time_limit = options.at(1), .max_steps = count_of(options.at(2))};
  for (const Json& factor : json.at("factors")) study.factors.push_back(factor_of(factor));
  for (const Json& material : json.at("materials")) study.materials.push_back(material_of(material));
  study.labels = labels_of(json);
  const Json& sampling = json.at("sampling");
  for (const Json& pair : sampling.at("correlations"))
    study.correlations.push_back({count_of(pair.at(0)), count_of(pair.at(1)), pair.at(2)});
  study.sampling = sampling_of(sampling.at("method"));
  study.samples = count_of(sampling.at("samples"));
  study.seed = count_of(sampling.at("seed"));
  study.indices = sampling.at("indices");
  study.responses = json.at("responses").get<std::vector<std::string>>();
  if (json.contains("standards")) study.standards = json["standards"].get<std::vector<std::string>>();
  return study;
}

/// Whether the columns of the store are those of its study: readers go by both.
bool has_columns_of(const Store& store, const Study& study) {
  const auto same = [](const StoredColumn& column, const std::string& name, const std::string& unit) {
    return column.name == name && column.unit == unit;
  };
  const std::vector<FactorKey> keys = factor_keys(study);
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

Json spread_json(const Levels& levels) { return {{"levels", levels.values}}; }
Json spread_json(const Normal& normal) { return {{"normal", {normal.mean, normal.deviation}}}; }
Json spread_json(const Lognormal& lognormal) { return {{"lognormal", {lognormal.median, lognormal.spread}}}; }
Json spread_json(const Uniform& uniform) { return {{"uniform", {uniform.low, uniform.high}}}; }
Json spread_json(const Triangular& triangular) {
  return {{"triangular", {triangular.low, triangular.mode, triangular.high}}};
}
Json spread_json(const Empirical& empirical) { return {{"empirical", empirical.values}}; }

Json spread_json(const ByRow& by_row) { return {{"rows", by_row.values}}; }
Json spread_json(const ByDraw& by_draw) { return {{"draws", by_draw.values}}; }

Json factor_json(const Factor& factor) {
  Json json = std::visit([](const auto& spread) { return spread_json(spread); }, factor.spread);
  json["key"] = factor.key;
  json["unit"] = factor.unit;
  json["lowest"] = number(factor.lowest);
  json["highest"] = number(factor.highest);
  return json;
}

Json material_json(const Material& material) {
  Json json = {{"name", material.name}, {"title", material.title}, {"law", name_of(material.law)}};
  for (const ParameterValue& parameter : parameter_values(material.law))
    json["parameters"][parameter.key] = number(parameter.value);
  if (Json curves = curves_json(material.law); !curves.is_null()) json["curves"] = std::move(curves);
  if (material.density) json["density"] = *material.density;
  if (material.density_exponent) json["density_exponent"] = *material.density_exponent;
  if (const auto& [temperature, factor] = material.temperature_table; !temperature.empty())
    json["temperature"] = {numbers(temperature), numbers(factor)};
  if (material.nose_over_pad) json["nose_over_pad"] = *material.nose_over_pad;
  if (material.fitted)
    json["fitted"] = {material.fitted->highest_strain, material.fitted->lowest_rate,
                      material.fitted->highest_rate};
  return json;
}

Json condition_json(const PadCondition& condition) {
  return {condition.scale, number(condition.density), number(condition.temperature)};
}

Json nose_json(const Nose& nose) {
  Json json = {{"shape", name_of(nose)}};
  for (const ParameterValue& value : parameter_values(nose)) json[value.key] = number(value.value);
  if (const auto* profile = std::get_if<Profile>(&nose)) {
    Json points = Json::array();
    for (const Profile::Point& point : profile->points) points.push_back({point.depth, point.size});
    json[profile->of == Profile::Of::radius ? "radii" : "areas"] = std::move(points);
  }
  return json;
}

Json case_json(const ImpactCase& impact) {
  Json points = Json::array();
  for (const Support::Point& point : impact.support.points())
    points.push_back({point.deflection, point.force});
  Json json = {{"title", impact.title},
               {"impactor",
                {{"mass", impact.impactor.mass},
                 {"nose", nose_json(impact.impactor.nose)},
                 {"speed", impact.impactor.speed}}},
               {"thickness", impact.pad.thickness},
               {"condition", condition_json(impact.pad.condition)},
               {"material", material_json(impact.pad.material)},
               {"support", points}};
  if (impact.pad.area) json["area"] = *impact.pad.area;
  if (impact.pad.earlier_penetration > 0) json["earlier_penetration"] = impact.pad.earlier_penetration;
  if (impact.pad.sheet > 0) json["sheet"] = impact.pad.sheet;
  if (impact.pad.neighbours > 0) {
    json["floor"] = name_of(impact.pad.floor);
    json["neighbours"] = impact.pad.neighbours;
  }
  if (impact.blows) json["blows"] = {impact.blows->count, impact.blows->recovery};
  if (impact.impactor.gravity != 0) json["impactor"]["gravity"] = impact.impactor.gravity;
  if (impact.backing != Backing{})
    for (const Parameter<Backing>& parameter : Backing::parameters)
      json["backing"][parameter.key] = number(parameter.of(impact.backing));
  for (const PadLayer& layer : impact.pad.layers)
    json["layers"].push_back({{"thickness", layer.thickness},
                              {"condition", condition_json(layer.condition)},
                              {"material", material_json(layer.material)}});
  return json;
}

/// What the cards state as uncertain, on which drawn foams depend.
void add_uncertainties(const Study& study, Json& json) {
  const auto add = [](const Material& material, Json& stored) {
    stored["uncertainty"] = uncertainty_json(material.uncertainty);
  };
  add(study.base.pad.material, json["case"]["material"]);
  for (std::size_t i = 0; i < study.base.pad.layers.size(); ++i)
    add(study.base.pad.layers[i].material, json["case"]["layers"][i]["material"]);
  for (std::size_t i = 0; i < study.materials.size(); ++i) add(study.materials[i], json["materials"][i]);
}

Json sampling_json(const Study& study) {
  Json correlations = Json::array();
  for (const Correlation& pair : study.correlations)
    correlations.push_back({pair.first, pair.second, pair.value});
  return {{"method", static_cast<int>(study.sampling)},
          {"samples", study.samples},
          {"seed", study.seed},
          {"indices", study.indices},
          {"correlations", correlations}};
}

}  // namespace

Study stored_study(const Store& store) {
  const std::string damaged =
      store.file() + ": the store is damaged or was made by another version; the study can no longer be read";
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

std::vector<RowLabel> row_labels(const Store& store) {
  const DamagedStore damaged(store.file() + ": the labels of its rows are damaged");
  try {
    std::vector<RowLabel> labels = labels_of(Json::parse(store.resolved_text()));
    for (const RowLabel& label : labels)
      if (label.texts.empty() || label.texts.size() != labels.front().texts.size() ||
          store.rows() % label.texts.size() != 0)
        throw damaged;
    return labels;
  } catch (const Json::exception&) {
    throw damaged;
  }
}

std::vector<std::string> stored_standards(const Store& store) {
  try {
    return Json::parse(store.resolved_text()).value("standards", std::vector<std::string>{});
  } catch (const Json::exception&) {
    throw DamagedStore(store.file() + ": the names of its standards are damaged");
  }
}

std::string resolved_text(const Study& study) {
  Json factors = Json::array(), materials = Json::array();
  for (const Factor& factor : study.factors) factors.push_back(factor_json(factor));
  for (const Material& material : study.materials) materials.push_back(material_json(material));
  Json json = {{"title", study.title},
               {"case", case_json(study.base)},
               {"options", {study.options.tolerance, study.options.time_limit, study.options.max_steps}},
               {"factors", factors},
               {"materials", materials},
               {"sampling", sampling_json(study)},
               {"responses", study.responses}};
  if (!study.standards.empty()) json["standards"] = study.standards;
  for (const RowLabel& label : study.labels) json["labels"].push_back({label.name, label.texts});
  if (std::ranges::any_of(study.factors, uncertainty::is_foam_factor, &Factor::key))
    add_uncertainties(study, json);
  return json_text(json);
}

}  // namespace dashpad::study
