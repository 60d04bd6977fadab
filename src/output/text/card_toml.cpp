#include "dashpad/output/card_toml.hpp"

#include <algorithm>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>

#include "model/parameter_values.hpp"
#include "output/text/case_toml.hpp"

namespace dashpad::output {

namespace {

std::string table_head(const std::string& prefix, std::string_view name) {
  return fmt::format("\n[{}{}]\n", prefix, name);
}

std::string points_toml(const TableCurve& curve) {
  return toml_line("stress_unit", "Pa") + toml_line("strain", curve.strain) +
         toml_line("stress", curve.stress);
}

template <class Owner>
std::string numbers_toml(const Owner& owner) {
  std::string text;
  for (const Parameter<Owner>& parameter : Owner::parameters)
    text += toml_line(parameter.key, parameter.of(owner), parameter.unit);
  return text;
}

/// `key = ["1 unit", ...]`
std::string quantities_toml(const std::string& key, const std::vector<double>& values,
                            const std::string& unit) {
  std::string text = key + " = [";
  for (std::size_t i = 0; i < values.size(); ++i) text += (i == 0 ? "" : ", ") + toml_value(values[i], unit);
  return text + "]\n";
}

std::string rate_toml(const RateEffect& effect, const std::string& prefix) {
  return std::visit(
      [&]<class Form>(const Form& form) -> std::string {
        if constexpr (std::is_same_v<Form, NoRateEffect>) {
          return "";
        } else {
          std::string text = table_head(prefix, "rate") + toml_line("form", Form::name);
          if constexpr (std::is_same_v<Form, PowerRateEffect>) {
            text += numbers_toml(form);
          } else if constexpr (std::is_same_v<Form, FactorRateEffect>) {
            text += quantities_toml("rates", form.rate, "1/s") + toml_line("factors", form.factor);
          } else {
            text += toml_line("interpolation", form.linear ? "linear" : "log-log");
            for (const CurvesRateEffect::AtRate& at : form.curves)
              text += fmt::format("\n[[{}rate.curves]]\n", prefix) + toml_line("rate", at.rate, "1/s") +
                      points_toml(at.curve);
          }
          return text;
        }
      },
      effect);
}

std::string curves_toml(const FoamCurves& curves, const std::string& prefix) {
  return table_head(prefix, "curve") +
         std::visit(
             [&]<class Form>(const Form& form) {
               const std::string head =
                   toml_line("form", Form::name) + toml_line("rate", curves.slowest_rate, "1/s");
               if constexpr (std::is_same_v<Form, TableCurve>)
                 return head + points_toml(form);
               else
                 return head + numbers_toml(form);
             },
             curves.base) +
         rate_toml(curves.rate_effect, prefix);
}

/// Parameters that mean nothing: a measured unloading takes the place of the formula.
bool is_overruled(const PadLaw& law, std::string_view key) {
  const auto* const foam = std::get_if<Foam>(&law);
  return foam != nullptr && foam->unloading_curve && key.starts_with("unloading_");
}

std::string fitted_toml(const FittedRange& fitted, const std::string& prefix) {
  return table_head(prefix, "fitted") + toml_line("highest_strain", fitted.highest_strain, "1") +
         toml_line("lowest_rate", fitted.lowest_rate, "1/s") +
         toml_line("highest_rate", fitted.highest_rate, "1/s");
}

/// `key = [[...], ...]`
std::string rows_toml(const std::string& key, const std::vector<std::vector<double>>& rows) {
  std::string text = key + " = [\n";
  for (const std::vector<double>& row : rows) {
    std::string line;
    for (const double value : row) line += (line.empty() ? "" : ", ") + toml_value(value, "1");
    text += "  [" + line + "],\n";
  }
  return text + "]\n";
}

std::string posterior_toml(const PosteriorAxes& axes, const std::string& prefix) {
  if (axes.keys.empty()) return "";
  std::string keys;
  for (const std::string& key : axes.keys) keys += (keys.empty() ? "" : ", ") + toml_string(key);
  return table_head(prefix, "uncertainty.posterior") + "keys = [" + keys + "]\n" +
         rows_toml("minus", axes.minus) + rows_toml("plus", axes.plus);
}

std::string misfit_toml(const Misfit& misfit, const std::string& prefix) {
  return table_head(prefix, "uncertainty.misfit") +
         toml_line("peak_acceleration", misfit.peak_acceleration, "1") + toml_line("hic", misfit.hic, "1") +
         toml_line("rebound_speed", misfit.rebound_speed, "1") +
         toml_line("penetration", misfit.penetration, "1") + toml_line("impacts", misfit.impacts, "1") +
         fmt::format("held_out = {}\n", misfit.is_held_out) +
         (misfit.nose_over_pad ? toml_line("nose_over_pad", *misfit.nose_over_pad, "1") : "");
}

std::string uncertainty_toml(const Uncertainty& uncertainty, const std::string& prefix) {
  if (uncertainty == Uncertainty{}) return "";
  std::string text = table_head(prefix, "uncertainty");
  const auto range = [&](const char* key, const std::optional<ValueRange>& value) {
    if (value) text += toml_line(key, std::vector{value->low, value->high});
  };
  range("recoil", uncertainty.recoil);
  range("unloading_factor", uncertainty.unloading_factor);
  range("lag_strain", uncertainty.lag_strain);
  range("rate_exponent", uncertainty.rate_exponent);
  if (uncertainty.scatter) text += toml_line("scatter", *uncertainty.scatter, "1");
  if (uncertainty.misfit) text += misfit_toml(*uncertainty.misfit, prefix);
  return text + posterior_toml(uncertainty.posterior, prefix);
}

bool is_bare_key(std::string_view key) {
  return !key.empty() && key.find_first_not_of(
                             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                             "0123456789_-") == std::string_view::npos;
}

std::string optional_line(const std::string& key, const std::string& text) {
  return text.empty() ? "" : toml_line(key, text);
}

}  // namespace

std::string law_toml(const Material& material, const std::string& prefix) {
  std::string text = fmt::format("law = \"{}\"\n", name_of(material.law)) + table_head(prefix, "parameters");
  for (const ParameterValue& parameter : parameter_values(material.law))
    if (!is_overruled(material.law, parameter.key))
      text += toml_line(parameter.key, parameter.value, parameter.unit);
  if (const auto* const foam = std::get_if<Foam>(&material.law)) {
    text += curves_toml(foam->curves, prefix);
    if (foam->unloading_curve) text += table_head(prefix, "unloading") + points_toml(*foam->unloading_curve);
  } else if (const auto* const crushable = std::get_if<CrushableFoam>(&material.law)) {
    text += curves_toml(crushable->curves, prefix);
  }
  if (material.fitted) text += fitted_toml(*material.fitted, prefix);
  return text + uncertainty_toml(material.uncertainty, prefix);
}

std::string card_toml(const Material& material) {
  const auto or_else = [](const std::string& text, const std::string& other) {
    return std::ranges::all_of(text, [](char c) { return c == ' '; }) ? other : text;
  };
  // A card without a title or a source is none.
  std::string text = toml_line("title", or_else(material.title, or_else(material.name, "untitled"))) +
                     toml_line("source", or_else(material.source, "not stated")) +
                     optional_line("basis", material.basis) + optional_line("licence", material.licence);
  if (material.density) text += toml_line("density", *material.density, "kg/m3");
  if (material.density_exponent) text += toml_line("density_exponent", *material.density_exponent, "1");
  if (!material.reservations.empty()) {
    text += "reservations = [\n";
    for (const std::string& reservation : material.reservations)
      text += "  " + toml_string(reservation) + ",\n";
    text += "]\n";
  }
  text += law_toml(material);
  if (const auto& [temperature, factor] = material.temperature_table; !temperature.empty())
    text += table_head("", "temperature") + quantities_toml("temperatures", temperature, "K") +
            toml_line("factors", factor);
  if (material.nose_over_pad)
    text += table_head("", "measured_by") + toml_line("nose", "sphere") +
            toml_line("nose_over_pad", *material.nose_over_pad, "1");
  if (!material.also_published.empty()) {
    text += table_head("", "also_published");
    for (const auto& [key, value] : material.also_published)
      text += toml_line(is_bare_key(key) ? key : toml_string(key), value);
  }
  return text;
}

}  // namespace dashpad::output
