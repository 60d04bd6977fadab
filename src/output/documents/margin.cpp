// The document of where a verdict turns.

#include "dashpad/output/margin.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "injury/short_spike.hpp"
#include "output/documents/basis.hpp"
#include "output/layout.hpp"
#include "output/text/capitals.hpp"
#include "output/text/margin_words.hpp"
#include "output/text/study_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// Rows of the table over the range without --all.
constexpr std::size_t max_rows = 9;

std::string limits_text(const margin::Answer& answer, const UnitSystem& units) {
  std::string text;
  for (std::size_t i = 0; i < answer.limits.size(); ++i)
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", limit_title(answer, i),
                        limit_text(answer.limits[i], units));
  return text;
}

std::vector<std::string> subject_of(const margin::Answer& answer, const std::string& file,
                                    const UnitSystem& units) {
  const margin::Question& question = answer.question;
  std::vector<std::string> lines;
  const std::string title = one_line(question.impacts.front().impact.title);
  lines.push_back(title.empty() ? "Case: " + file : fmt::format("Case: {} ({})", title, file));
  for (const margin::Judged& judged : question.impacts)
    if (judged.standard)
      lines.push_back(
          fmt::format("Standard: {} ({})", one_line(judged.standard->title), judged.standard->name));
  if (const auto& blows = question.impacts.front().impact.blows)
    lines.push_back(fmt::format("Figures of the last of {} blows", blows->count));
  lines.push_back(fmt::format("{}: {}; searched from {} to {}", is_aim(answer.question) ? "Aim" : "Limits",
                              limits_text(answer, units), key_text(answer, question.low, units),
                              key_text(answer, question.high, units)));
  if (const auto& chance = question.chance) {
    std::string varied;
    for (const study::Factor& factor : chance->factors)
      varied += (varied.empty() ? "" : ", ") + factor_words(factor.key);
    if (chance->foam)
      varied += (varied.empty() ? "" : ", and ") + std::string("all that the foam's card leaves uncertain");
    lines.push_back(fmt::format("{} draws of: {}", chance->draws, varied));
  }
  return lines;
}

/// A row for each turn: what is at its limit there, and on which side the limits are kept.
std::vector<ValueRow> turn_rows(const margin::Answer& answer, const UnitSystem& units) {
  std::vector<ValueRow> rows;
  const std::string key = capitalised(factor_words(answer.question.key));
  for (const margin::Turn& turn : answer.turns) {
    ValueRow row{.label = key, .value = key_text(answer, turn.value, units)};
    if (turn.interval) {
      const auto& [low, high] = *turn.interval;
      row.interval =
          std::isfinite(low) && std::isfinite(high)
              ? fmt::format("{} to {}", key_text(answer, low, units), key_text(answer, high, units))
          : std::isfinite(low)  ? "at least " + key_text(answer, low, units)
          : std::isfinite(high) ? "at most " + key_text(answer, high, units)
                                : "the whole range";
    }
    const margin::Limit& limit = answer.limits[turn.limit];
    row.remark =
        fmt::format("{} {} {}; {} {}", limit_title(answer, turn.limit), turn.jumps ? "jumps across" : "is at",
                    brief_quantity(limit.value, limit.figure->si_unit, units),
                    is_aim(answer.question) ? "lower" : "passes", turn.passes_above ? "above" : "below");
    rows.push_back(std::move(row));
  }
  return rows;
}

/// "it passes from 31 mm to 100 mm, it fails from 6.25 mm to 28.1 mm, ..."
std::string certain_words(const margin::Answer& answer, const UnitSystem& units) {
  std::string text;
  for (const auto& [zone, verb] : {std::pair{margin::Zone::pass, "passes"},
                                   {margin::Zone::fail, "fails"},
                                   {margin::Zone::undecided, "is undecided"},
                                   {margin::Zone::unknown, "has no verdict"}}) {
    std::string where;
    for (const margin::Stretch& stretch : answer.stretches)
      if (stretch.zone == zone)
        where += fmt::format("{}from {} to {}", where.empty() ? "" : " and ",
                             key_text(answer, stretch.from, units), key_text(answer, stretch.to, units));
    if (!where.empty()) text += fmt::format("{}it {} {}", text.empty() ? "" : ", ", verb, where);
  }
  return text;
}

