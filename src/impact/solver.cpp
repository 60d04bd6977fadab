#include "dashpad/impact/solve.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/quantities/portable_math.hpp"
#include "impact/contacts.hpp"
#include "impact/figures.hpp"
#include "impact/march.hpp"
#include "impact/numerics.hpp"
#include "impact/refinement.hpp"
#include "model/parameter_values.hpp"

namespace dashpad {

namespace {

void refuse_unsound(const ImpactCase& impact, bool law_is_sound, const Options& options) {
  auto broken = law_is_sound ? violations_beside_law(impact) : violations(impact);
  check_bounds(options, "", broken);
  if (options.fixed_runs < 0 || options.fixed_runs > numerics.max_fixed_runs)
    broken.push_back({"fixed_runs", double(options.fixed_runs), "must be from 0 to 10"});
  if (broken.empty()) return;
  std::string message = "invalid impact case";
  for (const auto& v : broken) message += fmt::format("\n  {} = {}: {}", v.key, v.value, v.rule);
  throw std::invalid_argument(message);
}

/// Entries of a history that are reserved from the start: more than most impacts need, and in total less than
/// the 128 KiB from which on the heap returns memory to the system and requests it anew for every Solver.
constexpr std::size_t usual_entries = 700;

/// Records of the runs of an impact.
struct Runs {
  Track now;      ///< current or failed run
  Track finest;   ///< finest run whose figures are reported
  Pulse coarser;  ///< pulse of the run before it
};

/// Runs the impact at increasingly fine resolution until the figures settle or the work is spent.
template <class Contact>
Refinement refine(const ImpactCase& impact, Contact& contact, const Options& options, Runs& runs) {
  Refinement refinement(impact, options.tolerance);
  March<Contact> march(impact, contact, options);
  double expected = impact.pad.thickness;
  double left = numerics.max_work *
                std::clamp(portable::pow(1e-3 / options.tolerance, 7.0 / 8), 1.0, numerics.max_patience);
  double cost = 0;    // estimate for the next run, s
  double steps = 0;   // steps of the next run
  double before = 0;  // work of the last run that got through
  int given_up = 0;   // runs given up since then
  runs.finest.clear();
  runs.coarser.time.clear();
  runs.coarser.acceleration.clear();
  for (double resolution = numerics.first_resolution;; resolution /= 2) {
    const Figures run = march.run(resolution, runs.now, {.expected = expected, .max_work = left});
    const bool has_two = refinement.asks_for_distance() && runs.finest.size() > 1 && runs.now.size() > 1;
    const double apart =
        has_two ? distance_between(runs.now.history, runs.finest.history, impact.impactor) : infinite;
    if (refinement.add(run, apart)) {
      if (refinement.runs_compared()) {
        runs.coarser.time = runs.finest.history.time;
        runs.coarser.acceleration = runs.finest.history.acceleration;
      }
      std::swap(runs.now, runs.finest);
    }
    if (run.peak_penetration > 0) expected = run.peak_penetration;
    if (options.fixed_runs > 0 ? refinement.runs() >= options.fixed_runs : refinement.settled()) break;
    if (options.fixed_runs > 0) continue;
    // Cost of the next run: twice the steps, each with up to twice the columns. A run that stalls predicts
    // nothing, and a finer one may get through.
    left -= run.work;
    const double growth = before > 0 ? std::clamp(run.work / before, 2.0, 4.0) : 2.0;
    if (run.ending == Status::tolerance_not_met) {
      if (++given_up > numerics.max_given_up) break;
      cost *= 4, steps *= 2;
    } else {
      given_up = 0;
      cost = run.work * growth, steps = 2.0 * double(run.steps);
      before = run.work;
    }
    if (cost > left || steps > double(options.max_steps)) break;
  }
  return refinement;
}

/// The case of the next blow (theory.md, Eq. 47): the only place where a state is carried from one blow to
/// the next. Nothing after the last blow, or after one that leaves the pad in an unknown state; with a fixed
/// number of runs accuracy does not matter.
std::optional<ImpactCase> next_blow(const ImpactCase& series, const ImpactCase& blow, const Summary& summary,
                                    const Options& options) {
  const bool leaves_a_pad =
      options.fixed_runs > 0 ? summary.release && !summary.bottomed : leaves_a_known_pad(summary);
  if (summary.blow >= summary.blows || !leaves_a_pad) return std::nullopt;
  ImpactCase next = blow;
  if (blow_memory(blow.pad.material.law) != BlowMemory::none)
    next.pad.earlier_penetration =
        (1 - series.blows->recovery) * std::max(blow.pad.earlier_penetration, summary.peak_penetration);
  // Below its preload a support does not move.
  if (summary.support && summary.support->crushing_force > blow.backing.preload)
    next.backing.earlier_force = std::max(blow.backing.earlier_force, summary.support->crushing_force);
  return next;
}

}  // namespace

struct Solver::Memory {
  Runs runs;
  Contacts contacts;
  Solution solution;

  /// Solves one blow.
  void solve(const ImpactCase& impact, const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    const Refinement refinement =
        contacts.visit(impact, options.plain ? ColumnMath::plain : ColumnMath::vector,
                       [&](auto& contact) { return refine(impact, contact, options, runs); });
    solution.summary = summarise(impact, refinement, runs.finest.history, options.tolerance);
    solution.summary.steps = runs.finest.size() - 1;
    std::swap(solution.history, runs.finest.history);
    std::swap(solution.coarser, runs.coarser);
    solution.summary.wall_time =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  void check(const ImpactCase& impact, const Options& options) const {
    refuse_unsound(impact, impact.pad.layers.empty() && contacts.know(impact.pad.material.law), options);
  }
};

Solver::Solver() : memory_(std::make_unique<Memory>()) {
  memory_->runs.now.reserve(usual_entries);
  memory_->runs.finest.reserve(usual_entries);
}
Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

const Solution& Solver::solve(const ImpactCase& impact, const Options& options) {
  if (impact.blows) {
    solve_each_blow(impact, options, [](const ImpactCase&, const Solution&) {});
  } else {
    memory_->check(impact, options);
    memory_->solve(impact, options);
  }
  return memory_->solution;
}

void Solver::solve_each_blow(const ImpactCase& impact, const Options& options, const BlowVisitor& visit) {
  memory_->check(impact, options);
  std::optional<ImpactCase> blow = impact;
  blow->blows.reset();
  for (int number = 1; blow; ++number) {
    memory_->solve(*blow, options);
    Summary& summary = memory_->solution.summary;
    summary.blow = number;
    summary.blows = impact.blows ? impact.blows->count : 1;
    visit(*blow, memory_->solution);
    blow = next_blow(impact, *blow, summary, options);
  }
}

Solution solve(const ImpactCase& impact, const Options& options) { return Solver().solve(impact, options); }

std::vector<Blow> solve_blows(const ImpactCase& impact, const Options& options) {
  std::vector<Blow> blows;
  Solver().solve_each_blow(impact, options, [&](const ImpactCase& blow, const Solution& solution) {
    blows.push_back({blow, solution});
  });
  return blows;
}

}  // namespace dashpad
