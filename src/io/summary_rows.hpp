#pragma once
/// The summary of an impact in words and figures, before it is laid out: for the terminal and for the page.

#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/io/unit_system.hpp"

namespace dashpad {

/// One figure as people read it.
struct SummaryRow {
  std::string label;
  std::string value;  ///< five digits
  std::string unit;
  std::string error;   ///< "0.003 %"; empty if there is no estimate
  std::string remark;  ///< may be empty
};

/// How it ended, in one sentence.
std::string outcome(const Summary& summary);

/// What to beware of, each beginning with a word in capitals: the flags of
/// dashpad/impact/flags.hpp, with moments in the units of the reader.
std::vector<std::string> warnings(const Summary& summary, const UnitSystem& units);

/// The figures, those that a designer asks for first on top; none if nothing was run.
std::vector<SummaryRow> summary_rows(const ImpactCase& impact, const Summary& summary,
                                     const UnitSystem& units);

/// The numbers behind the numbers: tolerance, steps, energy residual, version.
std::string numbers_text(const Summary& summary);

/// An estimate as it is shown. Below a millionth of the figure nobody looks for digits.
std::string shown_error(double error);

}  // namespace dashpad
