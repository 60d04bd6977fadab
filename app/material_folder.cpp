#include "material_folder.hpp"

#include <cstdlib>
#include <system_error>

namespace dashpad {

namespace fs = std::filesystem;

fs::path material_folder(const fs::path& executable) {
  if (const char* chosen = std::getenv("DASHPAD_MATERIALS"); chosen != nullptr && *chosen != '\0')
    return chosen;

  std::error_code ignored;
  const fs::path installed =
      (fs::absolute(executable, ignored).parent_path() / DASHPAD_INSTALLED_MATERIALS).lexically_normal();
  if (fs::is_directory(installed, ignored)) return installed;

  const fs::path source{DASHPAD_SOURCE_MATERIALS};
  if (fs::is_directory(source, ignored)) return source;

  return installed;
}

fs::path running_executable(const char* argument_zero) {
  std::error_code error;
  fs::path executable = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path{argument_zero} : executable;
}

}  // namespace dashpad
