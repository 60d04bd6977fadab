#pragma once
/// The solver's march at given resolutions, without the search for the resolution that meets a tolerance.

#include <optional>
#include <tuple>
#include <type_traits>
#include <variant>

#include "contact/column_field.hpp"
#include "contact/curve_contact.hpp"
#include "impact/march.hpp"
#include "impact/refinement.hpp"

namespace dashpad::bench {

/// Keeps its memory from run to run, as Solver does.
class FixedRuns {
 public:
  /// At `resolution` and, if extrapolated, at twice that before it.
  Figures run(const ImpactCase& impact, double resolution, bool extrapolated) {
    const double thickness = impact.pad.thickness, radius = impact.impactor.radius;
    const auto march_on = [&](auto& contact) {
      const Options options;
      March<std::decay_t<decltype(contact)>> march(impact.impactor, thickness, impact.support, contact,
                                                   options);
      Refinement refinement(impact.impactor, options.tolerance);
      if (extrapolated) refinement.add(march.run(2 * resolution, track_));
      refinement.add(march.run(resolution, track_));
      return refinement.figures();
    };
    return std::visit(
        [&](const auto& law) {
          using Law = std::decay_t<decltype(law)>;
          if constexpr (IsMemoryless<Law>) {
            CurveContact contact(law.curve(), Law::recovers, thickness, radius);
            return march_on(contact);
          } else {
            auto& field = std::get<std::optional<ColumnField<Law>>>(fields_);
            if (field)
              field->set(law, thickness, radius, ColumnMath::vector);
            else
              field.emplace(law, thickness, radius, ColumnMath::vector);
            return march_on(*field);
          }
        },
        impact.pad.material.law);
  }

 private:
  Track track_;
  std::tuple<std::optional<ColumnField<LinearViscoelastic>>, std::optional<ColumnField<NineParameter>>,
             std::optional<ColumnField<TwentyOneParameter>>>
      fields_;
};

}  // namespace dashpad::bench
