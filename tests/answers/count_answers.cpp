/// How good the solver's answers are over many random cases: each is solved at a tolerance and again at a
/// finer one, whose figures stand for the truth.
///
///   count_answers --kind practice --cases 1000 --tolerance 1e-3
///
/// counts the figures that are off by more than the tolerance or by more than they state, answers that miss
/// the tolerance, ledgers that do not close, slow cases and exceptions, and lists the cases by what is wrong;
///
///   count_answers --kind practice --from 17 --cases 1 --all --write /tmp/cases
///
/// repeats one case, and writes it as a case file. Exit code 1 where the counts are above the goals below.

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "answers/answer_figures.hpp"
#include "answers/processor_time.hpp"
#include "answers/program.hpp"
#include "dashpad/impact/solve.hpp"
#include "output/text/case_toml.hpp"

namespace dashpad::test {
namespace {

// Goals: of figures held to the tolerance, of cases, and seconds of processor time a case.
constexpr double max_beyond_tolerance = 2e-4;
constexpr double max_not_met = 1e-3;
constexpr double max_not_met_of_practice = 1e-2;
constexpr double slow = 5;

/// A figure is listed from so many times its estimate on.
constexpr double listed_estimates = 3;

struct Settings : CaseSettings {
  double reference = 1e-5;
  std::string write;
};

struct Answer {
  std::vector<Blow> blows;
  double seconds = 0;  ///< of the processor
};

Answer answer_to(const ImpactCase& impact, double tolerance) {
  const double begin = processor_seconds();
  Answer answer{solve_blows(impact, {.tolerance = tolerance}), 0};
  answer.seconds = processor_seconds() - begin;
  return answer;
}

/// What is wrong with a case: a kind of fault, and the numbers.
struct Fault {
  std::string kind, text;
};

struct FigureCount {
  std::uint64_t compared = 0, beyond_tolerance = 0, beyond_estimate = 0, beyond_thrice = 0,
                without_reference = 0;
  double worst = 0;           ///< difference over what the tolerance allows
  double worst_estimate = 0;  ///< difference over the estimates
  bool held = true;

  void add(const FigureCount& other) {
    compared += other.compared, without_reference += other.without_reference;
    beyond_tolerance += other.beyond_tolerance;
    beyond_estimate += other.beyond_estimate, beyond_thrice += other.beyond_thrice;
    worst = std::max(worst, other.worst), worst_estimate = std::max(worst_estimate, other.worst_estimate);
    held = other.held;
  }
};

/// What one thread finds; all of them together are the count.
struct Findings {
  std::map<std::string, FigureCount> figures;
  std::map<std::string, std::uint64_t> statuses;
  /// By kind of fault, by seed.
  std::map<std::string, std::map<std::uint64_t, std::string>> faults;
  double seconds = 0, longest = 0, reference_seconds = 0;

  void add(const Findings& other) {
    for (const auto& [name, count] : other.figures) figures[name].add(count);
    for (const auto& [name, count] : other.statuses) statuses[name] += count;
    for (const auto& [kind, cases] : other.faults) faults[kind].insert(cases.begin(), cases.end());
    seconds += other.seconds, reference_seconds += other.reference_seconds;
    longest = std::max(longest, other.longest);
  }
};

const char* const not_met = "tolerance not met";
const char* const no_ledger = "ledger not closed";
const char* const too_slow = "slow";
const char* const thrown = "exception";

/// Why an answer missed the tolerance: its largest estimates.
std::string reasons(const ImpactCase& impact, const Solution& solution, double tolerance) {
  const EnergyLedger& energy = solution.summary.energy;
  std::string text =
      fmt::format("{} runs, residual {:.1e}", solution.summary.runs, energy.residual / energy.impact);
  for (const AnswerFigure& figure : figures_of(impact, solution))
    if (figure.allowed > 0 && !(figure.estimate < figure.allowed * tolerance))
      text += fmt::format(", {} {:.6g} ± {:.1e}", figure.name, figure.value, figure.estimate);
  return text;
}

class Examination {
 public:
  Examination(const Settings& settings, std::uint64_t seed, const ImpactCase& impact, Findings& findings)
      : settings_(settings), seed_(seed), findings_(findings), impact_(impact) {}

