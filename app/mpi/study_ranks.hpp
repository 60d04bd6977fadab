#pragma once
/// A study on the ranks of an MPI job: rank 0 hands out batches and is the only one that writes.

#include <filesystem>

#include "study/study.hpp"

namespace dashpad::app {

/// As dashpad study on one machine; only rank 0 prints. Returns the exit code. The command itself goes over
/// to dashpad-mpi, which holds all this; it throws Refused where that is not there.
int run_on_ranks(const StudyRequest& request, const std::filesystem::path& materials);

}  // namespace dashpad::app
