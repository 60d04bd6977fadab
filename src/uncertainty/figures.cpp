#include "uncertainty/figures.hpp"

#include "dashpad/impact/flags.hpp"
#include "dashpad/injury/dwell.hpp"
#include "dashpad/injury/figures.hpp"
#include "result/summary_values.hpp"

namespace dashpad::uncertainty {

std::vector<FigureName> figure_names(std::span<const double> dwell_levels) {
  using Kind = FigureName::Kind;
  std::vector<FigureName> names{{"peak_acceleration", Kind::acceleration},
                                {"peak_force", Kind::acceleration},
                                {"hic15", Kind::hic},
                                {"hic36", Kind::hic},
                                {"hic_unlimited", Kind::hic},
                                {"hic_d", Kind::hic_d},
                                {"clip_3ms", Kind::acceleration},
                                {"cumulative_3ms", Kind::acceleration},
                                {"severity_index", Kind::hic},
                                {"peak_penetration", Kind::penetration},
                                {"peak_strain", Kind::penetration},
                                {"rebound_speed", Kind::rebound},
                                {"restitution", Kind::rebound}};
  for (const double level : dwell_levels) names.push_back({"dwell_time", Kind::dwell, level});
  return names;
}

std::vector<double> figures_of(const Solution& solution, std::span<const FigureName> names) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const Summary& summary = solution.summary;
  const auto injury = injury::whole_pulse_figures(solution);
  const auto value_of = [&](const FigureName& name) {
    for (const SummaryQuantity& of : summary_quantities())
      if (name.key == of.quantity->key) return of.of(summary).value;
    if (!injury) return none;
    if (name.key == "dwell_time")
      return injury::cumulative_dwell(injury::pulse_of(solution.history), name.level);
    for (const injury::InjuryValue& of : injury::injury_values(*injury))
      if (name.key == of.quantity->key) return of.value;
    return none;
  };
  std::vector<double> values;
  for (const FigureName& name : names) values.push_back(value_of(name));
  return values;
}

}  // namespace dashpad::uncertainty
