#pragma once
/// The subcommands of dashpad study, and their common parts.

#include <cstdint>
#include <string>
#include <vector>

#include "command.hpp"
#include "dashpad/study/store.hpp"
#include "dashpad/study/study.hpp"

namespace dashpad::app {

void add_study_replay(CLI::App& study, Action& action);
void add_study_summary(CLI::App& study, Action& action);
void add_study_export(CLI::App& study, Action& action);

struct StudyRequest {
  std::string study_file;
  std::string store_file;
  std::string materials, standards;
  int threads = 0;  ///< 0: all cores
  bool quiet = false;
  bool extend = false;
};

/// Reads the study file. Throws InputError.
study::Study study_of(const StudyRequest& request);

/// Opens the store of a study, new or existing. Throws Refused if that is impossible.
study::Store open_store(const study::Study& study, const StudyRequest& request);

/// Opens a store for reading. Throws Refused if there is none.
study::Store open_stored(const std::string& file);

/// The store and the files of SQLite beside it.
std::vector<input::InputFile> files_of_store(const std::string& file);

/// Reports a run in a line: rows, rate, doubtful rows; or how to continue. Returns the exit code.
int finish_study(const study::Store& store, const StudyRequest& request, std::uint64_t rows_before,
                 double seconds, bool complete);

/// Like dashpad study on one machine, but only rank 0 prints. Returns the exit code. Implemented in
/// dashpad-mpi, which the command itself becomes; throws Refused if it is missing.
int run_on_ranks(const StudyRequest& request);

}  // namespace dashpad::app
