#include "study/stored_uncertainty.hpp"

#include <algorithm>

namespace dashpad::study {
namespace {

using Numbers = std::vector<double>;

struct NamedRange {
  const char* key;
  std::optional<ValueRange> Uncertainty::*range;
};
constexpr NamedRange ranges[] = {{"recoil", &Uncertainty::recoil},
                                 {"unloading_factor", &Uncertainty::unloading_factor},
                                 {"lag_strain", &Uncertainty::lag_strain},
                                 {"rate_exponent", &Uncertainty::rate_exponent}};

}  // namespace

Json uncertainty_json(const Uncertainty& uncertainty) {
  Json json = Json::object();
  for (const auto& [key, range] : ranges)
    if (const auto& given = uncertainty.*range) json[key] = {given->low, given->high};
  if (uncertainty.scatter) json["scatter"] = *uncertainty.scatter;
  if (const auto& misfit = uncertainty.misfit) {
    json["misfit"] = {misfit->peak_acceleration, misfit->hic, misfit->rebound_speed, misfit->penetration};
    json["impacts"] = misfit->impacts;
    json["is_held_out"] = misfit->is_held_out;
    if (misfit->nose_over_pad) json["misfit_nose_over_pad"] = *misfit->nose_over_pad;
  }
  if (const PosteriorAxes& axes = uncertainty.posterior; !axes.keys.empty())
    json["posterior"] = {{"keys", axes.keys}, {"minus", axes.minus}, {"plus", axes.plus}};
  return json;
}

Uncertainty uncertainty_of(const Json& json) {
  Uncertainty uncertainty;
  for (const auto& [key, range] : ranges)
    if (json.contains(key)) uncertainty.*range = ValueRange{json[key].at(0), json[key].at(1)};
  if (json.contains("scatter")) uncertainty.scatter = json["scatter"].get<double>();
  if (json.contains("misfit")) {
    const Json& shares = json["misfit"];
    uncertainty.misfit = Misfit{.peak_acceleration = shares.at(0),
                                .hic = shares.at(1),
                                .rebound_speed = shares.at(2),
                                .penetration = shares.at(3),
                                .impacts = json.at("impacts"),
                                .is_held_out = json.at("is_held_out")};
    if (json.contains("misfit_nose_over_pad"))
      uncertainty.misfit->nose_over_pad = json["misfit_nose_over_pad"].get<double>();
  }
  if (json.contains("posterior")) {
    const Json& axes = json["posterior"];
    uncertainty.posterior = {axes.at("keys").get<std::vector<std::string>>(),
                             axes.at("minus").get<std::vector<Numbers>>(),
                             axes.at("plus").get<std::vector<Numbers>>()};
  }
  return uncertainty;
}

}  // namespace dashpad::study
