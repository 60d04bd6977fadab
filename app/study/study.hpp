#pragma once
/// The subcommands of dashpad study, and what they share.

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

/// What the user wants computed.
struct StudyRequest {
  std::string study_file;
  std::string store_file;
  std::string materials;
  int threads = 0;  ///< 0: all cores
  bool quiet = false;
};

/// Opens the store of a study, new or begun. Throws Refused for what forbids it.
study::Store open_store(const study::Study& study, const std::string& file);

/// Opens a store to read. Throws Refused where there is none.
study::Store open_stored(const std::string& file);

/// The store and what SQLite keeps beside it while it is open.
std::vector<input::InputFile> files_of_store(const std::string& file);

/// Says what a run came to, in a line: rows, rate, doubtful rows; or how to go on. Returns the exit code.
int finish_study(const study::Store& store, const StudyRequest& request, std::uint64_t rows_before,
                 double seconds, bool complete);

/// As dashpad study on one machine; only rank 0 prints. Returns the exit code. The command itself goes over
/// to dashpad-mpi, which holds all this; it throws Refused where that is not there.
int run_on_ranks(const StudyRequest& request);

}  // namespace dashpad::app
