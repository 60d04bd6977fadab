#pragma once
/// The contact of a case, in memory that is reused from one impact to the next.

#include <optional>
#include <tuple>
#include <type_traits>
#include <variant>

#include "dashpad/impact/impact_case.hpp"
#include "impact/neighbours.hpp"
#include "model/contact/column_field.hpp"
#include "model/contact/curve_contact.hpp"
#include "model/contact/foam_contact.hpp"
#include "model/contact/layered_contact.hpp"
#include "model/contact/nine_parameter_contact.hpp"
#include "model/contact/with_neighbours.hpp"
#include "model/pad/layer/layer_law.hpp"

namespace dashpad {

// The layers of a case as arguments of a contact.

/// The layers of a pad, which must be sound.
inline LayeredContact::Parts layers_of(const Pad& pad) {
  LayeredContact::Parts parts;
  for (const PadLayer& layer : pad.layers)
    parts.push_back({layer.thickness, layer_law(layer.material.law).value(),
                     stress_factor(layer.condition, layer.material)});
  return parts;
}

class Contacts {
 public:
  /// Whether this was the last foam, which is then sound; checking its curves takes a third of the time.
  [[nodiscard]] bool know(const PadLaw& law) const { return foam_ && foam_->is_of(law); }
  /// Returns visit(contact). With ColumnMath::plain columns are computed one by one, without short cuts.
  template <class Visit>
  auto visit(const ImpactCase& impact, ColumnMath math, Visit&& visit) {
    const ColumnFactor factor = factor_of_columns(impact);
    if (!impact.pad.layers.empty())
      return visit(renewed(layered_, factor, layers_of(impact.pad), sections_of(impact)));
    const double thickness = impact.pad.thickness;
    const double scale = stress_factor(impact.pad.condition, impact.pad.material);
    const Sections sections = sections_of(impact);
    const double earlier = impact.pad.earlier_penetration;
    const auto of_law = [&](const auto& law) {
      using Law = std::decay_t<decltype(law)>;
      if constexpr (IsMemoryless<Law>) {
        WithNeighbours<CurveContact> contact(factor, law.curve(), Law::recovers, thickness, sections,
                                             earlier);
        return visit(contact);
      } else if constexpr (SharesSlip<Law>) {
        return visit(renewed(foam_, factor, law, thickness, sections, scale, math, earlier));
      } else {
        if constexpr (std::is_same_v<Law, NineParameter>)
          if (math == ColumnMath::vector && !sections.shape)
            return visit(renewed(nine_parameter_, factor, law, thickness, sections));
        return visit(renewed(std::get<Field<Law>>(fields_), factor, law, thickness, sections, math));
      }
    };
    const PadLaw& law = impact.pad.material.law;
    // The curves of a foam are prepared once, without the scale; its contact multiplies the force instead.
    return has_curves(law) || scale == 1 ? std::visit(of_law, law) : std::visit(of_law, scaled(law, scale));
  }

 private:
  template <class Contact, class... Arguments>
  static Contact& renewed(std::optional<Contact>& contact, const Arguments&... arguments) {
    if (contact)
      contact->set(arguments...);
    else
      contact.emplace(arguments...);
    return *contact;
  }

  std::optional<WithNeighbours<LayeredContact>> layered_;
  std::optional<WithNeighbours<NineParameterContact>> nine_parameter_;
  std::optional<WithNeighbours<FoamContact>> foam_;
  template <class Law>
  using Field = std::optional<WithNeighbours<ColumnField<Law>>>;
  WithMemory<Field> fields_;
};

}  // namespace dashpad
