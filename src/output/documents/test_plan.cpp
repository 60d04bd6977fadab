// The document of several assessments: a table of verdicts, then each assessment in full.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "output/documents/assessment.hpp"
#include "output/layout.hpp"
#include "output/text/capitals.hpp"
#include "output/text/standard_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// An assessment as a place in the plan.
struct Combination {
  std::string name;  ///< name of the case
  const AssessmentReport& report;
  Document document;  ///< its document, without pictures
  ValueRow next;      ///< the criterion next to its limit or farthest beyond it; without margins the first
};

/// Titles, where they tell the cases apart; the names of their files, where they do not.
std::vector<std::string> names_of(const std::vector<AssessmentReport>& reports) {
  std::set<std::string> files, titles;
  for (const AssessmentReport& report : reports) {
    files.insert(report.file);
    if (!report.given.title.empty()) titles.insert(one_line(report.given.title));
  }
  std::vector<std::string> names;
  for (const AssessmentReport& report : reports)
    names.push_back(one_line(titles.size() == files.size() ? report.given.title : report.file));
  return names;
}

std::vector<Combination> combinations(const std::vector<AssessmentReport>& reports, const UnitSystem& units) {
  const std::vector<std::string> names = names_of(reports);
  std::vector<Combination> all;
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const std::vector<injury::CriterionResult>& results = reports[i].assessment.results;
    const injury::CriterionResult* const next = closest(results);
    all.push_back({names[i], reports[i], assessment_document(reports[i], units),
                   criterion_row(next == nullptr ? results.front() : *next, units, Detail::main)});
  }
  return all;
}

std::string full_title(const Combination& combination) {
  return combination.name + ", " + full_name(combination.report.standard);
}

std::size_t count_of(const std::vector<Combination>& all, injury::Verdict verdict) {
  return static_cast<std::size_t>(std::ranges::count_if(
      all, [&](const Combination& combination) { return combination.report.assessment.verdict == verdict; }));
}

/// "4 of 6 pass, 1 fails, 1 is undecided".
std::string counted(const std::vector<Combination>& all) {
  const std::size_t passed = count_of(all, injury::Verdict::pass);
  const std::size_t failed = count_of(all, injury::Verdict::fail);
  const std::size_t open = count_of(all, injury::Verdict::undecided);
  if (passed == all.size()) return fmt::format("All {} pass", passed);
  std::string text = fmt::format("{} of {} pass", passed == 0 ? "None" : std::to_string(passed), all.size());
  if (failed > 0) text += fmt::format(", {} fail{}", failed, failed == 1 ? "s" : "");
  if (open > 0) text += fmt::format(", {} {} undecided", open, open == 1 ? "is" : "are");
  return text;
}

/// 0 for a fail, 1 for an undecided verdict, 2 for a pass.
int rank(const Combination& combination) {
  const injury::Verdict verdict = combination.report.assessment.verdict;
  return verdict == injury::Verdict::fail ? 0 : verdict == injury::Verdict::undecided ? 1 : 2;
}

/// The combinations from the one farthest beyond its limit to the one with most to spare.
std::vector<const Combination*> worst_first(const std::vector<Combination>& all) {
  std::vector<const Combination*> sorted;
  for (const Combination& combination : all) sorted.push_back(&combination);
  std::ranges::stable_sort(sorted, [](const Combination* a, const Combination* b) {
    return std::pair(rank(*a), -a->next.share.value_or(0)) < std::pair(rank(*b), -b->next.share.value_or(0));
  });
  return sorted;
}

/// A row a case, a column a standard. The combinations stand case by case.
Table plan_table(const std::vector<Combination>& all) {
  Table table{.columns = {"Case"}};
  for (const Combination& combination : all) {
    if (table.rows.empty() || &combination.report.given != &(&combination - 1)->report.given)
      table.rows.push_back({combination.name});
    if (table.rows.size() == 1) table.columns.push_back(full_name(combination.report.standard));
    const Lead& lead = *combination.document.lead;
    table.rows.back().push_back(lead.answer + (combination.document.warnings.empty() ? "" : " *"));
  }
  return table;
}

