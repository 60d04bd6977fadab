/// The fast path against the plain one over many random cases (property/path_comparison.hpp).
///
///   compare_paths --cases 100000 --threads 2             ordinary cases, the seeds 1 to 100000
///   compare_paths --extreme --from 1234 --cases 1 --all  one case again, printed whatever it gives

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "dashpad/pad/law.hpp"
#include "property/path_comparison.hpp"
#include "property/random_case.hpp"

namespace dashpad::test {
namespace {

struct Settings {
  std::uint64_t cases = 1000;
  std::uint64_t from = 1;
  unsigned threads = 1;
  double tolerance = 1e-3;
  std::size_t most_steps = 3000;
  bool extreme = false;
  bool all = false;
};

struct Row {
  std::uint64_t seed = 0;
  std::string case_kind;  ///< law and support
  PathComparison paths;
};

std::string kind_of(const ImpactCase& impact) {
  const Support& support = impact.support;
  const char* name = support.is_rigid() ? "rigid" : support.points().size() == 1 ? "linear" : "curved";
  return fmt::format("{}, {} support", name_of(impact.pad.material.law), name);
}

struct FigureCount {
  std::uint64_t compared = 0, beyond_tolerance = 0, beyond_twice = 0, unexplained = 0, both = 0;
  double largest = 0;
  void add(const PathFigure& figure, double tolerance) {
    ++compared;
    beyond_tolerance += figure.difference > tolerance;
    beyond_twice += !figure.alike(tolerance);
    unexplained += !figure.explained();
    both += figure.difference > tolerance && !figure.explained();
    largest = std::max(largest, figure.difference);
  }
};

/// What one thread finds; all of them together are the answer.
struct Findings {
  std::map<std::string, FigureCount> figures;
  std::map<std::string, std::uint64_t> status;
  std::vector<Row> listed;
  std::uint64_t compared = 0, different = 0, other_status = 0;
  double fast_time = 0, plain_time = 0;

  void add(Row row, const Settings& settings) {
    const PathComparison& p = row.paths;
    fast_time += p.fast_time, plain_time += p.plain_time;
    const bool same = p.fast == p.plain;
    other_status += !same;
    ++status[same ? to_string(p.fast) : fmt::format("{} / {}", to_string(p.fast), to_string(p.plain))];
    compared += p.compared();
    for (const PathFigure& figure : p.figures) figures[figure.name].add(figure, settings.tolerance);
    const bool alike = p.alike(settings.tolerance);
    different += !alike;
    if (!same || !alike || settings.all) listed.push_back(std::move(row));
  }
  void add(Findings&& other) {
    for (const auto& [name, count] : other.status) status[name] += count;
    for (const auto& [name, c] : other.figures) {
      FigureCount& sum = figures[name];
      sum.compared += c.compared, sum.beyond_tolerance += c.beyond_tolerance;
      sum.beyond_twice += c.beyond_twice, sum.unexplained += c.unexplained, sum.both += c.both;
      sum.largest = std::max(sum.largest, c.largest);
    }
    std::ranges::move(other.listed, std::back_inserter(listed));
    compared += other.compared, different += other.different, other_status += other.other_status;
    fast_time += other.fast_time, plain_time += other.plain_time;
  }
};

Findings compare_all(const Settings& settings) {
  std::vector<Findings> found(settings.threads);
  std::atomic<std::uint64_t> next = 0;
  const auto work = [&](Findings& mine) {
    Solver solver;
    for (std::uint64_t i = next++; i < settings.cases; i = next++) {
      const std::uint64_t seed = settings.from + i;
      const ImpactCase impact = settings.extreme ? random_case(seed) : ordinary_case(seed);
      mine.add(
          {seed, kind_of(impact), compare_paths(solver, impact, settings.tolerance, settings.most_steps)},
          settings);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < settings.threads; ++i) threads.emplace_back(work, std::ref(found[i]));
  work(found[0]);
  for (std::thread& thread : threads) thread.join();
  for (unsigned i = 1; i < settings.threads; ++i) found[0].add(std::move(found[i]));
  std::ranges::sort(found[0].listed, {}, &Row::seed);
  return std::move(found[0]);
}

void print(const Settings& settings, const Findings& found) {
  for (const Row& row : found.listed) fmt::print("{} ({}): {}\n", row.seed, row.case_kind, row.paths.text());
  fmt::print("{} cases from seed {}, {}, tolerance {:.0e}; CPU time {:.1f} s fast, {:.1f} s plain\n",
             settings.cases, settings.from, settings.extreme ? "extreme" : "ordinary", settings.tolerance,
             found.fast_time, found.plain_time);
  fmt::print("compared {}; {} differ by more than twice the tolerance; {} differ in status\n", found.compared,
             found.different, found.other_status);
  for (const auto& [name, count] : found.status) fmt::print("  {:40} {:8}\n", name, count);
  fmt::print(
      "differences             compared  > tolerance  > twice  > estimates  > tolerance and estimates"
      "   largest\n");
  for (const auto& [name, c] : found.figures)
    fmt::print("  {:20} {:9} {:12} {:8} {:12} {:26} {:9.1e}\n", name, c.compared, c.beyond_tolerance,
               c.beyond_twice, c.unexplained, c.both, c.largest);
}

int run(int count, char** arguments) {
  Settings settings;
  CLI::App app{"The fast path of the solver against the plain one over random cases; 1 if they differ"};
  app.add_option("--cases", settings.cases, "Number of cases")->capture_default_str();
  app.add_option("--from", settings.from, "First seed")->capture_default_str();
  app.add_option("--threads", settings.threads, "Threads")->check(CLI::Range(1, 256))->capture_default_str();
  app.add_option("--tolerance", settings.tolerance, "Of both paths")
      ->check(CLI::Range(1e-8, 1e-2))
      ->capture_default_str();
  app.add_option("--most-steps", settings.most_steps, "Of one run")->capture_default_str();
  app.add_flag("--extreme", settings.extreme, "Cases of extreme ratios in place of ordinary ones");
  app.add_flag("--all", settings.all, "Print every case, not only those that differ");
  CLI11_PARSE(app, count, arguments);
  const Findings found = compare_all(settings);
  print(settings, found);
  return found.different == 0 ? 0 : 1;
}

}  // namespace
}  // namespace dashpad::test

int main(int count, char** arguments) {
  try {
    return dashpad::test::run(count, arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "compare_paths: {}\n", error.what());
    return 2;
  }
}
