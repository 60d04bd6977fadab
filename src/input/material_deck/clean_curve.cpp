#include "input/material_deck/deck_foam.hpp"

#include <tuple>

#include <fmt/format.h>

#include "quantities/magnitude_bounds.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

/// NaN had its fault when it was read.
bool is_sound_point(const DeckCurve& curve, std::size_t i) {
  return curve.strain[i] == curve.strain[i] && curve.stress[i] == curve.stress[i];
}

std::string written_number(double value) { return fmt::format("{:.6g}", value); }

/// Compares a point with the previous one, which may be at or below strain 0.
bool judge_order(const DeckCurve& curve, std::size_t i, MeasurementFaults& faults) {
  const double e = curve.strain[i];
  for (const auto& [what, value, unit] :
       {std::tuple{": strain", e, "1"}, {": stress", curve.stress[i], "Pa"}})
    if (const std::string rule = rule_of(stated_magnitudes, value, unit); !rule.empty()) {
      faults.add(curve.lines[i], curve.name + what, written_number(value), rule);
      return false;
    }
  if (i > 0 && is_sound_point(curve, i - 1) && e <= curve.strain[i - 1]) {
    faults.add(curve.lines[i], curve.name + ": strain", written_number(e),
               e == curve.strain[i - 1]
                   ? "appears twice; each strain can have only one stress"
                   : fmt::format("must be more than the previous strain, {:.6g}", curve.strain[i - 1]));
    return false;
  }
  if (e < 1) return true;
  faults.add(curve.lines[i], curve.name + ": strain", written_number(e),
             "must be less than 1, at which no thickness is left; is it in per cent?");
  return false;
}

bool judge_stress(const DeckCurve& curve, std::size_t i, const CleanCurve& clean, CurveRole role,
                  MeasurementFaults& faults) {
  const double stress = curve.stress[i];
  const std::string key = curve.name + ": stress";
  if (!(stress > 0)) {
    faults.add(curve.lines[i], key, written_number(stress), "must be positive at a positive strain");
    return false;
  }
  const double before =
      clean.table.stress.empty() ? clean.stress_at_zero.value_or(0) : clean.table.stress.back();
  if (role == CurveRole::base && stress < before) {
    faults.add(curve.lines[i], key, written_number(stress),
               fmt::format("must not be less than the previous stress, {:.6g} Pa: the curve for the lowest "
                           "rate must not fall",
                           before));
    return false;
  }
  return true;
}

void tell_of_cuts(const DeckCurve& curve, std::size_t tension, std::size_t slack, const CleanCurve& clean,
                  std::vector<std::string>& differences) {
  const auto tell = [&](std::size_t count, const char* which) {
    if (count > 0)
      differences.push_back(fmt::format("{}: {} {} {} left out.", curve.name, plural(count, "point"), which,
                                        count == 1 ? "was" : "were"));
  };
  tell(tension, "in tension");
  tell(slack, "without stress at the start");
  if (clean.stress_at_zero && *clean.stress_at_zero < 0)
    differences.push_back(fmt::format("{}: the stress of {:.6g} Pa at a strain of 0 was left out.",
                                      curve.name, *clean.stress_at_zero));
}

}  // namespace

std::optional<CleanCurve> clean_curve(const DeckCurve& curve, CurveRole role, MeasurementFaults& faults,
                                      std::vector<std::string>& differences) {
  CleanCurve clean;
  std::size_t tension = 0, slack = 0;
  bool sound = true;
  for (std::size_t i = 0; i < curve.strain.size(); ++i) {
    if (!sound && curve.is_moved) break;
    if (!is_sound_point(curve, i) || !judge_order(curve, i, faults)) {
      sound = false;
      continue;
    }
    if (curve.strain[i] < 0) {
      ++tension;
    } else if (curve.strain[i] == 0) {
      if (curve.stress[i] != 0) clean.stress_at_zero = curve.stress[i];
    } else if (role == CurveRole::unloading && clean.table.strain.empty() && curve.stress[i] <= 0) {
      ++slack;
    } else if (!judge_stress(curve, i, clean, role, faults)) {
      sound = false;
    } else {
      clean.table.strain.push_back(curve.strain[i]);
      clean.table.stress.push_back(curve.stress[i]);
      clean.lines.push_back(curve.lines[i]);
    }
  }
  if (!sound) return std::nullopt;
  if (clean.table.strain.size() > TableCurve::max_points) {
    faults.add(curve.line, curve.name, "", too_many_points(clean.table.strain.size()));
    return std::nullopt;
  }
  tell_of_cuts(curve, tension, slack, clean, differences);
  return clean;
}

bool limit_to_elastic_line(CleanCurve& curve, double modulus, const DeckCurve& deck_curve,
                           MeasurementFaults& faults, std::vector<std::string>& differences) {
  const std::vector<double>&strain = curve.table.strain, &stress = curve.table.stress;
  const auto is_below_line = [&](std::size_t i) { return stress[i] <= modulus * strain[i] * (1 + 1e-12); };
  std::size_t first = 0;
  while (first < strain.size() && !is_below_line(first)) ++first;
  const double at_zero = std::max(curve.stress_at_zero.value_or(0), 0.0);
  if (first == 0 && at_zero == 0) return true;
  if (first == strain.size()) {
    faults.add(deck_curve.line, deck_curve.name, "",
               fmt::format("lies entirely above the elastic line, whose modulus is {:.6g} Pa", modulus));
    return false;
  }
  const double e0 = first == 0 ? 0 : strain[first - 1];
  const double s0 = first == 0 ? at_zero : stress[first - 1];
  const double slope = (stress[first] - s0) / (strain[first] - e0);
  const double yield = (s0 - slope * e0) / (modulus - slope);
  // Three points along the line keep the interpolated curve straight.
  TableCurve limited{{yield / 3, 2 * yield / 3, yield},
                     {modulus * yield / 3, modulus * (2 * yield / 3), modulus * yield}};
  std::vector<std::size_t> lines(3, deck_curve.line);
  for (std::size_t i = first; i < strain.size(); ++i)
    if (strain[i] > yield * (1 + 1e-9) && stress[i] >= limited.stress.back()) {
      limited.strain.push_back(strain[i]);
      limited.stress.push_back(stress[i]);
      lines.push_back(curve.lines[i]);
    }
  differences.push_back(fmt::format(
      "{}: up to a strain of {:.3g} the stress rises along the elastic line, with a slope of {:.6g} Pa, "
      "as in the solver.",
      deck_curve.name, yield, modulus));
  curve.table = std::move(limited);
  curve.lines = std::move(lines);
  return true;
}

bool add_air(CleanCurve& curve, const DeckAir& air, const DeckCurve& deck_curve, MeasurementFaults& faults) {
  if (air.pressure == 0) return true;
  for (std::size_t i = 0; i < curve.table.strain.size(); ++i) {
    const double e = curve.table.strain[i];
    const double room = 1 - e - air.relative_density;
    if (!(room > 0)) {
      faults.add(curve.lines[i], deck_curve.name + ": strain", written_number(e),
                 fmt::format("must be less than 1 - Phi = {:.6g}, at which no air is left",
                             1 - air.relative_density));
      return false;
    }
    curve.table.stress[i] += air.pressure * e / room;
  }
  return true;
}

std::string too_many_points(std::size_t count) {
  return fmt::format("has {} points; at most {} are allowed", count, TableCurve::max_points);
}

}  // namespace dashpad::input
