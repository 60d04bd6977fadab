#include "impact/layer_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace dashpad {
namespace {

/// Shortest time over which a rate is taken, of the history: in a shorter step it is made of what the roots
/// have left over.
constexpr double shortest_share = 1e-3;

double largest_rate(const std::vector<double>& time, const std::vector<double>& strain) {
  const double shortest = shortest_share * (time.back() - time.front());
  double largest = 0;
  for (std::size_t from = 0, to = 1; to < time.size(); ++to) {
    const double elapsed = time[to] - time[from];
    if (elapsed < shortest) continue;
    largest = std::max(largest, std::abs(strain[to] - strain[from]) / elapsed);
    from = to;
  }
  return largest;
}

/// When a strain is first passed, by a line between entries, s.
std::optional<double> time_of(double level, const std::vector<double>& time,
                              const std::vector<double>& strain) {
  const auto beyond = std::ranges::find_if(strain, [&](double e) { return e > level; });
  if (beyond == strain.end()) return std::nullopt;
  const auto i = static_cast<std::size_t>(beyond - strain.begin());
  if (i == 0) return time.front();
  return time[i - 1] + (time[i] - time[i - 1]) * (level - strain[i - 1]) / (strain[i] - strain[i - 1]);
}

}  // namespace

std::vector<LayerSummary> layer_summaries(const Pad& pad, const History& history) {
  std::vector<LayerSummary> all;
  for (std::size_t i = 0; i < std::min(pad.layers.size(), history.layer_strain.size()); ++i) {
    const std::vector<double>& strain = history.layer_strain[i];
    LayerSummary layer;
    layer.peak_strain = *std::ranges::max_element(strain);
    layer.peak_strain_rate = largest_rate(history.time, strain);
    if (const auto range = range_of(pad.layers[i].material))
      layer.beyond_tested = time_of(range->highest_strain, history.time, strain);
    layer.struck_through = time_of(1 - struck_through_gap, history.time, strain);
    all.push_back(layer);
  }
  return all;
}

std::vector<Extrapolation> layer_extrapolations(const Pad& pad, const std::vector<LayerSummary>& layers) {
  std::vector<std::size_t> order(layers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) {
    return layers[i].beyond_tested.value_or(std::numeric_limits<double>::infinity());
  });
  std::vector<Extrapolation> reasons;
  for (const std::size_t i : order) {
    const PadLayer& layer = pad.layers[i];
    const std::string which = fmt::format("layer {} ({}): ", i + 1, layer.material.name);
    std::vector<Extrapolation> of_layer =
        extrapolations(layer.material, layers[i].peak_strain, layers[i].peak_strain_rate);
    for (Extrapolation& reason : extrapolations(layer.condition, layer.material))
      of_layer.push_back(std::move(reason));
    for (const auto& [beyond, text] : of_layer) reasons.push_back({beyond, which + text});
  }
  return reasons;
}

}  // namespace dashpad
