#include "dashpad/output/material_deck.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/output/deck/exports.hpp"
#include "dashpad/version.hpp"
#include "output/deck/deck_text.hpp"

namespace dashpad::output {

namespace {

constexpr std::array<MaterialDeckFormat, 8> formats_of_materials{{
    {"ls-dyna-057", "*MAT_LOW_DENSITY_FOAM", Foam::name, false},
    {"ls-dyna-083", "*MAT_FU_CHANG_FOAM", Foam::name, true},
    {"ls-dyna-063", "*MAT_CRUSHABLE_FOAM", CrushableFoam::name, false},
    {"ls-dyna-163", "*MAT_MODIFIED_CRUSHABLE_FOAM", CrushableFoam::name, true},
    {"radioss-70", "/MAT/LAW70", Foam::name, true},
    {"radioss-90", "/MAT/LAW90", Foam::name, true},
    {"radioss-33", "/MAT/LAW33", CrushableFoam::name, false},
    {"radioss-62", "/MAT/LAW62", ViscoelasticFoam::name, true},
}};

const MaterialDeckFormat* format_named(const std::string& name) {
  const auto* const found =
      std::ranges::find_if(formats_of_materials, [&](const auto& each) { return name == each.name; });
  return found == formats_of_materials.end() ? nullptr : found;
}

void tell_of_foam(const Foam& foam, const MaterialDeckOptions& options, std::vector<std::string>& remarks) {
  if (foam.friction > 0) remarks.push_back(fmt::format("friction = {:g} is left out.", foam.friction));
  if (foam.unloading_curve && options.format != "radioss-70")
    remarks.emplace_back(
        "The measured unloading curve is left out; the deck unloads without loss on its slowest "
        "curve. Set HU and SHAPE.");
  else if (!foam.unloading_curve && foam.unloading_factor == 0)
    remarks.push_back(
        fmt::format("unloading_factor = 0 is given as {:g}, since the solver takes 0 for not given.",
                    written_unloading_factor(foam)));
}

/// Remarks on the rates, besides those on the curves.
void tell_of_rates(const FoamCurves& curves, const MaterialDeckFormat& format, const MaterialPoints& points,
                   std::vector<std::string>& remarks) {
  const bool has_effect = !std::holds_alternative<NoRateEffect>(curves.rate_effect);
  if (!format.has_rates)
    remarks.push_back(fmt::format("The curve is that of {:g} 1/s, which the deck cannot state{}.",
                                  curves.slowest_rate, has_effect ? "; the rate effect is left out" : ""));
  if (!format.has_rates || !has_effect) return;
  if (!points.linear_in_rate && std::string(format.name) != "ls-dyna-083")
    remarks.emplace_back(
        "Between two rates the card's stress is a power of the rate; the solver's is linear in the rate.");
  if (points.linear_in_rate || std::string(format.name) != "ls-dyna-083")
    remarks.emplace_back(
        "Above the highest rate the solver extrapolates; the card keeps the curve of that rate.");
  if (format.law == Foam::name)
    remarks.emplace_back("recoil and lag_strain are left out: where loading ends the solver's stress jumps.");
}

MaterialPoints points_for(const Material& material, const MaterialDeckFormat& format) {
  MaterialPoints points = material_points(material.law, format.has_rates);
  if (std::string(format.name) != "radioss-70") points.unloading.reset();
  return points;
}

/// The law as the deck holds it. If a measured way back is left out, HU and SHAPE have no meaning either.
Material as_in_deck(Material material, const std::string& format) {
  if (auto* const foam = std::get_if<Foam>(&material.law); foam != nullptr && foam->unloading_curve)
    if (format != "radioss-70") foam->unloading_factor = foam->unloading_shape = 1;
  return material;
}

}  // namespace

std::span<const MaterialDeckFormat> material_deck_formats() { return formats_of_materials; }

std::string why_no_material_deck(const Material& material, const MaterialDeckOptions& options) {
  const MaterialDeckFormat* const format = format_named(options.format);
  if (format == nullptr) return fmt::format("unknown format \"{}\"", options.format);
  const std::string law = name_of(material.law);
  if (law != format->law)
    return fmt::format("{} is a card for the law {}, and {} has the law {}", format->card, format->law,
                       material.name, law);
  if (!material.density)
    return fmt::format("{} has no density, which {} needs; add density = \"... kg/m3\" to the card",
                       material.name, format->card);
  if (options.first_id < 1 || options.first_id > highest_curve_id - 2 * static_cast<int>(max_rates))
    return fmt::format("number {}: must be from 1 to {}", options.first_id,
                       highest_curve_id - 2 * static_cast<int>(max_rates));
  return "";
}

std::vector<std::string> not_in_material_deck(const Material& material, const MaterialDeckOptions& options) {
  const MaterialDeckFormat* const format = format_named(options.format);
  if (format == nullptr) return {};
  if (std::holds_alternative<ViscoelasticFoam>(material.law))
    return {
        "In the solver the second Piola-Kirchhoff stress relaxes, in the card the nominal stress; they agree "
        "for a sudden strain and after long times, but not for a strain that changes in between."};
  const MaterialPoints points = points_for(material, *format);
  std::vector<std::string> remarks = points.remarks;
  std::visit(
      [&]<class Law>(const Law& law) {
        if constexpr (SharesSlip<Law>) tell_of_rates(law.curves, *format, points, remarks);
        if constexpr (std::is_same_v<Law, Foam>) tell_of_foam(law, options, remarks);
      },
      material.law);
  remarks.emplace_back(
      "Between its points the card's curve is a monotone cubic, but the solver's is piecewise linear; "
      "beyond the last point they are continued differently (continuation_exponent).");
  if (format->law == Foam::name)
    remarks.emplace_back(
        "The modulus is the steepest slope of the curves; the solver uses it for tension, contact "
        "and the time step.");
  return remarks;
}

std::string material_deck(const Material& given, const MaterialDeckOptions& options) {
  if (const std::string why = why_no_material_deck(given, options); !why.empty())
    throw std::invalid_argument(why);
  const Material material = as_in_deck(given, options.format);
  const MaterialPoints points = points_for(material, *format_named(options.format));
  DeckNumbers numbers(options.units);
  const bool radioss = options.format.starts_with("radioss");
  const std::string body = radioss ? radioss_material(material, points, options, numbers)
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
    lines.push_back("Not in this deck: " + remark);
  if (numbers.rounded() > 0)
    lines.push_back(
        fmt::format("Rounded to the digits that 20 columns hold: {} numbers.", numbers.rounded()));
  std::string text = radioss ? "" : "*KEYWORD\n";
  for (const std::string& line : lines) text += comment(radioss ? "#" : "$", line);
  return text + body + (radioss ? "" : "*END\n");
}

}  // namespace dashpad::output
