#include "dashpad/study/stored_study.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "dashpad/study/application.hpp"
#include "dashpad/study/design.hpp"
#include "dashpad/study/resolved_study.hpp"
#include "io/json_values.hpp"

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

template <class Law>
PadLaw law_with(const Json& parameters) {
  Law law;
  for (const Parameter<Law>& parameter : Law::parameters)
    law.*parameter.member = parameters.at(parameter.key).template get<double>();
  return law;
}

template <std::size_t... index>
PadLaw law_of(const std::string& name, const Json& parameters, std::index_sequence<index...>) {
  std::optional<PadLaw> law;
  const auto try_law = [&]<class Law>(const Law&) {
    if (name == Law::name) law = law_with<Law>(parameters);
  };
  (try_law(std::variant_alternative_t<index, PadLaw>{}), ...);
  if (!law) throw std::runtime_error("no law \"" + name + "\"");
  return *law;
}

Material material_of(const Json& json) {
  Material material;
  material.name = json.at("name");
  material.title = json.at("title");
  material.law =
      law_of(json.at("law"), json.at("parameters"), std::make_index_sequence<std::variant_size_v<PadLaw>>());
  if (json.contains("fitted")) {
    const Numbers range = json["fitted"].get<Numbers>();
    material.fitted = FittedRange{range.at(0), range.at(1), range.at(2)};
  }
  return material;
}

ImpactCase case_of(const Json& json) {
  const Numbers impactor = json.at("impactor").get<Numbers>();
  std::vector<Support::Point> points;
  for (const Json& point : json.at("support")) points.push_back({point.at(0), point.at(1)});
  return {.title = json.at("title"),
          .impactor = {impactor.at(0), impactor.at(1), impactor.at(2)},
          .pad = {json.at("thickness"), material_of(json.at("material"))},
          .support = points.empty() ? Support::rigid() : Support::through(points)};
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
                              return same(column, name, find_response_kind(name)->unit);
                            }) &&
         store.rows() == Design{study}.rows();
}

}  // namespace

Study stored_study(const Store& store) {
  constexpr const char* damaged =
      "the store does not tell its study: it is damaged, or another version made it";
  try {
    Study study = study_of(Json::parse(store.resolved_text()));
    study.text = store.study_text();
    if (resolved_text(study) == store.resolved_text() && violations(study).empty() &&
        has_columns_of(store, study))
      return study;
  } catch (const std::exception&) {
    throw std::runtime_error(damaged);
  }
  throw std::runtime_error(damaged);
}

}  // namespace dashpad::study
