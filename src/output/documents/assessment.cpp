#include "output/documents/assessment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "dashpad/injury/figures.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "injury/short_spike.hpp"
#include "output/documents/basis.hpp"
#include "output/plot/foam_figures.hpp"
#include "output/plot/impact_figures.hpp"
#include "output/result_rows.hpp"
#include "output/text/capitals.hpp"
#include "output/text/case_toml.hpp"
#include "output/text/standard_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

std::array<double, 3> numbers_of(const Impactor& impactor) {
  return {impactor.mass, sphere_radius(impactor.nose), impactor.speed};
}

/// The value of the standard that the user replaced: "; 6.7 m/s in the standard"; "" without one.
std::string of_standard(const NamedValue& entry, const UnitSystem& units) {
  if (!entry.value->instead) return "";
  return fmt::format("{} in the standard", brief_quantity(*entry.value->instead, entry.si_unit, units));
}

/// The text between two others; empty if it is.
std::string enclosed(const char* before, const std::string& text, const char* behind) {
  return text.empty() ? "" : before + text + behind;
}

/// The values of the case that the standard replaces, a line each, and those that are kept.
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
      kept += fmt::format("{} ({}{}), ", entry.name, in_case, enclosed("; ", of_standard(entry, units), ""));
      continue;
    }
    replaced.lines.push_back(fmt::format("{}, {}{} instead of {}{}", entry.name, value_text(entry, units),
                                         entry.value->chosen_by_user ? " given by you" : " from the standard",
                                         in_case, enclosed(" (", of_standard(entry, units), ")")));
  }
  replaced.kept = fmt::format("Kept from the case: {}pad, support and solver settings.", kept);
  return replaced;
}

/// The names and origins of the standard's figures in force, without values from the user or the case.
std::vector<std::pair<std::string, const injury::Origin*>> origins_of(const injury::Standard& standard) {
  std::vector<std::pair<std::string, const injury::Origin*>> all;
  for (const NamedValue& entry : values_of(standard))
    if (entry.value->value && !entry.value->chosen_by_user)
      all.emplace_back(entry.name, &entry.value->origin);
  for (const injury::Criterion& criterion : standard.criteria)
    all.emplace_back(injury::limit_of(criterion), &criterion.origin);
  return all;
}

std::string sources_of(const injury::Standard& standard) {
  std::vector<std::string> kinds;
  for (const injury::SourceKind kind :
       {injury::SourceKind::own_text, injury::SourceKind::secondary, injury::SourceKind::none}) {
    std::vector<std::string> names;
    for (const auto& [name, origin] : origins_of(standard))
      if (origin->kind == kind) names.push_back(name);
    if (!names.empty()) kinds.push_back(fmt::format("{} ({})", to_string(kind), fmt::join(names, ", ")));
  }
  return fmt::format("Sources of the standard's values: {}; dashpad standards {} lists them.",
                     fmt::join(kinds, ", "), full_name(standard));
}

/// The one that is undecided, of several that which is next to its limit.
const injury::CriterionResult& undecided_of(const injury::Assessment& assessment,
                                            const injury::CriterionResult& next) {
  if (next.verdict == injury::Verdict::undecided) return next;
  const auto of =
      std::ranges::find(assessment.results, injury::Verdict::undecided, &injury::CriterionResult::verdict);
  return of == assessment.results.end() ? next : *of;
}

/// The reason to doubt a pass beside its interval, the spike that no clip sees or the pad that is struck
/// through; empty without one.
std::string doubt_about_pass(const AssessmentReport& report) {
  const Summary& summary = report.solution.summary;
  if (report.assessment.verdict != injury::Verdict::pass || closest(report.assessment.results) == nullptr)
    return "";
  const std::vector<Flag>& reservations = report.assessment.reservations;
  if (const auto spike = std::ranges::find(reservations, injury::short_spike_name, &Flag::name);
      spike != reservations.end())
    return ", but " + injury::words_of(*spike);
  if (!is_struck_through(summary.peak_penetration, report.assessed.pad.thickness)) return "";
  const std::string text = ", but less than 0.1 % of the pad thickness is left";
  if (!summary.peak_acceleration) return text;
  const double peak = rounded_to(*summary.peak_acceleration / standard_gravity, 3);
  return text + ", at a peak of " + brief(peak) + " g";
}

