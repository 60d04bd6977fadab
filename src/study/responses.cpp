#include "dashpad/study/responses.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/quantities/constants.hpp"
#include "injury/hic_search.hpp"
#include "injury/pulse_line.hpp"
#include "result/summary_values.hpp"

namespace dashpad::study {

using injury::hic_power;

/// The injury figures of one solution after the other, each computed only on request, with the values and
/// errors of injury_figures() (dashpad/injury/figures.hpp).
class PulseFigures {
 public:
  /// Takes no memory once it has held a pulse as long.
  void take(const Solution& solution) {
    const History& history = solution.history;
    force_error_ = solution.summary.errors.peak_force;
    whole_window_.reset();
    clip_.reset();
    whole_ = injury::has_whole_pulse(solution);
    if (!whole_) return;
    fine_.pulse.time = history.time;
    fine_.pulse.acceleration = history.acceleration;
    check(fine_.pulse);
    fine_.prepare();
    has_coarse_ = injury::has_coarser_run(solution);
    if (!has_coarse_) return;
    coarse_.pulse = solution.coarser;
    coarse_.prepare();
  }
  /// False: the impactor did not leave the pad, or a value is not finite. Nothing may be asked then.
  [[nodiscard]] bool whole() const { return whole_; }
  /// A window longer than the pulse is none: HIC15 of a short pulse is its HIC36, and computed once.
  EstimatedValue hic(double longest_window) {
    const auto figure = [](double window) {
      return [window](Sampled& sampled) { return sampled.hic(window); };
    };
    if (fine_.pulse.time.back() - fine_.pulse.time.front() > longest_window)
      return with_error(figure(longest_window), hic_power);
    if (!whole_window_) whole_window_ = with_error(figure(injury::unlimited_window), hic_power);
    return *whole_window_;
  }
  EstimatedValue hic_d() {
    const EstimatedValue hic36 = hic(injury::hic36_window);
    const double value = injury::hic_d(hic36.value);
    return {value, injury::hic_d_error(hic36.error, value, force_error_)};
  }
  EstimatedValue clip_3ms() {
    const auto clip = [](const Sampled& sampled) {
      return sampled.hump ? injury::clip_of(*sampled.hump, sampled.pulse, injury::usual_clip)
                          : injury::contiguous_clip(sampled.pulse, injury::usual_clip);
    };
    if (!are_humps()) return level_of(clip);
    if (!clip_) clip_ = level_of(clip);
    return *clip_;
  }
  EstimatedValue cumulative_3ms() {
    if (are_humps()) return clip_3ms();
    return level_of(
        [](const Sampled& sampled) { return injury::cumulative_clip(sampled.pulse, injury::usual_clip); });
  }
  EstimatedValue severity_index() {
    return with_error([](const Sampled& sampled) { return injury::severity_index(sampled.pulse); },
                      hic_power);
  }
  EstimatedValue velocity_change() {
    return with_error([](const Sampled& sampled) { return injury::velocity_change(sampled.pulse); }, 1);
  }

 private:
  /// A pulse, and what several figures need of it.
  struct Sampled {
    Pulse pulse;
    std::optional<injury::Hump> hump;
    std::optional<double> scale;  ///< scale of the curve, once it is assigned
    injury::hic_search::Curve curve;

    void prepare() {
      hump = injury::hump_of(pulse);
      scale.reset();
    }
    double hic(double longest_window) {
      if (!hump) return injury::hic(pulse, longest_window).value;
      if (!scale) {
        scale = injury::scale_for(std::abs(pulse.acceleration[hump->peak]));
        curve.assign(pulse, hump->sign * *scale);
      }
      return injury::hic_of(*hump, curve, *scale, longest_window).value;
    }
  };

