#pragma once
/// The solver's march at given resolutions, without the search for the resolution that meets a tolerance.

#include "impact/contacts.hpp"
#include "impact/march.hpp"
#include "impact/refinement.hpp"

namespace dashpad::bench {

/// Keeps its memory from run to run, as Solver does.
class FixedRuns {
 public:
  /// At `resolution` and, if extrapolated, at twice that before it.
  Figures run(const ImpactCase& impact, double resolution, bool extrapolated) {
    return contacts_.visit(impact, ColumnMath::vector, [&](auto& contact) {
      const Options options;
      March march(impact, contact, options);
      Refinement refinement(impact, options.tolerance);
      if (extrapolated) refinement.add(march.run(2 * resolution, track_));
      refinement.add(march.run(resolution, track_));
      return refinement.figures();
    });
  }

 private:
  Track track_;
  Contacts contacts_;
};

}  // namespace dashpad::bench
