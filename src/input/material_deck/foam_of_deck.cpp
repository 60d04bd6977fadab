// Conversion of the foam of a deck to a material.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "input/material_deck/deck_foam.hpp"
#include "model/pad/foam/foam_curve.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

constexpr double slowest_rate_assumed = 0.01;  // 1/s, of an ordinary quasi-static test

/// The lines of the numbers of a law, for faults.
struct CurveLines {
  std::size_t material = 0;
  std::vector<std::vector<std::size_t>> loading;  ///< of the points of each curve
  std::vector<std::size_t> of_rates;
  std::size_t unloading = 0;
};

/// The steepest slope of a base curve, computed as for the rule of the unloading modulus.
double steepest_slope(const CrushableFoam& foam) {
  constexpr int places = 400;
  const FoamCurve base(foam.curves.base, foam.continuation_exponent);
  const double step = base.last_strain() / places;
  double steepest = 0, before = 0;
  for (int i = 1; i <= places; ++i) {
    const double stress = base.at(strain_of(step * i)).stress;
    steepest = std::max(steepest, (stress - before) / step);
    before = stress;
  }
  return steepest;
}

/// The index from 0 in "rate.curves[2].stress[7]" after `name`; absent if there is none.
std::optional<std::size_t> index_in(const std::string& key, const std::string& name) {
  const auto at = key.find(name + "[");
  if (at == std::string::npos) return std::nullopt;
  const auto index = read_number(key.substr(at + name.size() + 1, key.find(']', at) - at - name.size() - 1));
  return index.kind == NumberKind::number && index.value >= 1
             ? std::optional(static_cast<std::size_t>(index.value) - 1)
             : std::nullopt;
}

std::size_t line_of(const std::string& key, const CurveLines& lines) {
  if (key.starts_with("unloading.") && lines.unloading > 0) return lines.unloading;
  const auto curve = key.starts_with("rate.") ? index_in(key, "curves") : std::nullopt;
  const std::size_t place = curve ? *curve + 1 : 0;
  if (!key.starts_with("curve.") && !curve) return lines.material;
  if (place >= lines.loading.size()) return lines.material;
  if (key.ends_with(".rate")) return lines.of_rates[place];
  const std::string after = key.substr(key.find('.', key.find("curve")) + 1);
  for (const char* const name : {"strain", "stress"})
    if (const auto point = index_in(after, name); point && *point < lines.loading[place].size())
      return lines.loading[place][*point];
  return lines.loading[place].empty() ? lines.material : lines.loading[place].front();
}

/// "curve 22: stress" for "rate.curves[1].stress"; other keys as they are.
std::string in_words_of_deck(const std::string& key, const DeckFoam& foam) {
  const auto curve = key.starts_with("rate.") ? index_in(key, "curves") : std::nullopt;
  if (!curve || *curve + 1 >= foam.loading.size()) return key;
  const auto end = key.find("].");
  return foam.loading[*curve + 1].curve.name + (end == std::string::npos ? "" : ": " + key.substr(end + 2));
}

/// Checks the rates and assumes the first one if it is missing.
bool settle_rates(DeckFoam& foam, MeasurementFaults& faults) {
  bool sound = true;
  for (std::size_t i = 0; i < foam.loading.size(); ++i) {
    const auto& [rate, line, curve, temperature] = foam.loading[i];
    if (rate != rate) sound = false;
    if (rate < 0) {
      faults.add(line, foam.card + ": rate", fmt::format("{:.6g}", rate),
                 "must not be negative; logarithms of rates, and rates in tension, are not read");
      sound = false;
    } else if (i > 0 && rate <= foam.loading[i - 1].rate) {
      faults.add(line, foam.card + ": rate", fmt::format("{:.6g}", rate),
                 fmt::format("must be more than the previous rate, {:.6g} 1/s", foam.loading[i - 1].rate));
      sound = false;
    }
  }
  if (!sound || foam.loading.front().rate > 0) return sound;
  double rate = slowest_rate_assumed;
  if (foam.loading.size() > 1 && rate >= foam.loading[1].rate) rate = foam.loading[1].rate / 10;
  foam.loading.front().rate = rate;
  foam.assumptions.push_back(fmt::format("The lowest rate is not stated; {:g} 1/s was used.", rate));
  return true;
}

