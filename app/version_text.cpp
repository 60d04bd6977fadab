// Answers --version.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "dashpad/version.hpp"

namespace dashpad::app {

namespace {

#ifdef DASHPAD_HAS_MPI
constexpr const char* ranks = "with MPI";
#else
constexpr const char* ranks = "none: built without MPI";
#endif

}  // namespace

std::string version_text() {
  const BuildFacts& facts = build_facts();
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
      NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH, ranks);
}

}  // namespace dashpad::app
