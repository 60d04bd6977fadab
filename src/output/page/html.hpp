#pragma once
/// Pages as HTML that is complete without scripts, as in a mail preview or in print.

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/output/document.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// Base64 with padding (RFC 4648, section 4).
std::string base64(std::string_view bytes);
/// "sha256-" and the SHA-256 of the text in Base64, as a Content-Security-Policy writes it.
std::string policy_hash(std::string_view text);

/// The style and the script of all pages, from web/, and those of the live page, which has controls, too.
extern const std::string_view page_style, page_script, page_live_style, page_live_script, page_live_controls;

struct PageHtml {
  std::set<std::string> styles;  ///< styles of its SVGs
  std::string title;             ///< title in the browser's tab
  std::string body;
  bool is_live =
      false;  ///< with the script of the live page, which starts WebAssembly and workers of its own
};

/// The HTML file. Its security policy allows only its own script and styles, by their hashes, and no network.
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
