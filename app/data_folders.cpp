// Locates the material cards, standards, measured tests and the engine that came with the command.

#include "command.hpp"

#include <string>
#include <system_error>

#include "system.hpp"

namespace dashpad::app {

namespace fs = std::filesystem;

namespace {

struct DataPlace {
  const char* variable;   ///< of the environment
  const char* installed;  ///< relative to the folder of the program
  const char* source;     ///< likewise, for a program that was built but not installed
};

fs::path chosen(const std::string& folder, const DataPlace& place) {
  if (!folder.empty()) return folder;
  if (const std::string named = environment(place.variable); !named.empty()) return named;

  std::error_code ignored;
  const fs::path program = fs::absolute(running_executable(), ignored).parent_path();
  const fs::path installed = (program / place.installed).lexically_normal();
  const fs::path source = (program / place.source).lexically_normal();
  return !fs::exists(installed, ignored) && fs::exists(source, ignored) ? source : installed;
}

}  // namespace

fs::path chosen_folder(const std::string& folder) {
  return chosen(folder,
                {"DASHPAD_MATERIALS", DASHPAD_INSTALLED_DATA "/materials", DASHPAD_SOURCE_DATA "/materials"});
}

fs::path chosen_standards(const std::string& folder) {
  return chosen(folder,
                {"DASHPAD_STANDARDS", DASHPAD_INSTALLED_DATA "/standards", DASHPAD_SOURCE_DATA "/standards"});
}

fs::path chosen_measured_tests(const std::string& folder) {
  return chosen(folder, {"DASHPAD_VALIDATION_DATA", DASHPAD_INSTALLED_DATA "/data/validation",
                         DASHPAD_SOURCE_DATA "/data/validation"});
}

fs::path chosen_engine() {
  return chosen("", {"DASHPAD_ENGINE", DASHPAD_INSTALLED_DATA "/engine.wasm.lzma",
                     DASHPAD_SOURCE_DATA "/build/wasm/engine.wasm.lzma"});
}

}  // namespace dashpad::app
