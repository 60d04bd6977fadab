#include "property/answer_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace dashpad::test {
namespace {

void add(AnswerComparison& comparison, const char* name, std::optional<double> value,
         std::optional<double> reference, double min_scale, double error, double error_of_reference) {
  if (value.has_value() != reference.has_value()) comparison.same_figures = false;
  if (!value || !reference) return;
  const double scale = std::max(std::abs(*reference), min_scale);
  const double difference = *value == *reference ? 0 : std::abs(*value - *reference) / scale;
  comparison.figures.push_back({name, *value, *reference, difference, error + error_of_reference});
}

std::optional<double> time_of(const std::optional<Moment>& moment) {
  return moment ? std::optional(moment->time) : std::nullopt;
}

}  // namespace

bool AnswerComparison::alike(double allowed) const {
  return same_figures &&
         std::ranges::all_of(figures, [&](const ComparedFigure& f) { return f.difference <= allowed; });
}

std::string AnswerComparison::text() const {
  std::string line = to_string(status);
  if (status != reference_status) line += fmt::format(" / {}", to_string(reference_status));
  for (const ComparedFigure& f : figures)
    line += fmt::format("  {} {:.6g} / {:.6g} ({:.1e}, estimates {:.1e})", f.name, f.value, f.reference,
                        f.difference, f.estimates);
  return line;
}

AnswerComparison compare_answers(Solver& solver, const ImpactCase& impact, const Options& options,
                                 const Options& of_reference) {
  const Summary a = solver.solve(impact, options).summary;
  const Summary b = solver.solve(impact, of_reference).summary;
  AnswerComparison comparison{.status = a.status, .reference_status = b.status, .figures = {}};
  comparison.wall_time = a.wall_time;
  comparison.reference_time = b.wall_time;
  if (!a.trustworthy() || a.status != b.status) return comparison;
  add(comparison, "peak force", a.peak_force, b.peak_force, 0, a.errors.peak_force, b.errors.peak_force);
  add(comparison, "peak penetration", a.peak_penetration, b.peak_penetration, 0, a.errors.peak_penetration,
      b.errors.peak_penetration);
  add(comparison, "rebound speed", a.rebound_speed, b.rebound_speed, 1e-3 * impact.impactor.speed,
      a.errors.rebound_speed, b.errors.rebound_speed);
  add(comparison, "end of contact", time_of(a.contact_end), time_of(b.contact_end), 0, a.errors.contact_end,
      b.errors.contact_end);
  return comparison;
}

}  // namespace dashpad::test
