// Sources as JSON: everything that is known, and CSL-JSON, the format of reference managers.

#include <string>
#include <utility>

#include <fmt/format.h>

#include "dashpad/output/citation.hpp"
#include "json/json_values.hpp"
#include "output/text/citation_words.hpp"

namespace dashpad::output {

namespace {

/// Adds what is known.
void add(Json& json, const char* key, const std::string& text) {
  if (!text.empty()) json[key] = text;
}

Json author_csl(const std::string& author, bool is_alone) {
  const std::size_t comma = author.find(", ");
  if (comma != std::string::npos)
    return {{"family", author.substr(0, comma)}, {"given", author.substr(comma + 2)}};
  return is_alone ? Json{{"literal", author}} : Json{{"family", author}};
}

Json citation_csl(const Citation& citation) {
  Json json{{"id", citation.key}, {"type", citation.type}};
  add(json, "title", citation.title);
  for (const std::string& author : citation.authors)
    json["author"].push_back(author_csl(author, citation.authors.size() == 1));
  if (citation.year > 0) {
    Json date = Json::array({citation.year});
    if (citation.month > 0) date.push_back(citation.month);
    json["issued"] = {{"date-parts", Json::array({date})}};
  }
  for (const auto& [key, text] : {std::pair{"container-title", &citation.container},
                                  {"volume", &citation.volume},
                                  {"page", &citation.pages},
                                  {"edition", &citation.edition},
                                  {"publisher", &citation.publisher},
                                  {"publisher-place", &citation.place},
                                  {"number", &citation.number},
                                  {"version", &citation.version}})
    add(json, key, *text);
  add(json, "note", fmt::format("{}", fmt::join(notes_of(citation), " ")));
  return json;
}

Json citation_json(const Citation& citation) {
  Json json{{"for", to_string(citation.cited)}, {"key", citation.key}, {"type", citation.type}};
  if (!citation.authors.empty()) json["authors"] = citation.authors;
  for (const auto& [key, text] : {std::pair{"title", &citation.title},
                                  {"container", &citation.container},
                                  {"volume", &citation.volume},
                                  {"pages", &citation.pages},
                                  {"edition", &citation.edition},
                                  {"publisher", &citation.publisher},
                                  {"place", &citation.place},
                                  {"number", &citation.number},
                                  {"version", &citation.version}})
    add(json, key, *text);
  if (citation.year > 0) json["year"] = citation.year;
  if (citation.month > 0) json["month"] = citation.month;
  add(json, "source", citation.source);
  json["uses"] = citation.uses;
  json["remarks"] = citation.remarks;
  return json;
}

}  // namespace

std::string citations_csl_json(std::span<const Citation> citations) {
  return json_text(array_of(citations, citation_csl));
}

std::string citations_json(const std::string& name, std::span<const Citation> citations) {
  return result_json_text({{"case", name}, {"sources", array_of(citations, citation_json)}});
}

}  // namespace dashpad::output
