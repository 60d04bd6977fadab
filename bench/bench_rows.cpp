/// Processor time of a row of a study, by kind of case: an impact with its injury figures on one thread, at
/// the tolerance of studies and at a tenth of it, over speeds or stresses around those of an example.
///
/// With --against the same program of another commit is timed in turn with this one, so that both meet the
/// same machine; the table has their medians.

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/input/case_file.hpp"
#include "machine.hpp"

namespace dashpad::bench {
namespace {

constexpr std::array tolerances{1e-3, 1e-4};

struct Kind {
  const char* name;
  const char* example;
  std::vector<std::string> changes = {};  ///< as --set of the command
  double scale = 0;  ///< of the example: it is varied by 10 % to both sides; 0: the speed is, by 3 %
};
const std::vector<Kind> kinds{
    {"two layers below a sphere", "playground-mat-in-layers"},
    {"post on bumper", "post-on-bumper"},
    {"head on a pillar", "head-on-a-pillar"},
    {"head on a pillar, stress varied", "head-on-a-pillar", {}, 2.5},
    {"helmet on an anvil", "helmet-on-anvil"},
    {"helmet on an anvil, stress varied", "helmet-on-anvil", {}, 8.75},
    {"head on a door panel", "head-on-door-panel"},
    {"foam nearly flat", "helmet-pad-10fps", {"pad.thickness=25 mm", "impactor.speed=20 mph"}},
    {"helmet pad at 10 ft/s", "helmet-pad-10fps"},
    {"law 5, dashboard", "dashboard-20mph-21-parameter"},
    {"law 4, dashboard", "dashboard-20mph"},
};

/// Milliseconds a row, by kind and tolerance.
using Times = std::map<std::string, std::array<double, tolerances.size()>>;

/// The cases of the rows.
std::vector<ImpactCase> cases_of(const Kind& kind) {
  constexpr int places = 20;
  const std::string folder = DASHPAD_SOURCE_DIR;
  std::vector<ImpactCase> cases;
  for (int k = 0; k < places; ++k) {
    const double share = 2.0 * k / (places - 1) - 1;
    std::vector<std::string> changes = kind.changes;
    if (kind.scale > 0) changes.push_back(fmt::format("pad.scale={}", kind.scale * (1 + 0.1 * share)));
    auto read =
        input::read_case(folder + "/examples/" + kind.example + ".toml", folder + "/materials", changes);
    if (!read) throw std::runtime_error(fmt::format("{} cannot be read", kind.example));
    if (kind.scale == 0) read->impact.impactor.speed *= 1 + 0.03 * share;
    cases.push_back(std::move(read->impact));
  }
  return cases;
}

/// Mean time of a row, ms, over rows that take `least` s together.
double time_of_row(const std::vector<ImpactCase>& cases, double tolerance, double least) {
  Solver solver;
  int rows = 0;
  const double begun = thread_time();
  do {
    for (const ImpactCase& impact : cases) {
      if (!injury::whole_pulse_figures(solver.solve(impact, {.tolerance = tolerance})))
        throw std::runtime_error("an impact has no whole pulse");
      ++rows;
    }
  } while (thread_time() - begun < least);
  return 1e3 * (thread_time() - begun) / rows;
}

Times measured(double least) {
  Times times;
  for (const Kind& kind : kinds) {
    const std::vector<ImpactCase> cases = cases_of(kind);
    for (std::size_t i = 0; i < tolerances.size(); ++i)
      times[kind.name][i] = time_of_row(cases, tolerances[i], least);
  }
  return times;
}

/// What another build of this program prints with --raw.
Times measured_by(const std::string& program, double least) {
  const std::string command = fmt::format("'{}' --raw --least {}", program, least);
  const std::unique_ptr<FILE, int (*)(FILE*)> output(popen(command.c_str(), "r"), pclose);
  Times times;
  std::array<char, 256> line{};
  while (output && std::fgets(line.data(), line.size(), output.get())) {
    const std::string text = line.data();
    const std::size_t end = text.find(';');
    if (end == std::string::npos) continue;
    auto& of = times[text.substr(0, end)];
    if (std::sscanf(text.c_str() + end, ";%lf;%lf", &of[0], &of[1]) != 2)
      throw std::runtime_error(fmt::format("{} printed {}", program, text));
  }
  if (times.empty()) throw std::runtime_error(fmt::format("{} printed nothing", program));
  return times;
}

double median_of(const std::vector<Times>& passes, const std::string& kind, std::size_t tolerance) {
  std::vector<double> values;
  for (const Times& pass : passes)
    if (const auto found = pass.find(kind); found != pass.end()) values.push_back(found->second[tolerance]);
  if (values.empty()) return 0;
  std::ranges::nth_element(values, values.begin() + std::ssize(values) / 2);
  return values[values.size() / 2];
}

void print_table(const std::vector<Times>& now, const std::vector<Times>& before) {
  for (const auto& [key, value] : machine_facts()) fmt::print("{}: {}\n", key, value);
  fmt::print("\n| case | 1e-3 | before | ratio | 1e-4 | before | ratio | 1e-4 over 1e-3 |\n");
  fmt::print("|---|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const Kind& kind : kinds) {
    fmt::print("| {} |", kind.name);
    for (std::size_t i = 0; i < tolerances.size(); ++i) {
      const double time = median_of(now, kind.name, i), earlier = median_of(before, kind.name, i);
      fmt::print(" {:.3g} ms |", time);
      if (earlier > 0)
        fmt::print(" {:.3g} ms | {:.2f} |", earlier, time / earlier);
      else
        fmt::print(" - | - |");
    }
    fmt::print(" {:.1f} |\n", median_of(now, kind.name, 1) / median_of(now, kind.name, 0));
  }
}

}  // namespace
}  // namespace dashpad::bench

int main(int argc, char** argv) {
  using namespace dashpad::bench;
  CLI::App app("Processor time of a row of a study, by kind of case", "bench_rows");
  std::string other;
  int passes = 5;
  double least = 0.1;
  bool raw = false;
  app.add_option("--against", other, "This program of another commit, timed in turn with this one");
  app.add_option("--passes", passes, "Passes, of which the table has the medians")->check(CLI::Range(1, 100));
  app.add_option("--least", least, "Least time of a case in a pass, s")->check(CLI::Range(0.001, 100.0));
  app.add_flag("--raw", raw, "One pass, as kind;ms at 1e-3;ms at 1e-4");
  CLI11_PARSE(app, argc, argv);
  try {
    if (raw) {
      for (const auto& [kind, times] : measured(least)) fmt::print("{};{};{}\n", kind, times[0], times[1]);
      return 0;
    }
    std::vector<Times> now, before;
    for (int i = 0; i < passes; ++i) {
      now.push_back(measured(least));
      if (!other.empty()) before.push_back(measured_by(other, least));
    }
    print_table(now, before);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_rows: %s\n", error.what());
    return 1;
  }
}
