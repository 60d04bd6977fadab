#include "dashpad/impact/solve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "impact/contacts.hpp"
#include "impact/figures.hpp"
#include "impact/march.hpp"
#include "impact/numerics.hpp"
#include "impact/refinement.hpp"

namespace dashpad {

namespace {

void refuse_unsound(const ImpactCase& impact, bool law_is_sound, const Options& options) {
  auto broken = law_is_sound ? violations_beside_law(impact) : violations(impact);
  if (!(options.tolerance >= 1e-8 && options.tolerance <= 1e-2))
    broken.push_back({"tolerance", options.tolerance, "must be from 1e-8 to 1e-2"});
  if (!(options.time_limit > 0 && std::isfinite(options.time_limit)))
    broken.push_back({"time_limit", options.time_limit, "must be greater than 0"});
  if (options.fixed_runs < 0 || options.fixed_runs > numerics.most_fixed_runs)
    broken.push_back({"fixed_runs", double(options.fixed_runs), "must be from 0 to 10"});
  if (broken.empty()) return;
  std::string message = "invalid impact case";
  for (const auto& v : broken) message += fmt::format("\n  {} = {}: {}", v.key, v.value, v.rule);
  throw std::invalid_argument(message);
}

/// Entries of a history for which there is room from the start: more than most impacts need, and in all less
/// than the 128 KiB that the heap hands back to the system, and has to ask for anew, with every Solver.
constexpr std::size_t usual_entries = 700;

/// What the runs of an impact leave behind.
struct Runs {
  Track now;      ///< of the run that goes on, or failed
  Track finest;   ///< of the last of those whose figures are reported
  Pulse coarser;  ///< of the one before it
};

/// Runs the impact at finer and finer resolution until the figures settle or the work is spent.
template <class Contact>
Refinement refine(const ImpactCase& impact, Contact& contact, const Options& options, Runs& runs) {
  Refinement refinement(impact.impactor, options.tolerance);
  March<Contact> march(impact, contact, options);
  double expected = impact.pad.thickness;
  double left = numerics.most_work *
                std::clamp(std::pow(1e-3 / options.tolerance, 7.0 / 8), 1.0, numerics.most_patience);
  double cost = 0;    // of the next run, as far as the runs so far tell, s
  double steps = 0;   // likewise
  double before = 0;  // work of the run before that got through
  int given_up = 0;   // runs since then
  runs.finest.clear();
  runs.coarser.time.clear();
  runs.coarser.acceleration.clear();
  for (double resolution = numerics.first_resolution;; resolution /= 2) {
    const Figures run = march.run(resolution, runs.now, {.expected = expected, .most_work = left});
    if (refinement.add(run)) {
      if (refinement.runs_compared()) {
        runs.coarser.time = runs.finest.history.time;
        runs.coarser.acceleration = runs.finest.history.acceleration;
      }
      std::swap(runs.now, runs.finest);
    }
    if (run.peak_penetration > 0) expected = run.peak_penetration;
    if (options.fixed_runs > 0 ? refinement.runs() >= options.fixed_runs : refinement.settled()) break;
    if (options.fixed_runs > 0) continue;
    // What the next run will cost: twice the steps, and of columns up to twice as many each. A run that
    // stalls says nothing of it, and one that is finer may get through.
    left -= run.work;
    const double growth = before > 0 ? std::clamp(run.work / before, 2.0, 4.0) : 2.0;
    if (run.ending == Ending::too_many_steps) {
      if (++given_up > numerics.most_given_up) break;
      cost *= 4, steps *= 2;
    } else {
      given_up = 0;
      cost = run.work * growth, steps = 2.0 * double(run.steps);
      before = run.work;
    }
    if (cost > left || steps > double(options.most_steps)) break;
  }
  return refinement;
}

/// The first blow of a series, or the case itself.
ImpactCase first_blow(const ImpactCase& series) {
  ImpactCase blow = series;
  blow.blows.reset();
  return blow;
}

/// What the next blow meets (theory.md, Eq. 47): the only place where a state is carried from one blow to the
/// next. Nothing after the last blow, and after one whose outcome does not say what it leaves behind; with a
/// fixed number of runs its accuracy does not count.
std::optional<ImpactCase> next_blow(const ImpactCase& series, const ImpactCase& blow, const Summary& summary,
                                    const Options& options) {
  const bool leaves_a_pad =
      options.fixed_runs > 0 ? summary.release && !summary.bottomed : leaves_a_known_pad(summary);
  if (summary.blow >= summary.blows || !leaves_a_pad) return std::nullopt;
  ImpactCase next = blow;
  if (blow_memory(blow.pad.material.law) != BlowMemory::none)
    next.pad.earlier_penetration =
        (1 - series.blows->recovery) * std::max(blow.pad.earlier_penetration, summary.peak_penetration);
  // Below its preload a support stays where it is.
  if (summary.support && summary.support->crushing_force > blow.backing.preload)
    next.backing.earlier_force = std::max(blow.backing.earlier_force, summary.support->crushing_force);
  return next;
}

}  // namespace

struct Solver::Memory {
  Runs runs;
  Contacts contacts;
  Solution solution;

  Refinement refine_law(const ImpactCase& impact, const Options& options) {
    return contacts.visit(impact, options.plain ? ColumnMath::plain : ColumnMath::vector,
                          [&](auto& contact) { return refine(impact, contact, options, runs); });
  }

  /// One blow.
  void solve(const ImpactCase& impact, const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    const Refinement refinement = refine_law(impact, options);
    solution.summary = summarise(impact, refinement, runs.finest.history, options.tolerance);
    solution.summary.steps = runs.finest.size() - 1;
    std::swap(solution.history, runs.finest.history);
    std::swap(solution.coarser, runs.coarser);
    solution.summary.wall_time =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  void check(const ImpactCase& impact, const Options& options) {
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
  std::optional<ImpactCase> blow = first_blow(impact);
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
