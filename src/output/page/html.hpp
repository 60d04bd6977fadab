#pragma once
/// A page as HTML that needs no script, as a mail preview, a printer or a reader who allows no scripts sees
/// it; and the file around it.

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/output/document.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// "sha256-" and the SHA-256 of the text in Base64, as a Content-Security-Policy writes it.
std::string policy_hash(std::string_view text);

/// The style and the script of all pages, from web/.
extern const std::string_view page_style, page_script;

struct PageHtml {
  std::set<std::string> styles;  ///< those that its SVGs bring
  std::string title;             ///< what browsers show above the page
  std::string body;
};

/// One HTML file. A policy in it allows its own script and styles, by their hashes, and nothing else: a
/// script that got in some other way would not run.
std::string framed(const PageHtml& html);

/// Throws std::invalid_argument if columns of a series or rows of a table differ in length, if an axis
/// cannot have its limits, or a bar its ends.
void check(const Document& page);

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
