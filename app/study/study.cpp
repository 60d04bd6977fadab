// dashpad study: many impacts, from a study file into a store.

#include <chrono>
#include <cstdlib>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "dashpad/study/answers.hpp"
#include "dashpad/study/run_study.hpp"
#include "dashpad/study/study_file.hpp"
#include "output.hpp"
#include "progress_line.hpp"
#include "study/study.hpp"

namespace dashpad::app {

namespace fs = std::filesystem;

namespace {

template <class Open>
study::Store opened(const std::string& file, Open open) {
  try {
    return open();
  } catch (const std::runtime_error& error) {
    const std::string what = error.what();
    throw Refused({what.find(file) == std::string::npos ? fmt::format("{}: {}", file, what) : what});
  }
}

constexpr const char* study_footer = R"(Examples:
  dashpad study examples/studies/speed-and-thickness.toml --out speed.db
  dashpad study summary speed.db --response hic15 --limit "hic15 > 1000"
  dashpad study replay speed.db 17 --units us
  dashpad study export speed.db --csv speed.csv
  dashpad study my-study.toml --out my-study.db --threads 8
  mpirun -n 32 dashpad study my-study.toml --out my-study.db

A study file names a base case, factors that vary (lists, ranges, distributions) and the responses to keep. With
rows = "design.csv" it solves the cases of a table; with samples_from = "draws.csv" it draws from one; with
foam_uncertainty = true each draw also has a foam of its own, within what the cards leave uncertain. The same study
gives the same rows on any number of cores or machines. The store is an SQLite file.

To resume after an interruption (Ctrl-C, SIGTERM, a crash, a full disk), run the same command again; no row is lost
and none is computed twice. During the run, summary, export and any SQLite tool can read the completed rows. Under
mpirun, each rank computes on one core. See docs/studies.md.

Exit codes: 0 all rows are complete, 1 a result could not be written, 2 invalid input (nothing was run), 3 all rows
are complete but some are doubtful (tolerance not met, no valid case, or a figure missing), 130 or 143 stopped by
Ctrl-C or SIGTERM (run the same command again to resume).)";

/// Whether mpirun or a batch system started this process as one of several ranks. Asks the environment, so
/// that a plain command never loads MPI.
bool is_one_of_several_ranks() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* size = std::getenv(name); size != nullptr && std::atoi(size) > 1) return true;
  return false;
}

int run_here(const StudyRequest& request) {
  // Created before the store: whoever sees its file may stop the study, and is told how to continue.
  const StopSignal stop;
  const study::Study study = study_of(request);
  study::Store store = open_store(study, request);
  const std::uint64_t before = store.rows_done();
  const auto begin = std::chrono::steady_clock::now();
  bool complete = false;
  {
    StudyProgress progress{request.quiet};
    complete = study::run(study, store,
                          {.threads = request.threads,
                           .stop = &StopSignal::wanted(),
                           .progress = [&](const study::Progress& now) { progress.show(now); }});
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return finish_study(store, request, before, seconds, complete);
}

}  // namespace

study::Study study_of(const StudyRequest& request) {
  return study::read_study(request.study_file, chosen_folder(request.materials),
                           chosen_standards(request.standards))
      .value();
}

study::Store open_store(const study::Study& study, const StudyRequest& request) {
  const std::string& file = request.store_file;
  return opened(file, [&] { return study::Store::open_for(study, file, request.extend); });
}

study::Store open_stored(const std::string& file) {
  return opened(file, [&] { return study::Store::open_to_read(file); });
}

std::vector<input::InputFile> files_of_store(const std::string& file) {
  std::vector<input::InputFile> files{{"the store", file}};
  std::error_code error;
  const std::string real = std::filesystem::weakly_canonical(file, error).string();
  for (const char* ending : {"-wal", "-shm", "-journal"})
    files.push_back({"a part of the store", (error ? file : real) + ending});
  return files;
}

int finish_study(const study::Store& store, const StudyRequest& request, std::uint64_t rows_before,
                 double seconds, bool complete) {
  store.check_in_place();
  const std::uint64_t rows = store.rows_done();
  const auto computed = static_cast<double>(rows - rows_before);
  if (!complete) {
    write_error(fmt::format("Stopped with {} rows in {}. Run the same command again to resume.\n", rows,
                            request.store_file));
    return StopSignal::exit_code();
  }
  const auto [doubtful, struck_through] = study::row_counts(store);
  std::string line = fmt::format("{} rows in {}", rows, request.store_file);
  line += rows == rows_before ? "; all were already in the store"
                              : fmt::format("; {} computed in {:.3g} s, {}", rows - rows_before, seconds,
                                            rate_text(computed, seconds));
  line += fmt::format("; {} doubtful{}", doubtful,
                      doubtful > 0 ? " (tolerance not met, no valid case, or a figure missing)" : "");
  if (struck_through > 0) line += fmt::format("; {} bottomed out on a rigid support", struck_through);
  line += "\n";
  write_output(line);
  return doubtful > 0 ? exit_not_trusted : exit_done;
}

void add_study(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand("study", "Solve many impacts: curves, maps, probabilities");
  const auto request = std::make_shared<StudyRequest>();
  add_option(*sub, "STUDY", request->study_file, "Study file (TOML)");
  add_option(*sub, "--out FILE", request->store_file,
             "Store file: a new file, or this study's existing store, to resume the study");
  add_option(*sub, "--threads N", request->threads, "Number of threads (default: one per core)")
      ->check(CLI::Range(1, 4096));
  add_flag(*sub, "--extend", request->extend,
           "Extend this study's store, made with fewer draws, by computing only the missing draws");
  add_flag(*sub, "--quiet", request->quiet, "Do not show progress");
  add_material_folder(*sub, request->materials);
  add_standard_folder(*sub, request->standards);
  sub->require_subcommand(0, 1);
  add_study_replay(*sub, action);
  add_study_summary(*sub, action);
  add_study_export(*sub, action);
  sub->footer(study_footer);
  // The callback of a subcommand comes first; STUDY is only needed without one.
  sub->callback([sub, request, &action] {
    if (!sub->get_subcommands().empty()) return;
    if (request->study_file.empty()) throw CLI::RequiredError("STUDY");
    if (request->store_file.empty()) throw CLI::RequiredError("--out");
    action = [request] { return is_one_of_several_ranks() ? run_on_ranks(*request) : run_here(*request); };
  });
}

}  // namespace dashpad::app
