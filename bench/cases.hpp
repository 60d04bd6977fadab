#pragma once
/// The impacts that are timed: reference cases of data/reference-cases.csv, and one on a linear viscoelastic
/// pad. c1 and c2 are the report's dashboard example with the 9- and the 21-parameter law.

#include <string>

#include "dashpad/input/case_file.hpp"
#include "oracle/reference_cases.hpp"

namespace dashpad::bench {

inline oracle::ReferenceCase reference_of(const std::string& id) {
  return oracle::reference_case(std::filesystem::path(DASHPAD_SOURCE_DIR) / "data/reference-cases.csv", id);
}

/// v1 is c1 with another pad: the report gives no linear viscoelastic one, so its constants are ours. f1 is
/// c1 with the softest pad of the cards that has two rates, three times as thick and as stiff as it is.
inline ImpactCase impact_of(const std::string& id) {
  if (id != "v1" && id != "f1") return reference_of(id).impact;
  ImpactCase impact = reference_of("c1").impact;
  if (id == "f1") {
    impact.title = "dashboard example, foam by curves";
    impact.pad.material =
        input::read_material(std::filesystem::path(DASHPAD_SOURCE_DIR) / "materials/vn600.toml").value();
    impact.pad.thickness *= 3;
    impact.pad.condition.scale = 3;
    return impact;
  }
  impact.title = "dashboard example, linear viscoelastic pad";
  impact.pad.material.law =
      LinearViscoelastic{.asymptotic_modulus = 1.4e6, .initial_modulus = 4.2e6, .relaxation_time = 5e-3};
  return impact;
}

}  // namespace dashpad::bench
