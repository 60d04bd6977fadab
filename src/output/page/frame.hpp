#pragma once
/// The file around what a page says.

#include <set>
#include <string>
#include <string_view>

namespace dashpad::output {

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

}  // namespace dashpad::output