/// Each kind of reservation once, for the combination with its largest effect, and how many have it.
std::vector<std::string> reservations(const std::vector<Combination>& all) {
  struct Kind {
    Flag worst;
    std::string of;
    std::set<const Combination*> with_it;
  };
  std::map<std::string, Kind> kinds;
  for (const Combination& combination : all)
    for (const Flag& flag : combination.report.assessment.reservations) {
      Kind& kind = kinds[flag.name];
      if (kind.with_it.empty() || largest_effect(flag) > largest_effect(kind.worst)) {
        kind.worst = flag;
        kind.of = full_title(combination);
      }
      kind.with_it.insert(&combination);
    }
  std::vector<Flag> worst;
  for (auto& [name, kind] : kinds) {
    kind.worst.text += fmt::format(" ({}", kind.of);
    if (kind.with_it.size() > 1)
      kind.worst.text += fmt::format(
          "; {} {} assessments have this reservation",
          kind.with_it.size() == all.size() ? "all" : fmt::format("{} of", kind.with_it.size()), all.size());
    kind.worst.text += ")";
    worst.push_back(std::move(kind.worst));
  }
  return by_severity(std::move(worst));
}

/// An assessment as a whole: answer, reservations, criteria and figures, the curve with its limits.
Section section_of(const Combination& combination, const UnitSystem& units, Pictures pictures) {
  Section section{.heading = full_title(combination),
                  .seen = Seen::on_pages,
                  .paragraphs = {combination.document.lead->answer + "."}};
  for (const std::string& warning : combination.document.warnings) section.paragraphs.push_back(warning);
  section.rows = {{"", combination.document.lead->figures}};
  if (pictures == Pictures::drawn)
    section.figures.push_back({.name = "Deceleration", .plot = deciding_curve(combination.report, units)});
  return section;
}

}  // namespace

Document test_plan_document(const std::vector<AssessmentReport>& reports, const UnitSystem& units,
                            Pictures pictures) {
  const std::vector<Combination> all = combinations(reports, units);
  const std::vector<const Combination*> sorted = worst_first(all);
  const Combination& worst = *sorted.front();
  const Table plan = plan_table(all);
  Document document{
      .title = counted(all),
      .lead =
          Lead{.answer = counted(all),
               .tone = worst.document.lead->tone,
               .subject = {fmt::format("Test plan: {}, {}", plural(plan.rows.size(), "case"),
                                       plural(plan.columns.size() - 1, "standard")),
                           fmt::format("{}: {}. {}.", rank(worst) == 2 ? "Smallest margin" : "Most critical",
                                       full_title(worst), worst.document.lead->answer)}},
      .warnings = reservations(all)};
  for (const Combination* combination : sorted) {
    ValueRow row = combination->next;
    row.limit = uncapitalised(std::exchange(row.label, full_title(*combination))) + " " + row.limit;
    row.remark = to_string(combination->report.assessment.verdict);
    document.lead->figures.push_back(std::move(row));
  }
  if (all.size() > max_key_figures)
    document.sections.push_back(
        {.seen = Seen::on_pages,
         .paragraphs = {
             fmt::format("Above are the {} most critical of {} assessments.", max_key_figures, all.size())}});
  document.sections.push_back({.heading = "The plan", .seen = Seen::always, .tables = {plan}});
  if (!document.warnings.empty())
    document.sections.back().paragraphs = {
        "* with at least one reservation, given in the full assessment of that case against that standard."};
  for (const Combination& combination : all)
    document.sections.push_back(section_of(combination, units, pictures));
  document.sections.push_back(
      {.seen = Seen::in_brief,
       .paragraphs = {"--all shows every assessment in full; --report FILE writes them all to one page."}});
  document.sections.push_back({.seen = Seen::always, .paragraphs = {assessment_caveat()}});
  return document;
}

}  // namespace dashpad::output
