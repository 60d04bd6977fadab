#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <variant>

#include <fmt/format.h>

#include "dashpad/quantities/constants.hpp"
#include "impact/refinement.hpp"

namespace dashpad {

namespace {

/// Shortest time for a rate, as a share of the history; in shorter steps it is the residual of the roots.
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

/// Time at which a strain is first passed, by a line between entries, s.
std::optional<double> time_of(double level, const std::vector<double>& time,
                              const std::vector<double>& strain) {
  const auto beyond = std::ranges::find_if(strain, [&](double e) { return e > level; });
  if (beyond == strain.end()) return std::nullopt;
  const auto i = static_cast<std::size_t>(beyond - strain.begin());
  if (i == 0) return time.front();
  return time[i - 1] + (time[i] - time[i - 1]) * (level - strain[i - 1]) / (strain[i] - strain[i - 1]);
}

/// Figures of the layers of a pad; none where the history has no layers.
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

std::vector<Extrapolation> extrapolations(const Material& material, const PadCondition& condition,
                                          double strain, double rate) {
  std::vector<Extrapolation> reasons = extrapolations(material, strain, rate);
  for (Extrapolation& reason : extrapolations(condition, material)) reasons.push_back(std::move(reason));
  return reasons;
}

/// Reasons why a result is extrapolated by layers beyond their tests, in the order of time.
std::vector<Extrapolation> layer_extrapolations(const Pad& pad, const std::vector<LayerSummary>& layers) {
  std::vector<std::size_t> order(layers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return layers[i].beyond_tested.value_or(infinite); });
  std::vector<Extrapolation> reasons;
  for (const std::size_t i : order) {
    const PadLayer& layer = pad.layers[i];
    const std::string which = fmt::format("in layer {} ({}), ", i + 1, layer.material.name);
    for (const auto& [beyond, text] :
         extrapolations(layer.material, layer.condition, layers[i].peak_strain, layers[i].peak_strain_rate))
      reasons.push_back({beyond, which + text});
  }
  return reasons;
}

std::vector<Extrapolation> extrapolations(const ImpactCase& impact, const Summary& summary) {
  std::vector<Extrapolation> reasons = layer_extrapolations(impact.pad, summary.layers);
  if (impact.pad.layers.empty())
    reasons = extrapolations(impact.pad.material, impact.pad.condition, summary.peak_strain,
                             summary.peak_strain_rate);
  // A linear support has one point, which only gives its slope.
  const auto& points = impact.support.points();
  const std::optional<double> force =
      summary.support ? summary.support->peak_transmitted : summary.peak_force;
  if (points.size() > 1 && force && *force > points.back().force)
    reasons.push_back(
        {Beyond::other, fmt::format("the support force reaches {:.4g} N; the support curve ends at {:.4g} N",
                                    *force, points.back().force)});
  return reasons;
}

EnergyLedger ledger_of(const Impactor& impactor, const Figures& figures) {
  EnergyLedger energy = figures.energy;
  energy.impact = impactor.mass * impactor.speed * impactor.speed / 2;
  energy.kinetic = impactor.mass * figures.final_velocity * figures.final_velocity / 2;
  energy.residual = energy.supply() - energy.kinetic - energy.support - energy.support_loss - energy.moving -
                    energy.pad - energy.sheet;
  return energy;
}

SupportFigures support_figures(const Support& support, const Backing& backing, const Figures& figures) {
  SupportFigures of{.peak_deflection = figures.peak_deflection, .crushing_force = figures.crushing_force};
  if (!(support.is_rigid() && figures.ending == Status::bottomed_out))
    of.peak_transmitted = figures.peak_transmitted;
  if (backing.unloading_stiffness > 0) of.set = figures.set;
  if (backing.body_mass > 0) of.body_speed = figures.body_velocity;
  return of;
}

/// Summary::force_on_way_in. With laws 4 and 5, whose rate stress ignores the sign of the strain rate, a pad
/// that opens on a spring pushes the harder the faster it does. 0 unless the peak is larger by 5 %.
double force_on_way_in(const ImpactCase& impact, const History& history, double peak) {
  constexpr double noticed = 1.05;
  const PadLaw& law = impact.pad.material.law;
  const bool pushes_back =
      std::holds_alternative<NineParameter>(law) || std::holds_alternative<TwentyOneParameter>(law);
  if (!pushes_back || impact.backing.mass > 0 || history.force.empty()) return 0;
  const auto deepest = std::ranges::max_element(history.penetration) - history.penetration.begin();
  const double way_in = *std::max_element(history.force.begin(), history.force.begin() + deepest + 1);
  return peak > noticed * way_in ? way_in : 0;
}

}  // namespace

std::string to_string(Status status) {
  constexpr const char* names[]{"not run",    "released",          "bottomed out",
                                "time limit", "tolerance not met", "at rest"};
  return names[static_cast<std::size_t>(status)];
}

Summary summarise(const ImpactCase& impact, const Refinement& refinement, const History& finest,
                  double tolerance) {
  const Figures& figures = refinement.figures();
  const Impactor& impactor = impact.impactor;
  Summary s;
  s.status = refinement.is_met() ? figures.ending : Status::tolerance_not_met;
  if (figures.ending != Status::bottomed_out) {
    // The peak of a run that is cut at its very beginning may be extrapolated below 0.
    s.peak_force = std::max(figures.peak_force, 0.0);
    s.time_of_peak_force = figures.time_of_peak_force;
    s.peak_acceleration = *s.peak_force / impactor.mass;
    s.force_on_way_in = force_on_way_in(impact, finest, *s.peak_force);
  }
  s.peak_motion = figures.peak_motion;
  s.peak_penetration = figures.bottomed ? impact.pad.thickness : figures.peak_penetration;
  s.peak_strain = s.peak_penetration / impact.pad.thickness;
  s.peak_strain_rate = figures.peak_pad_rate / impact.pad.thickness;
  s.force_below_weight = figures.force_below_weight;
  s.contact_end = figures.contact_end;
  s.release = figures.release;
  s.bottomed = figures.bottomed;
  if (figures.release) {
    // Rigid foam may leave an impactor at rest with a rounding of either sign.
    const double velocity = figures.release->velocity;
    s.rebound_speed = impact.backing.body_mass > 0 ? std::max(-velocity, 0.0) : std::abs(velocity);
    s.restitution = impact.backing.body_mass > 0 ? (figures.body_velocity - velocity) / impactor.speed
                                                 : *s.rebound_speed / impactor.speed;
  }
  s.rest = figures.rest;
  s.still_sinking =
      figures.rest && is_still_sinking(figures.left_to_sink, figures.peak_penetration, tolerance);
  if (impact.backing != Backing{}) s.support = support_figures(impact.support, impact.backing, figures);
  s.energy = ledger_of(impactor, figures);
  s.speed_to_sheet = figures.speed_to_sheet;
  s.energy_absorbed_fraction =
      1 - (s.energy.kinetic + s.energy.support + s.energy.support_loss + s.energy.moving - s.energy.weight) /
              s.energy.impact;
  s.layers = layer_summaries(impact.pad, finest);
  s.extrapolations = extrapolations(impact, s);
  s.softening_rates = softening_rates(impact.pad.material.law);  // no layer may have such a curve
  s.errors = refinement.errors();
  s.tolerance = tolerance;
  s.stations = figures.stations;
  s.runs = refinement.runs();
  return s;
}

}  // namespace dashpad
