#pragma once
/// The files that a result was computed from, so that none of them is overwritten by it.

#include <filesystem>
#include <string>

namespace dashpad::input {

struct InputFile {
  std::string kind;  ///< with its article: "the case file", "the material card"
  std::filesystem::path file;
};

}  // namespace dashpad::input
