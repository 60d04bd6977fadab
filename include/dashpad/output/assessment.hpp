#pragma once
/// Standards and assessments for people and for programs.

#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/standard.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// The note beside every assessment that it is a computation, not a certification.
const std::string& assessment_caveat();

/// A standard in one line: name, title, and how many of its values are unverified.
std::string standard_line(const injury::Standard& standard);

/// A standard in full: impactor, criteria and variants, each value with source and state of verification.
Document standard_document(const injury::Standard& standard, const UnitSystem& units);

/// An assessment. `given` is the case of the file, `assessed` the same with the impactor of the standard.
struct AssessmentReport {
  const injury::Standard& standard;
  const ImpactCase& given;
  const ImpactCase& assessed;
  const Solution& solution;
  const injury::Assessment& assessment;
  std::vector<injury::OtherChoice> others =
      {};                 ///< choices that change the verdict; each has its reservation, too
  std::string file = {};  ///< case file
};

/// The reservation about another choice of nose or speed: "OTHER SPEED: with the case's own speed, 6.7 m/s,
/// the verdict is fail (HIC(d) 1005); run with --keep-speed". `standard` has its own nose and speed.
Flag other_choice(const injury::OtherChoice& choice, const injury::Standard& standard,
                  const ImpactCase& given, const UnitSystem& units);

/// The verdict, the reservations, a row a criterion with its margin, what was replaced and what was kept.
Document assessment_document(const AssessmentReport& report, const UnitSystem& units,
                             Pictures pictures = Pictures::left_out);

/// Several assessments as a test plan: a table with a row for each case and a column for each standard,
/// beginning with the worst, then each in full. All cases must have the same standards in the same order.
Document test_plan_document(const std::vector<AssessmentReport>& reports, const UnitSystem& units,
                            Pictures pictures = Pictures::left_out);

/// An assessment in SI, with the summary of the impact as `dashpad run --json` writes it under "result".
std::string assessment_json(const AssessmentReport& report);
/// An array of them.
std::string assessments_json(const std::vector<AssessmentReport>& reports);

}  // namespace dashpad::output
