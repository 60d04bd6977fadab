#include "dashpad/output/assessment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/output/text/case.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "output/text/assessment_words.hpp"
#include "output/text/foam_words.hpp"
#include "output/text/interval_words.hpp"
#include "output/text/standard_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

std::string giver(const injury::StandardValue& value) {
  return value.chosen_by_user ? "given by you" : "of the standard";
}

std::array<double, 3> numbers_of(const Impactor& impactor) {
  return {impactor.mass, sphere_radius(impactor.nose), impactor.speed};
}

/// What the user did not want.
std::string of_standard(const NamedValue& entry, const UnitSystem& units) {
  if (!entry.value->instead) return "";
  return fmt::format(", the standard {}", brief_quantity(*entry.value->instead, entry.si_unit, units));
}

/// What the standard's impactor takes the place of, and what stays, a line each.
struct Replaced {
  std::vector<std::string> lines;
  std::string kept;
};
Replaced replaced_in(const AssessmentReport& report, const UnitSystem& units) {
  const std::array<double, 3> of_case = numbers_of(report.given.impactor);
  Replaced replaced;
  std::string kept;
  std::size_t i = 0;
  for (const NamedValue& entry : values_of(report.standard)) {
    const double before = of_case[i++];
    const std::string in_case = std::isnan(before) ? with_article(words_of(report.given.impactor.nose))
                                                   : brief_quantity(before, entry.si_unit, units);
    const std::optional<double>& value = entry.value->value;
    if (!value || !injury::differ(*value, before)) {
      kept += fmt::format("{} ({}{}), ", entry.name, in_case, of_standard(entry, units));
      continue;
    }
    replaced.lines.push_back(fmt::format("{:<8}{}, {}; the case has {}", entry.name, value_text(entry, units),
                                         giver(*entry.value), in_case) +
                             of_standard(entry, units));
  }
  replaced.kept = fmt::format("Kept from the case: {}pad, support, solver.", kept);
  return replaced;
}

std::string replaced_text(const AssessmentReport& report, const UnitSystem& units) {
  const Replaced replaced = replaced_in(report, units);
  std::string text =
      replaced.lines.empty() ? "Nothing of the case was replaced.\n" : "Replaced in the case:\n";
  for (const std::string& line : replaced.lines) text += wrapped("  " + line, 10) + "\n";
  return text + wrapped(replaced.kept, 2) + "\n";
}

/// The figures in force that have sources of one kind; what the user gives or the case has is none of them.
std::vector<std::string> figures_from(injury::SourceKind kind, const injury::Standard& standard) {
  std::vector<std::string> names;
  for (const NamedValue& entry : values_of(standard))
    if (entry.value->value && !entry.value->chosen_by_user && entry.value->origin.kind == kind)
      names.emplace_back(entry.name);
  for (const injury::Criterion& criterion : standard.criteria)
    if (criterion.origin.kind == kind) names.push_back(injury::limit_of(criterion));
  return names;
}

std::string sources_of(const injury::Standard& standard) {
  std::vector<std::string> kinds;
  for (const injury::SourceKind kind :
       {injury::SourceKind::own_text, injury::SourceKind::secondary, injury::SourceKind::none})
    if (const auto names = figures_from(kind, standard); !names.empty())
      kinds.push_back(fmt::format("{} ({})", to_string(kind), fmt::join(names, ", ")));
  return fmt::format("Sources of the standard's figures: {}. dashpad standards {} names them.",
                     fmt::join(kinds, ", "), full_name(standard));
}

/// Each source of what is in force with what comes from it, for those who cannot ask for the standard.
std::vector<std::string> sources_in_full(const injury::Standard& standard) {
  std::vector<std::pair<std::string, std::string>> all;  // source, names
  const auto add = [&](const injury::Origin& origin, const std::string& name) {
    const std::string source = fmt::format("{} ({}{})", one_line(origin.source), to_string(origin.kind),
                                           origin.verified ? "" : ", unverified");
    const auto known = std::ranges::find(all, source, &std::pair<std::string, std::string>::first);
    if (known == all.end())
      all.emplace_back(source, name);
    else
      known->second += ", " + name;
  };
  for (const NamedValue& entry : values_of(standard))
    if (entry.value->value && !entry.value->chosen_by_user) add(entry.value->origin, entry.name);
  for (const injury::Criterion& criterion : standard.criteria)
    add(criterion.origin, injury::limit_of(criterion));
  std::vector<std::string> lines;
  for (const auto& [source, names] : all) lines.push_back(fmt::format("Source of {}: {}.", names, source));
  return lines;
}

