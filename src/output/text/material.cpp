#include <algorithm>
#include <array>
#include <iterator>
#include <type_traits>
#include <variant>

#include <fmt/format.h>

#include "dashpad/output/materials.hpp"
#include "laboratory/loading_curve.hpp"
#include "model/pad/foam/foam_curve.hpp"
#include "output/svg/text.hpp"
#include "output/text/table.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr auto not_stated = "-";

std::string or_not_stated(const std::string& text) { return text.empty() ? not_stated : one_line(text); }

/// The first clause of the first, and how many more there are.
std::string in_short(const std::vector<std::string>& reservations) {
  if (reservations.empty()) return not_stated;
  constexpr std::size_t longest = 44;
  std::string first = one_line(reservations.front());
  for (const char* end : {": ", "; ", ". "}) first.resize(std::min(first.find(end), first.size()));
  if (first.ends_with('.')) first.pop_back();
  first = shortened(first, longest);
  return reservations.size() == 1 ? first : fmt::format("{} (+{})", first, reservations.size() - 1);
}

std::string range_words(double low, double high) { return fmt::format("{} to {}", brief(low), brief(high)); }

std::vector<std::string> row_of(const Material& material) {
  const auto range = range_of(material);
  return {material.name,
          name_of(material.law),
          material.density ? brief(*material.density) : not_stated,
          range ? brief(range->highest_strain) : not_stated,
          range ? range_words(range->lowest_rate, range->highest_rate) : not_stated,
          or_not_stated(material.basis),
          in_short(material.reservations)};
}

/// A line each: key, symbol, value, unit, meaning.
template <class Of>
std::string parameter_lines(const Of& of, const UnitSystem& units) {
  std::string text;
  for (const Parameter<Of>& parameter : Of::parameters) {
    const std::string unit = unit_for(units, parameter.unit);
    text += fmt::format("  {:<26}{:<8}{:>12} {:<6} {}\n", parameter.key, parameter.symbol,
                        brief(value_in(units, parameter.of(of), parameter.unit)), shown_unit(unit),
                        parameter.meaning);
  }
  return text;
}

std::string points_words(const TableCurve& curve) {
  return fmt::format("{} points up to a strain of {}", curve.strain.size(), brief(curve.strain.back()));
}

std::string base_words(const FoamCurves& curves) {
  return std::visit(
      [&curves]<class Form>(const Form& form) {
        const std::string rate = brief(curves.slowest_rate);
        if constexpr (std::is_same_v<Form, TableCurve>)
          return fmt::format("  Curve   {}, {}, at {} 1/s\n", Form::name, points_words(form), rate);
        else
          return fmt::format("  Curve   {}, up to a strain of {}, at {} 1/s\n", Form::name,
                             brief(form.highest_strain), rate);
      },
      curves.base);
}

struct RateWords {
  std::string operator()(const NoRateEffect&) const { return "  Rate    one tested: no effect\n"; }
  std::string operator()(const PowerRateEffect& effect) const {
    return fmt::format("  Rate    power, up to {} 1/s\n", brief(effect.highest_rate));
  }
  std::string operator()(const FactorRateEffect& effect) const {
    std::string text = "  Rate    factor";
    for (std::size_t i = 0; i < effect.rate.size(); ++i)
      text +=
          fmt::format("{} {} at {} 1/s", i == 0 ? "" : ",", brief(effect.factor[i]), brief(effect.rate[i]));
    return wrapped(text, 10) + "\n";
  }
  std::string operator()(const CurvesRateEffect& effect) const {
    std::string text;
    for (const auto& [rate, curve] : effect.curves)
      text += fmt::format("  {:<8}curve at {} 1/s, {}\n", text.empty() ? "Rate" : "", brief(rate),
                          points_words(curve));
    return text + (effect.linear ? "          between two rates linear in the rate\n" : "");
  }
};

/// Form, rates and points of the curves.
template <SharesSlip Law>
std::string curves_words(const Law& law) {
  std::string text = base_words(law.curves) + std::visit(RateWords{}, law.curves.rate_effect);
  if constexpr (requires { law.unloading_curve; })
    if (law.unloading_curve)
      text +=
          fmt::format("  Back    curve, {}, in place of HU and SHAPE\n", points_words(*law.unloading_curve));
  return text;
}

