// Foams as /MAT blocks of the Radioss starter.

#include <utility>

#include <fmt/format.h>

#include "output/deck/material_points.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t columns_of_title = 100;

std::string function_text(const TableCurve& curve, int id, const std::string& title, bool mirrored,
                          DeckNumbers& numbers) {
  std::string text = fmt::format("/FUNCT/{}\n{}\n#                  X                   Y\n", id, title);
  const std::string origin = fmt::format("{:>20}{:>20}\n", "0.0", "0.0");
  const auto point = [&](std::size_t i) {
    const double strain = mirrored ? -curve.strain[i] : curve.strain[i];
    return numbers.plain(strain, 20) + numbers.stress(curve.stress[i], 20) + "\n";
  };
  const std::size_t count = curve.strain.size();
  if (!mirrored) text += origin;
  for (std::size_t i = 0; i < count; ++i) text += point(mirrored ? count - 1 - i : i);
  return mirrored ? text + origin : text;
}

std::string rows_text(const MaterialPoints& points, int first_id, DeckNumbers& numbers) {
  std::string text = "#  fct_IDL             Eps_dot              Fscale\n";
  for (std::size_t i = 0; i < points.loading.size(); ++i)
    text += fmt::format("{:>10}{}{:>20}\n", first_id + static_cast<int>(i),
                        numbers.rate(points.loading[i].rate, 20), "1.0");
  return text;
}

std::string head_text(const Material& material, const char* law, int id, DeckNumbers& numbers) {
  return fmt::format("/MAT/{}/{}\n{}\n#              RHO_I\n{}\n", law, id,
                     deck_title(material, columns_of_title), numbers.density(*material.density, 20));
}

std::string loading_functions(const MaterialPoints& points, int first_id, DeckNumbers& numbers) {
  std::string text;
  for (std::size_t i = 0; i < points.loading.size(); ++i)
    text += function_text(points.loading[i].curve, first_id + static_cast<int>(i),
                          fmt::format("Nominal stress over strain at {:g} 1/s", points.loading[i].rate),
                          false, numbers);
  return text;
}

std::string law_90(const Material& material, const Foam& foam, const MaterialPoints& points, int id,
                   DeckNumbers& numbers) {
  std::string text = head_text(material, "LAW90", id, numbers);
  text += fmt::format("#                 E0                  nu\n{}{:>20}\n",
                      numbers.stress(steepest_line(points), 20), "0.0");
  text += fmt::format(
      "#       NL   Ismooth                Fcut               Shape                 Hys               Alpha\n"
      "{:>10}{:>10}{:>20}{}{}{:>20}\n",
      points.loading.size(), 0, "0.0", numbers.plain(foam.unloading_shape, 20),
      numbers.plain(written_unloading_factor(foam), 20), "1.0");
  return text + rows_text(points, id, numbers) + loading_functions(points, id, numbers);
}

std::string law_70(const Material& material, const Foam& foam, const MaterialPoints& points, int id,
                   DeckNumbers& numbers) {
  std::string text = head_text(material, "LAW70", id, numbers);
  const std::string modulus = numbers.stress(steepest_line(points), 20);
  const int id_back = id + static_cast<int>(points.loading.size());
  text += fmt::format(
      "#                 E0                  nu               E_max             EPS_max     Itens\n"
      "{}{:>20}{}{:>20}{:>10}\n",
      modulus, "0.0", modulus, "1.0", 0);
  // Iflag 0: by the unloading function; 4: the whole stress by Shape and Hys.
  text += fmt::format(
      "#               Fcut   Fsmooth        NL       NuL     Iflag               Shape                 Hys\n"
      "{:>20}{:>10}{:>10}{:>10}{:>10}{}{}\n",
      "0.0", 0, points.loading.size(), points.unloading ? 1 : 0, points.unloading ? 0 : 4,
      numbers.plain(foam.unloading_shape, 20), numbers.plain(written_unloading_factor(foam), 20));
  text += rows_text(points, id, numbers);
  if (points.unloading)
    text += fmt::format("# fct_IDuL             Eps_dot              Fscale\n{:>10}{:>20}{:>20}\n", id_back,
                        "0.0", "1.0");
  text += loading_functions(points, id, numbers);
  if (points.unloading)
    text += function_text(*points.unloading, id_back, "Way back from the last strain", false, numbers);
  return text;
}

