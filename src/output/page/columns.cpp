#include "output/page/columns.hpp"

#include <algorithm>
#include <cmath>

#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_entries = 400;

/// Evenly spread entries, with the largest force and penetration among them.
std::vector<std::size_t> shown_entries(const History& history) {
  const std::size_t size = history.size();
  const std::size_t stride = (size + most_entries - 1) / most_entries;
  std::vector<std::size_t> entries;
  for (std::size_t i = 0; i < size; i += stride) entries.push_back(i);
  if (size == 0) return entries;
  entries.push_back(size - 1);
  for (const auto* column : {&history.force, &history.penetration, &history.motion})
    entries.push_back(
        static_cast<std::size_t>(std::max_element(column->begin(), column->end()) - column->begin()));
  std::ranges::sort(entries);
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  return entries;
}

template <class Value>
Json column(const std::vector<std::size_t>& entries, Value&& value) {
  Json numbers = Json::array();
  for (const std::size_t i : entries) numbers.push_back(rounded(value(i)));
  return numbers;
}

Json column(const std::vector<double>& values) {
  Json numbers = Json::array();
  for (const double value : values) numbers.push_back(rounded(value));
  return numbers;
}

/// Integral of a force over the way that it goes, up to each entry, by trapezoids.
template <class Way>
std::vector<double> work_of(const std::vector<double>& force, Way&& way) {
  std::vector<double> work(force.size(), 0.0);
  for (std::size_t i = 1; i < force.size(); ++i)
    work[i] = work[i - 1] + (force[i - 1] + force[i]) / 2 * (way(i) - way(i - 1));
  return work;
}

}  // namespace

Json rounded(double value) {
  if (!std::isfinite(value)) return nullptr;
  if (value == 0) return 0;
  return rounded_to(value, 7);
}

Json page_history(const ImpactCase& impact, const History& history) {
  const std::vector<std::size_t> entries = shown_entries(history);
  const auto shown = [&](const std::vector<double>& values) {
    return column(entries, [&](std::size_t i) { return values[i]; });
  };
  const auto kinetic = [&](std::size_t i) {
    return impact.impactor.mass * history.velocity[i] * history.velocity[i] / 2;
  };
  const std::vector<double> back = work_of(history.force_of_pad(), [&](std::size_t i) {
    return history.support_deflection[i] + (history.body_motion.empty() ? 0 : history.body_motion[i]);
  });
  // With the sheet on it, which takes its share from the impactor.
  std::vector<double> pad = work_of(history.force, [&](std::size_t i) {
    return history.pad_force.empty() ? history.penetration[i] : history.motion[i];
  });
  if (!history.pad_force.empty())
    for (std::size_t i = 0; i < pad.size(); ++i) pad[i] -= back[i];
  // What a support has taken is a function of the force as long as it is only elastic.
  const auto support = [&](std::size_t i) {
    if (!history.body_motion.empty()) return back[i];
    return impact.support.is_rigid() ? 0.0 : impact.support.energy(history.force_of_pad()[i]);
  };
  const double weight = impact.impactor.mass * impact.impactor.gravity;
  const auto sum = [&](std::size_t i) {
    return kinetic(i) + support(i) + pad[i] - weight * history.motion[i];
  };
  double worst = 0;
  for (std::size_t i = 0; i < history.size(); ++i)
    worst = std::max(worst, std::abs(sum(i) - kinetic(0)) / kinetic(0));
  Json result;
  result["time"] = shown(history.time);
  result["force"] = shown(history.force);
  result["deceleration"] =
      column(entries, [&](std::size_t i) { return 0 - history.acceleration[i] / standard_gravity; });
  result["motion"] = shown(history.motion);
  result["penetration"] = shown(history.penetration);
  result["support_deflection"] = shown(history.support_deflection);
  result["kinetic_energy"] = column(entries, kinetic);
  result["support_energy"] = column(entries, support);
  result["pad_energy"] = shown(pad);
  result["total_energy"] = column(entries, sum);
  result["energy_residual_fraction"] = rounded(worst);
  return result;
}

Json page_snapshots(const std::vector<ContactSnapshot>& snapshots) {
  Json list = Json::array();
  for (const ContactSnapshot& snapshot : snapshots)
    list.push_back({{"time", rounded(snapshot.time)},
                    {"when", snapshot.when},
                    {"determined", snapshot.determined},
                    {"deviation", rounded(std::abs(snapshot.force_of_stress() / snapshot.force - 1))},
                    {"radius", column(snapshot.radius)},
                    {"strain", column(snapshot.strain)},
                    {"stress", column(snapshot.stress)}});
  return list;
}

}  // namespace dashpad::output