  [[nodiscard]] bool are_humps() const { return fine_.hump && (coarse_.hump || !has_coarse_); }
  /// The error from the steps, plus that of the force times its power in the figure.
  template <class Figure>
  EstimatedValue with_error(Figure figure, double power) {
    const double value = figure(fine_);
    if (!has_coarse_) return {value, infinite};
    const double coarse = figure(coarse_);
    return {injury::extrapolated(value, coarse), injury::step_error(value, coarse) + power * force_error_};
  }
  template <class ClipOf>
  EstimatedValue level_of(ClipOf clip_of) {
    const injury::Clip clip = clip_of(fine_);
    if (!has_coarse_) return {clip.level, infinite};
    const injury::Clip coarse = clip_of(coarse_);
    return {injury::extrapolated(clip.level, coarse.level),
            injury::step_error(fine_.pulse, clip, coarse) + force_error_};
  }

  Sampled fine_, coarse_;
  bool has_coarse_ = false;
  double force_error_ = 0;
  bool whole_ = false;
  std::optional<EstimatedValue> whole_window_;  ///< HIC with a window that is no limit
  std::optional<EstimatedValue>
      clip_;  ///< clip of a hump, for which contiguous and cumulative clips are equal
};

namespace {

/// A response and the function that computes it, one of two.
struct Recipe {
  ResultQuantity kind;
  EstimatedValue (*of_summary)(const Summary&) = nullptr;
  EstimatedValue (*of_pulse)(PulseFigures&) = nullptr;
};

constexpr std::pair<const char*, EstimatedValue (*)(PulseFigures&)> of_pulses[] = {
    {"hic15", [](PulseFigures& pulse) { return pulse.hic(injury::hic15_window); }},
    {"hic36", [](PulseFigures& pulse) { return pulse.hic(injury::hic36_window); }},
    {"hic_unlimited", [](PulseFigures& pulse) { return pulse.hic(injury::unlimited_window); }},
    {"hic_d", [](PulseFigures& pulse) { return pulse.hic_d(); }},
    {"clip_3ms", [](PulseFigures& pulse) { return pulse.clip_3ms(); }},
    {"cumulative_3ms", [](PulseFigures& pulse) { return pulse.cumulative_3ms(); }},
    {"severity_index", [](PulseFigures& pulse) { return pulse.severity_index(); }},
    {"velocity_change", [](PulseFigures& pulse) { return pulse.velocity_change(); }},
};

/// The order is that of the table of results.
const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> recipes = [] {
    std::vector<Recipe> all;
    for (const SummaryQuantity& entry : summary_quantities())
      if (entry.quantity->role.in_studies) all.push_back({*entry.quantity, entry.of, nullptr});
    for (const auto& [key, of] : of_pulses) all.push_back({result_quantity(key), nullptr, of});
    return all;
  }();
  return recipes;
}

}  // namespace

const std::vector<ResultQuantity>& response_kinds() {
  static const std::vector<ResultQuantity> kinds = [] {
    std::vector<ResultQuantity> all;
    for (const Recipe& recipe : recipes()) all.push_back(recipe.kind);
    return all;
  }();
  return kinds;
}

std::optional<Response> find_response(const std::string& name) {
  const std::size_t point = name.find('.');
  const std::string_view key = std::string_view(name).substr(0, point);
  const auto& kinds = response_kinds();
  const auto kind = std::ranges::find_if(kinds, [&](const ResultQuantity& each) { return key == each.key; });
  if (kind == kinds.end()) return std::nullopt;
  if (point == std::string::npos) return Response{&*kind};
  Response response{&*kind};
  const char* const blows = name.c_str() + point + 1;
  if (std::sscanf(blows, "mean_%3d_%3d", &response.first_blow, &response.last_blow) < 2) {
    std::sscanf(blows, "blow_%3d", &response.first_blow);
    response.last_blow = response.first_blow;
  }
  // Columns of stores have this name: it is written in one way only.
  const auto& [quantity, first, last] = response;
  const bool is_one_spelling = name == fmt::format("{}.blow_{}", kind->key, first) ||
                               (last > first && name == fmt::format("{}.mean_{}_{}", kind->key, first, last));
  return first > 0 && is_one_spelling ? std::optional(response) : std::nullopt;
}

const ResultQuantity* find_response_kind(const std::string& name) {
  const auto response = find_response(name);
  return response ? response->kind : nullptr;
}

