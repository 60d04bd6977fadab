#pragma once
/// What a fit is asked for: which numbers of a material are unknown, and the measurements that they have to
/// meet. SI throughout; stress and strain are engineering values, compression positive.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad::fit {

/// Normal distribution of an unknown, known before the fit.
struct Prior {
  double mean = 0;
  double deviation = 0;  ///< > 0
};

/// A quantity of the case (dashpad/impact/case_quantity.hpp) that the fit has to find.
struct Unknown {
  std::string key;              ///< "pad.curve.modulus"
  std::string unit;             ///< SI; "1" for a pure number
  double lowest = 0;            ///< bounds within which it is sought
  double highest = 0;           ///< > lowest
  double start = 0;             ///< of the first start
  bool is_logarithmic = false;  ///< sought by its logarithm; then lowest > 0
  std::optional<Prior> prior;
};

/// A compression test, strain and stress point by point. Between the points the strain is straight in time.
struct MaterialMeasurement {
  std::string file;             ///< for messages and for the card
  std::vector<double> time;     ///< s since first contact, increasing
  std::vector<double> strain;   ///< in [0, 1)
  std::vector<double> stress;   ///< Pa
  double lowest_strain = 0;     ///< points with strains from here
  double highest_strain = 1;    ///< to here count; the others are only gone through
  std::optional<double> noise;  ///< standard deviation of a stress, Pa; absent: estimated from the misfit
  bool has_offset = false;      ///< its force zero is shifted by an unknown stress
  bool is_held_out = false;     ///< predicted, not fitted
};

enum class ImpactFigure {
  peak_force,
  peak_acceleration,
  time_of_peak,
  rebound_speed,
  peak_penetration,
  contact_time
};

/// A figure of an impact.
struct MeasuredFigure {
  ImpactFigure figure = ImpactFigure::peak_force;
  double value = 0;      ///< SI
  double deviation = 0;  ///< standard deviation, > 0
};

/// An impact and what was measured of it. The material of its pad is that of the fit.
struct ImpactMeasurement {
  std::string file;
  ImpactCase impact;
  Options options;
  std::vector<MeasuredFigure> figures;
  bool is_held_out = false;
};

struct Fit {
  std::string title;
  ImpactCase base;        ///< its material has the starting values; without impacts the rest is made up
  bool has_case = false;  ///< the base is a case of the user's, not a pad alone
  std::vector<Unknown> unknowns;
  std::vector<MaterialMeasurement> tests;
  std::vector<ImpactMeasurement> impacts;
  int starts = 8;          ///< [1, 1000]
  std::uint64_t seed = 1;  ///< of the places of all starts but the first
};

/// Name in fit files and results, and SI unit.
struct ImpactFigureName {
  ImpactFigure figure;
  const char* key;
  const char* unit;
};
const std::vector<ImpactFigureName>& impact_figure_names();

/// Whether a strain counts in the fit.
inline bool counts(const MaterialMeasurement& test, std::size_t i) {
  return test.strain[i] >= test.lowest_strain && test.strain[i] <= test.highest_strain;
}

/// Every rule that a fit breaks, over all its parts. Keys are those of fit files:
/// "unknowns.pad.curve.modulus", "tests[1].file".
std::vector<Violation> violations(const Fit& fit);

}  // namespace dashpad::fit
