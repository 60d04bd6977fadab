#pragma once
/// What the programs of this folder share: which cases they take, on how many threads, and how they end.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "answers/case_kinds.hpp"

namespace dashpad::test {

struct CaseSettings {
  std::uint64_t cases = 1000, from = 1;
  unsigned threads = 1;
  double tolerance = 1e-3;
  std::string kind = "practice";
  bool all = false;
};

inline void add_tolerance(CLI::App& app, const std::string& name, double& tolerance,
                          const std::string& text) {
  app.add_option(name, tolerance, text)->check(CLI::Range(1e-8, 1e-2))->capture_default_str();
}

inline void add_options(CLI::App& app, CaseSettings& settings) {
  app.add_option("--cases", settings.cases, "Number of cases")->capture_default_str();
  app.add_option("--from", settings.from, "First seed")->capture_default_str();
  app.add_option("--kind", settings.kind, "Which cases are drawn")
      ->check(CLI::IsMember(names_of_case_kinds()))
      ->capture_default_str();
  app.add_option("--threads", settings.threads, "Threads")->check(CLI::Range(1, 256))->capture_default_str();
  add_tolerance(app, "--tolerance", settings.tolerance, "Of the answers");
  app.add_flag("--all", settings.all, "List every case, not only those with something to say");
}

/// `examine(findings, seed, impact)` for every case, each thread with findings of its own, copies of `none`,
/// which are added up.
template <class Findings, class Examine>
Findings over_cases(const CaseSettings& settings, const Findings& none, const Examine& examine) {
  std::vector<Findings> found(settings.threads, none);
  std::atomic<std::uint64_t> next = 0;
  const auto work = [&](Findings& mine) {
    for (std::uint64_t i = next++; i < settings.cases; i = next++)
      examine(mine, settings.from + i, draw_case(settings.kind, settings.from + i));
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < settings.threads; ++i) threads.emplace_back(work, std::ref(found[i]));
  work(found[0]);
  for (std::thread& thread : threads) thread.join();
  for (unsigned i = 1; i < settings.threads; ++i) found[0].add(std::move(found[i]));
  return std::move(found[0]);
}

/// `run(app, count, arguments)` adds its options, parses and works; it returns the exit code.
template <class Run>
int run_program(const char* name, const char* text, int count, char** arguments, const Run& run) {
  CLI::App app{text, name};
  try {
    return run(app, count, arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", name, error.what());
    return 2;
  }
}

}  // namespace dashpad::test
