#pragma once
/// What `dashpad fit` was asked for.

#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "dashpad/fit/report.hpp"
#include "output_files.hpp"
#include "progress_line.hpp"
#include "test_columns.hpp"

namespace dashpad::app {

struct FitRequest {
  std::vector<std::string> inputs;  ///< a fit file, or tests with --auto
  bool is_auto = false;
  TestColumnsRequest tests;
  OutputFiles files;
  std::optional<std::string> state;
  std::vector<std::string> posterior;  ///< N and FILE
  std::string materials;
};

/// 0 without --posterior, or after an error.
std::size_t draws_of(const FitRequest& request, std::vector<std::string>& errors);
std::vector<Target> fit_targets(const FitRequest& request);
/// Nothing but JSON is written of a fit that did not converge.
void drop_results(std::vector<Target>& targets);
/// "written: card.toml", a line each, and what a sample is.
std::string written_words(const FitRequest& request, const std::vector<Target>& targets,
                          const fit::FitReport& report);
/// Tells what a stopped fit left; returns its exit code.
int stopped(const FitRequest& request, std::size_t kept);

/// Calls `run` with the options, a progress line and a way to be stopped. Throws fit::Stopped.
template <class Run>
auto with_progress(fit::RunOptions options, const Run& run) {
  ProgressLine line{"Fitting", ProgressLine::Elsewhere::lines};
  options.stop = &StopSignal::wanted();
  options.progress = [&line](const char* what, std::size_t done, std::size_t all) {
    line.now(fmt::format("{} ({} of {})", what, done, all));
  };
  return run(options);
}

/// `dashpad fit --auto`.
int fit_automatically(const FitRequest& request);

}  // namespace dashpad::app
