#pragma once
/// A case as people read it.

#include <string>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// The impact in two lines, below its title if it has one.
std::string case_text(const ImpactCase& impact, const UnitSystem& units);

/// The parts of a case in words.
struct CaseWords {
  std::string impactor;  ///< "a sphere of mass 4.5 kg and radius 82.5 mm"
  std::string speed;
  std::string pad;      ///< "vn600 (foam law), 30 mm thick, bonded"
  std::string support;  ///< "a rigid support"
  std::string blows;    ///< "3 times; between blows the pad recovers fully"; empty of one blow
};
CaseWords case_words(const ImpactCase& impact, const UnitSystem& units);

/// Every value of the case as it is computed with: `key = value unit` in SI and full precision, a line each.
std::string case_in_si(const ImpactCase& impact, const Options& options);

/// The case `name` as `dashpad check` shows it: its words, then every value.
std::string checked_case(const std::string& name, const ImpactCase& impact, const Options& options,
                         const UnitSystem& units);

}  // namespace dashpad::output
