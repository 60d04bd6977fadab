// Cases of a batch as JSON.

#include <cstdint>

#include "dashpad/input/case_file.hpp"
#include "reading.hpp"

namespace fs = std::filesystem;
using namespace dashpad;
using namespace dashpad::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const fs::path source = DASHPAD_SOURCE_DIR;
  static const bool has_case =
      fs::copy_file(source / "examples/dashboard-20mph.toml", folder() / "case.toml");
  require(has_case, "the case is there");
  const auto read = read_or_refuse([&] {
    return input::read_case_json(text_of(bytes, size), 1, "cases.jsonl", folder(), source / "materials")
        .read.value();
  });
  if (read) require(violations(read->impact).empty(), "a case that was read breaks no rule");
  return 0;
}
