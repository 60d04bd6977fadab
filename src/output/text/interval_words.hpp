#pragma once
/// How sure figures are, in words.

#include <string>
#include <vector>

#include "dashpad/impact/interval.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "output/result_rows.hpp"
#include "output/text/table.hpp"

namespace dashpad::output {

/// "980 to 1010", "34.1 to 38.2 g"; "231 g or more" where there is no bound. Three digits, and as many as it
/// takes to tell the ends apart.
std::string range_words(double low, double high, const std::string& si_unit, const UnitSystem& units);
/// Of a figure as a whole.
std::string interval_words(const FigureInterval& of, const UnitSystem& units);

/// "what columns leave out ...: 861 to 1120 alone": what moves a figure, largest first.
std::vector<std::string> source_words(const FigureInterval& of, const Intervals& intervals,
                                      const UnitSystem& units);

/// Beside each row its interval, where it has one.
void add_intervals(std::vector<ValueRow>& rows, const Summary& summary, const UnitSystem& units);

/// A figure a row, those that are asked for first: with all that is not known together, then with each source
/// alone.
Table interval_table(const Summary& summary, const UnitSystem& units, std::vector<std::string> asked = {});
/// The sources in words, and why one gives no interval.
std::string source_paragraph(const Intervals& intervals);

/// The interval of the figure that is asked for first, by what it is, and what is in none; a paragraph each,
/// none without intervals.
std::vector<std::string> interval_paragraphs(const Summary& summary, const UnitSystem& units);

}  // namespace dashpad::output
