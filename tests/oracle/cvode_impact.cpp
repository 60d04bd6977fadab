#include "oracle/cvode_impact.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <type_traits>
#include <variant>

#include "oracle/elastic_phase.hpp"
#include "oracle/foam_impact.hpp"
#include "oracle/loading_phase.hpp"
#include "oracle/maxwell_impact.hpp"
#include "oracle/unloading_phase.hpp"

namespace dashpad::oracle {

namespace {

template <class Formulas>
void solve_columns(ImpactRun& run, const Formulas& law) {
  if (run.thickness > run.radius)
    throw std::invalid_argument("CVODE oracle: a pad thicker than the sphere's radius is not covered");
  LoadingPhase<Formulas> loading(run, law);
  TurningPoint turn;
  if (!loading.run(turn)) return;
  UnloadingPhase<Formulas>(run, law, loading.grid(), turn).run();
}

void solve_law(ImpactRun& run, const Elastic& law) { solve_elastic(run, law.modulus); }
void solve_law(ImpactRun& run, const LinearViscoelastic& law) { solve_columns(run, LinearFormulas(law)); }
void solve_law(ImpactRun&, const RigidFoam&) {
  throw std::invalid_argument("CVODE oracle: rigid foam is not covered");
}
void solve_law(ImpactRun& run, const NineParameter& law) { solve_columns(run, NineFormulas(law)); }
void solve_law(ImpactRun& run, const TwentyOneParameter& law) { solve_columns(run, TwentyOneFormulas(law)); }

template <class Law>
constexpr bool by_curves = std::is_same_v<Law, Foam> || std::is_same_v<Law, CrushableFoam>;

}  // namespace

CvodeImpact solve_with_cvode(const ImpactCase& impact, const CvodeOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  ImpactRun run{impact.impactor.mass,
                sphere_radius(impact.impactor.nose),
                impact.impactor.speed,
                impact.pad.thickness,
                impact.pad.earlier_penetration,
                SupportLine(impact.support),
                impact.backing,
                impact.impactor.gravity,
                options,
                {}};
  const auto solve = [&]<class Law>(const Law& law) {
    if (!by_curves<Law> && (impact.backing != Backing{} || impact.impactor.gravity != 0))
      throw std::invalid_argument("CVODE oracle: on such a support foams by curves only");
    if constexpr (by_curves<Law>) {
      solve_foam(run, FoamFormulas(law), impact.impactor.nose);
    } else if constexpr (std::is_same_v<Law, ViscoelasticFoam>) {
      solve_maxwell(run, MaxwellFormulas(law), impact.impactor.nose);
    } else {
      if (!std::holds_alternative<Sphere>(impact.impactor.nose))
        throw std::invalid_argument("CVODE oracle: for this law a sphere only");
      solve_law(run, law);
    }
  };
  std::visit(solve,
             scaled(impact.pad.material.law, stress_factor(impact.pad.condition, impact.pad.material)));
  run.result.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run.result;
}

namespace {

std::optional<double> relative(std::optional<double> ours, std::optional<double> oracle) {
  if (!ours || !oracle) return std::nullopt;
  return *ours / *oracle - 1;
}
std::optional<double> time_of(const std::optional<Moment>& moment) {
  return moment ? std::optional(moment->time) : std::nullopt;
}
std::optional<double> velocity_of(const std::optional<Moment>& moment) {
  return moment ? std::optional(moment->velocity) : std::nullopt;
}

}  // namespace

Differences compare(const Summary& summary, const CvodeImpact& oracle) {
  Differences result;
  if (oracle.ending == Ending::released) {
    result.peak_force = relative(summary.peak_force, oracle.peak_force);
    result.time_of_peak_force = relative(summary.time_of_peak_force, oracle.time_of_peak_force);
  }
  result.peak_motion = relative(summary.peak_motion, oracle.peak_motion);
  result.peak_penetration = relative(summary.peak_penetration, oracle.peak_penetration);
  result.weight_time = relative(time_of(summary.force_below_weight), time_of(oracle.weight));
  result.weight_velocity = relative(velocity_of(summary.force_below_weight), velocity_of(oracle.weight));
  result.contact_end_time = relative(time_of(summary.contact_end), time_of(oracle.contact_end));
  result.contact_end_velocity = relative(velocity_of(summary.contact_end), velocity_of(oracle.contact_end));
  result.release_time = relative(time_of(summary.release), time_of(oracle.release));
  result.release_velocity = relative(velocity_of(summary.release), velocity_of(oracle.release));
  return result;
}

double Differences::largest() const {
  double result = 0;
  for (const auto& entry :
       {peak_force, time_of_peak_force, peak_motion, peak_penetration, weight_time, weight_velocity,
        contact_end_time, contact_end_velocity, release_time, release_velocity})
    if (entry) result = std::max(result, std::abs(*entry));
  return result;
}

std::string Differences::text() const {
  std::string line;
  const auto add = [&](const char* name, const std::optional<double>& value) {
    char entry[64];
    if (value)
      std::snprintf(entry, sizeof entry, "%s %.2e  ", name, *value);
    else
      std::snprintf(entry, sizeof entry, "%s -  ", name);
    line += entry;
  };
  add("peak force", peak_force), add("its time", time_of_peak_force), add("motion", peak_motion);
  add("penetration", peak_penetration), add("weight time", weight_time);
  add("weight velocity", weight_velocity), add("contact end time", contact_end_time);
  add("contact end velocity", contact_end_velocity), add("release time", release_time);
  add("release velocity", release_velocity);
  return line;
}

}  // namespace dashpad::oracle
