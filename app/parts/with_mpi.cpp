// Runs a study on ranks by turning the process into dashpad-mpi, which is beside it and links MPI.

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>

#include <unistd.h>

#include "command.hpp"
#include "study/study.hpp"
#include "system.hpp"

namespace dashpad::app {

int run_on_ranks(const StudyRequest&) {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string line{std::istreambuf_iterator<char>(file), {}};
  std::vector<char*> arguments;
  for (std::size_t at = 0; at < line.size(); at += std::strlen(&line[at]) + 1) arguments.push_back(&line[at]);
  arguments.push_back(nullptr);
  ::execv(running_executable().replace_filename("dashpad-mpi").c_str(), arguments.data());
  if (errno != ENOENT) throw std::system_error(errno, std::generic_category(), "dashpad-mpi");
  throw Refused(
      {"this dashpad was built without MPI and cannot run under mpirun; build it where MPI is "
       "installed (Debian: libopenmpi-dev)"});
}

}  // namespace dashpad::app
