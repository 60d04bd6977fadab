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

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "answers/program.hpp"
#include "dashpad/model/pad/law.hpp"
#include "property/answer_comparison.hpp"

namespace dashpad::test {
namespace {

/// Of a figure: both answers may be in error by the tolerance.
double allowed(const CaseSettings& settings) { return 2 * settings.tolerance; }

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

  void add(Row row, const CaseSettings& settings) {
    const AnswerComparison& a = row.answers;
    time += a.wall_time, reference_time += a.reference_time;
    const bool same = a.status == a.reference_status;
    other_status += !same;
    ++status[to_string(a.status)];
    if (a.status == Status::tolerance_not_met) ++unsolved[row.case_kind];
    compared += a.compared();
    for (const ComparedFigure& figure : a.figures) figures[figure.name].add(figure, allowed(settings));
    const bool alike = a.alike(allowed(settings));
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

Findings compare_all(const CaseSettings& settings) {
  Findings found =
      over_cases(settings, Findings{}, [&](Findings& mine, std::uint64_t seed, const ImpactCase& impact) {
        thread_local Solver solver;
        mine.add({seed, kind_of(impact), compare_paths(solver, impact, settings.tolerance)}, settings);
      });
  std::ranges::sort(found.listed, {}, &Row::seed);
  return found;
}

void print(const CaseSettings& settings, const Findings& found) {
  for (const Row& row : found.listed)
    fmt::print("{} ({}): {}\n", row.seed, row.case_kind, row.answers.text());
  fmt::print(
      "{} {} cases from seed {}, tolerance {:.0e}, against the plain path; CPU time {:.1f} s and {:.1f} s\n",
      settings.cases, settings.kind, settings.from, settings.tolerance, found.time, found.reference_time);
  fmt::print("compared {}; {} differ by more than {:.0e}; {} differ in status\n", found.compared,
             found.different, allowed(settings), found.other_status);
  for (const auto& [name, count] : found.status) fmt::print("  {:40} {:8}\n", name, count);
  for (const auto& [name, count] : found.unsolved)
    fmt::print("  tolerance not met: {:21} {:8}\n", name, count);
  fmt::print("differences             compared     beyond  > estimates  beyond and > estimates   largest\n");
  for (const auto& [name, c] : found.figures)
    fmt::print("  {:20} {:9} {:10} {:12} {:23} {:9.1e}\n", name, c.compared, c.beyond, c.unexplained, c.both,
               c.largest);
}

int run(CLI::App& app, int count, char** arguments) {
  CaseSettings settings;
  settings.kind = "ordinary";
  add_options(app, settings);
  app.parse(count, arguments);
  const Findings found = compare_all(settings);
  print(settings, found);
  return found.different == 0 ? 0 : 1;
}

}  // namespace
}  // namespace dashpad::test

int main(int count, char** arguments) {
  return dashpad::test::run_program("compare_answers",
                                    "Both paths of the solver over random cases; exit code 1 if they differ",
                                    count, arguments, dashpad::test::run);
}
