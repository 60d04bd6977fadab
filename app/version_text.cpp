// Answers --version.

#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "dashpad/version.hpp"
#include "material_folder.hpp"

namespace dashpad::app {

std::string version_text() {
  const BuildFacts& facts = build_facts();
  std::error_code ignored;
  const bool has_mpi =
      std::filesystem::exists(running_executable("").replace_filename("dashpad-mpi"), ignored);
  return fmt::format(
      "dashpad {}\n"
      "  commit      {}\n"
      "  compiler    {}\n"
      "  flags       {}\n"
      "  build type  {}\n"
      "  system      {}\n"
      "  libraries   CLI11 {}, fmt {}.{}.{}, nlohmann-json {}.{}.{}\n"
      "  ranks       {}",
      facts.version, facts.git_commit, facts.compiler, facts.compiler_flags, facts.build_type, facts.system,
      CLI11_VERSION, FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100,
      NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH,
      has_mpi ? "with MPI" : "none: built without MPI");
}

}  // namespace dashpad::app
