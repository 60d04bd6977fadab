#include "output/page/frame.hpp"

#include <fmt/format.h>

#include "output/page/digest.hpp"

namespace dashpad::output {

std::string framed(const PageHtml& html) {
  std::string styles = "'" + policy_hash(page_style) + "'";
  std::string elements = fmt::format("<style>{}</style>\n", page_style);
  for (const std::string& style : html.styles) {
    styles += " '" + policy_hash(style) + "'";
    elements += "<style>" + style + "</style>\n";
  }
  return fmt::format(R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src '{}'; style-src {}; img-src data:; base-uri 'none'; form-action 'none'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="robots" content="noindex">
<link rel="icon" href="data:,">
<title>{}</title>
{}</head>
<body>
{}<script>{}</script>
</body>
</html>
)",
                     policy_hash(page_script), styles, html.title, elements, html.body, page_script);
}

}  // namespace dashpad::output
