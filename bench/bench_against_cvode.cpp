/// Work against precision, Dashpad and CVODE side by side in one run: for each solver and setting the true
/// error and the time, and at Dashpad's true errors how many times longer CVODE takes.
///
/// Error: largest relative deviation of peak force, peak penetration and rebound speed from a converged
/// reference, and the largest of that over impact speeds a few per cent apart, so that no setting shines by
/// chance. Reference: CVODE with far finer settings than any that compete; Dashpad's finest result says how
/// well it is known. Time: median CPU time of one solution at full speed. The repetitions go round all
/// settings in turn, so that whatever else the machine does falls on all of them alike.

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>

#include "cases.hpp"
#include "dashpad/impact/solve.hpp"
#include "fixed_run.hpp"
#include "machine.hpp"
#include "oracle/cvode_impact.hpp"
#include "work_precision.hpp"

namespace dashpad::bench {
namespace {

struct Settings {
  std::vector<std::string> cases{"c1", "c2", "c3"};
  int repetitions = 15;
  bool quick = false;
  std::string csv;
};

constexpr std::array speed_shares{0.96, 0.98, 1.0, 1.02, 1.04};

// CVODE twice: with the best of all settings for each error, which only hindsight knows, and with the columns
// that the oracle has by itself.
constexpr const char* tuned = "cvode";
constexpr const char* untuned = "cvode, own columns";

ImpactCase at_speed(ImpactCase impact, double share) {
  impact.impactor.speed *= share;
  return impact;
}

// --- The solvers ---

std::optional<Outcome> by_dashpad(const ImpactCase& impact, double tolerance) {
  Options options;
  options.tolerance = tolerance;
  const Summary s = solve(impact, options).summary;
  if (!s.trustworthy() || !s.peak_force || !s.rebound_speed) return std::nullopt;
  return Outcome{*s.peak_force, s.peak_penetration, *s.rebound_speed};
}

std::optional<Outcome> by_march(const ImpactCase& impact, double resolution, bool extrapolated) {
  static Track track;
  const Figures figures = fixed_run(impact, resolution, extrapolated, track);
  if (!figures.release) return std::nullopt;
  return Outcome{figures.peak_force, figures.peak_penetration, std::abs(figures.release->velocity)};
}

std::optional<Outcome> by_cvode(const ImpactCase& impact, const oracle::CvodeOptions& options) {
  const oracle::CvodeImpact result = solve_with_cvode(impact, options);
  if (result.ending != oracle::Ending::released || !result.release) return std::nullopt;
  return Outcome{result.peak_force, result.peak_penetration, std::abs(result.release->velocity)};
}

// --- The settings that compete ---

std::vector<Contender> dashpad_contenders(const ImpactCase& impact) {
  std::vector<Contender> contenders;
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
    contenders.push_back({"dashpad", fmt::format("tolerance {:.0e}", tolerance),
                          [=](double share) { return by_dashpad(at_speed(impact, share), tolerance); }});
  for (const bool extrapolated : {false, true})
    for (const double resolution : {0.4, 0.2, 0.1, 0.05, 0.025})
      contenders.push_back(
          {"march",
           fmt::format("resolution {}{}", resolution, extrapolated ? " and twice that, extrapolated" : ""),
           [=](double share) { return by_march(at_speed(impact, share), resolution, extrapolated); }});
  return contenders;
}

Contender cvode_contender(const char* solver, const ImpactCase& impact, const oracle::CvodeOptions& options) {
  return {solver,
          fmt::format("{}+{} columns, edge {}, rtol {:.0e}", options.loading_columns,
                      options.unloading_columns, options.edge_power, options.rtol),
          [=](double share) { return by_cvode(at_speed(impact, share), options); }};
}

std::vector<Contender> cvode_contenders(const ImpactCase& impact, bool quick) {
  std::vector<int> loading{8, 12, 16, 24, 32, 48};
  std::vector<int> unloading{24, 40, 80, 160, 320, 640};
  std::vector<double> tolerances{1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9};
  std::vector<double> edges{3, 5};
  if (quick) loading = {12, 24}, unloading = {40, 160}, tolerances = {1e-4, 1e-6}, edges = {5};
  std::vector<Contender> contenders;
  for (const double tolerance : tolerances) {
    oracle::CvodeOptions options;
    options.rtol = tolerance;
    contenders.push_back(cvode_contender(untuned, impact, options));
    for (const int loads : loading)
      for (const int unloads : unloading)
        for (const double edge : edges) {
          options.loading_columns = loads;
          options.unloading_columns = unloads;
          options.edge_power = edge;
          contenders.push_back(cvode_contender(tuned, impact, options));
        }
  }
  return contenders;
}

Outcome reference_of(const ImpactCase& impact, bool quick) {
  oracle::CvodeOptions options;
  options.loading_columns = 64;
  options.unloading_columns = quick ? 640 : 2560;
  options.rtol = quick ? 1e-10 : 1e-11;
  const auto outcome = by_cvode(impact, options);
  if (!outcome) throw std::runtime_error("CVODE gave up on the reference solution");
  return *outcome;
}

// --- Measuring ---

using References = std::map<double, Outcome>;

/// Error and a first time. Absent for a setting that gives up at full speed.
std::optional<Measurement> judge(const Contender& contender, const References& references) {
  Measurement m;
  m.solver = contender.solver;
  m.setting = contender.setting;
  for (const auto& [share, reference] : references) {
    const double start = thread_time();
    const auto outcome = contender.solve(share);
    const double spent = thread_time() - start;
    if (share == 1) m.times.push_back(spent);
    if (!outcome) {
      if (share == 1) return std::nullopt;
      ++m.failures;
      continue;
    }
    m.error = std::max(m.error, deviation(*outcome, reference));
  }
  return m;
}

/// Settings of CVODE that are far from its front are not worth timing.
bool worth_timing(const Measurement& m, const std::vector<Measurement>& all) {
  constexpr double margin = 1.5;
  return m.solver != tuned || std::none_of(all.begin(), all.end(), [&](const Measurement& other) {
           return other.solver == m.solver && other.error <= m.error && margin * other.times[0] < m.times[0];
         });
}

struct CaseResult {
  std::string id;
  double reference_agreement = 0;  ///< of Dashpad's finest result with the reference
  std::size_t gave_up = 0;         ///< settings of CVODE
  std::size_t tried = 0;
  std::vector<Measurement> measurements;
};

CaseResult measure(const std::string& id, const Settings& settings) {
  const ImpactCase impact = impact_of(id);
  CaseResult result;
  result.id = id;
  References references;
  for (const double share : speed_shares)
    references[share] = reference_of(at_speed(impact, share), settings.quick);
  const auto finest = by_dashpad(impact, 1e-6);
  result.reference_agreement = finest ? deviation(*finest, references.at(1)) : NAN;

  std::vector<Contender> contenders = dashpad_contenders(impact);
  for (Contender& c : cvode_contenders(impact, settings.quick)) contenders.push_back(std::move(c));
  std::vector<Measurement> judged;
  std::vector<const Contender*> judged_contenders;
  for (const Contender& contender : contenders) {
    if (contender.solver == tuned) ++result.tried;
    if (auto m = judge(contender, references)) {
      judged.push_back(std::move(*m));
      judged_contenders.push_back(&contender);
    } else if (contender.solver == tuned) {
      ++result.gave_up;
    }
  }
  std::vector<const Contender*> timed;
  for (std::size_t i = 0; i < judged.size(); ++i)
    if (worth_timing(judged[i], judged)) {
      result.measurements.push_back(judged[i]);
      timed.push_back(judged_contenders[i]);
    }
  for (Measurement& m : result.measurements) m.times.clear();  // they were the warm-up
  for (int round = 0; round < settings.repetitions; ++round)
    for (std::size_t i = 0; i < timed.size(); ++i) result.measurements[i].times.push_back(time_of(*timed[i]));
  mark_fronts(result.measurements);
  return result;
}

// --- Writing ---

std::string in_microseconds(double time) { return fmt::format("{:.0f}", 1e6 * time); }

/// Columns "time" and "ratio" of a solver at the error of a measurement that took `time`.
std::string against(const std::vector<Measurement>& all, const char* solver, double error, double time) {
  const FrontTime other = time_on_front(all, solver, error);
  const std::string relation = other.relation == '=' ? "" : std::string(1, other.relation);
  return fmt::format("{:>10} {:>7}", relation + in_microseconds(other.time),
                     fmt::format("{}{:.1f}", relation, other.time / time));
}

void print(const CaseResult& result) {
  const auto& all = result.measurements;
  fmt::print(
      "\n{}: Dashpad's finest result agrees with the reference to {:.0e}; CVODE gave up with {} of {} "
      "settings\n",
      result.id, result.reference_agreement, result.gave_up, result.tried);
  fmt::print("{:<61} {:>21} {:>18}\n", "", "CVODE at that error:", "own columns:");
  fmt::print("{:<8} {:<46} {:>8} {:>7} {:>10} {:>7} {:>10} {:>7}\n", "solver", "setting", "error", "us", "us",
             "ratio", "us", "ratio");
  for (const Measurement& m : all) {
    if (m.solver == tuned || m.solver == untuned) continue;
    fmt::print("{:<8} {:<46} {:>8.1e} {:>7} {} {}{}\n", m.solver, m.setting, m.error,
               in_microseconds(m.median()), against(all, tuned, m.error, m.median()),
               against(all, untuned, m.error, m.median()),
               m.failures > 0 ? fmt::format("  gave up at {} speeds", m.failures) : "");
  }
  for (const double error : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const FrontTime march = time_on_front(all, "march", error);
    if (march.relation == '=')
      fmt::print("{:<8} {:<46} {:>8.1e} {:>7} {} {}\n", "march", "front, at", error,
                 in_microseconds(march.time), against(all, tuned, error, march.time),
                 against(all, untuned, error, march.time));
  }
  for (const char* solver : {tuned, untuned}) {
    std::vector<const Measurement*> front;
    for (const Measurement& m : all)
      if (m.solver == solver && m.on_front) front.push_back(&m);
    std::sort(front.begin(), front.end(),
              [](const auto* a, const auto* b) { return a->median() < b->median(); });
    fmt::print("front of {}:\n", solver);
    for (const Measurement* m : front)
      fmt::print("{:<8} {:<46} {:>8.1e} {:>7}\n", "", m->setting, m->error, in_microseconds(m->median()));
  }
  std::fflush(stdout);
}

void write_csv(const std::string& file, const std::vector<CaseResult>& results) {
  std::ofstream stream(file);
  for (const auto& [key, value] : machine_facts()) fmt::print(stream, "# {}: {}\n", key, value);
  fmt::print(stream,
             "# error: largest relative deviation of peak force, peak penetration and rebound speed, over {} "
             "impact speeds\n# times: CPU time of one solution, us, one a repetition\n",
             speed_shares.size());
  for (const CaseResult& r : results)
    fmt::print(stream, "# {}: Dashpad's finest result agrees with the reference to {:.1e}\n", r.id,
               r.reference_agreement);
  fmt::print(stream,
             "case,solver,setting,error,failed_speeds,on_front,median_us,tenth_percentile_us,ninetieth_"
             "percentile_us,"
             "times_us\n");
  for (const CaseResult& r : results)
    for (const Measurement& m : r.measurements) {
      std::string times;
      for (const double time : m.times)
        times += fmt::format("{}{:.1f}", times.empty() ? "" : " ", 1e6 * time);
      fmt::print(stream, "{},\"{}\",\"{}\",{:.3e},{},{:d},{:.1f},{:.1f},{:.1f},{}\n", r.id, m.solver,
                 m.setting, m.error, m.failures, m.on_front, 1e6 * m.median(), 1e6 * m.quantile(0.1),
                 1e6 * m.quantile(0.9), times);
    }
  stream.flush();
  if (!stream) throw std::runtime_error("cannot write " + file);
}

int compare_solvers(int count, char** arguments) {
  Settings settings;
  CLI::App app{"Work against precision: Dashpad and CVODE side by side"};
  app.add_option("--case", settings.cases, "Reference cases to solve")->capture_default_str();
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
    fmt::print(stderr, "bench_against_cvode: {}\n", error.what());
    return 1;
  }
}
