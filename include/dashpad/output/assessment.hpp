#pragma once
/// Standards and assessments for people and for programs.

#include <string>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/standard.hpp"
#include "dashpad/output/text/result.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// What every assessment says about itself: a computation, no certification.
const std::string& assessment_caveat();

/// A standard in one line: name, title, and how many of its values are unverified.
std::string standard_line(const injury::Standard& standard);

/// A standard in full: impactor, criteria and variants, each value with source and state of verification.
std::string standard_text(const injury::Standard& standard, const UnitSystem& units);

/// All that belongs to an assessment. `given` is the case as the file has it, `assessed` with the impactor of
/// the standard.
struct AssessmentReport {
  const injury::Standard& standard;
  const ImpactCase& given;
  const ImpactCase& assessed;
  const Solution& solution;
  const injury::Assessment& assessment;
};

/// The verdict, a row a criterion with its margin, the reservations, what was replaced and what was kept.
/// Errors stand beside values where they leave a criterion undecided, or with Detail::all.
std::string assessment_text(const AssessmentReport& report, const UnitSystem& units, Detail detail);

/// The page. Throws as figures_page() does.
std::string assessment_page(const AssessmentReport& report, const UnitSystem& units);

/// The same in SI, with the summary of the impact as `dashpad run --json` writes it under "result".
std::string assessment_json(const AssessmentReport& report);

}  // namespace dashpad::output
