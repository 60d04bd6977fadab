#include "dashpad/impact/solve.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "contact/column_field.hpp"
#include "contact/curve_contact.hpp"
#include "impact/figures.hpp"
#include "impact/march.hpp"
#include "impact/refinement.hpp"

namespace dashpad {
namespace {

void check(const ImpactCase& impact, const Options& options) {
  auto broken = violations(impact);
  if (!(options.tolerance >= 1e-8 && options.tolerance <= 1e-2))
    broken.push_back({"tolerance", options.tolerance, "must be from 1e-8 to 1e-2"});
  if (!(options.time_limit > 0 && std::isfinite(options.time_limit)))
    broken.push_back({"time_limit", options.time_limit, "must be greater than 0"});
  if (broken.empty()) return;
  std::string message = "invalid impact case";
  for (const auto& v : broken) message += fmt::format("\n  {} = {}: {}", v.key, v.value, v.rule);
  throw std::invalid_argument(message);
}

/// Column updates of a run after which one more run is the last that is worth its time (about a second).
constexpr std::size_t most_updates_before_last = 6'000'000;

/// Runs the impact at finer and finer resolution until the figures settle.
template <class Contact>
Refinement refine(const ImpactCase& impact, Contact contact, const Options& options, Track& track) {
  Refinement refinement(impact.impactor, options.tolerance);
  March<Contact> march(impact.impactor, impact.pad.thickness, impact.support, contact, options);
  for (double resolution = 0.2; !refinement.settled() && refinement.runs() < Refinement::most_runs;
       resolution /= 2) {
    const Figures run = march.run(resolution, track);
    refinement.add(run);
    // The next run would cost four times as much.
    if (run.ending == Ending::too_many_steps || run.updates > most_updates_before_last) break;
  }
  return refinement;
}

Refinement refine(const ImpactCase& impact, const Options& options, Track& track) {
  const double thickness = impact.pad.thickness;
  const double radius = impact.impactor.radius;
  return std::visit(
      [&](const auto& law) {
        using Law = std::decay_t<decltype(law)>;
        if constexpr (IsMemoryless<Law>)
          return refine(impact, CurveContact(law.curve(), Law::recovers, thickness, radius), options, track);
        else
          return refine(impact, ColumnField<Law>(law, thickness, radius), options, track);
      },
      impact.pad.material.law);
}

std::vector<std::string> extrapolations(const ImpactCase& impact, const Summary& summary) {
  std::vector<std::string> reasons =
      extrapolations(impact.pad.material, summary.peak_strain, summary.peak_strain_rate);
  // A linear support has one point, which only says its slope.
  const auto& points = impact.support.points();
  if (points.size() > 1 && summary.peak_force && *summary.peak_force > points.back().force)
    reasons.push_back(fmt::format("the support's force reaches {:.4g} N; its curve ends at {:.4g} N",
                                  *summary.peak_force, points.back().force));
  return reasons;
}

Status status_of(const Refinement& refinement) {
  if (!refinement.settled()) return Status::tolerance_not_met;
  switch (refinement.figures().ending) {
    case Ending::released: return Status::released;
    case Ending::bottomed_out: return Status::bottomed_out;
    case Ending::time_limit: return Status::time_limit;
    default: return Status::tolerance_not_met;
  }
}

EnergyLedger ledger_of(const Impactor& impactor, const Figures& figures) {
  EnergyLedger energy;
  energy.initial = impactor.mass * impactor.speed * impactor.speed / 2;
  energy.kinetic = impactor.mass * figures.final_velocity * figures.final_velocity / 2;
  energy.support = figures.support_energy;
  energy.pad = figures.pad_work;
  energy.residual = energy.initial - energy.kinetic - energy.support - energy.pad;
  return energy;
}

Summary summarise(const ImpactCase& impact, const Refinement& refinement) {
  const Figures& figures = refinement.figures();
  const Impactor& impactor = impact.impactor;
  Summary s;
  s.status = status_of(refinement);
  if (figures.ending != Ending::bottomed_out) {
    s.peak_force = figures.peak_force;
    s.time_of_peak_force = figures.time_of_peak_force;
    s.peak_acceleration = figures.peak_force / impactor.mass;
  }
  s.peak_motion = figures.peak_motion;
  s.peak_penetration = figures.bottomed ? impact.pad.thickness : figures.peak_penetration;
  s.peak_strain = s.peak_penetration / impact.pad.thickness;
  s.peak_strain_rate = figures.peak_pad_rate / impact.pad.thickness;
  s.weight = figures.weight;
  s.release = figures.release;
  s.bottomed = figures.bottomed;
  if (figures.release) {
    s.rebound_speed = std::abs(figures.release->velocity);
    s.restitution = *s.rebound_speed / impactor.speed;
  }
  s.energy = ledger_of(impactor, figures);
  s.energy_absorbed_fraction = 1 - (s.energy.kinetic + s.energy.support) / s.energy.initial;
  s.extrapolations = extrapolations(impact, s);
  s.extrapolated = !s.extrapolations.empty();
  s.errors = refinement.errors();
  s.stations = figures.stations;
  s.runs = refinement.runs();
  return s;
}

}  // namespace

std::string to_string(Status status) {
  switch (status) {
    case Status::released: return "released";
    case Status::bottomed_out: return "bottomed out";
    case Status::time_limit: return "time limit";
    case Status::tolerance_not_met: return "tolerance not met";
    case Status::not_run: break;
  }
  return "not run";
}

Solution solve(const ImpactCase& impact, const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  check(impact, options);
  Track track;
  track.reserve(options.most_steps + 2);
  const Refinement refinement = refine(impact, options, track);
  Solution solution;
  solution.summary = summarise(impact, refinement);
  solution.summary.tolerance = options.tolerance;
  solution.summary.steps = track.size() - 1;
  solution.history = std::move(track.history);
  solution.summary.wall_time =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return solution;
}

}  // namespace dashpad
