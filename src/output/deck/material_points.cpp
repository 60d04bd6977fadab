#include "output/deck/deck_text.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>

#include <fmt/format.h>

#include "model/pad/foam/foam_stress.hpp"
#include "model/pad/foam/monotone_curve.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr int points_of_formula = 100;
constexpr int digits_of_formula = 10;  // fits into every deck

/// Points of a formula, closer together at small strains, where foam is stiff.
template <class Form>
TableCurve points_along(const Form& form) {
  TableCurve curve;
  for (int i = 1; i <= points_of_formula; ++i) {
    const double part = static_cast<double>(i) / points_of_formula;
    const double strain = i == points_of_formula
                              ? form.highest_strain
                              : rounded_to(form.highest_strain * part * part, digits_of_formula);
    curve.strain.push_back(strain);
    curve.stress.push_back(rounded_to(form.stress(strain), digits_of_formula));
  }
  return curve;
}

TableCurve base_points(const BaseCurve& base, std::vector<std::string>& remarks) {
  return std::visit(
      [&]<class Form>(const Form& form) -> TableCurve {
        if constexpr (std::is_same_v<Form, TableCurve>) {
          return form;
        } else {
          remarks.push_back(
              fmt::format("The base curve is the formula \"{}\"; it is written as {} points up to its "
                          "highest strain, {:g}.",
                          Form::name, points_of_formula, form.highest_strain));
          return points_along(form);
        }
      },
      base);
}

/// The base curve with its stresses multiplied.
template <class Factor>
TableCurve scaled(TableCurve curve, Factor factor) {
  for (std::size_t i = 0; i < curve.strain.size(); ++i)
    curve.stress[i] = rounded_to(curve.stress[i] * factor(curve.strain[i]), digits_of_formula);
  return curve;
}

/// The rates for a power of the rate: a decade apart, and the highest.
std::vector<double> decades(double slowest, double highest) {
  std::vector<double> rates;
  for (double rate = 10 * slowest; rate < highest / 2 && rates.size() + 2 < max_rates; rate *= 10)
    rates.push_back(rounded_to(rate, digits_of_formula));
  rates.push_back(highest);
  return rates;
}

void add_rates(const FoamCurves& curves, MaterialPoints& points) {
  const TableCurve base = points.loading.front().curve;
  std::visit(
      [&]<class Effect>(const Effect& effect) {
        if constexpr (std::is_same_v<Effect, CurvesRateEffect>) {
          for (const CurvesRateEffect::AtRate& at : effect.curves)
            points.loading.push_back({at.rate, at.curve});
          points.linear_in_rate = effect.linear;
        } else if constexpr (!std::is_same_v<Effect, NoRateEffect>) {
          points.linear_in_rate = false;
          if constexpr (std::is_same_v<Effect, FactorRateEffect>) {
            for (std::size_t i = 0; i < effect.rate.size(); ++i)
              points.loading.push_back(
                  {effect.rate[i], scaled(base, [&](double) { return effect.factor[i]; })});
          } else {
            for (const double rate : decades(curves.slowest_rate, effect.highest_rate))
              points.loading.push_back({rate, scaled(base, [&](double e) {
                                          return std::pow(
                                              rate / curves.slowest_rate,
                                              std::max(effect.exponent + effect.exponent_slope * e, 0.0));
                                        })});
          }
          points.remarks.push_back(fmt::format(
              "The rate effect is the formula \"{}\"; it is written as {} at higher rates.", Effect::name,
              points.loading.size() == 2 ? "1 curve" : fmt::format("{} curves", points.loading.size() - 1)));
        }
      },
      curves.rate_effect);
}

}  // namespace

MaterialPoints material_points(const PadLaw& law, bool with_rates) {
  MaterialPoints points;
  if (const FoamCurves* const curves = foam_curves(law)) {
    points.loading.push_back({curves->slowest_rate, base_points(curves->base, points.remarks)});
    if (with_rates) add_rates(*curves, points);
  }
  if (const Foam* const foam = std::get_if<Foam>(&law)) points.unloading = foam->unloading_curve;
  return points;
}

namespace {

/// The stress of loading at a rate, Pa, also beyond the tested strain.
double loading_stress(const PadLaw& law, double strain, double rate) {
  return std::visit(
      [&]<class Law>(const Law& foam) -> double {
        if constexpr (SharesSlip<Law>)
          return FoamStress(foam).response(strain_of(strain), 0, rate).stress;
        else
          return no_value;
      },
      law);
}

/// Points at equal distances from the origin to `end`.
template <class Stress>
TableCurve evenly_placed(double end, int points, const Stress& stress) {
  constexpr int digits = 6;
  TableCurve curve;
  for (int i = 1; i < points; ++i) {
    const double strain = rounded_to(end * i / (points - 1), digits);
    curve.strain.push_back(strain);
    curve.stress.push_back(rounded_to(stress(strain), digits));
  }
  return curve;
}

}  // namespace

