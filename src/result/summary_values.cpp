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
EstimatedValue of_support(const Summary& of, Figure figure) {
  return of.support ? present(figure(*of.support), of.errors.support) : EstimatedValue{};
}

}  // namespace

std::span<const SummaryQuantity> summary_quantities() {
  static const std::vector<SummaryQuantity> all = [] {
    std::vector<SummaryQuantity> list;
    const auto figure = [&](const char* key, EstimatedValue (*of)(const Summary&)) {
      list.push_back({&result_quantity(key), of});
    };
    figure("peak_force", [](const Summary& of) { return present(of.peak_force, of.errors.peak_force); });
    figure("peak_acceleration",
           [](const Summary& of) { return present(of.peak_acceleration, of.errors.peak_force); });
    figure("time_to_peak_force",
           [](const Summary& of) { return present(of.time_of_peak_force, of.errors.time_of_peak_force); });
    figure("peak_motion", [](const Summary& of) { return present(of.peak_motion, of.errors.peak_motion); });
    figure("peak_penetration",
           [](const Summary& of) { return present(of.peak_penetration, of.errors.peak_penetration); });
    figure("peak_strain",
           [](const Summary& of) { return present(of.peak_strain, of.errors.peak_penetration); });
    figure("peak_strain_rate", [](const Summary& of) { return present(of.peak_strain_rate, 0); });
    figure("rebound_speed",
           [](const Summary& of) { return present(of.rebound_speed, of.errors.rebound_speed); });
    figure("restitution", [](const Summary& of) { return present(of.restitution, of.errors.rebound_speed); });
    figure("contact_end", [](const Summary& of) { return present(of.contact_end, of.errors.contact_end); });
    figure("release", [](const Summary& of) { return present(of.release); });
    figure("force_below_weight",
           [](const Summary& of) { return present(of.force_below_weight, of.errors.force_below_weight); });
    figure("bottomed", [](const Summary& of) { return present(of.bottomed, of.errors.bottomed); });
    figure("rest", [](const Summary& of) { return present(of.rest); });
    figure("peak_transmitted_force", [](const Summary& of) {
      return of_support(of, [](const SupportFigures& support) { return support.peak_transmitted; });
    });
    figure("peak_support_deflection", [](const Summary& of) {
      return of_support(of, [](const SupportFigures& support) { return support.peak_deflection; });
    });
    figure("support_set", [](const Summary& of) {
      return of_support(of, [](const SupportFigures& support) { return support.set; });
    });
    figure("body_speed", [](const Summary& of) {
      return of_support(of, [](const SupportFigures& support) { return support.body_speed; });
    });
    figure("energy_absorbed_fraction",
           [](const Summary& of) { return present(of.energy_absorbed_fraction, of.errors.energy_absorbed); });
    figure("energy_residual_fraction",
           [](const Summary& of) { return present(of.energy.residual / of.energy.impact, 0); });
    return list;
  }();
  return all;
}

}  // namespace dashpad
