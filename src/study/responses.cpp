#include "dashpad/study/responses.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "study/pulse_figures.hpp"

namespace dashpad::study {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// How a response is got: one of the two functions.
struct Recipe {
  ResponseKind kind;
  FigureWithError (*of_summary)(const Summary&) = nullptr;
  FigureWithError (*of_pulse)(PulseFigures&) = nullptr;
};

FigureWithError present(const std::optional<double>& value, double error) {
  return value ? FigureWithError{*value, error} : FigureWithError{no_value, 0};
}

const Recipe recipes[] = {
    {{"peak_force", "N", "largest force", false, Growth::with_force},
     [](const Summary& of) { return present(of.peak_force, of.errors.peak_force); }},
    {{"peak_acceleration", "m/s2", "largest deceleration of the impactor", false, Growth::with_force},
     [](const Summary& of) { return present(of.peak_acceleration, of.errors.peak_force); }},
    {{"time_of_peak_force", "s", "time of the largest force", false},
     [](const Summary& of) { return present(of.time_of_peak_force, of.errors.time_of_peak_force); }},
    {{"peak_motion", "m", "largest motion of the impactor", false, Growth::with_motion},
     [](const Summary& of) {
       return FigureWithError{of.peak_motion, of.errors.peak_motion};
     }},
    {{"peak_penetration", "m", "largest penetration of the pad", false, Growth::with_motion},
     [](const Summary& of) {
       return FigureWithError{of.peak_penetration, of.errors.peak_penetration};
     }},
    {{"peak_strain", "1", "largest strain on the axis", false, Growth::with_motion},
     [](const Summary& of) {
       return FigureWithError{of.peak_strain, of.errors.peak_penetration};
     }},
    {{"peak_strain_rate", "1/s", "largest strain rate on the axis", false, Growth::with_motion},
     [](const Summary& of) {
       return FigureWithError{of.peak_strain_rate, 0};
     }},
    {{"rebound_speed", "m/s", "speed when the impactor leaves the pad", false},
     [](const Summary& of) { return present(of.rebound_speed, of.errors.rebound_speed); }},
    {{"restitution", "1", "rebound speed over impact speed", false},
     [](const Summary& of) { return present(of.restitution, of.errors.rebound_speed); }},
    {{"contact_end_time", "s", "end of contact: the force falls below 0.1 % of its peak", false},
     [](const Summary& of) {
       return of.contact_end ? FigureWithError{of.contact_end->time, of.errors.contact_end}
                             : FigureWithError{no_value, 0};
     }},
    {{"release_time", "s", "when the last column is without pressure; has no error estimate", false},
     [](const Summary& of) {
       return FigureWithError{of.release ? of.release->time : no_value, 0};
     }},
    {{"energy_absorbed_fraction", "1", "part of the impact energy that the pad absorbs", false, Growth::none,
      true},
     [](const Summary& of) {
       return FigureWithError{of.energy_absorbed_fraction, of.errors.energy_absorbed};
     }},
    {{"hic15", "1", "head injury criterion, windows up to 15 ms", true, Growth::with_force},
     nullptr,
     [](PulseFigures& of) { return of.hic(15e-3); }},
    {{"hic36", "1", "head injury criterion, windows up to 36 ms", true, Growth::with_force},
     nullptr,
     [](PulseFigures& of) { return of.hic(36e-3); }},
    {{"hic_unlimited", "1", "head injury criterion, windows of any length", true, Growth::with_force},
     nullptr,
     [](PulseFigures& of) { return of.hic(unlimited_window); }},
    {{"hic_d", "1", "HIC(d) of the free-motion headform", true, Growth::with_force},
     nullptr,
     [](PulseFigures& of) { return of.hic_d(); }},
    {{"clip_3ms_contiguous", "m/s2", "deceleration exceeded for 3 ms without a break", true,
      Growth::with_force},
     nullptr,
     [](PulseFigures& of) { return of.contiguous_3ms(); }},
    {{"clip_3ms_cumulative", "m/s2", "deceleration exceeded for 3 ms in all", true, Growth::with_force},
     nullptr,
     [](PulseFigures& of) { return of.cumulative_3ms(); }},
    {{"severity_index", "1", "Gadd severity index", true, Growth::with_force},
     nullptr,
     [](PulseFigures& of) { return of.severity_index(); }},
    {{"velocity_change", "m/s", "velocity change over the pulse, with sign", true, Growth::none, true},
     nullptr,
     [](PulseFigures& of) { return of.velocity_change(); }},
};

}  // namespace

const std::vector<ResponseKind>& response_kinds() {
  static const std::vector<ResponseKind> kinds = [] {
    std::vector<ResponseKind> all;
    for (const Recipe& recipe : recipes) all.push_back(recipe.kind);
    return all;
  }();
  return kinds;
}

const ResponseKind* find_response_kind(const std::string& name) {
  const auto& kinds = response_kinds();
  const auto found = std::ranges::find_if(kinds, [&](const ResponseKind& kind) { return name == kind.name; });
  return found == kinds.end() ? nullptr : &*found;
}

bool is_possible(const ResponseKind& kind, double value) {
  return std::isfinite(value) && (kind.is_signed || value >= 0);
}

bool has_response(const ResponseKind& kind, Status status) {
  switch (status) {
    // Contact may never be lost: a rigid foam stops the impactor on a rigid support.
    case Status::released: return kind.name != std::string_view{"contact_end_time"};
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
    if (!kind.of_pulse) names.emplace_back(kind.name);
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
  outcome.extrapolated = summary.extrapolated;
  outcome.bottomed = summary.bottomed.has_value();
  outcome.error = 0;
  outcome.values.assign(kinds_.size(), no_value);
  if (pulse_) pulse_->take(solution);
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    const Recipe& recipe = recipes[kinds_[i]];
    if (recipe.of_pulse && !pulse_->whole()) continue;
    const FigureWithError figure = recipe.of_pulse ? recipe.of_pulse(*pulse_) : recipe.of_summary(summary);
    if (is_possible(recipe.kind, figure.value)) outcome.values[i] = figure.value;
    // An estimate that is no number bounds nothing.
    outcome.error = std::max(outcome.error, std::isnan(figure.error) ? infinity : figure.error);
  }
}

void read_responses(const Solution& solution, std::span<const std::string> names, Outcome& outcome) {
  ResponseReader reader(names);
  reader(solution, outcome);
}

}  // namespace dashpad::study
