/// The solver against the oracle of the tests (oracle/any_impact.hpp), which shares nothing with it but the
/// numbers of the case, over random cases.
///
///   compare_with_oracle --kind practice --cases 200 --tolerance 1e-4
///
/// or one case file (--file CASE.toml), lists the blows of which a figure is off by more than the tolerance,
/// or of a pulse by more than its estimate, what the oracle does not cover, and a table by figure. Exit code
/// 1 where more than --most figures are off or fewer than --least were compared.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "answers/answer_figures.hpp"
#include "answers/processor_time.hpp"
#include "answers/program.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/input/case_file.hpp"
#include "oracle/any_impact.hpp"

namespace dashpad::test {
namespace {

using Ending = oracle::AnyImpact::Ending;

struct Settings : CaseSettings {
  std::uint64_t most = 0, least = 0;
  oracle::AnyOptions oracle;
  std::string file;
};

/// The oracle may itself be off by so much of the tolerance.
constexpr double own_error = 0.1;

/// The oracle's figures by the names of answer_figures.hpp.
std::map<std::string, double> figures_of(const oracle::AnyImpact& any_impact) {
  std::map<std::string, double> all;
  const auto add = [&](const char* time, const char* velocity, const std::optional<Moment>& moment) {
    if (moment) all[time] = moment->time, all[velocity] = moment->velocity;
  };
  add("bottoming", "speed at bottoming", any_impact.bottomed);
  if (any_impact.ending == Ending::bottomed_out) return all;
  all["peak force"] = any_impact.peak_force, all["peak motion"] = any_impact.peak_motion;
  all["peak penetration"] = any_impact.peak_penetration,
  all["transmitted force"] = any_impact.peak_transmitted;
  all["deflection"] = any_impact.peak_deflection, all["set"] = any_impact.set;
  if (any_impact.ending == Ending::at_rest) return all;
  all["rebound speed"] = any_impact.rebound_speed, all["body speed"] = any_impact.body_speed;
  add("end of contact", "speed at end of contact", any_impact.contact_end);
  add("force below weight", "speed, force below weight", any_impact.force_below_weight);
  if (any_impact.absorbed) all["absorbed energy"] = *any_impact.absorbed;
  if (any_impact.hic15) all["HIC15"] = *any_impact.hic15, all["HIC36"] = *any_impact.hic36;
  return all;
}

struct FigureCount {
  std::uint64_t compared = 0, off = 0, beyond_estimate = 0;
  double worst = 0;
  bool held = true;
};

/// What one thread finds; all of them together are the count.
struct Findings {
  std::uint64_t blows = 0, blows_off = 0, asked_again = 0, longest_seed = 0;
  double seconds = 0, oracle_seconds = 0, longest = 0;
  std::map<std::string, FigureCount> figures;
  std::map<std::string, std::uint64_t> left_out;

  void add(const Findings& other) {
    blows += other.blows, blows_off += other.blows_off, asked_again += other.asked_again;
    seconds += other.seconds, oracle_seconds += other.oracle_seconds;
    if (other.longest > longest) longest = other.longest, longest_seed = other.longest_seed;
    for (const auto& [reason, count] : other.left_out) left_out[reason] += count;
    for (const auto& [name, c] : other.figures) {
      FigureCount& sum = figures[name];
      sum.compared += c.compared, sum.off += c.off, sum.beyond_estimate += c.beyond_estimate;
      sum.worst = std::max(sum.worst, c.worst), sum.held = c.held;
    }
  }
};

class Comparison {
 public:
  Comparison(const Settings& settings, std::uint64_t seed, Findings& findings)
      : settings_(settings), seed_(seed), findings_(findings) {}

  void run(const ImpactCase& impact) {
    double begin = processor_seconds();
    const std::vector<Blow> blows = solve_blows(impact, {.tolerance = settings_.tolerance});
    seconds_ = processor_seconds() - begin;
    findings_.seconds += seconds_;
    for (const Blow& blow : blows) {
      begin = processor_seconds();
      const Summary& summary = blow.solution.summary;
      Compared found = compare(blow, settings_.oracle);
      // Of what is off it is the oracle that may have too few columns.
      if (!found.off.empty() && summary.trustworthy()) {
        ++findings_.asked_again;
        oracle::AnyOptions finer = settings_.oracle;
        finer.fineness *= 2, finer.max_seconds *= 8;
        if (Compared again = compare(blow, finer); again.why_not.empty()) found = std::move(again);
      }
      oracle_seconds_ = processor_seconds() - begin;
      findings_.oracle_seconds += oracle_seconds_;
      if (oracle_seconds_ > findings_.longest)
        findings_.longest = oracle_seconds_, findings_.longest_seed = seed_;
      // What the solver itself is not sure of is shown, and not counted.
      if (!summary.trustworthy()) found.why_not = "the solver: " + to_string(summary.status);
      Findings of_blow;
      if (found.why_not.empty())
        of_blow.blows = 1, of_blow.blows_off = !found.off.empty(), of_blow.figures = found.figures;
      else
        of_blow.left_out[found.why_not] = 1;
      findings_.add(of_blow);
      say(blow, found);
    }
  }

 private:
  struct Compared {
    std::map<std::string, FigureCount> figures;
    std::string off;      ///< in words
    std::string why_not;  ///< they do not count; "" where they do
  };

  [[nodiscard]] Compared compare(const Blow& blow, const oracle::AnyOptions& options) const {
    Compared none;
    try {
      const oracle::AnyImpact truth = oracle::solve_any(blow.impact, options);
      if (truth.ending != Ending::failed) return compare(blow, figures_of(truth));
      none.why_not = "the oracle failed";
    } catch (const std::invalid_argument& error) {
      none.why_not = error.what();
    }
    return none;
  }

