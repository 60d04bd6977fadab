#include "dashpad/output/material_deck.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/output/deck/exports.hpp"
#include "dashpad/version.hpp"
#include "model/pad/foam/foam_curve.hpp"
#include "output/deck/deck_text.hpp"

namespace dashpad::output {

namespace {

constexpr std::array<MaterialDeckFormat, 10> formats_of_materials{{
    {"ls-dyna-057", "*MAT_LOW_DENSITY_FOAM", Foam::name, false},
    {"ls-dyna-083", "*MAT_FU_CHANG_FOAM", Foam::name, true},
    {"ls-dyna-063", "*MAT_CRUSHABLE_FOAM", CrushableFoam::name, false},
    {"ls-dyna-163", "*MAT_MODIFIED_CRUSHABLE_FOAM", CrushableFoam::name, true},
    {"radioss-70", "/MAT/LAW70", Foam::name, true},
    {"radioss-90", "/MAT/LAW90", Foam::name, true},
    {"radioss-33", "/MAT/LAW33", CrushableFoam::name, false},
    {"radioss-62", "/MAT/LAW62", ViscoelasticFoam::name, true},
    {"abaqus-low-density-foam", "*LOW DENSITY FOAM", Foam::name, true},
    {"abaqus-hyperfoam", "*HYPERFOAM", Foam::name, false},
}};

const MaterialDeckFormat* format_named(const std::string& name) {
  const auto* const found =
      std::ranges::find_if(formats_of_materials, [&](const auto& each) { return name == each.name; });
  return found == formats_of_materials.end() ? nullptr : found;
}

bool is_abaqus_format(const std::string& format) { return format.starts_with("abaqus-"); }
bool holds_unloading_curve(const std::string& format) {
  return format == "radioss-70" || format == "abaqus-low-density-foam";
}

void tell_of_foam(const Foam& foam, const MaterialDeckOptions& options, std::vector<std::string>& remarks) {
  if (foam.friction > 0) remarks.push_back(fmt::format("friction = {:g} is left out.", foam.friction));
  if (options.format == "abaqus-hyperfoam")
    remarks.emplace_back("The deck unloads along its curve, without energy loss.");
  else if (is_abaqus_format(options.format) && !foam.unloading_curve)
    remarks.emplace_back(
        "Unloading is written as a curve from the end of the curve for the lowest rate, computed from "
        "unloading_factor and unloading_shape; the solver scales it for unloading from smaller strains.");
  else if (foam.unloading_curve && !holds_unloading_curve(options.format))
    remarks.emplace_back(
        "The measured unloading curve is left out; in the deck the foam unloads along the curve for "
        "the lowest rate, without energy loss at that rate. Set HU and SHAPE (Hys and Shape in Radioss).");
  else if (!foam.unloading_curve && foam.unloading_factor == 0)
    remarks.push_back(
        fmt::format("unloading_factor = 0 is written as {:g}, since the solver treats 0 as blank.",
                    written_unloading_factor(foam)));
}

/// Remarks on the rates, besides those on the curves.
void tell_of_rates(const FoamCurves& curves, const MaterialDeckFormat& format, const MaterialPoints& points,
                   std::vector<std::string>& remarks) {
  const bool has_effect = !std::holds_alternative<NoRateEffect>(curves.rate_effect);
  if (!format.has_rates)
    remarks.push_back(fmt::format("The curve is for {:g} 1/s, a rate that the deck cannot state{}.",
                                  points.loading.front().rate,
                                  has_effect ? "; the rate effect is left out" : ""));
  if (!format.has_rates || !has_effect) return;
  if (!points.linear_in_rate && std::string(format.name) != "ls-dyna-083")
    remarks.emplace_back(
        "Between two rates, the card's stress is a power of the rate; the solver's is linear in the rate.");
  if (points.linear_in_rate || std::string(format.name) != "ls-dyna-083")
    remarks.emplace_back(
        "Above the highest rate, the solver extrapolates; the card keeps the curve for that rate.");
  if (format.law == Foam::name)
    remarks.emplace_back("recoil and lag_strain are left out: the solver's stress jumps when loading ends.");
}

MaterialPoints points_for(const Material& material, const MaterialDeckFormat& format,
                          const MaterialDeckOptions& options) {
  MaterialPoints points = options.places_points() ? placed_points(material.law, format.has_rates, options)
                                                  : material_points(material.law, format.has_rates);
  if (!holds_unloading_curve(format.name)) points.unloading.reset();
  if (const auto* const foam = std::get_if<Foam>(&material.law);
      foam != nullptr && !points.unloading && std::string(format.name) == "abaqus-low-density-foam")
    points.unloading = unloading_points(*foam, points.loading.front().curve.strain.back());
  return points;
}

/// The law as the deck holds it. If a measured way back is left out, HU and SHAPE have no meaning either.
Material as_in_deck(Material material, const std::string& format) {
  if (auto* const foam = std::get_if<Foam>(&material.law); foam != nullptr && foam->unloading_curve)
    if (!holds_unloading_curve(format)) foam->unloading_factor = foam->unloading_shape = 1;
  return material;
}

/// The reason why curves cannot be placed as the options ask; empty if they can.
std::string why_not_placed(const Material& material, const MaterialDeckFormat& format,
                           const MaterialDeckOptions& options) {
  const FoamCurves* const curves = foam_curves(material.law);
  if (options.places_points() && curves == nullptr)
    return fmt::format("{} has no curves to place points on", material.name);
  if (options.up_to && !(*options.up_to > 0 && *options.up_to <= highest_up_to))
    return fmt::format("--up-to must be a strain of more than 0 and at most {}", highest_up_to);
  if (options.rate && format.has_rates)
    return fmt::format("--rate is for formats with one curve; {} has one for each rate", format.card);
  if (options.rate && !(*options.rate >= curves->slowest_rate))
    return fmt::format("--rate must be at least the lowest rate of the card, {:g} 1/s", curves->slowest_rate);
  if (options.points && (*options.points < min_deck_points || *options.points > max_deck_points))
    return fmt::format("--points must be from {} to {}", min_deck_points, max_deck_points);
  return "";
}

}  // namespace

MaterialPoints deck_points(const Material& material, const MaterialDeckOptions& options) {
  return points_for(material, *format_named(options.format), options);
}

std::span<const MaterialDeckFormat> material_deck_formats() { return formats_of_materials; }

std::string why_no_material_deck(const Material& material, const MaterialDeckOptions& options) {
  const MaterialDeckFormat* const format = format_named(options.format);
  if (format == nullptr) return fmt::format("unknown format \"{}\"", options.format);
  const std::string law = name_of(material.law);
  if (law != format->law)
    return fmt::format("{} is a card for the law {}, but {} has the law {}", format->card, format->law,
                       material.name, law);
  if (!material.density)
    return fmt::format("{} has no density, which {} needs; add density = \"... kg/m3\" to the card",
                       material.name, format->card);
  if (const std::string why = why_not_placed(material, *format, options); !why.empty()) return why;
  if (options.first_id < 1 || options.first_id > highest_curve_id - 2 * static_cast<int>(max_rates))
    return fmt::format("the first number, {}, must be from 1 to {}", options.first_id,
                       highest_curve_id - 2 * static_cast<int>(max_rates));
  return "";
}

std::vector<std::string> not_in_material_deck(const Material& material, const MaterialDeckOptions& options) {
  const MaterialDeckFormat* const format = format_named(options.format);
  if (format == nullptr) return {};
  if (std::holds_alternative<ViscoelasticFoam>(material.law))
    return {
        "In the solver the second Piola-Kirchhoff stress relaxes; in the card, the nominal stress does. They "
        "agree for a sudden strain and after a long time, but not for a strain that changes gradually."};
  const MaterialPoints points = points_for(material, *format, options);
  std::vector<std::string> remarks = points.remarks;
  std::visit(
      [&]<class Law>(const Law& law) {
        if constexpr (SharesSlip<Law>) tell_of_rates(law.curves, *format, points, remarks);
        if constexpr (std::is_same_v<Law, Foam>) tell_of_foam(law, options, remarks);
      },
      material.law);
  remarks.emplace_back(
      "Between points, curves are monotone cubics in the card and straight lines in the solver; beyond "
      "the last point, they are extrapolated differently (continuation_exponent).");
  const FoamCurves& curves = *foam_curves(material.law);
  const double tested = last_strain_of(curves.base);
  if (options.up_to && *options.up_to > tested)
    remarks.push_back(fmt::format(
        "Up to a strain of {:g}, the curves are those of the card; it was tested up to {:g}, and beyond that "
        "they follow its extrapolation, which is a guess.",
        *options.up_to, tested));
  if (options.up_to && *options.up_to < tested)
    remarks.push_back(fmt::format("The curves end at a strain of {:g}; the card was tested up to {:g}.",
                                  *options.up_to, tested));
  if (const auto range = range_of(material); options.rate && range && *options.rate > range->highest_rate)
    remarks.push_back(fmt::format("The rate of {:g} 1/s is beyond the tests of the card, up to {:g} 1/s.",
                                  *options.rate, range->highest_rate));
  if (format->law == Foam::name && !is_abaqus_format(options.format))
    remarks.emplace_back(
        "The modulus is the steepest slope of the curves; the solver uses it for tension, contact "
        "and the time step.");
  return remarks;
}

std::string material_deck(const Material& given, const MaterialDeckOptions& options) {
  if (const std::string why = why_no_material_deck(given, options); !why.empty())
    throw std::invalid_argument(why);
  const Material material = as_in_deck(given, options.format);
  const MaterialPoints points = points_for(material, *format_named(options.format), options);
  DeckNumbers numbers(options.units);
  const bool radioss = options.format.starts_with("radioss"), abaqus = is_abaqus_format(options.format);
  const std::string body = radioss  ? radioss_material(material, points, options, numbers)
                           : abaqus ? abaqus_material(material, points, options, numbers)
                                    : ls_dyna_material(material, points, options, numbers);
  const UnitSystem& units = options.units;
  std::vector<std::string> lines{
      fmt::format("Dashpad {} (commit {}): material card {}", version(), build_facts().git_commit,
                  given.name),
      "Title: " + given.title, "Source: " + given.source,
      fmt::format("Units: {} (mass {}, length {}, time {}); stress {}, rate 1/{}", units.name, units.mass,
                  units.length, units.time, units.pressure, units.time)};
  if (!given.licence.empty()) lines.push_back("Licence: " + given.licence);
  for (const std::string& reservation : given.reservations) lines.push_back("Reservation: " + reservation);
  for (const std::string& remark : not_in_material_deck(given, options))
    lines.push_back("Difference from the card: " + remark);
  if (numbers.rounded() > 0)
    lines.push_back(fmt::format("Numbers rounded to fit 20 columns: {}.", numbers.rounded()));
  const bool ls_dyna = !radioss && !abaqus;
  std::string text = ls_dyna ? "*KEYWORD\n" : "";
  for (const std::string& line : lines) text += comment(radioss ? "#" : abaqus ? "**" : "$", line);
  return text + body + (ls_dyna ? "*END\n" : "");
}

}  // namespace dashpad::output
