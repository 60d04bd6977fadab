// Case files.

#include <cstdint>

#include "dashpad/input/case_file.hpp"
#include "dashpad/output/text/case.hpp"
#include "output/text/case_toml.hpp"
#include "reading.hpp"

namespace fs = std::filesystem;
using namespace dashpad;
using namespace dashpad::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const fs::path materials = DASHPAD_SOURCE_DIR "/materials";
  auto read = read_or_refuse(
      [&] { return input::read_case(write("case.toml", text_of(bytes, size)), materials).value(); });
  if (!read) return 0;
  require(violations(read->impact).empty(), "a case that was read breaks no rule");
  require(read->options.tolerance >= 1e-8 && read->options.tolerance <= 1e-2,
          "the tolerance is in its range");
  require(read->options.time_limit > 0, "the time limit is more than 0");
  require_finite({read->options.time_limit}, "the time limit is finite");
  require_plain_text(output::case_text(read->impact, unit_systems().front()),
                     "a case is shown as plain text");

  const std::string written = output::case_toml(read->impact, read->options);
  read->impact.pad.material.name = foam_of_the_case;
  for (PadLayer& layer : read->impact.pad.layers) layer.material.name = foam_of_the_case;
  const input::CaseFile again = input::read_case(write("again.toml", written), materials).value();
  require(output::case_in_si(again.impact, again.options) == output::case_in_si(read->impact, read->options),
          "a case that was written is read as the same numbers");
  return 0;
}
