#pragma once
/// Which Dashpad this is and how it was built. Results carry these facts.

#include <string_view>

namespace dashpad {

struct BuildFacts {
  std::string_view version;     ///< "0.1.0"
  std::string_view git_commit;  ///< "0123456789ab", with "-dirty" for changed sources; "unknown" without git
  std::string_view compiler;    ///< "GNU 12.2.0"
  std::string_view compiler_flags;  ///< of the library
  std::string_view build_type;      ///< "Release"
  std::string_view system;          ///< that it was built for: "Linux x86_64"
};

/// The text lives as long as the program.
const BuildFacts& build_facts();

/// "0.1.0", as in build_facts().
std::string_view version();

}  // namespace dashpad
