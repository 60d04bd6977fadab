// Where the command finds the material cards, the standards and the measured tests that came with it.

#include "command.hpp"

#include <cstdlib>
#include <system_error>

namespace dashpad::app {

namespace fs = std::filesystem;

namespace {

struct DataFolder {
  const char* variable;   ///< of the environment
  const char* installed;  ///< relative to the folder of the command
  const char* source;
};

fs::path find(const DataFolder& folder, const fs::path& executable) {
  if (const char* chosen = std::getenv(folder.variable); chosen != nullptr && *chosen != '\0') return chosen;

  std::error_code ignored;
  const fs::path installed =
      (fs::absolute(executable, ignored).parent_path() / folder.installed).lexically_normal();
  if (fs::is_directory(installed, ignored)) return installed;

  const fs::path source{folder.source};
  if (fs::is_directory(source, ignored)) return source;

  return installed;
}

}  // namespace

fs::path chosen_folder(const std::string& folder, const fs::path& executable) {
  if (!folder.empty()) return folder;
  return find({"DASHPAD_MATERIALS", DASHPAD_INSTALLED_DATA "/materials", DASHPAD_SOURCE_DATA "/materials"},
              executable);
}

fs::path chosen_standards(const std::string& folder, const fs::path& executable) {
  if (!folder.empty()) return folder;
  return find({"DASHPAD_STANDARDS", DASHPAD_INSTALLED_DATA "/standards", DASHPAD_SOURCE_DATA "/standards"},
              executable);
}

fs::path validation_data_folder(const fs::path& executable) {
  return find({"DASHPAD_VALIDATION_DATA", DASHPAD_INSTALLED_DATA "/data/validation",
               DASHPAD_SOURCE_DATA "/data/validation"},
              executable);
}

fs::path running_executable(const char* argument_zero) {
  std::error_code error;
  fs::path executable = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path{argument_zero} : executable;
}

}  // namespace dashpad::app