std::optional<CleanCurve> prepared(const DeckFoam& foam, std::size_t place, MeasurementFaults& faults,
                                   std::vector<std::string>& differences) {
  const DeckCurve& curve = foam.loading[place].curve;
  auto clean = clean_curve(curve, place == 0 ? CurveRole::base : CurveRole::rate, faults, differences);
  if (!clean) return std::nullopt;
  if (!foam.crushable && clean->stress_at_zero && *clean->stress_at_zero > 0)
    differences.push_back(fmt::format(
        "{}: the stress of {:.6g} Pa at a strain of 0 was left out; the curve starts at the origin.",
        curve.name, *clean->stress_at_zero));
  if (foam.crushable && (!limit_to_elastic_line(*clean, foam.modulus, curve, faults, differences) ||
                         !add_air(*clean, foam.air, curve, faults)))
    return std::nullopt;
  if (clean->table.strain.size() < TableCurve::fewest_points) {
    faults.add(curve.line, curve.name, "",
               fmt::format("has {} at strains between 0 and 1; at least {} are needed",
                           plural(clean->table.strain.size(), "point"), TableCurve::fewest_points));
    return std::nullopt;
  }
  return clean;
}

std::optional<FoamCurves> curves_of(const DeckFoam& foam, CurveLines& lines, MeasurementFaults& faults,
                                    std::vector<std::string>& differences) {
  FoamCurves curves;
  curves.slowest_rate = foam.loading.front().rate;
  CurvesRateEffect effect;
  effect.linear = foam.linear_in_rate;
  bool sound = true;
  std::vector<const DeckCurve*> at_fault;
  for (std::size_t i = 0; i < foam.loading.size(); ++i) {
    if (i == 0 && foam.hyperfoam) {
      curves.base = *foam.hyperfoam;
      lines.loading.push_back({foam.loading[i].curve.line});
      lines.of_rates.push_back(foam.loading[i].line);
      continue;
    }
    const DeckCurve& curve = foam.loading[i].curve;
    // One that serves two rates has its fault once.
    const bool is_told = std::ranges::any_of(at_fault, [&](const DeckCurve* other) {
      return other->name == curve.name && other->line == curve.line;
    });
    auto clean = is_told ? std::nullopt : prepared(foam, i, faults, differences);
    if (!clean) {
      sound = false;
      at_fault.push_back(&curve);
      continue;
    }
    lines.loading.push_back(clean->lines);
    lines.of_rates.push_back(foam.loading[i].line);
    if (i == 0)
      curves.base = std::move(clean->table);
    else
      effect.curves.push_back({foam.loading[i].rate, std::move(clean->table)});
  }
  if (!sound) return std::nullopt;
  if (!effect.curves.empty()) curves.rate_effect = std::move(effect);
  return curves;
}

std::optional<TableCurve> way_back(const DeckCurve& curve, double last_strain, MeasurementFaults& faults,
                                   std::vector<std::string>& differences) {
  auto clean = clean_curve(curve, CurveRole::unloading, faults, differences);
  if (!clean) return std::nullopt;
  auto& [strain, stress] = clean->table;
  std::size_t beyond = 0;
  for (; !strain.empty() && strain.back() > last_strain; ++beyond) {
    strain.pop_back();
    stress.pop_back();
  }
  if (beyond > 0)
    differences.push_back(fmt::format("{}: {} beyond the last strain of the loading curve {} left out.",
                                      curve.name, plural(beyond, "point"), beyond == 1 ? "was" : "were"));
  return clean->table;
}

std::optional<PadLaw> foam_law(const DeckFoam& foam, FoamCurves curves, CurveLines& lines,
                               MeasurementFaults& faults, std::vector<std::string>& differences) {
  Foam law;
  law.unloading_factor = foam.unloading_factor;
  law.unloading_shape = foam.unloading_shape;
  law.curves = std::move(curves);
  if (foam.unloading) {
    lines.unloading = foam.unloading->line;
    law.unloading_curve = way_back(*foam.unloading, last_strain_of(law.curves.base), faults, differences);
    if (!law.unloading_curve) return std::nullopt;
  }
  return law;
}

PadLaw crushable_law(const DeckFoam& foam, FoamCurves curves, std::vector<std::string>& assumptions) {
  CrushableFoam law;
  law.unloading_modulus = foam.modulus;
  law.curves = std::move(curves);
  const auto is_too_gentle = [](const Violation& broken) { return broken.key == "unloading_modulus"; };
  if (positive.contain(law.unloading_modulus) &&
      std::ranges::any_of(violations(PadLaw(law)), is_too_gentle)) {
    law.unloading_modulus = steepest_slope(law);
    assumptions.push_back(fmt::format(
        "The modulus in the deck, {:.6g} Pa, is less than the steepest slope of the curve; the foam "
        "unloads with that slope, {:.6g} Pa, instead.",
        foam.modulus, law.unloading_modulus));
  }
  return law;
}

