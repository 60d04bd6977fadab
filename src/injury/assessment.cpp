#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/injury/metrics.hpp"
#include "dashpad/injury/standard.hpp"
#include "dashpad/quantities/constants.hpp"
#include "injury/pulse_line.hpp"
#include "injury/short_spike.hpp"
#include "result/summary_values.hpp"

namespace dashpad::injury {

namespace {

/// Sets the time above a level and its error, due to the errors of force and time and to the time steps. An
/// error of the force shifts the level; the time is open where the pulse is that flat. The error is infinite
/// if one of these is unknown.
void set_dwell(const Solution& solution, const InjuryFigures& figures, CriterionResult& result) {
  const Pulse pulse = pulse_of(solution.history);
  const double level = result.criterion.level;
  const double time = cumulative_dwell(pulse, level);
  result.value = time;
  result.error = infinite;
  if (!has_coarser_run(solution) || !std::isfinite(figures.errors.peak)) return;
  const double shift = figures.errors.peak * level;
  const double shorter = cumulative_dwell(pulse, level + shift);
  const double longer = cumulative_dwell(pulse, std::max(level - shift, 0.0));
  const double of_steps = std::abs(cumulative_dwell(solution.coarser, level) - time);
  const double of_time = solution.summary.errors.contact_end * time;
  result.error = std::max(time - shorter, longer - time) + of_steps + of_time;
}

bool is_of_rebound(const ResultQuantity& quantity) {
  return quantity.role.doubt == Doubt::of_rebound || quantity.role.doubt == Doubt::of_rebound_height;
}

/// The row of the summary with that quantity; null for one of the pulse.
const SummaryQuantity* row_of(const ResultQuantity& quantity) {
  const auto rows = summary_quantities();
  const auto row = std::ranges::find(rows, &quantity, &SummaryQuantity::quantity);
  return row == rows.end() ? nullptr : &*row;
}

/// Sets the value of a result and its error; no value if the impact has none. The peak is the solver's own,
/// which may lie between two steps. An impactor that stays on the pad does not rebound.
void set_value(const Solution& solution, const InjuryFigures& figures, CriterionResult& result) {
  const Criterion& criterion = result.criterion;
  if (criterion.has_level()) return set_dwell(solution, figures, result);
  const std::optional<InjuryValue> of = injury_value(figures, *criterion.quantity);
  if (of) {
    const std::optional<double> solved =
        criterion.limits("peak_acceleration") ? solution.summary.peak_acceleration : std::nullopt;
    result.value = solved.value_or(of->value);
    result.error = std::abs(*result.value) * of->error;
    return;
  }
  const SummaryQuantity* const row = row_of(*criterion.quantity);
  if (row == nullptr) return;
  const EstimatedValue value = row->of(solution.summary);
  const bool stays = is_of_rebound(*criterion.quantity) && solution.summary.rest;
  if (std::isnan(value.value) && !stays) return;
  result.value = stays ? 0 : value.value;
  result.error = stays ? 0 : std::abs(value.value) * value.error;
}

/// Whether the force has passed its maximum: the impactor came to rest or left the pad.
bool peak_is_final(const Summary& summary) { return summary.release.has_value() || summary.rest.has_value(); }

bool is_lower_bound(const ResultQuantity& quantity, const Summary& summary) {
  const bool by_peak = row_of(quantity) != nullptr && quantity.role.growth != Growth::none;
  if (is_of_rebound(quantity)) return false;
  return by_peak ? !peak_is_final(summary) : !pulse_is_whole(summary);
}

CriterionResult struck_through(const Criterion& criterion) {
  CriterionResult result;
  result.criterion = criterion;
  result.verdict = Verdict::fail;
  result.reason = "bottomed out on a rigid support (no finite value)";
  return result;
}

std::string reason_of(const CriterionResult& result, const Summary& summary) {
  if (result.verdict != Verdict::undecided) return "";
  if (result.lower_bound)
    return peak_is_final(summary)
               ? "the pulse ends at its peak, since the foam does not unload; the value is a lower bound"
               : "the pulse ends with the impactor still on the pad; the value is a lower bound";
  if (!std::isfinite(result.error)) return "the error is unknown";
  return result.interval ? "the limit lies within the interval" : "the limit lies within the error estimate";
}

CriterionResult judge(const Criterion& criterion, const Solution& solution, const InjuryFigures& figures) {
  if (bottomed_on_rigid_support(solution.summary)) return struck_through(criterion);
  CriterionResult result;
  result.criterion = criterion;
  set_value(solution, figures, result);
  if (!result.value) {
    result.reason = fmt::format("the impact has no {}", title_in_sentence(*criterion.quantity));
    return result;
  }
  if (const auto& intervals = solution.summary.intervals)
    if (const FigureInterval* figure_interval =
            intervals->find(criterion.quantity->key, criterion.has_level() ? criterion.level : 0))
      result.interval = *figure_interval;
  result.lower_bound = is_lower_bound(*criterion.quantity, solution.summary);
  decide(result);
  result.reason = reason_of(result, solution.summary);
  return result;
}

KeyFigures key_figures(const Summary& summary, const InjuryFigures& injury) {
  const bool ended = peak_is_final(summary) || bottomed_on_rigid_support(summary);
  const auto of_pulse = [&summary](const Hic& hic) {
    return bottomed_on_rigid_support(summary) ? Figure{} : Figure{hic.value, !pulse_is_whole(summary)};
  };
  KeyFigures figures;
  figures.peak_acceleration = {summary.peak_acceleration, !ended};
  figures.hic15 = of_pulse(injury.hic15);
  figures.hic36 = of_pulse(injury.hic36);
  figures.peak_strain = {summary.peak_strain, !ended};
  if (pulse_is_whole(summary)) {
    figures.contact_end = {summary.contact_end->time};
    figures.rebound_speed = {summary.rebound_speed};
    figures.restitution = {summary.restitution};
  }
  return figures;
}

/// A pass by clips alone says nothing of a spike that is too short for them.
void add_reservation_about_spike(const Standard& standard, const Summary& summary,
                                 std::vector<Flag>& reservations) {
  std::vector<UpperLimit> limits;
  for (const Criterion& criterion : standard.criteria)
    limits.push_back({criterion.quantity, criterion.level, criterion.limit});
  if (std::optional<Flag> flag = short_spike(summary, limits)) reservations.push_back(*std::move(flag));
}

/// Without a range, a result cannot be flagged as extrapolated even if it is.
void add_reservations_about(const Material& material, std::vector<Flag>& reservations) {
  if (range_of(material)) return;
  const std::string where = material.name == foam_of_the_case ? "case" : "card";
  reservations.push_back(
      flag_of("UNKNOWN RANGE", "the " + where + " does not state the range over which its law was fitted"));
}

/// Collects the names of values and limits that were not verified in the standard.
struct ReadNames {
  std::string unverified, secondary;

