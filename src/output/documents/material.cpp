// Documents of material cards: of one card its parameters and stresses, of several a row each.

#include "dashpad/output/materials.hpp"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "dashpad/laboratory/material_test.hpp"
#include "model/pad/foam/foam_curve.hpp"
#include "output/layout.hpp"
#include "output/svg/svg.hpp"
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

std::string tested_range(double low, double high) { return fmt::format("{} to {}", brief(low), brief(high)); }

std::vector<std::string> row_of(const Material& material) {
  const auto range = range_of(material);
  return {material.name,
          name_of(material.law),
          material.density ? brief(*material.density) : not_stated,
          range ? brief(range->highest_strain) : not_stated,
          range ? tested_range(range->lowest_rate, range->highest_rate) : not_stated,
          or_not_stated(material.basis),
          in_short(material.reservations)};
}

using Rows = std::vector<std::vector<std::string>>;

/// Key, symbol, value, unit, meaning.
template <class Of>
void add_parameters(const Of& owner, const UnitSystem& units, Rows& rows) {
  if constexpr (requires { Of::parameters; })
    for (const Parameter<Of>& parameter : Of::parameters)
      rows.push_back({parameter.key, parameter.symbol,
                      brief(value_in(units, parameter.of(owner), parameter.unit)),
                      shown_unit(unit_for(units, parameter.unit)), parameter.meaning});
}

std::string points_words(const TableCurve& curve) {
  return fmt::format("{} points up to a strain of {}", curve.strain.size(), brief(curve.strain.back()));
}

std::string base_words(const FoamCurves& curves) {
  return std::visit(
      [&curves]<class Form>(const Form& form) {
        const std::string rate = brief(curves.slowest_rate);
        if constexpr (std::is_same_v<Form, TableCurve>)
          return fmt::format("{}, {}, at {} 1/s", Form::name, points_words(form), rate);
        else
          return fmt::format("{}, up to a strain of {}, at {} 1/s", Form::name, brief(form.highest_strain),
                             rate);
      },
      curves.base);
}

struct RateWords {
  std::string operator()(const NoRateEffect&) const { return "no rate effect: tested at one rate only"; }
  std::string operator()(const PowerRateEffect& effect) const {
    return fmt::format("power law, up to {} 1/s", brief(effect.highest_rate));
  }
  std::string operator()(const FactorRateEffect& effect) const {
    std::string text = "factor";
    for (std::size_t i = 0; i < effect.rate.size(); ++i)
      text +=
          fmt::format("{} {} at {} 1/s", i == 0 ? "" : ",", brief(effect.factor[i]), brief(effect.rate[i]));
    return text;
  }
  std::string operator()(const CurvesRateEffect& effect) const {
    std::string text;
    for (const auto& [rate, curve] : effect.curves)
      text +=
          fmt::format("{}curve at {} 1/s, {}", text.empty() ? "" : "; ", brief(rate), points_words(curve));
    return text + (effect.linear ? "; interpolated linearly in the rate" : "");
  }
};

/// Law, form and points of the curves, and what the foam does at higher rates.
Rows law_rows(const Material& material) {
  Rows rows{{"Law", name_of(material.law)}};
  if (const FoamCurves* const curves = foam_curves(material.law)) {
    rows.push_back({"Curve", base_words(*curves)});
    rows.push_back({"Rate", std::visit(RateWords{}, curves->rate_effect)});
  }
  if (const auto* const foam = std::get_if<Foam>(&material.law); foam && foam->unloading_curve)
    rows.push_back({"Unloading",
                    fmt::format("curve, {}, instead of HU and SHAPE", points_words(*foam->unloading_curve))});
  return rows;
}

std::string fitted_words(const Material& material) {
  const auto range = range_of(material);
  return range ? fmt::format("up to a strain of {} and at strain rates from {} to {} 1/s",
                             brief(range->highest_strain), brief(range->lowest_rate),
                             brief(range->highest_rate))
               : "range not stated, so extrapolation cannot be detected";
}

