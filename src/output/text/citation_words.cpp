#include "output/text/citation_words.hpp"

#include <array>

#include <fmt/format.h>

namespace dashpad::output {

namespace {

std::string date_words(const Citation& citation) {
  constexpr std::array months{"January", "February", "March",     "April",   "May",      "June",
                              "July",    "August",   "September", "October", "November", "December"};
  if (citation.month == 0) return std::to_string(citation.year);
  return fmt::format("{} {}", months.at(static_cast<std::size_t>(citation.month - 1)), citation.year);
}

std::string without_stop(std::string text) {
  while (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

std::string reference_words(const Citation& citation) {
  std::vector<std::string> parts;
  const auto add = [&parts](std::string part) {
    if (!part.empty()) parts.push_back(without_stop(std::move(part)));
  };
  add(citation.title + (citation.cited == Cited::foam && !citation.number.empty()
                            ? fmt::format(" (material card {})", citation.number)
                            : ""));
  if (citation.cited == Cited::standard) add(citation.number);
  if (!citation.version.empty()) add("Version " + citation.version);
  if (!citation.edition.empty()) add(fmt::format("Edition {}", citation.edition));
  if (!citation.container.empty()) {
    add(fmt::format("{} {} ({}){}", citation.container, citation.volume, citation.year,
                    citation.pages.empty() ? "" : " " + citation.pages));
  } else {
    std::string published = citation.publisher;
    for (const std::string& part : {citation.place, citation.year > 0 ? date_words(citation) : std::string()})
      if (!part.empty()) published += (published.empty() ? "" : ", ") + part;
    add(published);
  }
  const std::string authors =
      citation.authors.empty() ? "" : fmt::format("{}: ", fmt::join(citation.authors, "; "));
  return authors + fmt::format("{}.", fmt::join(parts, ". "));
}

std::vector<std::string> notes_of(const Citation& citation) {
  std::vector<std::string> notes;
  if (!citation.source.empty()) notes.push_back(fmt::format("Source: {}.", without_stop(citation.source)));
  const char* const label = citation.cited == Cited::foam       ? "Known"
                            : citation.cited == Cited::standard ? "Values"
                                                                : "Used for";
  if (!citation.uses.empty()) notes.push_back(fmt::format("{}: {}.", label, fmt::join(citation.uses, "; ")));
  for (const std::string& remark : citation.remarks) notes.push_back(without_stop(remark) + ".");
  return notes;
}

}  // namespace dashpad::output
