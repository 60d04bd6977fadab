// Replacements for functions that need libraries of pictures and archives, without which the C interface
// does: what asks for them is refused. The linker prefers them.

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/output/deck/iso_mme_test.hpp"
#include "input/iso_mme/test_files.hpp"
#include "output/svg/svg.hpp"

namespace dashpad {
namespace {

[[noreturn]] void refuse(const char* what) {
  throw std::runtime_error(std::string(what) + " are for the command dashpad; this library has none");
}

}  // namespace

namespace output {

std::string png_of(std::string_view) { refuse("PNG pictures"); }
std::string pdf_of(std::string_view, const std::string&) { refuse("PDF pictures"); }
std::string zip_of(const std::map<std::string, std::string>&) { refuse("archives"); }

}  // namespace output

namespace input {

std::vector<std::string> names_in_archive(const std::filesystem::path&) { refuse("archives"); }
MmeMembers read_from_archive(const std::filesystem::path&, const std::vector<std::string>&, std::size_t,
                             bool) {
  refuse("archives");
}

}  // namespace input
}  // namespace dashpad
