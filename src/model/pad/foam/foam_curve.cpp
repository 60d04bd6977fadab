#include "model/pad/foam/foam_curve.hpp"

#include <algorithm>
#include <type_traits>

#include "dashpad/quantities/portable_math.hpp"
#include "model/pad/foam/monotone_curve.hpp"

namespace dashpad {

double last_strain_of(const BaseCurve& base) {
  return std::visit(
      []<class Form>(const Form& form) {
        if constexpr (std::is_same_v<Form, TableCurve>)
          return form.strain.back();
        else
          return form.highest_strain;
      },
      base);
}

namespace {

/// The points with plateaus of equal stress lifted a little, so that each stress has one strain.
TableCurve rising(TableCurve table) {
  constexpr double lift = 1e-7;  // relative, from point to point
  for (std::size_t i = 1; i < table.stress.size(); ++i)
    table.stress[i] = std::max(table.stress[i], table.stress[i - 1] * (1 + lift));
  return table;
}

}  // namespace

FoamCurve::FoamCurve(const BaseCurve& base, double continuation_exponent)
    : last_{.exponent = continuation_exponent, .strain = last_strain_of(base)}, cells_(last_.strain) {
  last_.complement = 1 - last_.strain;
  double last_slope = 0;
  const auto take = [&](auto&& stress) {
    stress_.fill(cells_, [&](double root) { return stress(root * root); });
    const double d = 1e-5 * std::min(last_.strain, last_.complement);
    last_slope = (stress(last_.strain + d) - stress(last_.strain - d)) / (2 * d);
    last_.stress = stress(last_.strain);
  };
  std::visit(
      [&]<class Form>(const Form& form) {
        if constexpr (std::is_same_v<Form, TableCurve>)
          take([curve = MonotoneCurve(rising(form))](double e) { return curve.stress(e); });
        else
          take([&form](double e) { return form.stress(e); });
      },
      base);
  // A curve with a level end would never stiffen.
  constexpr double min_rise = 0.1;
  last_slope = std::max(last_slope, min_rise * last_.stress / last_.strain);

  work_.assign(Cells::count, 0);
  for (std::size_t i = 0; i + 1 < Cells::count; ++i) work_[i + 1] = within({i, 1}).work;
  last_.work = within({Cells::count - 1, 1}).work;
  moment_.assign(Cells::count, 0);
  for (std::size_t i = 0; i + 1 < Cells::count; ++i) moment_[i + 1] = moment_within({i, 1});
  last_moment_ = moment_within({Cells::count - 1, 1});
  last_.power = portable::pow(last_.complement, -last_.exponent);
  last_.growth = last_slope * last_.complement / (last_.exponent * last_.power);
}

}  // namespace dashpad
