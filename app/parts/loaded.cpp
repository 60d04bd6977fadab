// Replacements for functions in parts, which load the part and call its function. The linker prefers them.

#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include <dlfcn.h>

#include "command.hpp"
#include "dashpad/output/deck/iso_mme_test.hpp"
#include "output/svg/svg.hpp"
#include "parts/parts.hpp"
#include "system.hpp"

namespace dashpad {

namespace fs = std::filesystem;

namespace app {
namespace {

/// Beside the program in the build tree, in another folder of an installation.
fs::path file_of_part(const std::string& name) {
  const fs::path folder = running_executable().parent_path();
  std::error_code ignored;
  const fs::path built = folder / "parts" / name;
  return fs::exists(built, ignored) ? built : (folder / DASHPAD_INSTALLED_PARTS / name).lexically_normal();
}

/// Loads the part for the rest of the program.
template <class Part>
const Part& part() {
  static const Part* const loaded = [] {
    const fs::path file = file_of_part(std::string{"dashpad-"} + Part::name + ".so");
    void* const library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
      throw std::runtime_error("this needs " + file.string() + ", which cannot be loaded: " + ::dlerror());
    const auto entry = reinterpret_cast<const Part* (*)()>(::dlsym(library, "dashpad_part"));
    if (entry == nullptr) throw std::runtime_error(file.string() + " is not a part of dashpad");
    return entry();
  }();
  return *loaded;
}

}  // namespace

void write_hdf5(const study::Store& store, const fs::path& file, const std::string& shown) {
  part<Hdf5Part>().write(store, file, shown);
}

}  // namespace app

namespace output {

std::string png_of(std::string_view svg) { return app::part<app::PicturePart>().png(svg); }
std::string pdf_of(std::string_view svg, const std::string& title) {
  return app::part<app::PicturePart>().pdf(svg, title);
}
std::string zip_of(const std::map<std::string, std::string>& files) {
  return app::part<app::ArchivePart>().zip(files);
}

}  // namespace output

namespace input {

std::vector<std::string> names_in_archive(const fs::path& archive) {
  return app::part<app::ArchivePart>().names(archive);
}
MmeMembers read_from_archive(const fs::path& archive, const std::vector<std::string>& names, std::size_t most,
                             bool cut) {
  return app::part<app::ArchivePart>().read(archive, names, most, cut);
}

}  // namespace input
}  // namespace dashpad
