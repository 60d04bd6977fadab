/// What a study costs: the installed or built command on bench/studies/law-4.toml and law-5.toml, with all
/// responses. Scaling: the same study on 1 to all cores, by threads and by MPI ranks. Size: 100 to a million
/// samples on all cores. Wall and CPU time and memory are those of whole processes, start and store included.

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <thread>

#include "machine.hpp"
#include "timed_process.hpp"

namespace dashpad::bench {
namespace {

namespace fs = std::filesystem;

struct Settings {
  std::string command = DASHPAD_COMMAND;
  std::int64_t scaling_samples = 20'000;
  std::int64_t max_samples = 1'000'000;
  int repetitions = 3;
  std::string csv;
};

/// One run of the command.
struct Job {
  std::string part;      ///< "scaling" or "samples"
  std::string study;     ///< "law-4" or "law-5"
  std::string launcher;  ///< "threads" or "ranks"
  int workers = 1;
  std::int64_t samples = 0;
};

struct Result {
  Job job;
  int repetition = 0;
  ProcessCost cost;
  double store = 0;  ///< bytes
};

/// A folder of its own for studies and stores, gone at the end.
class Scratch {
 public:
  Scratch() : path_(fs::temp_directory_path() / fmt::format("dashpad-bench-study-{}", now())) {
    fs::create_directories(path_);
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  static std::int64_t now() { return std::chrono::steady_clock::now().time_since_epoch().count(); }
  fs::path path_;
};

/// The study with another number of samples; its case by the full path.
fs::path write_study(const Job& job, const fs::path& folder) {
  const fs::path source = fs::path(DASHPAD_SOURCE_DIR) / "bench/studies";
  std::ifstream stream(source / (job.study + ".toml"));
  std::ostringstream text;
  text << stream.rdbuf();
  std::string study =
      std::regex_replace(text.str(), std::regex("samples = \\d+"), fmt::format("samples = {}", job.samples));
  study = std::regex_replace(study, std::regex("case = \"\\.\\./\\.\\."),
                             std::string("case = \"") + DASHPAD_SOURCE_DIR);
  const fs::path file = folder / "study.toml";
  std::ofstream(file) << study;
  return file;
}

Result run(const Job& job, int repetition, const std::string& command) {
  const Scratch scratch;
  const fs::path store = scratch.path() / "study.db";
  std::vector<std::string> arguments;
  if (job.launcher == "ranks")
    arguments = {"mpirun", "--oversubscribe", "--allow-run-as-root", "-n", std::to_string(job.workers)};
  for (const std::string& argument :
       {command, std::string("study"), write_study(job, scratch.path()).string(), std::string("--quiet"),
        std::string("--out"), store.string()})
    arguments.push_back(argument);
  if (job.launcher == "threads") {
    arguments.emplace_back("--threads");
    arguments.push_back(std::to_string(job.workers));
  }
  Result result{job, repetition, timed_process(arguments), 0};
  // 3: some rows miss the tolerance.
  if (result.cost.exit_code != 0 && result.cost.exit_code != 3)
    throw std::runtime_error(fmt::format("{} ended with exit code {}", command, result.cost.exit_code));
  result.store = static_cast<double>(fs::file_size(store));
  return result;
}

/// 1, 2, 4, ... and all cores.
std::vector<int> worker_counts() {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::vector<int> counts;
  for (int count = 1; count < cores; count *= 2) counts.push_back(count);
  counts.push_back(cores);
  return counts;
}

/// Whether the command runs under mpirun.
bool has_ranks(const std::string& command) {
  try {
    return timed_process({"mpirun", "--allow-run-as-root", "-n", "1", command, "--version"}).exit_code == 0;
  } catch (const std::exception&) {
    return false;
  }
}

std::vector<Job> jobs_of(const Settings& settings) {
  std::vector<Job> jobs;
  const std::vector<int> counts = worker_counts();
  std::vector<std::string> launchers{"threads"};
  if (has_ranks(settings.command))
    launchers.emplace_back("ranks");
  else
    fmt::print(stderr, "No mpirun: scaling by threads only\n");
  for (const char* study : {"law-4", "law-5"})
    for (const std::string& launcher : launchers)
      for (const int workers : counts)
        jobs.push_back({"scaling", study, launcher, workers, settings.scaling_samples});
  for (const char* study : {"law-4", "law-5"})
    for (std::int64_t samples = 100; samples <= settings.max_samples; samples *= 10)
      jobs.push_back({"samples", study, "threads", counts.back(), samples});
  return jobs;
}

void print(const Result& r) {
  const auto rows = static_cast<double>(r.job.samples);
  fmt::print("{:<8} {} {:<8} {:>3} {:>8} rows {:>8.2f} s {:>9.0f} rows/s {:>8.1f} us CPU a row {:>6.0f} MB\n",
             r.job.part, r.job.study, r.job.launcher, r.job.workers, r.job.samples, r.cost.wall,
             rows / r.cost.wall, 1e6 * r.cost.cpu / rows, r.cost.peak_memory / 1e6);
  std::fflush(stdout);
}

void write_csv(const std::string& file, const std::vector<Result>& results) {
  std::ofstream stream(file);
  for (const auto& [key, value] : machine_facts()) fmt::print(stream, "# {}: {}\n", key, value);
  fmt::print(stream,
             "# of whole processes; memory is that of the largest process\n"
             "part,study,launcher,workers,samples,repetition,wall_s,cpu_s,peak_memory_bytes,store_bytes,exit_"
             "code\n");
  for (const Result& r : results)
    fmt::print(stream, "{},{},{},{},{},{},{:.4f},{:.4f},{:.0f},{:.0f},{}\n", r.job.part, r.job.study,
               r.job.launcher, r.job.workers, r.job.samples, r.repetition, r.cost.wall, r.cost.cpu,
               r.cost.peak_memory, r.store, r.cost.exit_code);
  stream.flush();
  if (!stream) throw std::runtime_error("cannot write " + file);
}

int measure_studies(int count, char** arguments) {
  Settings settings;
  CLI::App app{"What a study costs"};
  app.add_option("--command", settings.command, "The command dashpad")->capture_default_str();
  app.add_option("--scaling-samples", settings.scaling_samples, "Samples of the study on 1 to all cores")
      ->capture_default_str();
  app.add_option("--most-samples", settings.max_samples, "Largest study")->capture_default_str();
  app.add_option("--repetitions", settings.repetitions, "Of each run of less than 100,000 samples")
      ->capture_default_str();
  app.add_option("--csv", settings.csv, "File for all measurements");
  CLI11_PARSE(app, count, arguments);
  std::vector<Result> results;
  const std::vector<Job> jobs = jobs_of(settings);
  for (int repetition = 0; repetition < settings.repetitions; ++repetition)
    for (const Job& job : jobs) {
      if (job.samples >= 100'000 && repetition > 0) continue;
      results.push_back(run(job, repetition, settings.command));
      print(results.back());
    }
  if (!settings.csv.empty()) write_csv(settings.csv, results);
  return 0;
}

}  // namespace
}  // namespace dashpad::bench

int main(int count, char** arguments) {
  try {
    return dashpad::bench::measure_studies(count, arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_study: {}\n", error.what());
    return 1;
  }
}
