// A standard as text.

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "dashpad/output/assessment.hpp"
#include "output/text/standard_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

std::string origin_text(const injury::Origin& origin) {
  std::string text = wrapped(fmt::format("      {}{}: {}", origin.verified ? "" : "UNVERIFIED; ",
                                         to_string(origin.kind), one_line(origin.source)),
                             8) +
                     "\n";
  if (!origin.note.empty()) text += wrapped("      " + one_line(origin.note), 6) + "\n";
  return text;
}

std::string entry_text(const NamedValue& entry, const UnitSystem& units) {
  return fmt::format("    {:<8}{}\n", entry.name, value_text(entry, units)) +
         origin_text(entry.value->origin);
}

std::string criterion_text(const injury::Criterion& criterion, const UnitSystem& units) {
  return wrapped(fmt::format(
                     "    {}: {} {}; {}", injury::title_of(criterion), criterion.strict ? "below" : "at most",
                     brief_quantity(criterion.limit, injury::quantity_of(criterion.metric).si_unit, units),
                     one_line(criterion.description)),
                 6) +
         "\n" + origin_text(criterion.origin);
}

std::string variant_text(const injury::StandardVariant& variant, const UnitSystem& units) {
  std::string text = fmt::format("\n  Variant {}: {}\n", variant.name, one_line(variant.title));
  if (variant.mass) text += entry_text({"mass", "kg", &*variant.mass}, units);
  if (variant.radius) text += entry_text({"radius", "m", &*variant.radius}, units);
  if (variant.speed) text += entry_text({"speed", "m/s", &*variant.speed}, units);
  return text;
}

std::string variants_text(const injury::Standard& standard, const UnitSystem& units) {
  std::string text;
  for (const injury::StandardVariant& variant : standard.variants) text += variant_text(variant, units);
  return text;
}

/// Those that are in force are part of the impactor; of the others the names are enough.
std::string other_variants_text(const injury::Standard& standard) {
  std::string names;
  for (const injury::StandardVariant& variant : standard.variants)
    if (std::ranges::find(standard.chosen, variant.name) == standard.chosen.end())
      names += (names.empty() ? "" : ", ") + one_line(variant.name);
  return names.empty() ? "" : "\n  Not in force: " + names + "\n";
}

bool is_unverified(const std::optional<injury::StandardValue>& value) {
  return value && !value->origin.verified;
}

/// Of the values in force. Where no variant was chosen all may still be.
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

std::string values_counted(std::size_t count) {
  return fmt::format("{} value{}", count, count == 1 ? "" : "s");
}

}  // namespace

std::array<NamedValue, 3> values_of(const injury::Standard& standard) {
  return {
      {{"mass", "kg", &standard.mass}, {"radius", "m", &standard.radius}, {"speed", "m/s", &standard.speed}}};
}

std::string value_text(const NamedValue& entry, const UnitSystem& units) {
  if (!entry.value->value) return "the case's";
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
                     unverified > 0 ? fmt::format(" ({} unverified)", values_counted(unverified)) : "");
}

std::string standard_text(const injury::Standard& standard, const UnitSystem& units) {
  const auto line = [](const std::string& label, const std::string& of) {
    return wrapped(fmt::format("  {:<9}{}", label, one_line(of)), 11) + "\n";
  };
  std::string text = one_line(standard.title) + "\n" + line("Name", full_name(standard));
  if (!standard.article.empty()) text += line("Own text", standard.article);
  text += line("Read", to_string(standard.source_kind) + ": " + standard.source);
  if (!standard.note.empty()) text += line("Note", standard.note);
  if (const std::size_t unverified = count_unverified(standard); unverified > 0)
    text += line("WARNING", values_counted(unverified) +
                                " not read in the standard or a source that repeats it: UNVERIFIED below");
  text += "\n  Impactor\n";
  for (const NamedValue& entry : values_of(standard)) text += entry_text(entry, units);
  text += "\n  Criteria\n";
  for (const injury::Criterion& criterion : standard.criteria) text += criterion_text(criterion, units);
  text += standard.chosen.empty() ? variants_text(standard, units) : other_variants_text(standard);
  return text + "\n" + assessment_caveat() + "\n";
}

}  // namespace dashpad::output