/// "Passes: 3 ms clip has 3.66 g to spare", by the criterion next to its limit or farthest beyond it.
std::string answer_of(const AssessmentReport& report, const UnitSystem& units) {
  const injury::Assessment& assessment = report.assessment;
  const Summary& summary = report.solution.summary;
  if (assessment.verdict == injury::Verdict::fail && bottomed_on_rigid_support(summary))
    return fmt::format("Fails: the pad bottoms out with the impactor still moving at {}",
                       brief_quantity(summary.bottomed->velocity, "m/s", units, 3));
  const injury::CriterionResult* const next = closest(assessment.results);
  if (next == nullptr)
    return is_cut(summary) ? "Undecided: the run ends before the impact does"
                           : "Undecided: the pulse is incomplete";
  const std::string name = uncapitalised(injury::title_of(next->criterion));
  const std::string margin = margin_words(*next, units, 3);
  switch (assessment.verdict) {
    case injury::Verdict::pass:
      return fmt::format("Passes: {} has {} to spare{}", name, margin, doubt_about_pass(report));
    case injury::Verdict::fail: return fmt::format("Fails: {} is {} above its limit", name, margin);
    case injury::Verdict::undecided: break;
  }
  const injury::CriterionResult& open = undecided_of(assessment, *next);
  if (!open.interval) return fmt::format("Undecided: {} is {} from its limit", name, margin);
  const std::string limit = brief_quantity(open.criterion.limit, open.criterion.quantity->si_unit, units);
  const std::string range = interval_words(*open.interval, units);
  // "from 95 to 160 g", but "95 g or more", "at most 160 g"
  const bool has_both = range.find(" to ") != std::string::npos;
  return fmt::format("Undecided: {} could be {}{}, but must be {} {}",
                     uncapitalised(injury::title_of(open.criterion)), has_both ? "anywhere from " : "",
                     range == "unbounded" ? "any value" : range, open.criterion.strict ? "below" : "at most",
                     limit);
}

/// The distance of a criterion from its limit, with its share of the limit.
std::string distance(const injury::CriterionResult& result, const UnitSystem& units, int digits) {
  return fmt::format("{} ({:.1f} %)", margin_words(result, units, digits),
                     100 * std::abs(*result.relative_margin));
}

std::string verdict_words(const injury::CriterionResult& result, const UnitSystem& units, int digits) {
  std::string words = to_string(result.verdict);
  if (result.margin && result.verdict == injury::Verdict::pass)
    words += " with " + distance(result, units, digits) + " to spare";
  else if (result.margin && result.verdict == injury::Verdict::fail)
    words += " by " + distance(result, units, digits) + (result.lower_bound ? " or more" : "");
  return words + (result.reason.empty() ? "" : ": " + one_line(result.reason));
}

/// The criteria, then other figures to judge the impact by.
std::vector<ValueRow> figures_of(const AssessmentReport& report, const UnitSystem& units, Detail detail) {
  std::vector<ValueRow> rows = bottoming_figures(report.assessed, report.solution.summary, units);
  const char* const on_strain = report.assessed.pad.layers.empty()
                                    ? "1 = fully compressed pad"
                                    : "for all layers together; 1 = fully compressed pad";
  for (const auto& [key, member] : figures_of_assessment) {
    const injury::Figure& figure = report.assessment.figures.*member;
    const ResultQuantity& quantity = result_quantity(key);
    const auto is_limited = [&](const injury::CriterionResult& result) {
      return injury::title_of(result.criterion) == quantity.title;
    };
    if (!figure.value || std::ranges::any_of(report.assessment.results, is_limited)) continue;
    rows.push_back({.key = key,
                    .label = quantity.title,
                    .value = (figure.lower_bound ? "≥ " : "") +
                             brief_quantity(*figure.value, quantity.si_unit, units, digits_of(detail)),
                    .remark = member == &injury::KeyFigures::peak_strain ? on_strain : ""});
  }
  add_intervals(rows, report.solution.summary, units);
  std::vector<ValueRow> all = criterion_rows(report.assessment.results, units, detail);
  std::ranges::move(rows, std::back_inserter(all));
  return all;
}

/// The interval of each criterion with its largest source.
std::vector<std::string> interval_lines(const AssessmentReport& report, const UnitSystem& units) {
  std::vector<std::string> lines;
  const std::optional<Intervals>& intervals = report.solution.summary.intervals;
  for (const injury::CriterionResult& result : report.assessment.results) {
    if (!result.interval || !intervals || result.interval->sources.empty()) continue;
    const std::vector<std::string> sources = source_words(*result.interval, *intervals, units);
    lines.push_back(fmt::format(
        "{}: 95 % interval {}. The {} source of uncertainty is {}{}.", injury::title_of(result.criterion),
        interval_words(*result.interval, units), sources.size() == 1 ? "only contributing" : "largest",
        sources.front(),
        sources.size() == 1 ? "" : fmt::format(" by itself; --all lists {} more", sources.size() - 1)));
  }
  return lines;
}

