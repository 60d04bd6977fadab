/// Work against precision, all solvers side by side in one run: for each solver and setting the true error
/// and the time.
///
/// Error: largest relative deviation of peak force, peak penetration and rebound speed from a converged
/// reference, and the largest of that over impact speeds a few per cent apart, so that no setting shines by
/// chance. Reference: CVODE with far finer settings than any that compete; Dashpad's finest result says how
/// well it is known. Time: median CPU time of one solution at full speed. The repetitions go round all
/// settings in turn, so that whatever else the machine does falls on all of them alike; only the SciPy
/// script, a process of its own, is measured after the others.

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>

#include "cases.hpp"
#include "contenders.hpp"
#include "dashpad/spit1984/deck.hpp"
#include "machine.hpp"

namespace dashpad::bench {
namespace {

struct Settings {
  std::vector<std::string> cases{"c1", "c2", "c3", "v1"};
  int repetitions = 15;
  bool quick = false;
  std::string csv;
};

struct CaseResult {
  std::string id;
  double reference_agreement = 0;      ///< of Dashpad's finest result with the reference
  std::map<std::string, int> tried;    ///< settings of each solver
  std::map<std::string, int> gave_up;  ///< of those, at full speed
  std::vector<Measurement> measurements;
};

/// A contender that is still in.
struct Entrant {
  Contender contender;
  Measurement measurement;
};

/// Leaves out the settings of CVODE that are far from its front.
void drop_beaten(std::vector<Entrant>& entrants, double margin) {
  std::vector<Measurement> all;
  for (const Entrant& e : entrants) all.push_back(e.measurement);
  std::erase_if(entrants, [&](const Entrant& e) {
    return e.measurement.solver == tuned_cvode && is_beaten(e.measurement, all, margin);
  });
}

std::vector<Contender> contenders_of(const ImpactCase& impact, bool quick) {
  std::vector<Contender> all = dashpad_contenders(impact);
  // The program of 1984 has no foams by their curves.
  if (spit1984::what_a_deck_cannot_say(impact).empty())
    for (Contender& c : spit1984_contenders(impact)) all.push_back(std::move(c));
  for (Contender& c : cvode_contenders(impact, quick)) all.push_back(std::move(c));
  return all;
}

/// Those that solve the impact at full speed, with their errors over all speeds and a first time.
std::vector<Entrant> judged(const ImpactCase& impact, const References& references, bool quick,
                            CaseResult& result) {
  std::vector<Entrant> entrants;
  for (Contender& contender : contenders_of(impact, quick)) {
    ++result.tried[contender.solver];
    Measurement m;
    m.solver = contender.solver;
    m.setting = contender.setting;
    const double start = thread_time();
    const bool solved = judge(contender, 1, references, m);
    m.times.push_back(thread_time() - start);
    if (solved)
      entrants.push_back({std::move(contender), std::move(m)});
    else
      ++result.gave_up[contender.solver];
  }
  // One speed decides coarsely who is worth the other four, all five decide who is worth timing.
  drop_beaten(entrants, 4);
  for (Entrant& e : entrants)
    for (const double share : speed_shares)
      if (share != 1) judge(e.contender, share, references, e.measurement);
  drop_beaten(entrants, 1.5);
  return entrants;
}

CaseResult measure(const std::string& id, const Settings& settings) {
  const ImpactCase impact = impact_of(id);
  const References references = reference_solutions(impact, settings.quick);
  CaseResult result;
  result.id = id;
  std::vector<Entrant> entrants = judged(impact, references, settings.quick, result);
  for (const Entrant& e : entrants)
    if (e.measurement.solver == "Dashpad") result.reference_agreement = e.measurement.errors.largest();
  for (Entrant& e : entrants) e.measurement.times.clear();  // they were the warm-up
  for (int round = 0; round < settings.repetitions; ++round)
    for (Entrant& e : entrants) e.measurement.times.push_back(time_of(e.contender));
  for (Entrant& e : entrants) result.measurements.push_back(std::move(e.measurement));
  for (Measurement& m : scipy_measurements(impact, references, settings.quick))
    result.measurements.push_back(std::move(m));
  return result;
}

std::string facts_of(const CaseResult& result) {
  std::string text = fmt::format("{}: Dashpad's finest result agrees with the reference to {:.0e}", result.id,
                                 result.reference_agreement);
  for (const auto& [solver, count] : result.gave_up)
    text += fmt::format("; {} gave up with {} of {} settings", solver, count, result.tried.at(solver));
  return text;
}

void print(const CaseResult& result) {
  fmt::print("\n{}\n", facts_of(result));
  fmt::print("{:<24} {:<36} {:>8} {:>8} {:>8} {:>9}\n", "solver", "setting", "force", "rebound", "largest",
             "us");
  for (const Measurement& m : result.measurements)
    if (!is_beaten(m, result.measurements, 1))
      fmt::print("{:<24} {:<36} {:>8.1e} {:>8.1e} {:>8.1e} {:>9.0f}{}\n", m.solver, m.setting,
                 m.errors.peak_force, m.errors.rebound_speed, m.errors.largest(), 1e6 * m.median(),
                 m.failures > 0 ? fmt::format("  gave up {} times", m.failures) : "");
  std::fflush(stdout);
}

void write_csv(const std::string& file, const std::vector<CaseResult>& results) {
  std::ofstream stream(file);
  for (const auto& [key, value] : machine_facts()) fmt::print(stream, "# {}: {}\n", key, value);
  fmt::print(stream,
             "# error_*: largest relative deviation over {} impact speeds\n"
             "# *_us: CPU time of one solution\n",
             speed_shares.size());
  for (const CaseResult& r : results) fmt::print(stream, "# {}\n", facts_of(r));
  fmt::print(stream,
             "case,solver,setting,error_force,error_penetration,error_rebound,failures,median_us,"
             "tenth_percentile_us,ninetieth_percentile_us,times_us\n");
  for (const CaseResult& r : results)
    for (const Measurement& m : r.measurements) {
      std::string times;
      for (const double time : m.times)
        times += fmt::format("{}{:.1f}", times.empty() ? "" : " ", 1e6 * time);
      fmt::print(stream, "{},{},{},{:.3e},{:.3e},{:.3e},{},{:.1f},{:.1f},{:.1f},{}\n", r.id, m.solver,
                 m.setting, m.errors.peak_force, m.errors.peak_penetration, m.errors.rebound_speed,
                 m.failures, 1e6 * m.median(), 1e6 * m.quantile(0.1), 1e6 * m.quantile(0.9), times);
    }
  stream.flush();
  if (!stream) throw std::runtime_error("cannot write " + file);
}

int compare_solvers(int count, char** arguments) {
  Settings settings;
  CLI::App app{"Work against precision: Dashpad and others side by side"};
  app.add_option("--case", settings.cases, "c1, c2, c3, v1, f1")->capture_default_str();
  app.add_option("--repetitions", settings.repetitions, "Timed solutions of each setting")
      ->check(CLI::Range(1, 10'000))
      ->capture_default_str();
  app.add_flag("--quick", settings.quick, "Few settings and a coarser reference, to see that it works");
  app.add_option("--csv", settings.csv, "File for all measurements");
  CLI11_PARSE(app, count, arguments);
  for (const auto& [key, value] : machine_facts()) fmt::print("{}: {}\n", key, value);
  std::vector<CaseResult> results;
  for (const std::string& id : settings.cases) {
    results.push_back(measure(id, settings));
    print(results.back());
  }
  if (!settings.csv.empty()) write_csv(settings.csv, results);
  return 0;
}

}  // namespace
}  // namespace dashpad::bench

int main(int count, char** arguments) {
  try {
    return dashpad::bench::compare_solvers(count, arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_work_precision: {}\n", error.what());
    return 1;
  }
}
