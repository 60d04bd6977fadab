#pragma once
/// The solver's march at given resolutions, without the search for the resolution that meets a tolerance.

#include <type_traits>
#include <variant>

#include "contact/column_field.hpp"
#include "contact/curve_contact.hpp"
#include "impact/march.hpp"
#include "impact/refinement.hpp"

namespace dashpad::bench {

/// Runs at `resolution` and, if extrapolated, at twice that before it. `track` is storage to be used again.
inline Figures fixed_run(const ImpactCase& impact, double resolution, bool extrapolated, Track& track) {
  const auto march_on = [&](auto contact) {
    const Options options;
    March<decltype(contact)> march(impact.impactor, impact.pad.thickness, impact.support, contact, options);
    Refinement refinement(impact.impactor, options.tolerance);
    if (extrapolated) refinement.add(march.run(2 * resolution, track));
    refinement.add(march.run(resolution, track));
    return refinement.figures();
  };
  return std::visit(
      [&](const auto& law) {
        using Law = std::decay_t<decltype(law)>;
        const double thickness = impact.pad.thickness;
        const double radius = impact.impactor.radius;
        if constexpr (IsMemoryless<Law>)
          return march_on(CurveContact(law.curve(), Law::recovers, thickness, radius));
        else
          return march_on(ColumnField<Law>(law, thickness, radius));
      },
      impact.pad.material.law);
}

}  // namespace dashpad::bench