std::vector<Basis> basis_of(const AssessmentReport& report, const UnitSystem& units) {
  std::vector<Basis> rows = case_basis(report.assessed, units);
  const injury::Standard& standard = report.standard;
  rows.push_back({.what = "Standard",
                  .value = fmt::format("{} ({}){}{}", one_line(standard.title), full_name(standard),
                                       standard.article.empty() ? "" : "; ", one_line(standard.article)),
                  .doubt = one_line(standard.note)});
  for (Basis& row : sources_in_full(standard)) rows.push_back(std::move(row));
  const injury::KeyFigures& figures = report.assessment.figures;
  std::ranges::move(method_basis(report.assessed, {figures.hic15.value || figures.hic36.value,
                                                   report.solution.summary.intervals.has_value()}),
                    std::back_inserter(rows));
  rows.push_back(solver_basis(report.solution.summary));
  return rows;
}

Document texts_of(const AssessmentReport& report, const UnitSystem& units) {
  const injury::Assessment& assessment = report.assessment;
  const injury::Standard& standard = report.standard;
  const Summary& summary = report.solution.summary;
  const std::string title = one_line(report.assessed.title);
  Document document{
      .title = title,
      .lead = Lead{.answer = answer_of(report, units),
                   .tone = doubt_about_pass(report).empty() ? tone_of(assessment.verdict) : Tone::doubtful,
                   .subject = {fmt::format("{} ({})", one_line(standard.title), full_name(standard)),
                               title.empty() ? "" : "Case: " + title,
                               summary.blows > 1
                                   ? fmt::format("Figures for blow {} of {}", summary.blow, summary.blows)
                                   : ""},
                   .figures = figures_of(report, units, Detail::main)},
      .is_one_impact = true};
  document.warnings = by_severity(assessment.reservations);
  const Replaced replaced = replaced_in(report, units);
  std::vector<std::string> brief = interval_lines(report, units);
  for (std::string& line : case_lines(report.assessed, units)) brief.push_back(std::move(line));
  if (replaced.lines.empty())
    brief.emplace_back("No values of the case were replaced.");
  else
    document.lead->subject.push_back(
        fmt::format("Replaced in the case: {}.", fmt::join(replaced.lines, "; ")));
  brief.push_back(replaced.kept);
  brief.push_back(sources_of(standard));
  if (!standard.note.empty()) brief.push_back(one_line(standard.note));
  document.sections = {{.seen = Seen::in_brief, .paragraphs = std::move(brief)},
                       {.heading = "Figures", .rows = {{"", figures_of(report, units, Detail::all)}}}};
  if (const auto& intervals = summary.intervals; intervals && !intervals->figures.empty()) {
    std::vector<std::string> limited;
    for (const injury::CriterionResult& result : assessment.results)
      limited.emplace_back(result.criterion.quantity->key);
    document.sections.push_back({.heading = "Uncertainty of the figures",
                                 .paragraphs = interval_paragraphs(summary, units),
                                 .tables = {interval_table(summary, units, limited)}});
  }
  document.sections.push_back({.heading = basis_heading,
                               .paragraphs = {replaced.kept},
                               .tables = {basis_table(basis_of(report, units))}});
  document.sections.push_back({.seen = Seen::always, .paragraphs = {assessment_caveat()}});
  return document;
}

void add_plots(Document& document, const AssessmentReport& report, const UnitSystem& units) {
  const auto basis = std::ranges::find(document.sections, basis_heading, &Section::heading);
  if (std::optional<Plot> foam = foam_curve_plot(report.assessed.pad, report.solution.summary, units))
    basis->figures.push_back({.plot = *std::move(foam)});
  document.sections.push_back(
      {.heading = "Plots",
       .seen = Seen::on_pages,
       .figures = impact_figures(report.assessed, report.solution,
                                 injury::whole_pulse_figures(report.solution), units)});
}

}  // namespace

