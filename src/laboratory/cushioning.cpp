#include "dashpad/laboratory/material_test.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/math/tools/minima.hpp>

#include "model/root.hpp"

namespace dashpad::laboratory {
namespace {

CushionPoint point_of(double strain, double stress, double energy) {
  return {strain, stress, energy, stress > 0 ? energy / stress : 0,
          stress > 0 && strain > 0 ? energy / (stress * strain) : 0};
}

CushionPoint point(const CushionCurve& curve, std::size_t i) {
  return {curve.strain[i], curve.stress[i], curve.energy[i], curve.efficiency[i], curve.ideality[i]};
}

/// A point before the first place, by the power law stress = S1 (strain / e1)^q through the first two places.
CushionPoint before_first(const CushionCurve& curve, double limit) {
  const double e = curve.strain[0], S = curve.stress[0];
  const double q =
      curve.strain.size() > 1 ? std::log(curve.stress[1] / S) / std::log(curve.strain[1] / e) : 1;
  const double share = q > 0 ? std::pow(limit / S, 1 / q) : 0;
  return point_of(e * share, limit, curve.energy[0] * share * limit / S);
}

/// ln(stress) at ln(strain) = x, by Neville's scheme through four places around the interval before place i.
double log_stress(const CushionCurve& curve, std::size_t i, double x) {
  const std::size_t n = curve.strain.size();
  const std::size_t count = std::min<std::size_t>(4, n);
  const std::size_t first = std::min(i < 2 ? 0 : i - 2, n - count);
  std::array<double, 4> place{}, value{};
  for (std::size_t k = 0; k < count; ++k) {
    place[k] = std::log(curve.strain[first + k]);
    value[k] = std::log(curve.stress[first + k]);
  }
  for (std::size_t level = 1; level < count; ++level)
    for (std::size_t k = 0; k + level < count; ++k)
      value[k] =
          ((x - place[k + level]) * value[k] - (x - place[k]) * value[k + 1]) / (place[k] - place[k + level]);
  return value[0];
}

/// Energy between places i - 1 and i, by Hermite's cubic.
double energy_between(const CushionCurve& curve, std::size_t i, double strain) {
  const double width = curve.strain[i] - curve.strain[i - 1];
  const double t = (strain - curve.strain[i - 1]) / width;
  const double rise = curve.energy[i] - curve.energy[i - 1];
  return curve.energy[i - 1] + t * t * (3 - 2 * t) * rise +
         t * (1 - t) * width * ((1 - t) * curve.stress[i - 1] - t * curve.stress[i]);
}

CushionPoint between(const CushionCurve& curve, std::size_t i, double limit) {
  const double low = std::log(curve.strain[i - 1]);
  const double high = std::log(curve.strain[i]);
  const auto missing = [&](double x) { return log_stress(curve, i, x) - std::log(limit); };
  const RootBracket ends{.low = low, .high = high, .f_low = missing(low), .f_high = missing(high)};
  const bool is_between = ends.f_low < 0 && ends.f_high > 0;
  const double strain = std::exp(is_between ? narrowed(ends, missing).low : high);
  return point_of(strain, limit, energy_between(curve, i, strain));
}

/// Whether the efficiency has no kink at place i, judged by its second differences there and nearby.
bool is_smooth(const CushionCurve& curve, std::size_t i) {
  if (i < 3 || i + 3 >= curve.efficiency.size()) return false;
  const auto bend = [&](std::size_t k) {
    return std::abs(curve.efficiency[k - 1] - 2 * curve.efficiency[k] + curve.efficiency[k + 1]);
  };
  return bend(i) < 3 * std::max(bend(i - 2), bend(i + 2));
}

/// The point of the highest efficiency; where the curve is smooth, it may lie between places.
CushionPoint best_of(const CushionCurve& curve) {
  const auto best = std::ranges::max_element(curve.efficiency);
  if (best == curve.efficiency.end()) return {};
  const auto i = static_cast<std::size_t>(best - curve.efficiency.begin());
  if (!is_smooth(curve, i)) return point(curve, i);
  const auto at = [&](double strain) {
    const std::size_t next = strain > curve.strain[i] ? i + 1 : i;
    return point_of(strain, std::exp(log_stress(curve, next, std::log(strain))),
                    energy_between(curve, next, strain));
  };
  const double strain =
      boost::math::tools::brent_find_minima([&](double e) { return -at(e).efficiency; }, curve.strain[i - 1],
                                            curve.strain[i + 1], std::numeric_limits<double>::digits / 2)
          .first;
  const CushionPoint found = at(strain);
  return found.efficiency > *best ? found : point(curve, i);
}

/// Sets the largest stress and its strain, by a parabola in time unless it lies at an event or an end.
void find_peak(const ColumnTest& test, CushionFigures& figures) {
  const auto peak = std::ranges::max_element(test.stress);
  if (peak == test.stress.end() || !(*peak > 0)) return;
  const auto i = static_cast<std::size_t>(peak - test.stress.begin());
  figures.peak_stress = *peak;
  figures.strain_at_peak = test.strain[i];
  const bool is_at_event = std::ranges::find(test.events, i, &ColumnEvent::place) != test.events.end();
  if (i == 0 || i + 1 == test.size() || is_at_event) return;
  const double before = test.time[i - 1] - test.time[i], after = test.time[i + 1] - test.time[i];
  const double fall_before = (test.stress[i - 1] - *peak) / before;
  const double fall_after = (test.stress[i + 1] - *peak) / after;
  const double bend = (fall_after - fall_before) / (after - before);
  if (!(before < 0 && after > 0 && bend < 0)) return;
  const double slope = fall_before - bend * before;
  const double shift = -slope / (2 * bend);
  if (!(shift > before && shift < after)) return;
  figures.peak_stress += slope * shift / 2;
  const double rise_before = (test.strain[i - 1] - test.strain[i]) / before;
  const double rise_after = (test.strain[i + 1] - test.strain[i]) / after;
  const double curl = (rise_after - rise_before) / (after - before);
  figures.strain_at_peak += shift * (rise_before + curl * (shift - before));
}

}  // namespace

CushionCurve cushion_curve(const ColumnTest& test) {
  CushionCurve curve;
  double strain = 0;
  double stress = 0;
  for (std::size_t i = 0; i < test.size(); ++i) {
    if (test.strain[i] < strain) break;
    stress = std::max(stress, test.stress[i]);
    if (test.strain[i] == strain) continue;
    strain = test.strain[i];
    const CushionPoint p = point_of(strain, stress, test.work[i]);
    curve.strain.push_back(p.strain);
    curve.stress.push_back(p.stress);
    curve.energy.push_back(p.energy);
    curve.efficiency.push_back(p.efficiency);
    curve.ideality.push_back(p.ideality);
  }
  return curve;
}

CushionFigures cushion_figures(const ColumnTest& test) {
  CushionFigures figures;
  find_peak(test, figures);
  for (std::size_t i = 1; i < test.size(); ++i) {
    const double done = test.work[i] - test.work[i - 1];
    if (test.strain[i] > test.strain[i - 1])
      figures.energy_in += done;
    else
      figures.energy_returned -= done;
  }
  if (figures.energy_in > 0) {
    figures.hysteresis = 1 - figures.energy_returned / figures.energy_in;
    figures.energy_error = test.work_error / figures.energy_in + 1e-15;
  }
  figures.best_efficiency = best_of(cushion_curve(test));
  return figures;
}

std::optional<CushionPoint> at_stress_limit(const CushionCurve& curve, double limit) {
  if (!(limit > 0 && std::isfinite(limit)))
    throw std::invalid_argument(fmt::format("stress limit = {}: must be more than 0, in Pa", limit));
  const auto first = std::lower_bound(curve.stress.begin(), curve.stress.end(), limit);
  if (first == curve.stress.end()) return std::nullopt;
  const auto i = static_cast<std::size_t>(first - curve.stress.begin());
  if (*first == limit) return point(curve, i);
  return i == 0 ? before_first(curve, limit) : between(curve, i, limit);
}

}  // namespace dashpad::laboratory
