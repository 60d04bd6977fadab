// Sources as BibTeX.

#include <array>
#include <string_view>

#include <fmt/format.h>

#include "dashpad/output/citation.hpp"
#include "output/text/citation_words.hpp"

namespace dashpad::output {

namespace {

/// A text as TeX sets it: its special characters set apart, so that braces balance whatever a card says.
std::string tex(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '#':
      case '$':
      case '%':
      case '&':
      case '_': escaped += {'\\', c}; break;
      case '{': escaped += "\\textbraceleft "; break;
      case '}': escaped += "\\textbraceright "; break;
      case '\\': escaped += "\\textbackslash "; break;
      case '^': escaped += "\\textasciicircum "; break;
      case '~': escaped += "\\textasciitilde "; break;
      default: escaped += c;
    }
  }
  return escaped;
}

/// Types that every style of BibTeX knows.
const char* entry_type(std::string_view csl) {
  if (csl == "report") return "techreport";
  if (csl == "article-journal") return "article";
  return csl == "book" ? "book" : "misc";
}

/// An institution has braces of its own, so that it is not taken for a name.
std::string authors_of(const Citation& citation) {
  std::string text;
  for (const std::string& author : citation.authors)
    text += (text.empty() ? "" : " and ") +
            (citation.authors.size() > 1 || author.find(',') != std::string::npos ? tex(author)
                                                                                  : "{" + tex(author) + "}");
  return text;
}

/// "3--27": the dash of a range.
std::string dashed(const std::string& pages) {
  const std::size_t dash = pages.find('-');
  return dash == std::string::npos ? tex(pages) : tex(pages).replace(dash, 1, "--");
}

std::string entry(const Citation& citation) {
  const std::string type = entry_type(citation.type);
  std::string text = fmt::format("@{}{{{}", type, citation.key);
  const auto add = [&text](const char* name, const std::string& value) {
    if (!value.empty()) text += fmt::format(",\n  {} = {{{}}}", name, value);
  };
  add("author", authors_of(citation));
  // Braces keep the capitals of names.
  if (!citation.title.empty()) add("title", "{" + tex(citation.title) + "}");
  add("journal", tex(citation.container));
  add("volume", tex(citation.volume));
  add("pages", dashed(citation.pages));
  add("edition", tex(citation.edition));
  add(type == "techreport" ? "institution" : "publisher", tex(citation.publisher));
  add("address", tex(citation.place));
  if (citation.cited == Cited::foam && !citation.number.empty())
    add("howpublished", "Material card " + tex(citation.number));
  else
    add("howpublished", tex(citation.number));
  if (!citation.version.empty()) add("howpublished", "Version " + tex(citation.version));
  constexpr std::array months{"jan", "feb", "mar", "apr", "may", "jun",
                              "jul", "aug", "sep", "oct", "nov", "dec"};
  if (citation.month > 0)
    text += fmt::format(",\n  month = {}", months.at(static_cast<std::size_t>(citation.month - 1)));
  if (citation.year > 0) add("year", std::to_string(citation.year));
  add("note", tex(fmt::format("{}", fmt::join(notes_of(citation), " "))));
  return text + "\n}\n";
}

}  // namespace

std::string citations_bibtex(std::span<const Citation> citations) {
  std::string text;
  for (const Citation& citation : citations) text += (text.empty() ? "" : "\n") + entry(citation);
  return text;
}

}  // namespace dashpad::output