std::vector<Basis> sources_in_full(const injury::Standard& standard) {
  std::vector<Basis> all;
  for (const auto& [name, origin] : origins_of(standard)) {
    const std::string source = fmt::format("{} ({})", one_line(origin->source), to_string(origin->kind));
    const std::string doubt = origin->verified ? "" : "unverified";
    auto known = all.begin();
    while (known != all.end() && (known->source != source || known->doubt != doubt)) ++known;
    if (known == all.end())
      all.push_back({"", capitalised(name), source, doubt});
    else
      known->value += ", " + name;
  }
  return all;
}

std::string margin_words(const injury::CriterionResult& result, const UnitSystem& units, int digits) {
  return brief_quantity(std::abs(*result.margin), result.criterion.quantity->si_unit, units, digits);
}

const injury::CriterionResult* closest(const std::vector<injury::CriterionResult>& results) {
  const injury::CriterionResult* least = nullptr;
  for (const injury::CriterionResult& result : results)
    if (result.relative_margin && (least == nullptr || *result.relative_margin < *least->relative_margin))
      least = &result;
  return least;
}

Tone tone_of(injury::Verdict verdict) {
  switch (verdict) {
    case injury::Verdict::pass: return Tone::good;
    case injury::Verdict::fail: return Tone::bad;
    case injury::Verdict::undecided: break;
  }
  return Tone::doubtful;
}

ValueRow criterion_row(const injury::CriterionResult& result, const UnitSystem& units, Detail detail) {
  const injury::Criterion& criterion = result.criterion;
  const std::string unit = criterion.quantity->si_unit;
  ValueRow row{
      .label = injury::title_of(criterion),
      .value = result.value ? (result.lower_bound ? "≥ " : "") +
                                  brief_quantity(*result.value, unit, units, digits_of(detail))
                            : "none",
      .limit = (criterion.strict ? "below " : "at most ") + brief_quantity(criterion.limit, unit, units),
      .remark = verdict_words(result, units, digits_of(detail)),
      .tone = tone_of(result.verdict)};
  const bool decides = result.verdict == injury::Verdict::undecided && !result.interval;
  if (result.value && (detail == Detail::all || decides))
    row.error = std::abs(result.error / (*result.value == 0 ? 1 : *result.value));
  if (result.value && criterion.limit > 0) row.share = *result.value / criterion.limit;
  if (const auto& interval = result.interval; interval && !interval->sources.empty()) {
    row.interval = interval_words(*interval, units);
    if (row.share) row.share_range = {interval->low / criterion.limit, interval->high / criterion.limit};
  }
  return row;
}

std::vector<ValueRow> criterion_rows(const std::vector<injury::CriterionResult>& results,
                                     const UnitSystem& units, Detail detail) {
  std::vector<ValueRow> rows;
  for (const injury::CriterionResult& result : results) rows.push_back(criterion_row(result, units, detail));
  return rows;
}

std::vector<Series> acceleration_limits(const std::vector<injury::CriterionResult>& results,
                                        const UnitSystem& units) {
  std::vector<Series> lines;
  for (const injury::CriterionResult& result : results)
    if (result.criterion.quantity->si_unit == std::string_view("m/s2"))
      lines.push_back({.label = fmt::format("{}, {}", injury::limit_of(result.criterion),
                                            brief_quantity(result.criterion.limit, "m/s2", units)),
                       .style = SeriesStyle::horizontal_line,
                       .y = {result.criterion.limit / standard_gravity},
                       .palette_index = 1});
  return lines;
}

Plot deciding_curve(const AssessmentReport& report, const UnitSystem& units) {
  Panel panel = deceleration_panel(report.solution, injury::whole_pulse_figures(report.solution), units);
  panel.add(acceleration_limits(report.assessment.results, units));
  return {.panels = {std::move(panel)}};
}

const std::string& assessment_caveat() {
  static const std::string caveat =
      "Computed with a rigid nose on a flat pad, this is neither a test to the standard nor a certification.";
  return caveat;
}

Document assessment_document(const AssessmentReport& report, const UnitSystem& units, Pictures pictures) {
  Document document = texts_of(report, units);
  if (pictures != Pictures::left_out) {
    document.lead->drawing = impact_drawing(report.assessed, report.solution, units);
    document.lead->curve = deciding_curve(report, units);
  }
  if (pictures == Pictures::drawn) add_plots(document, report, units);
  document.sections.push_back(
      {.heading = "The case",
       .seen = Seen::on_pages,
       .paragraphs = {"This case, in SI units with the standard's impactor, can be saved and "
                      "solved with dashpad run."},
       .copy = case_toml(report.assessed, {})});
  return document;
}

}  // namespace dashpad::output
