#pragma once
/// The live page: an answer that changes while its numbers are dragged, with the engine inside one HTML file.

#include <map>
#include <string>
#include <string_view>

#include "live/answer.hpp"

namespace dashpad::live {

struct LivePage {
  std::string case_text;      ///< a case file that names no files but cards that came with the program
  std::string standard = {};  ///< name with its variants, of those that came with it; empty for none
  std::map<std::string, double> user = {};  ///< "mass", "radius", "speed" (SI) in place of the standard's
  std::string units = "si";                 ///< name of a unit system
  std::string_view engine = {};             ///< the module, packed by gzip (./do wasm)
};

/// The file. Without its script it shows the answer to the case as it is.
std::string live_page(const LivePage& page, const Folders& folders);

}  // namespace dashpad::live
