// How a foam goes on beyond its tested strain: the exponent of Eq. 37 at its two ends.

#include <algorithm>

#include <fmt/format.h>

#include "model/pad/foam/foam_curve.hpp"
#include "uncertainty/line.hpp"

namespace dashpad::uncertainty {
namespace {

/// The base curve up to a strain within it.
BaseCurve cut_at(const BaseCurve& base, double strain) {
  if (strain >= last_strain_of(base)) return base;
  const double stress = FoamCurve(base, 2).at(strain_of(strain)).stress;
  return std::visit(
      [&]<class Form>(Form form) -> BaseCurve {
        if constexpr (std::is_same_v<Form, TableCurve>) {
          const auto first = std::ranges::lower_bound(form.strain, strain);
          const auto kept = static_cast<std::size_t>(first - form.strain.begin());
          form.strain.resize(kept);
          form.stress.resize(kept);
          form.strain.push_back(strain);
          form.stress.push_back(stress);
          if (form.strain.size() < TableCurve::fewest_points) return base;
        } else {
          form.highest_strain = strain;
        }
        return form;
      },
      base);
}

/// Up to which strain the foam was tested.
std::optional<double> tested_strain(const Material& material) {
  std::optional<double> strain;
  if (material.fitted) strain = material.fitted->highest_strain;
  std::visit(
      [&]<class Law>(const Law& law) {
        if constexpr (SharesSlip<Law>) strain = std::min(strain.value_or(1), last_strain_of(law.curves.base));
      },
      material.law);
  return strain;
}

/// -1: the gentlest continuation that the card admits; 1: the steepest. The curve ends where the tests do.
void continue_by(Material& material, double tested, double place) {
  std::visit(
      [&]<class Law>(Law& law) {
        if constexpr (SharesSlip<Law>) {
          const double n = law.continuation_exponent;
          law.continuation_exponent = place < 0 ? n + place * (n - law.gentlest_continuation)
                                                : n + place * (law.steepest_continuation - n);
          law.curves.base = cut_at(law.curves.base, tested);
        }
      },
      material.law);
}

}  // namespace

void add_continuation(const ImpactCase& impact, const Summary& summary, Open& open) {
  std::vector<std::optional<double>> beyond;  // the tested strain of parts that went beyond it
  double first = 1;
  bool by_curves = false;
  for (const Part& part : parts_of(impact.pad, summary)) {
    const std::optional<double> tested = tested_strain(*part.material);
    const bool is_beyond = tested && part.strain > (1 + 1e-9) * *tested;
    beyond.push_back(is_beyond ? tested : std::nullopt);
    if (!is_beyond) continue;
    first = std::min(first, *tested);
    if (has_curves(part.material->law)) {
      by_curves = true;
    } else {
      open.sources.push_back({Source::continuation,
                              fmt::format("what the law is worth beyond a strain of {:.3g}", *tested),
                              fmt::format("the law {} has no number of its own for what comes beyond its fit",
                                          name_of(part.material->law))});
    }
  }
  if (!by_curves) return;
  open.sources.push_back(
      {Source::continuation, fmt::format("how the foam goes on beyond a strain of {:.3g}", first), ""});
  open.lines.push_back(
      {.source = Source::continuation, .ends = {-1, 1}, .at = [impact, beyond](double place) {
         return with_parts(impact, [&](Material& material, PadCondition&, std::size_t i) {
           if (beyond[i]) continue_by(material, *beyond[i], place);
         });
       }});
}

}  // namespace dashpad::uncertainty
