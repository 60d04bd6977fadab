#include "dashpad/study/responses.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include "quantities/special_numbers.hpp"
#include "result/summary_values.hpp"
#include "study/pulse_figures.hpp"

namespace dashpad::study {
namespace {

/// How a response is got: one of the two functions.
struct Recipe {
  ResponseKind kind;
  EstimatedValue (*of_summary)(const Summary&) = nullptr;
  EstimatedValue (*of_pulse)(PulseFigures&) = nullptr;
};

/// A figure of a pulse grows with what is missing of it, but for the velocity change.
struct PulseRecipe {
  const char* key;
  EstimatedValue (*of)(PulseFigures&);
};
constexpr PulseRecipe of_pulses[] = {
    {"hic15", [](PulseFigures& of) { return of.hic(injury::hic15_window); }},
    {"hic36", [](PulseFigures& of) { return of.hic(36e-3); }},
    {"hic_unlimited", [](PulseFigures& of) { return of.hic(injury::unlimited_window); }},
    {"hic_d", [](PulseFigures& of) { return of.hic_d(); }},
    {"clip_3ms", [](PulseFigures& of) { return of.clip_3ms(); }},
    {"cumulative_3ms", [](PulseFigures& of) { return of.cumulative_3ms(); }},
    {"severity_index", [](PulseFigures& of) { return of.severity_index(); }},
    {"velocity_change", [](PulseFigures& of) { return of.velocity_change(); }},
};

/// What is no figure of a study: moments of which not every impact has one, and an audit of the run.
constexpr std::string_view left_out[] = {"force_below_weight", "bottomed", "rest",
                                         "energy_residual_fraction"};

/// Not every support has them: they are responses where they are asked for.
constexpr std::string_view of_supports[] = {"peak_transmitted_force", "peak_support_deflection",
                                            "support_set", "body_speed"};
bool is_of_support(const ResponseKind& kind) {
  return std::ranges::find(of_supports, std::string_view{kind.key}) != std::end(of_supports);
}
bool is_of_release(const ResponseKind& kind) {
  for (const char* key : {"rebound_speed", "restitution", "contact_end", "release"})
    if (kind.key == std::string_view{key}) return true;
  return false;
}

Growth growth_of(std::string_view key) {
  for (const char* with_force : {"peak_force", "peak_acceleration", "peak_transmitted_force"})
    if (key == with_force) return Growth::with_force;
  for (const char* with_motion : {"peak_motion", "peak_penetration", "peak_strain", "peak_strain_rate",
                                  "peak_support_deflection", "support_set"})
    if (key == with_motion) return Growth::with_motion;
  return Growth::none;
}

std::vector<Recipe> make_recipes() {
  std::vector<Recipe> all;
  for (const SummaryQuantity& entry : summary_quantities()) {
    const std::string_view key = entry.quantity->key;
    if (std::ranges::find(left_out, key) == std::end(left_out))
      all.push_back(
          {{*entry.quantity, false, growth_of(key), key == "energy_absorbed_fraction"}, entry.of, nullptr});
  }
  for (const PulseRecipe& entry : of_pulses)
    all.push_back({{result_quantity(entry.key), true,
                    entry.key == std::string_view{"velocity_change"} ? Growth::none : Growth::with_force},
                   nullptr,
                   entry.of});
  return all;
}

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all = make_recipes();
  return all;
}

}  // namespace

const std::vector<ResponseKind>& response_kinds() {
  static const std::vector<ResponseKind> kinds = [] {
    std::vector<ResponseKind> all;
    for (const Recipe& recipe : recipes()) all.push_back(recipe.kind);
    return all;
  }();
  return kinds;
}

const ResponseKind* find_response_kind(const std::string& name) {
  const auto& kinds = response_kinds();
  const auto found = std::ranges::find_if(kinds, [&](const ResponseKind& kind) { return name == kind.key; });
  return found == kinds.end() ? nullptr : &*found;
}

bool is_possible(const ResponseKind& kind, double value) {
  return std::isfinite(value) && (kind.is_signed || value >= 0);
}

bool has_response(const ResponseKind& kind, Status status) {
  switch (status) {
    // Contact may never be lost: a rigid foam stops the impactor on a rigid support.
    case Status::released: return kind.key != std::string_view{"contact_end"} && !is_of_support(kind);
    case Status::at_rest: return !is_of_support(kind) && !is_of_release(kind);
    case Status::bottomed_out: return kind.growth == Growth::with_motion;
    case Status::time_limit: return kind.growth != Growth::none && !kind.of_pulse;
    case Status::tolerance_not_met:
    case Status::not_run: break;
  }
  return false;
}

std::vector<std::string> default_responses() {
  std::vector<std::string> names;
  for (const ResponseKind& kind : response_kinds())
    if (!kind.of_pulse && !is_of_support(kind)) names.emplace_back(kind.key);
  return names;
}

ResponseReader::ResponseReader(std::span<const std::string> names) {
  for (const std::string& name : names) {
    const ResponseKind* kind = find_response_kind(name);
    if (kind == nullptr) throw std::invalid_argument("no response: " + name);
    kinds_.push_back(static_cast<std::size_t>(kind - response_kinds().data()));
    if (kind->of_pulse && !pulse_) pulse_ = std::make_unique<PulseFigures>();
  }
}

ResponseReader::~ResponseReader() = default;
ResponseReader::ResponseReader(ResponseReader&&) noexcept = default;
ResponseReader& ResponseReader::operator=(ResponseReader&&) noexcept = default;

void ResponseReader::operator()(const Solution& solution, Outcome& outcome) {
  const Summary& summary = solution.summary;
  outcome.status = summary.status;
  outcome.extrapolated = (summary.is_beyond(Beyond::strain) ? extrapolated_strain : 0U) |
                         (summary.is_beyond(Beyond::rate) ? extrapolated_rate : 0U) |
                         (summary.is_beyond(Beyond::other) ? extrapolated_otherwise : 0U);
  outcome.bottomed = summary.bottomed.has_value();
  outcome.error = 0;
  outcome.values.assign(kinds_.size(), no_value);
  if (pulse_) pulse_->take(solution);
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    const Recipe& recipe = recipes()[kinds_[i]];
    if (recipe.of_pulse && !pulse_->whole()) continue;
    const EstimatedValue figure = recipe.of_pulse ? recipe.of_pulse(*pulse_) : recipe.of_summary(summary);
    if (is_possible(recipe.kind, figure.value)) outcome.values[i] = figure.value;
    // An estimate that is no number bounds nothing.
    outcome.error = std::max(outcome.error, std::isnan(figure.error) ? infinite : figure.error);
  }
}

void read_responses(const Solution& solution, std::span<const std::string> names, Outcome& outcome) {
  ResponseReader reader(names);
  reader(solution, outcome);
}

}  // namespace dashpad::study
