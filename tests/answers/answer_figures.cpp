#include "answers/answer_figures.hpp"

#include <algorithm>
#include <cmath>

#include "dashpad/injury/figures.hpp"

namespace dashpad::test {
namespace {

/// Speeds below this share of the impact speed are relative to it (theory.md, "What a tolerance means").
constexpr double min_speed = 1e-3;

class Figures {
 public:
  explicit Figures(double impact_speed) : impact_speed_(impact_speed) {}

  void add(const char* name, double value, double estimate, double allowed = 1) {
    add_to(name, value, std::abs(value), estimate, allowed);
  }
  void add_to(const char* name, double value, double scale, double estimate, double allowed = 1) {
    if (scale > 0) figures_.push_back({name, value, scale, estimate, allowed});
  }
  void add_speed(const char* name, double value, double estimate) {
    add_to(name, value, std::max(std::abs(value), min_speed * impact_speed_), estimate);
  }
  void add(const char* time, const char* speed, const std::optional<Moment>& moment, double estimate) {
    if (!moment) return;
    add(time, moment->time, estimate);
    add_speed(speed, moment->velocity, estimate);
  }
  [[nodiscard]] std::vector<AnswerFigure> all() && { return std::move(figures_); }

 private:
  double impact_speed_;
  std::vector<AnswerFigure> figures_;
};

void add_pulse(Figures& figures, const injury::InjuryFigures& injury_figures) {
  constexpr double not_held = 0;
  const auto add = [&](const char* name, double value, double estimate) {
    figures.add(name, value, estimate, not_held);
  };
  add("HIC15", injury_figures.hic15.value, injury_figures.errors.hic15);
  add("HIC36", injury_figures.hic36.value, injury_figures.errors.hic36);
  add("3 ms clip", injury_figures.clip_3ms.level, injury_figures.errors.clip_3ms);
  add("cumulative 3 ms clip", injury_figures.cumulative_3ms.level, injury_figures.errors.cumulative_3ms);
  add("severity index", injury_figures.severity_index, injury_figures.errors.severity_index);
  add("velocity change", injury_figures.velocity_change, injury_figures.errors.velocity_change);
}

}  // namespace

std::vector<AnswerFigure> figures_of(const ImpactCase& impact, const Solution& solution) {
  const Summary& s = solution.summary;
  const ErrorEstimates& e = s.errors;
  Figures figures(impact.impactor.speed);
  if (s.peak_force) figures.add("peak force", *s.peak_force, e.peak_force);
  figures.add("peak motion", s.peak_motion, e.peak_motion);
  figures.add("peak penetration", s.peak_penetration, e.peak_penetration);
  if (s.rebound_speed) figures.add_speed("rebound speed", *s.rebound_speed, e.rebound_speed);
  figures.add("end of contact", "speed at end of contact", s.contact_end, e.contact_end);
  figures.add("force below weight", "speed, force below weight", s.force_below_weight, e.force_below_weight);
  figures.add("bottoming", "speed at bottoming", s.bottomed, e.bottomed);
  const double absorbed = s.energy_absorbed_fraction;
  figures.add_to("absorbed energy", absorbed, 1, e.energy_absorbed, 10 * std::max(absorbed, 0.05));
  if (s.support) {
    if (const auto force = s.support->peak_transmitted) figures.add("transmitted force", *force, e.support);
    // A support that was never reached has rounding for a deflection.
    const double deflection = std::max(s.support->peak_deflection, 1e-6 * s.peak_motion);
    figures.add_to("deflection", s.support->peak_deflection, deflection, e.support);
    if (s.support->set) figures.add_to("set", *s.support->set, deflection, e.support);
    if (s.support->body_speed)
      figures.add_to("body speed", *s.support->body_speed, impact.impactor.speed, e.support);
  }
  if (const auto pulse = injury::whole_pulse_figures(solution)) add_pulse(figures, *pulse);
  return std::move(figures).all();
}

}  // namespace dashpad::test
