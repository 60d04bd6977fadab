#pragma once
/// A result in words and figures before it is laid out: for terminal and page.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/output/text/result.hpp"

namespace dashpad::output {

/// One figure as people read it.
struct ResultRow {
  std::string key;    ///< of the table of results
  std::string label;  ///< its title there
  std::string value;
  std::string unit;
  std::optional<double> error;  ///< estimated, relative
  std::string remark;           ///< may be empty
  std::string interval = {};    ///< "34.1 to 38.2 g", by what is not known; may be empty
};

/// How it ended, in one sentence.
std::string outcome(const Summary& summary);

/// What to beware of, each beginning with a word in capitals: the flags of
/// dashpad/impact/flags.hpp, with moments in the units of the reader.
std::vector<std::string> warnings(const Summary& summary, const UnitSystem& units);

/// Every figure of the impact; none if nothing was run.
std::vector<ResultRow> summary_rows(const ImpactCase& impact, const Summary& summary, const UnitSystem& units,
                                    Detail detail);

/// The figures of the pulse. With Detail::main, those that are asked for first, and equal ones in one row.
std::vector<ResultRow> pulse_rows(const injury::InjuryFigures& figures, const UnitSystem& units,
                                  Detail detail);

/// The rows that people ask for first: those of the pulse, then those of the impact, none twice.
std::vector<ResultRow> main_rows(const ImpactCase& impact, const Summary& summary,
                                 const std::optional<injury::InjuryFigures>& injury, const UnitSystem& units);

/// "  Peak force             5757 N      5100 to 6400 N    ± 0.2 %  remark", at most 100 columns wide;
/// without room for an interval where no row has one.
std::string laid_out(const std::vector<ResultRow>& rows);

/// The numbers behind the numbers: tolerance, steps, energy residual, version.
std::string numbers_text(const Summary& summary);

/// An estimate as it is shown. Below a millionth of the figure nobody looks for digits.
std::string shown_error(double error);

/// "from 5.847 to 20.12 ms", with 0 for what is 0 up to rounding.
std::string stretch(double begin, double end, const UnitSystem& units, int digits);

}  // namespace dashpad::output
