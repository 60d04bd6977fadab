#pragma once
/// Functions that the writers of documents share.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/impact/flags.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/output/text/table.hpp"

namespace dashpad::output {

/// "76.3 g".
std::string shown_value(const ValueRow& row);

/// An estimate as it is shown. Below a millionth of the figure nobody looks for digits.
std::string shown_error(double error);

/// "91.6 to 101 g at 95 %; at 9.431 ms", "at most 80 g": what stands below a figure that is shown large.
std::string words_beside(const ValueRow& row);

/// The rows as a table, with the columns that any of them has something for.
Table table_of(const RowGroup& group);

/// All tables of a section, beginning with those of its rows.
std::vector<Table> tables_of(const Section& section);

/// The table in GitHub's Markdown.
std::string markdown(const Table& table);

/// The table for a terminal of 100 columns; texts of its widest columns may continue on further lines.
std::string plain_text(const Table& given);

/// "  Peak force             5757 N      5100 to 6400 N    ± 0.2 %  remark", at most 100 columns wide;
/// without room for what no row has.
std::string laid_out(const std::vector<ValueRow>& given);

/// The same table below that line.
Table captioned(std::string caption, Table table);

/// A plot for where its title and source stand already.
Plot untitled(Plot plot);

/// The texts of flags, the most severe first; a note that moves a figure counts as a doubt.
std::vector<std::string> by_severity(std::vector<Flag> flags);

/// Length of the words in capitals that a warning begins with: "PULSE CUT".
std::size_t capitals_in_front(std::string_view text);

/// The number of figures that a page shows large; with more, none of them stands out.
inline constexpr std::size_t max_key_figures = 6;

/// Whether a section is shown where people see that much.
bool is_seen(const Section& section, Detail detail);

/// "12.5", "-3e-4", "< 0.1 %", "4.1 ± 0.2"; or what says that there is none: "-", "none".
bool is_number_or_none(const std::string& cell);

/// Whether each cell of the column is a number or says that there is none, and at least one is a number.
bool is_column_of_numbers(const Table& table, std::size_t column);

}  // namespace dashpad::output
