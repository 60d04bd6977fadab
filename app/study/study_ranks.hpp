#pragma once
/// A study on the ranks of an MPI job: rank 0 hands out batches and is the only one that writes.

#include <filesystem>

#include "study/study.hpp"

namespace dashpad::app {

/// Whether mpirun or a batch system started this process as one of several ranks. Asks the environment, so
/// that a plain command never pays for MPI.
bool is_one_of_several_ranks();

/// As dashpad study on one machine; only rank 0 prints. Returns the exit code. Throws Refused where this
/// build has no MPI.
int run_on_ranks(const StudyRequest& request, const std::filesystem::path& materials);

}  // namespace dashpad::app
