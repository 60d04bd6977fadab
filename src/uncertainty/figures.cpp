#include "uncertainty/figures.hpp"

#include "dashpad/impact/flags.hpp"
#include "dashpad/injury/dwell.hpp"
#include "dashpad/injury/figures.hpp"
#include "result/summary_values.hpp"

namespace dashpad::uncertainty {

std::vector<AskedFigure> asked_figures(std::span<const double> dwell_levels) {
  std::vector<AskedFigure> asked;
  for (const ResultQuantity& of : result_quantities())
    if (of.role.doubt == Doubt::of_level) {
      for (const double level : dwell_levels) asked.push_back({&of, level});
    } else if (of.has_interval()) {
      asked.push_back({&of});
    }
  return asked;
}

std::vector<double> figures_of(const Solution& solution, std::span<const AskedFigure> asked) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const Summary& summary = solution.summary;
  const auto injury = injury::whole_pulse_figures(solution);
  const auto value_of = [&](const AskedFigure& figure) {
    for (const SummaryQuantity& of : summary_quantities())
      if (figure.quantity == of.quantity) return of.of(summary).value;
    if (!injury) return none;
    if (figure.quantity->role.doubt == Doubt::of_level)
      return injury::cumulative_dwell(injury::pulse_of(solution.history), figure.level);
    for (const injury::InjuryValue& of : injury::injury_values(*injury))
      if (figure.quantity == of.quantity) return of.value;
    return none;
  };
  std::vector<double> values;
  for (const AskedFigure& figure : asked) values.push_back(value_of(figure));
  return values;
}

}  // namespace dashpad::uncertainty