/// The sign is there always: a margin of a failed criterion is negative. Of a lower bound it can only shrink.
std::string margin_text(const injury::CriterionResult& result, const UnitSystem& units, int digits) {
  if (!result.margin) return "none";
  const std::string margin =
      brief_quantity(*result.margin, injury::quantity_of(result.criterion.metric).si_unit, units, digits);
  return fmt::format("{}{} ({:+.1f} %)", result.lower_bound ? "≤ " : "",
                     margin.starts_with('-') ? margin : "+" + margin, 100 * *result.relative_margin);
}

/// Only where it may decide, or is asked for.
std::string error_text(const injury::CriterionResult& result, const UnitSystem& units, Detail detail) {
  const bool is_asked_for =
      detail == Detail::all || (result.verdict == injury::Verdict::undecided && !result.interval);
  if (!result.value || !is_asked_for) return "";
  if (!std::isfinite(result.error)) return "± unknown";
  const ScaledUnit unit = shown_as(injury::quantity_of(result.criterion.metric).si_unit, units);
  return fmt::format("± {:.2g} {}", unit.scale * result.error, unit.unit);
}

/// The interval with what makes it, the largest first and alone where not all is asked for.
std::string interval_lines(const injury::CriterionResult& result, const std::optional<Intervals>& intervals,
                           const UnitSystem& units, Detail detail) {
  if (!result.interval || !intervals || result.interval->sources.empty()) return "";
  std::vector<std::string> sources = source_words(*result.interval, *intervals, units);
  const std::size_t others = sources.size() - 1;
  if (detail == Detail::main) sources.resize(1);
  std::string text = wrapped(
      fmt::format("    {} at 95 %, by {}", interval_words(*result.interval, units), fmt::join(sources, "; ")),
      6);
  if (detail == Detail::main && others > 0)
    text = wrapped(fmt::format("    {} at 95 %, by {}, and by {} more (--all)",
                               interval_words(*result.interval, units), sources.front(), others),
                   6);
  return text + "\n";
}

std::string row(const injury::CriterionResult& result, const std::optional<Intervals>& intervals,
                const UnitSystem& units, Detail detail) {
  const int digits = digits_of(detail);
  const std::string unit = injury::quantity_of(result.criterion.metric).si_unit;
  const std::string value = result.value ? brief_quantity(*result.value, unit, units, digits) : "none";
  std::string line =
      fmt::format("  {:<24}{:>12} {:<12}{:>10}  {:<23}{}\n", injury::title_of(result.criterion),
                  (result.lower_bound ? "≥ " : "") + value, error_text(result, units, detail),
                  (result.criterion.strict ? "< " : "") + brief_quantity(result.criterion.limit, unit, units),
                  margin_text(result, units, digits), to_string(result.verdict));
  if (!result.reason.empty()) line += wrapped("    " + result.reason, 4) + "\n";
  return line + interval_lines(result, intervals, units, detail);
}

/// A line of two figures: "  Peak acceleration        108.7 g     Peak strain             0.8".
std::string figures_text(const injury::KeyFigures& of, const UnitSystem& units, int digits) {
  const auto cell = [&](const char* key, const injury::Figure& figure) {
    const ResultQuantity& quantity = result_quantity(key);
    return fmt::format("{:<19}{:>12}", quantity.title,
                       figure.value ? (figure.lower_bound ? "≥ " : "") +
                                          brief_quantity(*figure.value, quantity.si_unit, units, digits)
                                    : "none");
  };
  return fmt::format("  {}     {}\n  {}     {}\n  {}     {}\n",
                     cell("peak_acceleration", of.peak_acceleration), cell("peak_strain", of.peak_strain),
                     cell("hic15", of.hic15), cell("contact_end", of.contact_end), cell("hic36", of.hic36),
                     cell("rebound_speed", of.rebound_speed)) +
         (of.restitution.value ? fmt::format("  {:<31}     {}\n", "", cell("restitution", of.restitution))
                               : "");
}