/// The place nearest to each of some even steps over the range, and to each turn: a search crowds its looks.
std::vector<std::size_t> chosen_places(const margin::Answer& answer, std::size_t max) {
  const std::vector<margin::Place>& places = answer.places;
  std::vector<std::size_t> chosen(places.size());
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  if (places.size() <= max) return chosen;
  const margin::Question& question = answer.question;
  const auto place_of = [&](double value) { return question.logarithmic ? std::log(value) : value; };
  std::vector<double> wanted;
  for (std::size_t i = 0; i < max; ++i)
    wanted.push_back(std::lerp(place_of(question.low), place_of(question.high),
                               static_cast<double>(i) / static_cast<double>(max - 1)));
  for (const margin::Turn& turn : answer.turns) wanted.push_back(place_of(turn.value));
  chosen.clear();
  for (const double at : wanted) {
    const auto nearest = std::ranges::min_element(
        places, {}, [&](const margin::Place& place) { return std::abs(place_of(place.value) - at); });
    chosen.push_back(static_cast<std::size_t>(nearest - places.begin()));
  }
  std::ranges::sort(chosen);
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

Table places_table(const margin::Answer& answer, const UnitSystem& units, std::size_t max) {
  Table table{.caption = answer.question.chance ? fmt::format("Figures that {} of the draws keep",
                                                              per_cent(answer.question.chance->probability))
                                                : "",
              .columns = {capitalised(factor_words(answer.question.key))}};
  for (std::size_t i = 0; i < answer.limits.size(); ++i)
    table.columns.push_back(capitalised(limit_title(answer, i)));
  table.columns.insert(table.columns.end(), {"Of the limit", "95 % interval"});
  if (answer.question.chance) table.columns.emplace_back("Draws that pass");
  for (const std::size_t i : chosen_places(answer, max)) {
    const margin::Place& place = answer.places[i];
    std::vector<std::string> row{key_text(answer, place.value, units)};
    for (std::size_t j = 0; j < answer.limits.size(); ++j)
      row.push_back(figure_text(answer.limits[j], place.figures[j], units));
    const auto share = [&](double excess) {
      return std::isfinite(excess)
                 ? fmt::format("{:.4g} %", 100 * share_of_limit(answer.limits[place.worst], excess))
                 : std::string("-");
    };
    row.push_back(share(place.excess));
    row.push_back(place.low == place.high || !std::isfinite(place.low) ? "-"
                  : answer.limits[place.worst].at_least
                      ? fmt::format("{} to {}", share(place.high), share(place.low))
                      : fmt::format("{} to {}", share(place.low), share(place.high)));
    if (answer.question.chance) row.push_back(per_cent(place.share));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// What scatters most, and what to measure where no value of the key reaches the probability.
std::vector<std::string> scatter_words(const margin::Answer& answer) {
  if (answer.contributors.empty()) return {};
  std::string list;
  std::size_t named = 0;
  for (const margin::Contributor& of : answer.contributors)
    if (of.share > 0.02 && named++ < 3)
      list += fmt::format("{}{} ({:.0f} %)", list.empty() ? "" : ", ", factor_words(of.key), 100 * of.share);
  if (list.empty()) return {};
  std::vector<std::string> lines{fmt::format("These explain most of the scatter, each by itself: {}.", list)};
  const margin::Contributor& first = answer.contributors.front();
  if (answer.turns.empty() && answer.nearest && answer.places[*answer.nearest].excess > 0)
    lines.push_back(
        fmt::format("No value reaches the probability. It would help most to know this better: {}.",
                    factor_words(first.key)));
  return lines;
}

Tone tone_of(const margin::Answer& answer) {
  if (is_aim(answer.question)) return answer.turns.empty() ? Tone::doubtful : Tone::plain;
  const auto any = [&](margin::Zone zone) {
    return std::ranges::count(answer.stretches, zone, &margin::Stretch::zone) > 0;
  };
  const bool is_spike_unseen =
      std::ranges::count(answer.reservations, injury::short_spike_name, &Flag::name) > 0;
  if (any(margin::Zone::pass) && is_spike_unseen) return Tone::doubtful;
  return any(margin::Zone::pass) ? Tone::good : any(margin::Zone::undecided) ? Tone::doubtful : Tone::bad;
}

}  // namespace

Document margin_document(const margin::Answer& answer, const std::string& file, const UnitSystem& units,
                         Pictures pictures) {
  Document document{.title = one_line(answer.question.impacts.front().impact.title),
                    .lead = Lead{.answer = margin_answer(answer, units),
                                 .tone = tone_of(answer),
                                 .subject = subject_of(answer, file, units),
                                 .figures = turn_rows(answer, units)}};
  document.warnings = by_severity(answer.reservations);
  std::vector<std::string> lines;
  if (const std::string certain = certain_words(answer, units); !certain.empty() && !is_aim(answer.question))
    lines.push_back(fmt::format("{}, {}.",
                                answer.question.chance      ? "Allowing for the number of draws"
                                : answer.question.intervals ? "Allowing for the uncertainty of foam and model"
                                                            : "With the foam exactly as on the card",
                                certain));
  for (std::string& line : scatter_words(answer)) lines.push_back(std::move(line));
  if (answer.doubtful > 0)
    lines.push_back(fmt::format("At {} of {} values the solver missed the tolerance: the answer is doubtful.",
                                answer.doubtful, answer.places.size()));
  if (!answer.is_complete)
    lines.emplace_back("The search ended before it could exclude further solutions: give a smaller range.");
  for (const margin::Place& place : answer.places)
    if (!place.why_unknown.empty()) {
      lines.push_back(fmt::format("There is no verdict at {}: {}.", key_text(answer, place.value, units),
                                  place.why_unknown));
      break;
    }
  lines.push_back(fmt::format("{} solved in {:.2g} s.", plural(answer.impacts, "impact"), answer.seconds));
  document.sections.push_back({.seen = Seen::always, .paragraphs = std::move(lines)});
  document.sections.push_back({.heading = "Over the range",
                               .seen = Seen::in_brief,
                               .tables = {places_table(answer, units, max_rows)}});
  document.sections.push_back(
      {.heading = "Over the range", .tables = {places_table(answer, units, answer.places.size())}});
  document.sections.push_back(
      {.heading = basis_heading,
       .tables = {basis_table(case_basis(answer.question.impacts.front().impact, units))}});
  if (pictures == Pictures::drawn) document.lead->curve = untitled(margin_plot(answer, units));
  return document;
}

}  // namespace dashpad::output