std::string law_33(const Material& material, const CrushableFoam& foam, const MaterialPoints& points, int id,
                   DeckNumbers& numbers) {
  std::string text = head_text(material, "LAW33", id, numbers);
  text += fmt::format("#                  E        Ka   fct_IDf              Fscale\n{}{:>10}{:>10}{:>20}\n",
                      numbers.stress(foam.unloading_modulus, 20), 0, id, "1.0");
  text += fmt::format("#                 P0                 Phi             Gamma_0\n{0:>20}{0:>20}{0:>20}\n",
                      "0.0");
  text += fmt::format("#                  A                   B                   C\n{0:>20}{0:>20}{0:>20}\n",
                      "0.0");
  return text + function_text(points.loading.front().curve, id,
                              "Yield stress over volumetric strain V/V0 - 1, negative in compression", true,
                              numbers);
}

/// The moduli are those of a sudden strain, and the ratios are shares of it: Flag_Rigi 0, which every version
/// understands. Flag_Visc 1: the whole stress relaxes.
std::string law_62(const Material& material, const ViscoelasticFoam& foam, int id, DeckNumbers& numbers) {
  const double sudden = 1 + foam.first_share + foam.second_share;
  using Rows = std::vector<std::pair<double, double>>;
  Rows terms, branches;
  for (const auto& [modulus, exponent] : {std::pair{foam.first_modulus, foam.first_exponent},
                                          std::pair{foam.second_modulus, foam.second_exponent}})
    if (modulus > 0) terms.emplace_back(modulus * sudden, exponent);
  for (const auto& [share, time] :
       {std::pair{foam.first_share, foam.first_time}, std::pair{foam.second_share, foam.second_time}})
    if (share > 0) branches.emplace_back(share / sudden, time);

  std::string text = head_text(material, "LAW62", id, numbers);
  text += fmt::format(
      "#                 Nu         N         M              mu_max Flag_Visc Flag_Rigi\n"
      "{:>20}{:>10}{:>10}{:>20}{:>10}{:>10}\n",
      "0.0", terms.size(), branches.size(), "0.0", 1, 0);
  text += "#               mu_i\n";
  for (const auto& [modulus, exponent] : terms) text += numbers.stress(modulus, 20);
  text += "\n#            alpha_i\n";
  for (const auto& [modulus, exponent] : terms) text += numbers.plain(exponent, 20);
  if (!branches.empty()) {
    text += "\n#            gamma_i\n";
    for (const auto& [ratio, time] : branches) text += numbers.plain(ratio, 20);
    text += "\n#              tau_i\n";
    for (const auto& [ratio, time] : branches) text += numbers.time(time, 20);
  }
  text += "\n#               nu_i\n";
  for (std::size_t i = 0; i < terms.size(); ++i) text += fmt::format("{:>20}", "0.0");
  return text + "\n";
}

}  // namespace

std::string radioss_material(const Material& material, const MaterialPoints& points,
                             const MaterialDeckOptions& options, DeckNumbers& numbers) {
  if (const auto* const crushable = std::get_if<CrushableFoam>(&material.law))
    return law_33(material, *crushable, points, options.first_id, numbers);
  if (const auto* const slow = std::get_if<ViscoelasticFoam>(&material.law))
    return law_62(material, *slow, options.first_id, numbers);
  const Foam& foam = std::get<Foam>(material.law);
  return options.format == "radioss-70" ? law_70(material, foam, points, options.first_id, numbers)
                                        : law_90(material, foam, points, options.first_id, numbers);
}

}  // namespace dashpad::output