std::string response_title(const std::string& name) {
  const auto response = find_response(name);
  if (!response) return name;
  const auto& [kind, first, last] = *response;
  if (first == 0) return kind->title;
  return last > first ? fmt::format("{}, mean of blows {} to {}", kind->title, first, last)
                      : fmt::format("{} of blow {}", kind->title, first);
}

bool is_possible(const ResultQuantity& kind, double value) {
  return std::isfinite(value) && (kind.role.is_signed || value >= 0);
}

bool has_response(const ResultQuantity& kind, Status status) {
  const ResultRole& role = kind.role;
  switch (status) {
    // Contact may never be lost: a rigid foam stops the impactor on a rigid support.
    case Status::released: return kind.key != std::string_view{"contact_end"} && role.needs != Needs::support;
    case Status::at_rest: return role.needs == Needs::nothing;
    case Status::bottomed_out: return role.growth == Growth::with_motion;
    case Status::time_limit: return role.growth != Growth::none && kind.part != Part::pulse;
    case Status::tolerance_not_met:
    case Status::not_run: break;
  }
  return false;
}

std::vector<std::string> default_responses() {
  std::vector<std::string> names;
  // Only some supports have figures of their own, and the rebound height says again what the speed does:
  // these are responses on request only.
  for (const ResultQuantity& kind : response_kinds())
    if (kind.part != Part::pulse && kind.role.needs != Needs::support &&
        kind.role.doubt != Doubt::of_rebound_height)
      names.emplace_back(kind.key);
  return names;
}

ResponseReader::ResponseReader(std::span<const std::string> names) {
  for (const std::string& name : names) {
    const auto response = find_response(name);
    if (!response) throw std::invalid_argument("no response: " + name);
    wanted_.push_back({static_cast<std::size_t>(response->kind - response_kinds().data()), *response});
    needs_blows_ = needs_blows_ || response->first_blow > 0;
    if (response->kind->part == Part::pulse && !pulse_) pulse_ = std::make_unique<PulseFigures>();
  }
}

ResponseReader::~ResponseReader() = default;
ResponseReader::ResponseReader(ResponseReader&&) noexcept = default;
ResponseReader& ResponseReader::operator=(ResponseReader&&) noexcept = default;

void ResponseReader::operator()(const Solution& solution, Outcome& outcome) {
  const Summary& summary = solution.summary;
  if (!needs_blows_ || summary.blow == 1) {
    outcome = {.values = std::move(outcome.values)};
    outcome.values.assign(wanted_.size(), no_value);
    sums_.assign(wanted_.size(), 0);
  }
  if (outcome.status != Status::tolerance_not_met) outcome.status = summary.status;
  outcome.extrapolated |= (summary.is_beyond(Beyond::strain) ? extrapolated_strain : 0U) |
                          (summary.is_beyond(Beyond::rate) ? extrapolated_rate : 0U) |
                          (summary.is_beyond(Beyond::other) ? extrapolated_otherwise : 0U);
  outcome.bottomed = outcome.bottomed || summary.bottomed.has_value();
  if (pulse_) pulse_->take(solution);
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    const auto& [number, of] = wanted_[i];
    const bool is_of_last = of.first_blow == 0;
    if (!is_of_last && (summary.blow < of.first_blow || summary.blow > of.last_blow)) continue;
    const Recipe& recipe = recipes()[number];
    double value = no_value;
    if (!recipe.of_pulse || pulse_->whole()) {
      const EstimatedValue figure = recipe.of_pulse ? recipe.of_pulse(*pulse_) : recipe.of_summary(summary);
      if (is_possible(recipe.kind, figure.value)) value = figure.value;
      // An estimate that is no number bounds nothing.
      outcome.error = std::max(outcome.error, std::isnan(figure.error) ? infinite : figure.error);
    }
    if (is_of_last) {
      outcome.values[i] = value;
      continue;
    }
    sums_[i] += value;
    if (summary.blow == of.last_blow) outcome.values[i] = sums_[i] / (of.last_blow - of.first_blow + 1);
  }
}

}  // namespace dashpad::study