MaterialPoints placed_points(const PadLaw& law, bool with_rates, const MaterialDeckOptions& options) {
  MaterialPoints points = material_points(law, with_rates);
  const int count = options.points.value_or(max_deck_points);
  bool was_levelled = false;
  if (options.rate) points.loading.resize(1);
  for (PointsAtRate& at : points.loading) {
    if (options.rate) at.rate = *options.rate;
    at.curve = evenly_placed(options.up_to.value_or(at.curve.strain.back()), count,
                             [&](double strain) { return loading_stress(law, strain, at.rate); });
  }
  if (options.rate && !std::ranges::is_sorted(points.loading.front().curve.stress)) {
    std::vector<double>& stress = points.loading.front().curve.stress;
    std::partial_sum(stress.begin(), stress.end(), stress.begin(),
                     [](double before, double now) { return std::max(before, now); });
    was_levelled = true;
  }
  if (points.unloading && options.up_to) {
    points.unloading = unloading_points(std::get<Foam>(law), *options.up_to);
  } else if (points.unloading) {
    const MonotoneCurve tested(*points.unloading);
    points.unloading =
        evenly_placed(tested.last_strain(), count, [&](double strain) { return tested.stress(strain); });
  }
  points.remarks = {fmt::format("Each curve is given as {} evenly spaced points with six digits.", count)};
  if (was_levelled)
    points.remarks.emplace_back("The curve at that rate falls in places; there it is written level.");
  return points;
}

TableCurve unloading_points(const Foam& foam, double from) {
  const FoamStress of(foam);
  const double rate = foam.curves.slowest_rate;
  return evenly_placed(from, points_of_formula / 2, [&](double strain) {
    // The last point of the way back is the end of the curve.
    return strain < from ? of.response(strain_of(strain), from - strain, -rate).stress
                         : of.response(strain_of(from), 0, rate).stress;
  });
}

double steepest_line(const MaterialPoints& points) {
  double steepest = 0;
  for (const auto& [rate, curve] : points.loading)
    for (std::size_t i = 0; i < curve.strain.size(); ++i) {
      const double e = i == 0 ? 0 : curve.strain[i - 1];
      const double s = i == 0 ? 0 : curve.stress[i - 1];
      steepest = std::max(steepest, (curve.stress[i] - s) / (curve.strain[i] - e));
    }
  const double unit = std::pow(10, std::floor(std::log10(steepest)) - 2);
  return rounded_to(std::ceil(steepest / unit) * unit, 3);
}

std::string DeckNumbers::field(input::Content content, double value, std::size_t width) {
  if (content == input::Content::whole) return fmt::format("{:>{}}", static_cast<long>(value), width);
  const input::DeckUnit& unit = units_.of(content);
  const std::string text = input::deck_number(value, unit, width);
  if (input::read_deck_number(text, unit).value != value) ++rounded_;
  return fmt::format("{:>{}}", text, width);
}

std::string card_text(char mark, input::DeckCard card, const CardValues& values, DeckNumbers& numbers,
                      std::size_t width) {
  std::string names;
  for (const input::DeckField& field : card) {
    const std::size_t room = width > 0 ? width : field.width;
    names += names.empty() ? mark + fmt::format("{:>{}}", field.name, room - 1)
                           : fmt::format("{:>{}}", field.name, room);
  }
  return names + "\n" + card_line(card, values, numbers, width);
}

std::string card_line(input::DeckCard card, const CardValues& values, DeckNumbers& numbers,
                      std::size_t width) {
  std::string line;
  for (const input::DeckField& field : card) {
    const auto value = values.find(field.name);
    line += numbers.field(field.content, value == values.end() ? 0 : value->second,
                          width > 0 ? width : field.width);
  }
  return line + "\n";
}

double written_unloading_factor(const Foam& foam) {
  constexpr double nearly_nothing = 1e-6;
  return foam.unloading_factor > 0 ? foam.unloading_factor : nearly_nothing;
}

std::string deck_title(const Material& material, std::size_t width) {
  std::string title = plain_ascii(material.title.empty() ? material.name : material.title);
  title.erase(0, title.find_first_not_of(' '));
  if (title.empty() || std::string_view("*$/#").find(title[0]) != std::string_view::npos)
    title = "Dashpad: " + title;
  return title.substr(0, width);
}

}  // namespace dashpad::output