  void run() {
    try {
      const Answer answer = answer_to(impact_, settings_.tolerance);
      findings_.seconds += answer.seconds;
      findings_.longest = std::max(findings_.longest, answer.seconds);
      if (answer.seconds > slow) note(too_slow, fmt::format("{:.1f} s", answer.seconds));
      const Answer reference = answer_to(impact_, settings_.reference);
      findings_.reference_seconds += reference.seconds;
      judge(answer, reference);
    } catch (const std::exception& error) {
      note(thrown, error.what());
    }
    if (faults_.empty() && settings_.all) note("none", "");
    for (const Fault& fault : faults_) {
      std::string& text = findings_.faults[fault.kind][seed_];
      text += (text.empty() ? words_of(impact_) + ": " : "; ") + fault.text;
    }
    if (!faults_.empty() && !settings_.write.empty()) write();
  }

 private:
  void note(const char* kind, std::string text) { faults_.push_back({kind, std::move(text)}); }

  void judge(const Answer& answer, const Answer& reference) {
    for (std::size_t i = 0; i < answer.blows.size(); ++i) {
      const auto& [impact, solution] = answer.blows[i];
      const Summary& summary = solution.summary;
      ++findings_.statuses[to_string(summary.status)];
      if (!summary.trustworthy()) {
        note(not_met, reasons(impact, solution, settings_.tolerance));
        return;
      }
      const double residual = std::abs(summary.energy.residual) / summary.energy.impact;
      if (!(residual <= settings_.tolerance)) note(no_ledger, fmt::format("{:.1e}", residual));
      if (i >= reference.blows.size()) return;
      const Solution& truth = reference.blows[i].solution;
      if (!truth.summary.trustworthy()) ++findings_.statuses["finer answer: tolerance not met"];
      if (truth.summary.trustworthy() && truth.summary.status != summary.status)
        note("other status", to_string(summary.status) + " / " + to_string(truth.summary.status));
      else
        compare(figures_of(impact, solution), figures_of(impact, truth), truth.summary.trustworthy());
    }
  }

  void compare(const std::vector<AnswerFigure>& figures, const std::vector<AnswerFigure>& truths, bool sure) {
    for (const AnswerFigure& figure : figures) {
      FigureCount& count = findings_.figures[figure.name];
      count.held = figure.allowed > 0;
      const double allowed = settings_.tolerance * (count.held ? figure.allowed : 1);
      const auto truth = std::ranges::find(truths, std::string_view(figure.name),
                                           [](const AnswerFigure& f) { return std::string_view(f.name); });
      if (truth == truths.end()) {
        if (sure && count.held) note("figure of one answer only", figure.name);
        continue;
      }
      if (!(truth->estimate <= 0.3 * allowed)) {
        ++count.without_reference;
        continue;
      }
      ++count.compared;
      const double difference = std::abs(figure.value - truth->value) / truth->scale;
      const double stated = figure.estimate + truth->estimate;
      const double times = difference == 0 ? 0 : difference / stated;
      count.beyond_tolerance += difference > allowed;
      count.beyond_estimate += times > 1, count.beyond_thrice += times > listed_estimates;
      count.worst = std::max(count.worst, difference / allowed);
      count.worst_estimate = std::max(count.worst_estimate, times);
      const auto text = [&] {
        return fmt::format("{} {:.8g} / {:.8g} ({:.1e}, {:.2g} times its estimate of {:.1e})", figure.name,
                           figure.value, truth->value, difference, times, figure.estimate);
      };
      if (count.held && difference > allowed) note("beyond the tolerance", text());
      if (times > listed_estimates)
        note(count.held ? "beyond its estimate" : "beyond its estimate, of the pulse", text());
    }
  }

