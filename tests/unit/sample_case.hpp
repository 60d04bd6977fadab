#pragma once
/// A good case file, to be read as it is or with one thing spoilt.

#include <filesystem>
#include <stdexcept>
#include <string>

#include "dashpad/input/case_file.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad::test {

inline const std::filesystem::path source = DASHPAD_SOURCE_DIR;
inline const std::filesystem::path materials = source / "materials";

inline const std::string good_case = R"(title = "A case"
[impactor]
radius = "3 in"
weight = "10 lbf"
speed = "20 mph"
[pad]
thickness = "1 in"
material = "ensolite-aac-9"
[support]
type = "linear"
stiffness = "600 lbf/in"
[solver]
tolerance = 1e-5
time_limit = "200 ms"
)";

inline const std::string in_line_material = R"(law = "linear-viscoelastic"
[pad.parameters]
asymptotic_modulus = "40 psi"
initial_modulus = "90 psi"
relaxation_time = "10 ms"
[pad.fitted]
highest_strain = 0.8
lowest_rate = "1 1/s"
highest_rate = "50 1/s")";

/// `text` with `from`, which must be there, replaced.
inline std::string edited(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("no \"" + from + "\" to edit");
  return text.replace(at, from.size(), to);
}

inline input::CaseFile read(const std::string& text) {
  const test::TemporaryFolder folder;
  return input::read_case(folder.write("case.toml", text), materials).value();
}

}  // namespace dashpad::test