/// The law of a foam with curves; absent after a fault.
std::optional<PadLaw> law_by_curves(DeckFoam& foam, CurveLines& lines, MeasurementFaults& faults) {
  if (std::isnan(foam.modulus)) return std::nullopt;  // reported when it was read
  if (foam.crushable && !(foam.modulus > 0)) {
    faults.add(foam.line, foam.card + ": E", fmt::format("{:.6g}", foam.modulus),
               "must be more than 0; the foam unloads with this modulus");
    return std::nullopt;
  }
  if (foam.loading.empty() || !settle_rates(foam, faults)) return std::nullopt;
  auto curves = curves_of(foam, lines, faults, foam.differences);
  if (!curves) return std::nullopt;
  if (foam.crushable) return crushable_law(foam, *std::move(curves), foam.assumptions);
  return foam_law(foam, *std::move(curves), lines, faults, foam.differences);
}

/// A function that serves two rates has each of its differences twice.
std::vector<std::string> without_repeats(const std::vector<std::string>& sentences) {
  std::vector<std::string> once;
  for (const std::string& sentence : sentences)
    if (std::ranges::find(once, sentence) == once.end()) once.push_back(sentence);
  return once;
}

/// Adds the differences that hold for every deck.
void tell_common_differences(const DeckFoam& foam, std::vector<std::string>& differences) {
  if (foam.viscoelastic) return;
  if (!foam.hyperfoam)
    differences.emplace_back("Here curves are interpolated by monotone cubics, not linearly.");
  differences.emplace_back("Beyond its last strain, each curve is extrapolated to full compression.");
  if (foam.loading.size() > 1) {
    differences.emplace_back(
        "Above the highest rate, Dashpad uses the curve for that rate; solvers extrapolate.");
    if (!foam.crushable)
      differences.emplace_back(
          "When the strain rate reverses, Dashpad's stress changes over a small strain (lag_strain), and its "
          "rate-dependent part resists recovery (recoil); in solvers, the stress jumps to the unloading "
          "curve.");
  }
}

}  // namespace

std::optional<DeckMaterial> material_of(const DeckFoam& given, MeasurementFaults& faults) {
  DeckFoam foam = given;
  CurveLines lines{.material = foam.line, .loading = {}, .of_rates = {}};
  std::optional<PadLaw> law =
      foam.viscoelastic ? std::optional<PadLaw>(*foam.viscoelastic) : law_by_curves(foam, lines, faults);
  if (!law) return std::nullopt;

  DeckMaterial result;
  result.card = foam.card;
  result.id = foam.id;
  result.line = static_cast<int>(foam.line);
  Material& material = result.material;
  material.law = *std::move(law);
  constexpr std::size_t longest_title = 200;  // bytes
  material.name = name_for_card(quoted_part(foam.title, longest_title), foam.id);
  material.title =
      foam.title.empty() ? fmt::format("{} {}", foam.card, foam.id) : quoted_part(foam.title, longest_title);
  material.source = foam.source;
  material.basis = foam.basis;
  material.temperature_table = foam.temperature_table;
  if (foam.density > 0) material.density = foam.density;
  const std::vector<Violation> broken = violations(material);
  for (const Violation& violation : broken)
    if (!std::isnan(violation.value))  // reported when it was read
      faults.add(line_of(violation.key, lines), foam.card + ": " + in_words_of_deck(violation.key, foam),
                 fmt::format("{:.6g}", violation.value), violation.rule);
  if (!broken.empty()) return std::nullopt;

  tell_common_differences(foam, foam.differences);
  result.units = foam.units;
  result.assumptions = without_repeats(foam.assumptions);
  result.differences = without_repeats(foam.differences);
  material.reservations = result.assumptions;
  material.reservations.insert(material.reservations.end(), result.differences.begin(),
                               result.differences.end());
  return result;
}

std::string name_for_card(const std::string& title, long id) {
  constexpr std::size_t longest = 40;
  std::string name;
  for (const char c : lower_case(title)) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (is_plain)
      name += c;
    else if (!name.empty() && !name.ends_with('-'))
      name += '-';
  }
  name.resize(std::min(name.size(), longest));
  while (name.ends_with('-')) name.pop_back();
  return name.empty() ? fmt::format("material-{}", id) : name;
}

}  // namespace dashpad::input
