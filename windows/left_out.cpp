// What is not in the command for Windows, since Debian has its libraries for Linux only, and says so when it
// is asked for.

#include <cstddef>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "dashpad/input/fault.hpp"
#include "dashpad/output/deck/iso_mme_test.hpp"
#include "dashpad/study/answers.hpp"
#include "input/iso_mme/test_files.hpp"
#include "output/svg/svg.hpp"

namespace dashpad {

namespace fs = std::filesystem;

namespace app {

void add_study(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand("study", "Solve many impacts (not in dashpad for Windows)");
  sub->prefix_command();
  sub->callback([&action] {
    action = []() -> int {
      throw Refused(
          {"study: is not in dashpad for Windows, which has no SQLite for the store; use WSL or Linux"});
    };
  });
}

}  // namespace app

// The documents of studies are there, but no study that they could be about.
namespace study {

std::optional<std::size_t> min_peak(const CushionCurve& /*curve*/) { std::abort(); }
std::vector<double> values_of(const Study& /*study*/, const Records& /*records*/, const Group& /*group*/,
                              std::size_t /*response*/) {
  std::abort();
}

}  // namespace study

namespace output {

// Asked for by their names, they were refused before the impact was solved: missing_for().
std::string png_of(std::string_view /*svg*/) { throw app::Refused({"PNG is not in dashpad for Windows"}); }
std::string pdf_of(std::string_view /*svg*/, const std::string& /*title*/) {
  throw app::Refused({"PDF is not in dashpad for Windows"});
}
std::string zip_of(const std::map<std::string, std::string>& /*files*/) {
  throw app::Refused({"ISO-MME as an archive is not in dashpad for Windows"});
}

}  // namespace output

namespace input {

std::vector<std::string> names_in_archive(const fs::path& archive) {
  refuse_file(archive,
              "is an archive, which dashpad for Windows does not read; unpack it and give its folder");
}

MmeMembers read_from_archive(const fs::path& archive, const std::vector<std::string>& /*names*/,
                             std::size_t /*most*/, bool /*cut*/) {
  names_in_archive(archive);
  return {};
}

}  // namespace input
}  // namespace dashpad
