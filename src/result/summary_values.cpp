#include "result/summary_values.hpp"

#include <optional>
#include <vector>

namespace dashpad {

namespace {

double error_of(const Summary& summary, double ErrorEstimates::*estimate) {
  return estimate == nullptr ? 0 : summary.errors.*estimate;
}

/// A figure of the impact, with its estimate.
template <auto figure, double ErrorEstimates::*estimate = nullptr>
EstimatedValue figure_of(const Summary& summary) {
  const std::optional<double> value = summary.*figure;
  return value ? EstimatedValue{.value = *value, .error = error_of(summary, estimate)} : EstimatedValue{};
}

template <auto moment, double ErrorEstimates::*estimate = nullptr>
EstimatedValue moment_of(const Summary& summary) {
  const std::optional<Moment>& at = summary.*moment;
  return at ? EstimatedValue{at->time, error_of(summary, estimate), at->velocity} : EstimatedValue{};
}

/// A figure of the support; no value where the impact has none.
template <auto figure>
EstimatedValue support_figure_of(const Summary& summary) {
  if (!summary.support) return {};
  const std::optional<double> value = *summary.support.*figure;
  return value ? EstimatedValue{.value = *value, .error = summary.errors.support} : EstimatedValue{};
}

/// v^2 / (2 g): the error of a square is twice that of its root.
EstimatedValue rebound_height_of(const Summary& summary) {
  const std::optional<double> speed = summary.rebound_speed;
  return speed ? EstimatedValue{.value = *speed * *speed / (2 * standard_gravity),
                                .error = 2 * summary.errors.rebound_speed}
               : EstimatedValue{};
}

EstimatedValue energy_residual_of(const Summary& summary) {
  return {.value = summary.energy.residual / summary.energy.impact};
}

}  // namespace

std::span<const SummaryQuantity> summary_quantities() {
  using Error = ErrorEstimates;
  static const std::vector<SummaryQuantity> all{
      {&result_quantity("peak_force"), figure_of<&Summary::peak_force, &Error::peak_force>},
      {&result_quantity("peak_acceleration"), figure_of<&Summary::peak_acceleration, &Error::peak_force>},
      {&result_quantity("time_to_peak_force"),
       figure_of<&Summary::time_of_peak_force, &Error::time_of_peak_force>},
      {&result_quantity("peak_motion"), figure_of<&Summary::peak_motion, &Error::peak_motion>},
      {&result_quantity("peak_penetration"), figure_of<&Summary::peak_penetration, &Error::peak_penetration>},
      {&result_quantity("peak_strain"), figure_of<&Summary::peak_strain, &Error::peak_penetration>},
      {&result_quantity("peak_strain_rate"), figure_of<&Summary::peak_strain_rate>},
      {&result_quantity("rebound_speed"), figure_of<&Summary::rebound_speed, &Error::rebound_speed>},
      {&result_quantity("restitution"), figure_of<&Summary::restitution, &Error::rebound_speed>},
      {&result_quantity("rebound_height"), rebound_height_of},
      {&result_quantity("contact_end"), moment_of<&Summary::contact_end, &Error::contact_end>},
      {&result_quantity("release"), moment_of<&Summary::release>},
      {&result_quantity("force_below_weight"),
       moment_of<&Summary::force_below_weight, &Error::force_below_weight>},
      {&result_quantity("bottomed"), moment_of<&Summary::bottomed, &Error::bottomed>},
      {&result_quantity("rest"), moment_of<&Summary::rest>},
      {&result_quantity("peak_transmitted_force"), support_figure_of<&SupportFigures::peak_transmitted>},
      {&result_quantity("peak_support_deflection"), support_figure_of<&SupportFigures::peak_deflection>},
      {&result_quantity("support_set"), support_figure_of<&SupportFigures::set>},
      {&result_quantity("body_speed"), support_figure_of<&SupportFigures::body_speed>},
      {&result_quantity("energy_absorbed_fraction"),
       figure_of<&Summary::energy_absorbed_fraction, &Error::energy_absorbed>},
      {&result_quantity("energy_residual_fraction"), energy_residual_of}};
  return all;
}

}  // namespace dashpad