std::string upper_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return text;
}

/// The answer, with the names of what stands beside it.
std::string verdict_text(const AssessmentReport& report, const UnitSystem& units) {
  const injury::Assessment& assessment = report.assessment;
  std::vector<std::string> names;
  for (const Flag& reservation : assessment.reservations)
    if (std::ranges::find(names, reservation.name) == names.end()) names.push_back(reservation.name);
  std::string text = upper_case(to_string(assessment.verdict));
  if (!names.empty()) text += fmt::format(", with reservations: {}", fmt::join(names, ", "));
  text = wrapped(text, 2) + "\n";
  const Summary& summary = report.solution.summary;
  if (bottomed_on_rigid_support(summary))
    text += fmt::format("The pad bottomed out at {}: on its rigid support no force is finite then.\n",
                        brief_quantity(summary.bottomed->velocity, "m/s", units));
  return text;
}

std::string reservations_text(const injury::Assessment& assessment) {
  std::string text;
  for (const Flag& reservation : assessment.reservations)
    text += wrapped("  - " + one_line(reservation.text), 4) + "\n";
  return text.empty() ? "" : "Reservations:\n" + text + "\n";
}

/// That which is next to its limit, or farthest beyond it; null without a margin.
const injury::CriterionResult* closest(const injury::Assessment& assessment) {
  const injury::CriterionResult* least = nullptr;
  for (const injury::CriterionResult& result : assessment.results)
    if (result.relative_margin && (least == nullptr || *result.relative_margin < *least->relative_margin))
      least = &result;
  return least;
}

/// The one that is undecided, of several that which is next to its limit.
const injury::CriterionResult& undecided_of(const injury::Assessment& assessment,
                                            const injury::CriterionResult& next) {
  if (next.verdict == injury::Verdict::undecided) return next;
  const auto of =
      std::ranges::find(assessment.results, injury::Verdict::undecided, &injury::CriterionResult::verdict);
  return of == assessment.results.end() ? next : *of;
}

}  // namespace

std::string doubt_about_pass(const AssessmentReport& report) {
  const injury::Assessment& assessment = report.assessment;
  const Summary& summary = report.solution.summary;
  const injury::CriterionResult* const next = closest(assessment);
  if (assessment.verdict != injury::Verdict::pass || next == nullptr) return "";
  const auto in_g = [](double acceleration) {
    return brief(rounded_to(acceleration / standard_gravity, 3)) + " g";
  };
  if (is_struck_through(summary.peak_penetration, report.assessed.pad.thickness))
    return ", but the pad is struck through" +
           (summary.peak_acceleration ? ", at a peak of " + in_g(*summary.peak_acceleration) : "");
  return "";
}

std::string assessment_answer(const AssessmentReport& report, const UnitSystem& units) {
  const injury::Assessment& assessment = report.assessment;
  const Summary& summary = report.solution.summary;
  if (assessment.verdict == injury::Verdict::fail && bottomed_on_rigid_support(summary))
    return fmt::format("Fails: the pad bottoms out with {} left",
                       brief_quantity(summary.bottomed->velocity, "m/s", units, 3));
  const injury::CriterionResult* const next = closest(assessment);
  if (next == nullptr)
    return is_cut(summary) ? "Undecided: the run ends before the impact does"
                           : "Undecided: the pulse says too little";
  const std::string name = injury::title_of(next->criterion);
  const std::string margin =
      brief_quantity(std::abs(*next->margin), injury::quantity_of(next->criterion.metric).si_unit, units, 3);
  switch (assessment.verdict) {
    case injury::Verdict::pass:
      return fmt::format("Passes: {} has {} to spare{}", name, margin, doubt_about_pass(report));
    case injury::Verdict::fail: return fmt::format("Fails: {} is {} above its limit", name, margin);
    case injury::Verdict::undecided: break;
  }
  const injury::CriterionResult& open = undecided_of(assessment, *next);
  if (!open.interval) return fmt::format("Undecided: {} is {} from its limit", name, margin);
  const std::string limit =
      brief_quantity(open.criterion.limit, injury::quantity_of(open.criterion.metric).si_unit, units);
  return fmt::format("Undecided: {} is {}, and {} {} is asked for", injury::title_of(open.criterion),
                     interval_words(*open.interval, units), open.criterion.strict ? "below" : "at most",
                     limit);
}

