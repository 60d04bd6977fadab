#pragma once
/// Raw results as figures and tables.

#include <string>
#include <vector>

#include "dashpad/output/document.hpp"
#include "raw_results.hpp"

namespace dashpad::bench {

/// A section of the page; its tables are also those of README.md, by `names`, its figures also stills.
struct Chapter {
  output::Section section;
  std::vector<std::string> table_names;
  std::vector<std::string> figure_names;
};

Chapter work_precision_chapter(const RawResults& results);
Chapter study_chapter(const RawResults& results);

/// "AMD EPYC, 2 cores; load 2.1; commit ..; GNU 12.2.0, flags; measured ..".
std::string facts_text(const RawResults& results);

}  // namespace dashpad::bench
