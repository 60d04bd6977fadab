/// The solver's fast path against the plain one over many random cases (property/answer_comparison.hpp).
///
///   compare_answers --cases 100000 --threads 2
///
/// takes the ordinary cases of the seeds 1 to 100000;
///
///   compare_answers --kind extreme --from 1234 --cases 1 --all
///
/// repeats one case and prints it whatever it gives.

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

#include "answers/case_kinds.hpp"
#include "dashpad/model/pad/law.hpp"
#include "property/answer_comparison.hpp"

namespace dashpad::test {
namespace {

struct Settings {
  std::uint64_t cases = 1000;
  std::uint64_t from = 1;
  unsigned threads = 1;
  double tolerance = 1e-3;
  std::string kind = "ordinary";
  bool all = false;

  /// Of a figure: both answers may be in error by the tolerance.
  [[nodiscard]] double allowed() const { return 2 * tolerance; }
};

struct Row {
  std::uint64_t seed = 0;
  std::string case_kind;  ///< law and support
  AnswerComparison answers;
};

std::string kind_of(const ImpactCase& impact) {
  const Support& support = impact.support;
  const char* name = support.is_rigid() ? "rigid" : support.points().size() == 1 ? "linear" : "curved";
  return fmt::format("{}, {} support", name_of(impact.pad.material.law), name);
}

struct FigureCount {
  std::uint64_t compared = 0, beyond = 0, unexplained = 0, both = 0;
  double largest = 0;
  void add(const ComparedFigure& figure, double allowed) {
    ++compared;
    beyond += figure.difference > allowed;
    unexplained += !figure.explained();
    both += figure.difference > allowed && !figure.explained();
    largest = std::max(largest, figure.difference);
  }
};

/// What one thread finds; all of them together are the answer.
struct Findings {
  std::map<std::string, FigureCount> figures;
  std::map<std::string, std::uint64_t> status, unsolved;
  std::vector<Row> listed;
  std::uint64_t compared = 0, different = 0, other_status = 0;
  double time = 0, reference_time = 0;

  void add(Row row, const Settings& settings) {
    const AnswerComparison& a = row.answers;
    time += a.wall_time, reference_time += a.reference_time;
    const bool same = a.status == a.reference_status;
    other_status += !same;
    ++status[to_string(a.status)];
    if (a.status == Status::tolerance_not_met) ++unsolved[row.case_kind];
    compared += a.compared();
    for (const ComparedFigure& figure : a.figures) figures[figure.name].add(figure, settings.allowed());
    const bool alike = a.alike(settings.allowed());
    different += !alike;
    const bool solved = a.status != Status::tolerance_not_met;
    if (!same || !alike || !solved || settings.all) listed.push_back(std::move(row));
  }
  void add(Findings&& other) {
    for (const auto& [name, count] : other.status) status[name] += count;
    for (const auto& [name, count] : other.unsolved) unsolved[name] += count;
    for (const auto& [name, c] : other.figures) {
      FigureCount& sum = figures[name];
      sum.compared += c.compared, sum.beyond += c.beyond;
      sum.unexplained += c.unexplained, sum.both += c.both;
      sum.largest = std::max(sum.largest, c.largest);
    }
    std::ranges::move(other.listed, std::back_inserter(listed));
    compared += other.compared, different += other.different, other_status += other.other_status;
    time += other.time, reference_time += other.reference_time;
  }
};

Findings compare_all(const Settings& settings) {
  std::vector<Findings> found(settings.threads);
  std::atomic<std::uint64_t> next = 0;
  const auto work = [&](Findings& mine) {
    Solver solver;
    for (std::uint64_t i = next++; i < settings.cases; i = next++) {
      const std::uint64_t seed = settings.from + i;
      const ImpactCase impact = draw_case(settings.kind, seed);
      mine.add({seed, kind_of(impact), compare_paths(solver, impact, settings.tolerance)}, settings);
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
  for (const Row& row : found.listed)
    fmt::print("{} ({}): {}\n", row.seed, row.case_kind, row.answers.text());
  fmt::print(
      "{} {} cases from seed {}, tolerance {:.0e}, against the plain path; CPU time {:.1f} s and {:.1f} s\n",
      settings.cases, settings.kind, settings.from, settings.tolerance, found.time, found.reference_time);
  fmt::print("compared {}; {} differ by more than {:.0e}; {} differ in status\n", found.compared,
             found.different, settings.allowed(), found.other_status);
  for (const auto& [name, count] : found.status) fmt::print("  {:40} {:8}\n", name, count);
  for (const auto& [name, count] : found.unsolved)
    fmt::print("  tolerance not met: {:21} {:8}\n", name, count);
  fmt::print("differences             compared     beyond  > estimates  beyond and > estimates   largest\n");
  for (const auto& [name, c] : found.figures)
    fmt::print("  {:20} {:9} {:10} {:12} {:23} {:9.1e}\n", name, c.compared, c.beyond, c.unexplained, c.both,
               c.largest);
}

int run(int count, char** arguments) {
  Settings settings;
  CLI::App app{"Both paths of the solver over random cases; exit code 1 if they differ"};
  app.add_option("--cases", settings.cases, "Number of cases")->capture_default_str();
  app.add_option("--from", settings.from, "First seed")->capture_default_str();
  app.add_option("--kind", settings.kind, "Which cases are drawn")
      ->check(CLI::IsMember(names_of_case_kinds()))
      ->capture_default_str();
  app.add_option("--threads", settings.threads, "Threads")->check(CLI::Range(1, 256))->capture_default_str();
  app.add_option("--tolerance", settings.tolerance, "Of the answers")
      ->check(CLI::Range(1e-8, 1e-2))
      ->capture_default_str();
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
    fmt::print(stderr, "compare_answers: {}\n", error.what());
    return 2;
  }
}