  void write() const {
    const std::filesystem::path file =
        std::filesystem::path(settings_.write) / fmt::format("{}-{}.toml", settings_.kind, seed_);
    std::ofstream(file) << output::case_toml(impact_, {.tolerance = settings_.tolerance});
  }

  const Settings& settings_;
  std::uint64_t seed_;
  Findings& findings_;
  const ImpactCase& impact_;
  std::vector<Fault> faults_;
};

/// Prints a count against its goal; whether it is met.
bool meets(const char* what, std::uint64_t count, double most) {
  const bool met = static_cast<double>(count) <= most;
  fmt::print("  {:44} {:8}   goal: at most {:g}{}\n", what, count, std::floor(most), met ? "" : "   MISSED");
  return met;
}

/// Prints the table; whether the goals are met.
bool print(const Settings& settings, Findings& found) {
  for (const auto& [kind, cases] : found.faults) {
    fmt::print("## {}: {} cases\n\n", kind, cases.size());
    for (const auto& [seed, text] : cases) fmt::print("- {}: {}\n", seed, text);
    fmt::print("\n");
  }
  fmt::print(
      "{} cases ({}) from seed {}: tolerance {:.0e} against {:.0e}; {:.1f} s of processor time (longest "
      "{:.2f} s) and {:.1f} s\n",
      settings.cases, settings.kind, settings.from, settings.tolerance, settings.reference, found.seconds,
      found.longest, found.reference_seconds);
  for (const auto& [name, count] : found.statuses) fmt::print("  {:44} {:8}\n", name, count);
  fmt::print(
      "figures                     compared  no reference  > tolerance    worst  > estimate  > 3 times  most "
      "times\n");
  FigureCount held, pulse;
  for (const auto& [name, c] : found.figures) {
    fmt::print("  {:25} {:9} {:13} {:12} {:8.2g} {:11} {:10} {:11.2g}{}\n", name, c.compared,
               c.without_reference, c.beyond_tolerance, c.worst, c.beyond_estimate, c.beyond_thrice,
               c.worst_estimate, c.held ? "" : "   (not held to it)");
    (c.held ? held : pulse).add(c);
  }
  const auto cases = static_cast<double>(settings.cases);
  const double share = settings.kind == "practice" ? max_not_met_of_practice : max_not_met;
  bool met = meets("figures beyond the tolerance", held.beyond_tolerance,
                   max_beyond_tolerance * static_cast<double>(held.compared));
  met &= meets("tolerance not met", found.faults[not_met].size(), share * cases);
  met &= meets("ledger not closed", found.faults[no_ledger].size(), 0);
  met &= meets("more than 5 s of processor time", found.faults[too_slow].size(), 0);
  met &= meets("exceptions", found.faults[thrown].size(), 0);
  fmt::print("  of {} figures {} are beyond their estimate, of {} of pulses {}\n", held.compared,
             held.beyond_estimate, pulse.compared, pulse.beyond_estimate);
  return met;
}

int run(CLI::App& app, int count, char** arguments) {
  Settings settings;
  add_options(app, settings);
  add_tolerance(app, "--reference", settings.reference, "Tolerance of the finer answers");
  app.add_option("--write", settings.write, "Folder for the listed cases as case files")
      ->check(CLI::ExistingDirectory);
  app.parse(count, arguments);
  Findings found =
      over_cases(settings, Findings{}, [&](Findings& mine, std::uint64_t seed, const ImpactCase& impact) {
        Examination(settings, seed, impact, mine).run();
      });
  return print(settings, found) ? 0 : 1;
}

}  // namespace
}  // namespace dashpad::test

int main(int count, char** arguments) {
  return dashpad::test::run_program(
      "count_answers",
      "How good the solver's answers are over random cases; exit code 1 if the goals are missed", count,
      arguments, dashpad::test::run);
}
