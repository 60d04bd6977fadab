#include "dashpad/study/application.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "dashpad/study/design.hpp"
#include "model/parameter_values.hpp"

namespace dashpad::study {
namespace {

const std::string parameter_prefix = "pad.parameters.";

const std::string nose_prefix = "impactor.";

/// Of a law or of a nose.
template <class Variant>
double& parameter(Variant& variant, std::size_t index) {
  return std::visit([index]<class Of>(Of& of) -> double& { return of.*(Of::parameters.at(index).member); },
                    variant);
}

std::optional<std::size_t> place_of(const std::string& key, const std::string& prefix,
                                    const std::vector<ParameterValue>& parameters) {
  if (!key.starts_with(prefix)) return std::nullopt;
  const auto found = std::ranges::find(parameters, key.substr(prefix.size()), &ParameterValue::key);
  if (found == parameters.end()) return std::nullopt;
  return static_cast<std::size_t>(found - parameters.begin());
}

/// The forces of a support times a factor. NaN, zero and less make no support: its stiffness then breaks the
/// rules of the case.
Support scaled(const Support& support, double factor) {
  std::vector<Support::Point> points = support.points();
  for (Support::Point& point : points) point.force *= factor;
  return Support::through(std::move(points));
}

}  // namespace

std::vector<FactorKey> factor_keys(const ImpactCase& base) {
  std::vector<FactorKey> keys{{"impactor.mass", "kg"}, {"impactor.weight", "N"}};
  for (const ParameterValue& of : parameter_values(base.impactor.nose))
    keys.push_back({nose_prefix + of.key, of.unit});
  keys.insert(keys.end(),
              {{"impactor.speed", "m/s"}, {"pad.thickness", "m"}, {"pad.material", ""}, {"pad.scale", "1"}});
  const Material& material = base.pad.material;
  if (material.density_exponent) keys.push_back({"pad.density", "kg/m3"});
  if (!material.temperature_table.temperature.empty()) keys.push_back({"pad.temperature", "K"});
  for (const ParameterValue& of : parameter_values(base.pad.material.law))
    keys.push_back({parameter_prefix + of.key, of.unit});
  if (base.support.points().size() == 1) keys.push_back({"support.stiffness", "N/m"});
  if (!base.support.is_rigid()) keys.push_back({"support.scale", "1"});
  return keys;
}

Application::Application(const Study& study) : study_(&study) {
  for (const Factor& factor : study.factors) steps_.push_back(step_for(factor.key));
}

Application::Step Application::step_for(const std::string& key) const {
  static const std::vector<std::pair<std::string, Place>> places{
      {"impactor.mass", Place::mass},          {"impactor.weight", Place::weight},
      {"impactor.speed", Place::speed},        {"pad.thickness", Place::thickness},
      {"pad.material", Place::material},       {"pad.scale", Place::scale},
      {"pad.density", Place::density},         {"pad.temperature", Place::temperature},
      {"support.stiffness", Place::stiffness}, {"support.scale", Place::support_scale}};
  const auto keys = factor_keys(study_->base);
  if (!std::ranges::count(keys, key, &FactorKey::key))
    throw std::invalid_argument("no quantity of the case: " + key);
  for (const auto& [name, place] : places)
    if (name == key) return {place, 0};
  if (const auto place = place_of(key, nose_prefix, parameter_values(study_->base.impactor.nose)))
    return {Place::nose, *place};
  return {Place::parameter,
          *place_of(key, parameter_prefix, parameter_values(study_->base.pad.material.law))};
}

void Application::operator()(std::span<const double> values, ImpactCase& into) const {
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const double value = values[i];
    switch (steps_[i].place) {
      case Place::mass: into.impactor.mass = value; break;
      case Place::weight: into.impactor.mass = value / standard_gravity; break;
      case Place::nose: parameter(into.impactor.nose, steps_[i].parameter) = value; break;
      case Place::speed: into.impactor.speed = value; break;
      case Place::thickness: into.pad.thickness = value; break;
      case Place::parameter: parameter(into.pad.material.law, steps_[i].parameter) = value; break;
      case Place::material: {
        const Material& chosen = study_->materials.at(static_cast<std::size_t>(value));
        if (into.pad.material.name != chosen.name) into.pad.material = chosen;
        break;
      }
      case Place::scale: into.pad.condition.scale = value; break;
      case Place::density: into.pad.condition.density = value; break;
      case Place::temperature: into.pad.condition.temperature = value; break;
      case Place::stiffness: into.support = Support::linear(value); break;
      case Place::support_scale: into.support = scaled(study_->base.support, value); break;
    }
  }
}

void apply(const Study& study, std::span<const double> values, ImpactCase& into) {
  const Application application(study);
  application(values, into);
}

}  // namespace dashpad::study
