#pragma once
/// Pages as HTML that is complete without scripts, as in a mail preview or in print.

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
  std::set<std::string> styles;  ///< styles of its SVGs
  std::string title;             ///< title in the browser's tab
  std::string body;
};

/// The HTML file. Its security policy allows only its own script and styles, by their hashes.
std::string framed(const PageHtml& html);

/// Throws std::invalid_argument if the columns of a series or the rows of a table differ in length, an axis
/// cannot have its limits, or a bar its ends.
void check(const Document& page);

struct DocumentInUnits {
  const UnitSystem* units;
  Document document;
};

/// A page in one or several unit systems; the first is shown. Of the others the page keeps texts, tables and
/// drawings, hidden, and its script swaps them in and converts the axes whose SI unit is known.
PageHtml html_of(std::vector<DocumentInUnits> pages);
/// The file.
std::string to_html(std::vector<DocumentInUnits> documents);

}  // namespace dashpad::output
