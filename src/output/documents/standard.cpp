// The document of a standard: its impactor, its criteria, and the source of each value.

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dashpad/output/assessment.hpp"
#include "output/text/capitals.hpp"
#include "output/text/standard_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// The cells: name, value or limit, and source.
using Row = std::vector<std::string>;

std::string source_words(const injury::Origin& origin) {
  return fmt::format("{}{}: {}{}", origin.verified ? "" : "UNVERIFIED; ", to_string(origin.kind),
                     one_line(origin.source), origin.note.empty() ? "" : ". " + one_line(origin.note));
}

Row row_of(const NamedValue& entry, const UnitSystem& units) {
  return {capitalised(entry.name), value_text(entry, units), source_words(entry.value->origin)};
}

Row row_of(const injury::Criterion& criterion, const UnitSystem& units) {
  std::string limit = fmt::format("{} {}", criterion.strict ? "below" : "at most",
                                  brief_quantity(criterion.limit, criterion.quantity->si_unit, units));
  replace_all(limit, " ", "\u00a0");  // no place for a break
  return {injury::title_of(criterion), std::move(limit), one_line(criterion.description),
          source_words(criterion.origin)};
}

Table table_of(const injury::StandardVariant& variant, const UnitSystem& units) {
  Table table{.caption = fmt::format("Variant {}: {}", one_line(variant.name), one_line(variant.title)),
              .columns = {"", "Value", "Source"}};
  const auto add = [&](const char* name, const char* si_unit,
                       const std::optional<injury::StandardValue>& value) {
    if (value) table.rows.push_back(row_of({name, si_unit, &*value}, units));
  };
  add("mass", "kg", variant.mass);
  add("radius", "m", variant.radius);
  add("speed", "m/s", variant.speed);
  return table;
}

/// The names of the variants that are not in force. Those in force are part of the impactor already.
std::string other_variants_text(const injury::Standard& standard) {
  std::string names;
  for (const injury::StandardVariant& variant : standard.variants)
    if (std::ranges::find(standard.chosen, variant.name) == standard.chosen.end())
      names += (names.empty() ? "" : ", ") + one_line(variant.name);
  return names.empty() ? "" : "Variants not chosen: " + names;
}

bool is_unverified(const std::optional<injury::StandardValue>& value) {
  return value && !value->origin.verified;
}

/// Counts the unverified values in force; without a chosen variant, those of all variants.
std::size_t count_unverified(const injury::Standard& standard) {
  const auto bad_value = [](const NamedValue& entry) { return !entry.value->origin.verified; };
  const auto bad_limit = [](const injury::Criterion& criterion) { return !criterion.origin.verified; };
  auto count = static_cast<std::size_t>(std::ranges::count_if(values_of(standard), bad_value) +
                                        std::ranges::count_if(standard.criteria, bad_limit));
  if (!standard.chosen.empty()) return count;
  for (const injury::StandardVariant& variant : standard.variants)
    count += static_cast<std::size_t>(is_unverified(variant.mass)) +
             static_cast<std::size_t>(is_unverified(variant.radius)) +
             static_cast<std::size_t>(is_unverified(variant.speed));
  return count;
}

}  // namespace

std::array<NamedValue, 3> values_of(const injury::Standard& standard) {
  return {
      {{"mass", "kg", &standard.mass}, {"radius", "m", &standard.radius}, {"speed", "m/s", &standard.speed}}};
}

std::string value_text(const NamedValue& entry, const UnitSystem& units) {
  if (!entry.value->value) return "as in the case";
  std::string text = brief_quantity(*entry.value->value, entry.si_unit, units);
  if (entry.value->drop_height)
    text += fmt::format(" (after a fall of {})", brief_quantity(*entry.value->drop_height, "m", units));
  return text;
}

std::string full_name(const injury::Standard& standard) {
  std::string name = standard.name;
  for (const std::string& variant : standard.chosen) name += ":" + variant;
  return one_line(name);
}

std::string standard_line(const injury::Standard& standard) {
  const std::size_t unverified = count_unverified(standard);
  return fmt::format("  {:<28}{}{}\n", one_line(standard.name), one_line(standard.title),
                     unverified > 0 ? fmt::format(" ({} unverified)", plural(unverified, "value")) : "");
}

Document standard_document(const injury::Standard& standard, const UnitSystem& units) {
  Document document{.title = one_line(standard.title), .lead = Lead{.answer = one_line(standard.title)}};
  if (const std::size_t unverified = count_unverified(standard); unverified > 0)
    document.warnings = {"UNVERIFIED: " + plural(unverified, "value") +
                         ", marked below (found neither in the standard nor in a source that quotes it)"};
  Table reading{.columns = {"", ""}, .rows = {{"Name", full_name(standard)}}};
  const auto add = [&reading](const char* what, const std::string& text) {
    if (!text.empty()) reading.rows.push_back({what, one_line(text)});
  };
  add("Text", standard.article);
  add("Source", to_string(standard.source_kind) + ": " + standard.source);
  add("Note", standard.note);
  Table impactor{.columns = {"Impactor", "Value", "Source"}};
  for (const NamedValue& entry : values_of(standard)) impactor.rows.push_back(row_of(entry, units));
  Table criteria{.columns = {"Criterion", "Limit", "Meaning", "Source"}};
  for (const injury::Criterion& criterion : standard.criteria)
    criteria.rows.push_back(row_of(criterion, units));
  Section last{.seen = Seen::always};
  if (standard.chosen.empty())
    for (const injury::StandardVariant& variant : standard.variants)
      last.tables.push_back(table_of(variant, units));
  else if (const std::string others = other_variants_text(standard); !others.empty())
    last.paragraphs.push_back(others);
  document.sections = {{.seen = Seen::always, .tables = {std::move(reading)}},
                       {.heading = "Impactor", .seen = Seen::always, .tables = {std::move(impactor)}},
                       {.heading = "Requirements", .seen = Seen::always, .tables = {std::move(criteria)}},
                       std::move(last),
                       {.seen = Seen::always, .paragraphs = {assessment_caveat()}}};
  return document;
}

}  // namespace dashpad::output