/// Parameters of the base curve and of the rate effect, below those of the law.
std::string curve_parameters(const FoamCurves& curves, const UnitSystem& units) {
  const auto lines = [&units]<class Of>(const Of& of) -> std::string {
    if constexpr (requires { Of::parameters; })
      return parameter_lines(of, units);
    else
      return "";
  };
  std::string text;
  if (const std::string base = std::visit(lines, curves.base); !base.empty())
    text += "\n  The curve:\n" + base;
  if (const std::string effect = std::visit(lines, curves.rate_effect); !effect.empty())
    text += "\n  The rate:\n" + effect;
  return text;
}

/// What a first loading comes to at a few strains.
std::string stresses(const Material& material, const FoamCurves& curves, const UnitSystem& units) {
  constexpr std::array strains{0.1, 0.25, 0.5};
  constexpr int steps = 10;  // of 0.05: all of them are met
  const double last = last_strain_of(curves.base);
  Table table;
  table.columns.emplace_back("  Stress in a first loading");
  for (const double strain : strains)
    table.columns.push_back(fmt::format("at {}{}", brief(strain), strain > last ? " *" : ""));
  for (const double rate : laboratory::tested_rates(material)) {
    const laboratory::LoadingCurve loading = laboratory::loading_curve(material, rate, strains.back(), steps);
    std::vector<std::string> row{fmt::format("  at {} 1/s", brief(rate))};
    for (const double strain : strains) {
      const auto at = std::ranges::lower_bound(loading.strain, strain - 1e-6) - loading.strain.begin();
      row.push_back(brief_quantity(loading.stress.at(static_cast<std::size_t>(at)), "Pa", units, 3));
    }
    table.rows.push_back(std::move(row));
  }
  std::string text = "\n" + plain_text(table);
  if (strains.back() > last) text += "  * beyond the strains of the curve\n";
  return text;
}

}  // namespace

std::string materials_text(const std::vector<Material>& materials) {
  Table table;
  table.columns = {"Name", "Law", "kg/m3", "Strain", "Rates (1/s)", "Basis", "Reservations"};
  for (const Material& material : materials) table.rows.push_back(row_of(material));
  return plain_text(table);
}

std::string material_text(const Material& material, const UnitSystem& units) {
  std::string text = fmt::format("{}\n", one_line(material.title.empty() ? material.name : material.title));
  const auto line = [&text](const char* what, const std::string& value) {
    text += wrapped(fmt::format("  {:<8}{}", what, one_line(value)), 10) + "\n";
  };
  line("Name", material.name);
  line("Source", material.source.empty() ? "not stated" : material.source);
  if (!material.basis.empty()) line("Basis", material.basis);
  if (!material.licence.empty()) line("Licence", material.licence);
  if (material.density) line("Density", brief(*material.density) + " kg/m3");
  for (const std::string& reservation : material.reservations)
    line(&reservation == &material.reservations.front() ? "Caveats" : "", reservation);
  line("Law", name_of(material.law));
  text += std::visit(
      []<class Law>(const Law& law) -> std::string {
        if constexpr (SharesSlip<Law>)
          return curves_words(law);
        else
          return "";
      },
      material.law);
  if (const auto range = range_of(material))
    line("Fitted",
         fmt::format("up to a strain of {} and at strain rates from {} to {} 1/s",
                     brief(range->highest_strain), brief(range->lowest_rate), brief(range->highest_rate)));
  else
    line("Fitted", "range not stated: no result can be called extrapolated");
  if (material.nose_over_pad)
    line("Strikes",
         fmt::format("measured by strikes of a sphere with {} times the radius that the pad was thick: what "
                     "neighbouring columns do is in its numbers",
                     brief(*material.nose_over_pad)));
  text += "\n";
  text += std::visit(
      [&]<class Law>(const Law& law) {
        std::string lines = parameter_lines(law, units);
        if constexpr (SharesSlip<Law>)
          lines += curve_parameters(law.curves, units) + stresses(material, law.curves, units);
        return lines;
      },
      material.law);
  if (!material.also_published.empty()) text += "\n  Published too, but not used by the law:\n";
  for (const auto& [name, value] : material.also_published)
    text += fmt::format("  {:<26}{}\n", one_line(name), one_line(value));
  return text;
}

}  // namespace dashpad::output
