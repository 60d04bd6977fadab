#include "dashpad/study/application.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dashpad/study/design.hpp"
#include "io/parameter_values.hpp"

namespace dashpad::study {
namespace {

const std::string parameter_prefix = "pad.parameters.";

double& parameter(PadLaw& law, std::size_t index) {
  return std::visit([index]<class Law>(Law& of) -> double& { return of.*(Law::parameters.at(index).member); },
                    law);
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
  std::vector<FactorKey> keys{{"impactor.mass", "kg"},   {"impactor.weight", "N"}, {"impactor.radius", "m"},
                              {"impactor.speed", "m/s"}, {"pad.thickness", "m"},   {"pad.material", ""}};
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
      {"impactor.radius", Place::radius},      {"impactor.speed", Place::speed},
      {"pad.thickness", Place::thickness},     {"pad.material", Place::material},
      {"support.stiffness", Place::stiffness}, {"support.scale", Place::support_scale}};
  const auto keys = factor_keys(study_->base);
  if (!std::ranges::count(keys, key, &FactorKey::key))
    throw std::invalid_argument("no quantity of the case: " + key);
  for (const auto& [name, place] : places)
    if (name == key) return {place, 0};
  const auto parameters = parameter_values(study_->base.pad.material.law);
  const auto found = std::ranges::find(parameters, key.substr(parameter_prefix.size()), &ParameterValue::key);
  return {Place::parameter, static_cast<std::size_t>(found - parameters.begin())};
}

void Application::operator()(std::span<const double> values, ImpactCase& into) const {
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const double value = values[i];
    switch (steps_[i].place) {
      case Place::mass: into.impactor.mass = value; break;
      case Place::weight: into.impactor.mass = value / standard_gravity; break;
      case Place::radius: into.impactor.radius = value; break;
      case Place::speed: into.impactor.speed = value; break;
      case Place::thickness: into.pad.thickness = value; break;
      case Place::parameter: parameter(into.pad.material.law, steps_[i].parameter) = value; break;
      case Place::material: {
        const Material& chosen = study_->materials.at(static_cast<std::size_t>(value));
        if (into.pad.material.name != chosen.name) into.pad.material = chosen;
        break;
      }
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
