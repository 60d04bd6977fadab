#include "result/summary_values.hpp"

#include <optional>
#include <vector>

namespace dashpad {

namespace {

EstimatedValue present(const std::optional<double>& value, double error) {
  return value ? EstimatedValue{.value = *value, .error = error} : EstimatedValue{};
}

EstimatedValue present(const std::optional<Moment>& moment, double error = 0) {
  return moment ? EstimatedValue{moment->time, error, moment->velocity} : EstimatedValue{};
}

template <class Figure>
EstimatedValue of_support(const Summary& summary, Figure figure) {
  return summary.support ? present(figure(*summary.support), summary.errors.support) : EstimatedValue{};
}

}  // namespace

std::span<const SummaryQuantity> summary_quantities() {
  static const std::vector<SummaryQuantity> all = [] {
    std::vector<SummaryQuantity> list;
    const auto figure = [&](const char* key, EstimatedValue (*of)(const Summary&)) {
      list.push_back({&result_quantity(key), of});
    };
    figure("peak_force",
           [](const Summary& summary) { return present(summary.peak_force, summary.errors.peak_force); });
    figure("peak_acceleration", [](const Summary& summary) {
      return present(summary.peak_acceleration, summary.errors.peak_force);
    });
    figure("time_to_peak_force", [](const Summary& summary) {
      return present(summary.time_of_peak_force, summary.errors.time_of_peak_force);
    });
    figure("peak_motion",
           [](const Summary& summary) { return present(summary.peak_motion, summary.errors.peak_motion); });
    figure("peak_penetration", [](const Summary& summary) {
      return present(summary.peak_penetration, summary.errors.peak_penetration);
    });
    figure("peak_strain", [](const Summary& summary) {
      return present(summary.peak_strain, summary.errors.peak_penetration);
    });
    figure("peak_strain_rate", [](const Summary& summary) { return present(summary.peak_strain_rate, 0); });
    figure("rebound_speed", [](const Summary& summary) {
      return present(summary.rebound_speed, summary.errors.rebound_speed);
    });
    figure("restitution",
           [](const Summary& summary) { return present(summary.restitution, summary.errors.rebound_speed); });
    figure("contact_end",
           [](const Summary& summary) { return present(summary.contact_end, summary.errors.contact_end); });
    figure("release", [](const Summary& summary) { return present(summary.release); });
    figure("force_below_weight", [](const Summary& summary) {
      return present(summary.force_below_weight, summary.errors.force_below_weight);
    });
    figure("bottomed",
           [](const Summary& summary) { return present(summary.bottomed, summary.errors.bottomed); });
    figure("rest", [](const Summary& summary) { return present(summary.rest); });
    figure("peak_transmitted_force", [](const Summary& summary) {
      return of_support(summary, [](const SupportFigures& support) { return support.peak_transmitted; });
    });
    figure("peak_support_deflection", [](const Summary& summary) {
      return of_support(summary, [](const SupportFigures& support) { return support.peak_deflection; });
    });
    figure("support_set", [](const Summary& summary) {
      return of_support(summary, [](const SupportFigures& support) { return support.set; });
    });
    figure("body_speed", [](const Summary& summary) {
      return of_support(summary, [](const SupportFigures& support) { return support.body_speed; });
    });
    figure("energy_absorbed_fraction", [](const Summary& summary) {
      return present(summary.energy_absorbed_fraction, summary.errors.energy_absorbed);
    });
    figure("energy_residual_fraction", [](const Summary& summary) {
      return present(summary.energy.residual / summary.energy.impact, 0);
    });
    return list;
  }();
  return all;
}

}  // namespace dashpad