Table criteria_table(const AssessmentReport& report, const UnitSystem& units) {
  Table table{
      .caption = one_line(report.standard.title),
      .columns = {"Criterion", "Value", "95 % interval", "Numerical error", "Limit", "Margin", "Verdict"},
      .rows = {}};
  const int digits = digits_of(Detail::main);
  for (const injury::CriterionResult& of : report.assessment.results) {
    const std::string unit = injury::quantity_of(of.criterion.metric).si_unit;
    table.rows.push_back(
        {injury::title_of(of.criterion),
         of.value ? (of.lower_bound ? "≥ " : "") + brief_quantity(*of.value, unit, units, digits) : "none",
         of.interval ? interval_words(*of.interval, units) : "", error_text(of, units, Detail::all),
         (of.criterion.strict ? "< " : "") + brief_quantity(of.criterion.limit, unit, units),
         margin_text(of, units, digits),
         to_string(of.verdict) + (of.reason.empty() ? "" : ": " + one_line(of.reason))});
  }
  return table;
}

std::vector<std::string> assessment_basis(const AssessmentReport& report, const UnitSystem& units) {
  const Replaced replaced = replaced_in(report, units);
  std::vector<std::string> lines;
  std::string impactor;
  for (const std::string& line : replaced.lines) impactor += (impactor.empty() ? "" : "; ") + line;
  std::string other;
  for (const NamedValue& entry : values_of(report.standard))
    if (entry.value->value && entry.value->instead)
      other += fmt::format(" The {} is {}, where the standard has {}.", entry.name,
                           brief_quantity(*entry.value->value, entry.si_unit, units, 3),
                           brief_quantity(*entry.value->instead, entry.si_unit, units, 3));
  lines.push_back(
      (impactor.empty() ? "Nothing of the case was replaced." : "Replaced in the case: " + impactor + ".") +
      other);
  lines.push_back(replaced.kept);
  for (std::string& line : sources_in_full(report.standard)) lines.push_back(std::move(line));
  if (!report.standard.note.empty()) lines.push_back(report.standard.note);
  return lines;
}

const std::string& assessment_caveat() {
  static const std::string caveat =
      "A computation with one rigid sphere on a flat pad: no test to the standard and no certification.";
  return caveat;
}

std::string assessment_text(const AssessmentReport& report, const UnitSystem& units, Detail detail) {
  const injury::Standard& standard = report.standard;
  std::string text = verdict_text(report, units);
  text += wrapped(fmt::format("{} ({})", one_line(standard.title), full_name(standard)), 2) + "\n\n";
  text += fmt::format("  {:<24}{:>12} {:<12}{:>10}  {}\n", "Criterion", "value",
                      detail == Detail::all ? "error" : "", "limit", "margin");
  for (const injury::CriterionResult& result : report.assessment.results)
    text += row(result, report.solution.summary.intervals, units, detail);
  text += "\nThe impact:\n" + figures_text(report.assessment.figures, units, digits_of(detail)) + "\n";
  text += reservations_text(report.assessment) + wrapped_lines(case_text(report.assessed, units));
  text += replaced_text(report, units) + wrapped(sources_of(standard), 2) + "\n";
  if (!standard.note.empty()) text += wrapped(one_line(standard.note), 0) + "\n";
  return text + "\n" + assessment_caveat() + "\n";
}

}  // namespace dashpad::output
