#pragma once
/// The pages without what is in them, as web/build.mjs has made them. Empty texts where they were not built.

#include <array>
#include <string>
#include <string_view>

#include "output/page/digest.hpp"
#include "output/page/html.hpp"

namespace dashpad::output {

/// What stands before, between and after the hashes of styles, title, lead, body and data.
using PageParts = std::array<std::string_view, 6>;

extern const PageParts page_parts;
extern const PageParts figures_page_parts;

/// The file. `data` are for the script: JSON without a "<".
inline std::string filled(const PageParts& parts, const PageHtml& html, const std::string& data) {
  std::string text{parts[0]};
  for (const std::string& style : html.styles) text += " '" + policy_hash(style) + "'";
  text += parts[1];
  text += html.title;
  text += parts[2];
  text += html.lead;
  text += parts[3];
  text += html.body;
  text += parts[4];
  text += data;
  text += parts[5];
  return text;
}

}  // namespace dashpad::output