  void add(const Origin& origin, const std::string& what) {
    if (origin.verified && origin.kind == SourceKind::own_text) return;
    std::string& names = origin.verified ? secondary : unverified;
    names += (names.empty() ? "" : ", ") + what;
  }
  void say(std::vector<Flag>& reservations) const {
    if (!unverified.empty())
      reservations.push_back(flag_of(
          "UNVERIFIED", unverified + " (found neither in the standard nor in a source that quotes it)"));
    if (!secondary.empty())
      reservations.push_back(
          flag_of("SECONDARY SOURCE",
                  secondary + " (found in a source that quotes the standard, not in the standard itself)"));
  }
};

void add_reservations_about(const Standard& standard, std::vector<Flag>& reservations) {
  ReadNames names;
  const std::pair<const char*, const StandardValue*> values[]{
      {"mass", &standard.mass}, {"radius", &standard.radius}, {"speed", &standard.speed}};
  for (const auto& [name, value] : values) {
    const bool is_other_nose = value == &standard.radius && !value->value;
    if (value->instead)
      reservations.push_back(flag_of(
          "REPLACED", fmt::format("the {} is not that of the standard", is_other_nose ? "nose" : name)));
    if (value->value && !value->chosen_by_user) names.add(value->origin, name);
  }
  for (const Criterion& criterion : standard.criteria) names.add(criterion.origin, limit_of(criterion));
  names.say(reservations);
}

/// Adds the missing intervals. Their absence is no sign of certainty.
void add_reservations_about(const Summary& summary, std::vector<Flag>& reservations) {
  if (!summary.intervals) {
    reservations.push_back(
        flag_of("NO INTERVALS",
                "the uncertainty of the figures was not computed; the verdict is based on the values alone"));
    return;
  }
  for (const OpenSource& open_source : summary.intervals->sources)
    if (!open_source.why_not.empty())
      reservations.push_back(
          {"NO INTERVAL", fmt::format("NO INTERVAL for {}: {}", open_source.words, open_source.why_not)});
}

/// The keys of the limited figures, which decide on flags.
std::vector<std::string> decisive_figures(const Standard& standard) {
  std::vector<std::string> keys;
  for (const Criterion& criterion : standard.criteria) keys.emplace_back(criterion.quantity->key);
  return keys;
}

}  // namespace

void decide(CriterionResult& result) {
  const Criterion& of = result.criterion;
  const double lowest = (result.interval ? result.interval->low : *result.value) - result.error;
  const double highest = (result.interval ? result.interval->high : *result.value) + result.error;
  // Comparisons with NaN are false, which leaves the result undecided.
  const bool is_above = of.strict ? lowest >= of.limit : lowest > of.limit;
  const bool is_within = of.strict ? highest < of.limit : highest <= of.limit;
  result.verdict = is_above                           ? Verdict::fail
                   : is_within && !result.lower_bound ? Verdict::pass
                                                      : Verdict::undecided;
  if (result.lower_bound && !is_above) return;  // see `margin`
  result.margin = of.limit - *result.value;
  result.relative_margin = *result.margin / of.limit;
}

Verdict verdict_of(const std::vector<CriterionResult>& results) {
  const auto any = [&results](Verdict verdict) {
    return std::ranges::any_of(results, [verdict](const auto& result) { return result.verdict == verdict; });
  };
  if (any(Verdict::fail)) return Verdict::fail;
  return any(Verdict::undecided) ? Verdict::undecided : Verdict::pass;
}

std::vector<Flag> reservations_about_limits(const Standard& standard) {
  ReadNames names;
  for (const Criterion& criterion : standard.criteria) names.add(criterion.origin, limit_of(criterion));
  std::vector<Flag> reservations;
  names.say(reservations);
  return reservations;
}

std::vector<double> dwell_levels(const Standard& standard) {
  std::vector<double> levels;
  for (const Criterion& criterion : standard.criteria)
    if (criterion.has_level()) levels.push_back(criterion.level);
  return levels;
}

std::string to_string(Verdict verdict) {
  constexpr const char* names[]{"pass", "fail", "undecided"};
  return names[static_cast<std::size_t>(verdict)];
}

std::string to_string(const Assessment& assessment) {
  return to_string(assessment.verdict) + (assessment.unqualified() ? "" : ", with reservations");
}

Assessment assess(const Standard& standard, const ImpactCase& impact, const Solution& solution) {
  if (standard.criteria.empty()) throw std::invalid_argument("assess: the standard has no criteria");
  if (solution.summary.status == Status::not_run) throw std::invalid_argument("assess: nothing was computed");
  const InjuryFigures figures = injury_figures(solution);
  Assessment assessment;
  for (const Criterion& criterion : standard.criteria)
    assessment.results.push_back(judge(criterion, solution, figures));
  assessment.verdict = verdict_of(assessment.results);
  assessment.figures = key_figures(solution.summary, figures);
  assessment.reservations = flags(solution.summary, decisive_figures(standard));
  if (assessment.verdict != Verdict::fail)
    add_reservation_about_spike(standard, solution.summary, assessment.reservations);
  add_reservations_about(solution.summary, assessment.reservations);
  if (impact.pad.layers.empty()) add_reservations_about(impact.pad.material, assessment.reservations);
  for (const PadLayer& layer : impact.pad.layers)
    add_reservations_about(layer.material, assessment.reservations);
  add_reservations_about(standard, assessment.reservations);
  return assessment;
}

}  // namespace dashpad::injury
