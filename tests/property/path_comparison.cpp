#include "property/path_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace dashpad::test {
namespace {

void add(PathComparison& comparison, const char* name, std::optional<double> fast,
         std::optional<double> plain, double least_scale, double fast_error, double plain_error) {
  if (fast.has_value() != plain.has_value()) comparison.same_figures = false;
  if (!fast || !plain) return;
  const double scale = std::max(std::abs(*plain), least_scale);
  const double difference = *fast == *plain ? 0 : std::abs(*fast - *plain) / scale;
  comparison.figures.push_back({name, *fast, *plain, difference, fast_error + plain_error});
}

std::optional<double> time_of(const std::optional<Moment>& moment) {
  return moment ? std::optional(moment->time) : std::nullopt;
}

}  // namespace

bool PathComparison::alike(double tolerance) const {
  return same_figures &&
         std::ranges::all_of(figures, [&](const PathFigure& figure) { return figure.alike(tolerance); });
}

std::string PathComparison::text() const {
  std::string line = to_string(fast);
  if (fast != plain) line += fmt::format(" / {}", to_string(plain));
  for (const PathFigure& f : figures)
    line += fmt::format("  {} {:.6g} / {:.6g} ({:.1e}, estimates {:.1e})", f.name, f.fast, f.plain,
                        f.difference, f.estimates);
  return line;
}

PathComparison compare_paths(Solver& solver, const ImpactCase& impact, double tolerance,
                             std::size_t most_steps) {
  Options options{.tolerance = tolerance, .most_steps = most_steps};
  const Summary a = solver.solve(impact, options).summary;
  options.plain = true;
  const Summary b = solver.solve(impact, options).summary;
  PathComparison comparison{.fast = a.status, .plain = b.status, .figures = {}};
  comparison.fast_time = a.wall_time;
  comparison.plain_time = b.wall_time;
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