Table card_table(const Material& material) {
  Table table{.columns = {"", ""}};
  const auto add = [&table](const char* what, const std::string& value) {
    if (!value.empty()) table.rows.push_back({what, one_line(value)});
  };
  add("Name", material.name);
  add("Source", material.source.empty() ? "not stated" : material.source);
  add("Basis", material.basis);
  add("Licence", material.licence);
  if (material.density) add("Density", brief(*material.density) + " kg/m3");
  for (std::vector<std::string>& row : law_rows(material)) table.rows.push_back(std::move(row));
  add("Fitted", fitted_words(material));
  if (material.nose_over_pad)
    add("Impacts", fmt::format("measured with a sphere whose radius is {} times the pad thickness, so the "
                               "parameters include the effect of neighbouring columns",
                               brief(*material.nose_over_pad)));
  return table;
}

/// The stress of a first loading at a few strains, for each tested rate.
Section stresses(const Material& material, const FoamCurves& curves, const UnitSystem& units) {
  constexpr std::array strains{0.1, 0.25, 0.5};
  constexpr int steps = 10;  // steps of 0.05, which include all of these strains
  const double last = last_strain_of(curves.base);
  Table table{.columns = {"Stress in first loading"}};
  for (const double strain : strains)
    table.columns.push_back(fmt::format("at strain {}{}", brief(strain), strain > last ? " *" : ""));
  for (const double rate : laboratory::tested_rates(material)) {
    const laboratory::LoadingCurve loading = laboratory::loading_curve(material, rate, strains.back(), steps);
    std::vector<std::string> row{fmt::format("at {} 1/s", brief(rate))};
    for (const double strain : strains) {
      const auto at = std::ranges::lower_bound(loading.strain, strain - 1e-6) - loading.strain.begin();
      row.push_back(brief_quantity(loading.stress.at(static_cast<std::size_t>(at)), "Pa", units, 3));
    }
    table.rows.push_back(std::move(row));
  }
  Section section{.seen = Seen::always, .tables = {std::move(table)}};
  if (strains.back() > last) section.paragraphs = {"* beyond the last strain of the curve"};
  return section;
}

/// The parameters of the law, of its base curve and of its rate effect, and the resulting stresses.
std::vector<Section> law_sections(const Material& material, const UnitSystem& units) {
  std::vector<Section> sections{{.heading = "Parameters", .seen = Seen::always}};
  const auto add = [&](const char* caption, const auto& variant) {
    Table table{.caption = caption, .columns = {"Key", "Symbol", "Value", "Unit", "Meaning"}};
    std::visit([&](const auto& owner) { add_parameters(owner, units, table.rows); }, variant);
    if (!table.rows.empty()) sections.front().tables.push_back(std::move(table));
  };
  add("", material.law);
  if (const FoamCurves* const curves = foam_curves(material.law)) {
    add("The curve:", curves->base);
    add("The rate effect:", curves->rate_effect);
    sections.push_back(stresses(material, *curves, units));
  }
  return sections;
}

Table table_of(const std::vector<Material>& materials) {
  Table table{.columns = {"Name", "Law", "kg/m3", "Strain", "Rates (1/s)", "Basis", "Reservations"}};
  for (const Material& material : materials) table.rows.push_back(row_of(material));
  return table;
}

}  // namespace

Document material_document(const Material& material, const UnitSystem& units, Pictures pictures) {
  const std::string title = one_line(material.title.empty() ? material.name : material.title);
  Document document{.title = title, .lead = Lead{.answer = title}};
  for (const std::string& reservation : material.reservations)
    document.warnings.push_back(one_line(reservation));
  if (pictures == Pictures::drawn) document.lead->curve = material_plot(material, units);
  document.sections = {{.heading = "The card", .seen = Seen::always, .tables = {card_table(material)}}};
  for (Section& section : law_sections(material, units)) document.sections.push_back(std::move(section));
  if (material.also_published.empty()) return document;
  Table published{.columns = {"", ""}};
  for (const auto& [name, value] : material.also_published)
    published.rows.push_back({one_line(name), one_line(value)});
  document.sections.push_back(
      {.heading = "Also published, but not used by the law", .seen = Seen::always, .tables = {published}});
  return document;
}

Document materials_document(const std::vector<Material>& materials, const UnitSystem& units,
                            Pictures pictures) {
  Document document{.title = "Materials", .lead = Lead{.answer = plural(materials.size(), "material card")}};
  if (pictures == Pictures::drawn && !materials.empty())
    document.lead->curve = untitled(materials_plot(materials, units));
  document.sections = {{.heading = "The cards", .seen = Seen::always, .tables = {table_of(materials)}}};
  return document;
}

}  // namespace dashpad::output