  [[nodiscard]] Compared compare(const Blow& blow, const std::map<std::string, double>& truths) const {
    Compared found;
    const std::vector<AnswerFigure> figures = test::figures_of(blow.impact, blow.solution);
    const auto has = [&](const char* name) {
      return std::ranges::any_of(figures, [&](const AnswerFigure& answer_figure) {
        return std::string(answer_figure.name) == name;
      });
    };
    if (has("bottoming") != truths.contains("bottoming")) found.off += "  bottoming of one only";
    for (const AnswerFigure& figure : figures) {
      const auto truth = truths.find(figure.name);
      if (truth == truths.end()) continue;
      FigureCount& count = found.figures[figure.name];
      count.held = figure.allowed > 0;
      const double difference = std::abs(figure.value - truth->second) / figure.scale;
      const bool is_beyond = difference > figure.estimate + own_error * settings_.tolerance;
      const bool is_off =
          difference > settings_.tolerance * (count.held ? figure.allowed : 1) && (count.held || is_beyond);
      ++count.compared;
      count.beyond_estimate += is_beyond, count.off += is_off;
      count.worst = std::max(count.worst, difference);
      if (is_off)
        found.off += fmt::format("  {} {:.8g} / {:.8g} ({:.1e}, {:.2g} times its estimate)", figure.name,
                                 figure.value, truth->second, difference, difference / figure.estimate);
    }
    return found;
  }

  void say(const Blow& blow, const Compared& found) {
    if (found.off.empty() && !settings_.all && found.why_not != "the oracle failed") return;
    const Summary& s = blow.solution.summary;
    std::uint64_t compared = 0;
    for (const auto& [name, count] : found.figures) compared += count.compared;
    fmt::print("{} blow {} ({}): {}; {} figures; {:.1f} s, the oracle {:.1f} s{}{}{}\n", seed_, s.blow,
               words_of(blow.impact), to_string(s.status), compared, seconds_, oracle_seconds_,
               found.why_not.empty() ? "" : "; not counted: ", found.why_not, found.off);
  }

  const Settings& settings_;
  std::uint64_t seed_;
  Findings& findings_;
  double seconds_ = 0, oracle_seconds_ = 0;
};

/// Whether as many figures were compared and as few of those held to the tolerance are off as asked for.
bool print(const Settings& settings, const Findings& found) {
  fmt::print(
      "{} cases ({}) from seed {} at {:.0e}: {} blows compared ({} again, with twice the oracle's columns), "
      "{} of "
      "them off; {:.1f} s of processor time, the oracle {:.1f} s (longest {:.1f} s, seed {})\n",
      settings.cases, settings.kind, settings.from, settings.tolerance, found.blows, found.asked_again,
      found.blows_off, found.seconds, found.oracle_seconds, found.longest, found.longest_seed);
  for (const auto& [reason, count] : found.left_out) fmt::print("  not compared: {} ({})\n", count, reason);
  FigureCount held, pulse;
  for (const auto& [name, c] : found.figures) {
    fmt::print("  {:26} {:6} compared {:4} off {:4} beyond their estimate   worst {:.1e}{}\n", name,
               c.compared, c.off, c.beyond_estimate, c.worst, c.held ? "" : "   (not held to it)");
    FigureCount& sum = c.held ? held : pulse;
    sum.compared += c.compared, sum.off += c.off, sum.beyond_estimate += c.beyond_estimate;
  }
  fmt::print(
      "  of {} figures {} are off by more than {:.0e} and {} by more than their estimate; of {} of pulses "
      "{}\n",
      held.compared, held.off, settings.tolerance, held.beyond_estimate, pulse.compared,
      pulse.beyond_estimate);
  return held.off <= settings.most && held.compared >= settings.least;
}

int run(CLI::App& app, int count, char** arguments) {
  Settings settings;
  settings.cases = 200, settings.tolerance = 1e-4;
  add_options(app, settings);
  app.add_option("--most", settings.most, "Figures that may be off")->capture_default_str();
  app.add_option("--least", settings.least, "Figures that are compared")->capture_default_str();
  app.add_option("--oracle-error", settings.oracle.relative, "Of a step of the oracle")
      ->capture_default_str();
  app.add_option("--oracle-fineness", settings.oracle.fineness, "So many times its columns and panels")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  app.add_option("--oracle-seconds", settings.oracle.max_seconds, "After which a run of it is given up")
      ->capture_default_str();
  app.add_option("--file", settings.file, "A case file in the place of random cases")
      ->check(CLI::ExistingFile);
  app.parse(count, arguments);
  std::setvbuf(stdout, nullptr, _IOLBF, 1 << 12);  // long runs are read as they go
  Findings found;
  if (!settings.file.empty())
    Comparison(settings, 0, found)
        .run(input::read_case(settings.file, std::string(DASHPAD_SOURCE_DIR) + "/materials").value().impact);
  else
    found = over_cases(settings, found, [&](Findings& mine, std::uint64_t seed, const ImpactCase& impact) {
      Comparison(settings, seed, mine).run(impact);
    });
  return print(settings, found) ? 0 : 1;
}

}  // namespace
}  // namespace dashpad::test

int main(int count, char** arguments) {
  return dashpad::test::run_program(
      "compare_with_oracle",
      "The solver against the oracle over random cases; exit code 1 if more than --most figures are off",
      count, arguments, dashpad::test::run);
}
