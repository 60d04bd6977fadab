#pragma once
/// A page as HTML that needs no script: what a mail preview, a printer or a reader who allows no scripts sees
/// of it.

#include <vector>

#include "dashpad/output/document.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "output/page/frame.hpp"

namespace dashpad::output {

struct DocumentInUnits {
  const UnitSystem* units;
  Document document;
};

/// One page in one or several unit systems, the first of which is shown. Of the others only the texts, tables
/// and drawings are kept, out of sight: a script puts them in their places, and gives the axes of the plots,
/// if they know their SI unit, the units that go with them.
PageHtml html_of(std::vector<DocumentInUnits> documents);
/// The file.
std::string to_html(std::vector<DocumentInUnits> documents);

}  // namespace dashpad::output
