#pragma once
/// A result in words and figures before it is laid out: for terminal and page.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/interval.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "output/layout.hpp"

namespace dashpad::output {

/// The outcome of the impact in one sentence.
std::string outcome(const Summary& summary);

/// The flags of a summary, each beginning with a word in capitals, with moments in the reader's units.
std::vector<std::string> warnings(const Summary& summary, const UnitSystem& units);

/// Every figure of the impact; none if nothing was run.
std::vector<ValueRow> summary_rows(const ImpactCase& impact, const Summary& summary, const UnitSystem& units,
                                   Detail detail);

/// The figures of the pulse. With Detail::main, those that are asked for first, and equal ones in one row.
std::vector<ValueRow> pulse_rows(const injury::InjuryFigures& figures, const UnitSystem& units,
                                 Detail detail);

/// The rows that people ask for first: those of the pulse, then those of the impact, none twice.
std::vector<ValueRow> main_rows(const ImpactCase& impact, const Summary& summary,
                                const std::optional<injury::InjuryFigures>& injury, const UnitSystem& units);

/// The speed that was left when the pad bottomed out, beside that of the impact; none if it did not.
std::vector<ValueRow> bottoming_figures(const ImpactCase& impact, const Summary& summary,
                                        const UnitSystem& units);

/// How it was computed: "to a tolerance of 0.01 % for peak forces, distances and rebound: 120 steps, ...".
std::string numbers_text(const Summary& summary);

/// "from 5.847 to 20.12 ms", with 0 for what is 0 up to rounding.
std::string stretch(double begin, double end, const UnitSystem& units, int digits);

/// The growth of the peaks from the first to the last blow, or why they do not grow.
std::string growth_text(const ImpactCase& impact, const std::vector<BlowResult>& blows);

/// A row a blow.
Table blow_table(const ImpactCase& impact, const std::vector<BlowResult>& blows, const UnitSystem& units,
                 Detail detail);

/// The flags of blows before the last that the last does not have, and which blows have them: a line each.
std::vector<std::string> reservations(const std::vector<BlowResult>& blows);

/// A range: "980 to 1010", "34.1 to 38.2 g"; "231 g or more" without an upper bound. It has three digits, or
/// as many as tell its ends apart.
std::string range_words(double low, double high, const std::string& si_unit, const UnitSystem& units);
/// The interval of a figure from all sources together: "34.1 to 38.2 g", "at most 1.19 m/s" if its lower end
/// is the least that the figure can be, "0.94 or more" if its upper end is a strain or a restitution of 1,
/// "unbounded" if both are so.
std::string interval_words(const FigureInterval& interval, const UnitSystem& units);

/// "what columns leave out ..., 861 to 1120": what moves a figure and its interval by that, largest first.
std::vector<std::string> source_words(const FigureInterval& interval, const Intervals& intervals,
                                      const UnitSystem& units);

/// Adds intervals to the rows whose figures have them.
void add_intervals(std::vector<ValueRow>& rows, const Summary& summary, const UnitSystem& units);

/// A table with a row for each figure: its interval from all sources together, then from each source alone.
Table interval_table(const Summary& summary, const UnitSystem& units, std::vector<std::string> asked = {});

/// The interval of the leading figure with its sources, and what no interval covers, a paragraph each, of a
/// summary with intervals.
std::vector<std::string> interval_paragraphs(const Summary& summary, const UnitSystem& units);

}  // namespace dashpad::output
