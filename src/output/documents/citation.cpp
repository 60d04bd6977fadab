// The sources of a result, and how they are said in words.

#include "dashpad/output/citation.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "dashpad/output/document.hpp"
#include "dashpad/version.hpp"
#include "output/documents/assessment.hpp"
#include "output/documents/basis.hpp"
#include "output/text/capitals.hpp"
#include "output/text/citation_words.hpp"
#include "output/text/standard_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// A key for BibTeX: other characters than letters and digits become a hyphen.
std::string key_of(const std::string& name) {
  std::string key;
  for (const char c : name) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (is_plain)
      key += c;
    else if (!key.empty() && key.back() != '-')
      key += '-';
  }
  return key;
}

Citation foam_citation(const Material& material, const PadCondition& condition) {
  Citation foam{
      .cited = Cited::foam,
      .key = "foam-" + key_of(material.name),
      .type = "dataset",
      .title = material.title.empty() ? capitalised(one_line(material.name)) : one_line(material.title)};
  foam.source = source_of(material);
  if (material.name != foam_of_the_case) foam.number = one_line(material.name);
  foam.uses.push_back(fmt::format("{} law", name_of(material.law)));
  if (const std::string known = known_of(material, plain_si()); !known.empty()) foam.uses.push_back(known);
  if (const double factor = stress_factor(condition, material); factor != 1)
    foam.remarks.push_back(fmt::format("The case multiplies its stresses by {}.", brief(factor)));
  if (!material.basis.empty()) foam.remarks.push_back(fmt::format("Basis: {}.", one_line(material.basis)));
  for (const std::string& reservation : material.reservations) foam.remarks.push_back(one_line(reservation));
  if (!material.licence.empty())
    foam.remarks.push_back(fmt::format("Licence: {}.", one_line(material.licence)));
  return foam;
}

Citation standard_citation(const injury::Standard& standard) {
  Citation cited{.cited = Cited::standard,
                 .key = "standard-" + key_of(full_name(standard)),
                 .type = "standard",
                 .title = one_line(standard.title)};
  cited.number = one_line(standard.article);
  cited.source = fmt::format("{}: {}", to_string(standard.source_kind), one_line(standard.source));
  std::string unverified;
  for (const Basis& row : sources_in_full(standard)) {
    cited.uses.push_back(fmt::format("{}: {}", uncapitalised(row.value), row.source));
    if (!row.doubt.empty()) unverified += (unverified.empty() ? "" : ", ") + uncapitalised(row.value);
  }
  if (!unverified.empty()) cited.remarks.push_back(fmt::format("Unverified: {}.", unverified));
  if (!standard.note.empty()) cited.remarks.push_back(one_line(standard.note));
  return cited;
}

/// "Avalle, M.; Ibba, A." as a list.
std::vector<std::string> parts_of(std::string_view authors) {
  std::vector<std::string> parts;
  while (!authors.empty()) {
    const std::size_t end = std::min(authors.find("; "), authors.size());
    parts.emplace_back(authors.substr(0, end));
    authors.remove_prefix(std::min(end + 2, authors.size()));
  }
  return parts;
}

Citation method_citation(const Use& use) {
  const Publication& from = *use.publication;
  Citation cited{
      .key = std::string(from.key), .type = std::string(from.type), .authors = parts_of(from.authors)};
  const std::pair<std::string Citation::*, std::string_view> texts[]{
      {&Citation::title, from.title},     {&Citation::container, from.container},
      {&Citation::volume, from.volume},   {&Citation::pages, from.pages},
      {&Citation::edition, from.edition}, {&Citation::publisher, from.publisher},
      {&Citation::place, from.place}};
  for (const auto& [member, text] : texts) cited.*member = text;
  cited.year = from.year;
  cited.month = from.month;
  if (!from.read_at.empty()) cited.source = fmt::format("read at {}", from.read_at);
  cited.uses = use.what;
  if (const std::string places = places_of(use); !places.empty())
    cited.remarks.push_back(fmt::format("Where: {}.", places));
  if (from.key == this_program) {
    cited.cited = Cited::program;
    cited.version = fmt::format("{} (commit {})", build_facts().version, build_facts().git_commit);
  }
  return cited;
}

void make_keys_unique(std::vector<Citation>& citations) {
  std::set<std::string> taken;
  for (Citation& citation : citations) {
    const std::string first = citation.key;
    for (int number = 2; !taken.insert(citation.key).second; ++number)
      citation.key = fmt::format("{}-{}", first, number);
  }
}

}  // namespace

std::string to_string(Cited cited) {
  constexpr std::array names{"foam", "standard", "method", "program"};
  return names.at(static_cast<std::size_t>(cited));
}

std::vector<Citation> citations_of(const ImpactCase& impact, std::span<const injury::Standard> standards) {
  std::vector<Citation> citations;
  const Pad& pad = impact.pad;
  std::set<std::pair<std::string, double>> foams;  // a card may be in several layers
  const auto add = [&](const Material& material, const PadCondition& condition) {
    const bool is_card = material.name != foam_of_the_case;
    if (!is_card || foams.emplace(material.name, stress_factor(condition, material)).second)
      citations.push_back(foam_citation(material, condition));
  };
  if (pad.layers.empty()) add(pad.material, pad.condition);
  for (const PadLayer& layer : pad.layers) add(layer.material, layer.condition);
  for (const injury::Standard& standard : standards) citations.push_back(standard_citation(standard));
  for (const Use& use : method_of(impact)) citations.push_back(method_citation(use));
  make_keys_unique(citations);
  return citations;
}

std::string citations_text(const std::string& name, std::span<const Citation> citations) {
  Document document{.title = fmt::format("Sources of the results of {}", one_line(name))};
  for (std::size_t i = 0; i < citations.size(); ++i) {
    const Citation& citation = citations[i];
    const bool is_first = i == 0 || citations[i - 1].cited != citation.cited;
    std::vector<std::string> lines{reference_words(citation)};
    for (const std::string& note : notes_of(citation)) lines.push_back("  " + note);
    document.sections.push_back({.heading = is_first ? capitalised(to_string(citation.cited)) : "",
                                 .seen = Seen::always,
                                 .paragraphs = std::move(lines)});
  }
  return to_terminal(document, Detail::all);
}

}  // namespace dashpad::output
