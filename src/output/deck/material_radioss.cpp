#include <utility>

#include <fmt/format.h>

#include "output/deck/deck_text.hpp"

namespace dashpad::output {

namespace deck = input::deck;
using input::Content;

namespace {

constexpr std::size_t columns_of_title = 100;

std::string function_text(const TableCurve& curve, int id, const std::string& title, bool mirrored,
                          DeckNumbers& numbers) {
  std::string text = fmt::format("/FUNCT/{}\n{}\n#                  X                   Y\n", id, title);
  const std::string origin = numbers.point(0, 0);
  const auto point = [&](std::size_t i) {
    return numbers.point(mirrored ? -curve.strain[i] : curve.strain[i], curve.stress[i]);
  };
  const std::size_t count = curve.strain.size();
  if (!mirrored) text += origin;
  for (std::size_t i = 0; i < count; ++i) text += point(mirrored ? count - 1 - i : i);
  return mirrored ? text + origin : text;
}

std::string rows_text(const MaterialPoints& points, int first_id, DeckNumbers& numbers) {
  std::string text = "#  fct_IDL             Eps_dot              Fscale\n";
  for (std::size_t i = 0; i < points.loading.size(); ++i)
    text += card_line(
        deck::function_row,
        {{"fct_ID", first_id + static_cast<int>(i)}, {"Eps_dot", points.loading[i].rate}, {"Fscale", 1}},
        numbers);
  return text;
}

std::string head_text(const Material& material, const char* law, int id, DeckNumbers& numbers) {
  return fmt::format("/MAT/{}/{}\n{}\n", law, id, deck_title(material, columns_of_title)) +
         card_text('#', deck::density_line, {{"RHO_I", *material.density}}, numbers);
}

std::string loading_functions(const MaterialPoints& points, int first_id, DeckNumbers& numbers) {
  std::string text;
  for (std::size_t i = 0; i < points.loading.size(); ++i)
    text += function_text(points.loading[i].curve, first_id + static_cast<int>(i),
                          fmt::format("Nominal stress against strain at {:g} 1/s", points.loading[i].rate),
                          false, numbers);
  return text;
}

std::string law_90(const Material& material, const Foam& foam, const MaterialPoints& points, int id,
                   DeckNumbers& numbers) {
  std::string text = head_text(material, "LAW90", id, numbers);
  text += card_text('#', deck::law_90_elastic, {{"E0", steepest_line(points)}}, numbers);
  text += card_text('#', deck::law_90_flags,
                    {{"NL", points.loading.size()},
                     {"Shape", foam.unloading_shape},
                     {"Hys", written_unloading_factor(foam)},
                     {"Alpha", 1}},
                    numbers);
  return text + rows_text(points, id, numbers) + loading_functions(points, id, numbers);
}

std::string law_70(const Material& material, const Foam& foam, const MaterialPoints& points, int id,
                   DeckNumbers& numbers) {
  std::string text = head_text(material, "LAW70", id, numbers);
  const double modulus = steepest_line(points);
  const int id_back = id + static_cast<int>(points.loading.size());
  text +=
      card_text('#', deck::law_70_elastic, {{"E0", modulus}, {"E_max", modulus}, {"EPS_max", 1}}, numbers);
  // Iflag 0: unloading function; 4: Shape and Hys applied to the whole stress.
  text += card_text('#', deck::law_70_flags,
                    {{"NL", points.loading.size()},
                     {"NuL", points.unloading ? 1 : 0},
                     {"Iflag", points.unloading ? 0 : 4},
                     {"Shape", foam.unloading_shape},
                     {"Hys", written_unloading_factor(foam)}},
                    numbers);
  text += rows_text(points, id, numbers);
  if (points.unloading)
    text += "# fct_IDuL             Eps_dot              Fscale\n" +
            card_line(deck::function_row, {{"fct_ID", id_back}, {"Fscale", 1}}, numbers);
  text += loading_functions(points, id, numbers);
  if (points.unloading)
    text += function_text(*points.unloading, id_back, "Unloading from the last strain", false, numbers);
  return text;
}

std::string law_33(const Material& material, const CrushableFoam& foam, const MaterialPoints& points, int id,
                   DeckNumbers& numbers) {
  std::string text = head_text(material, "LAW33", id, numbers);
  text += card_text('#', deck::law_33_elastic,
                    {{"E", foam.unloading_modulus}, {"fct_IDf", id}, {"Fscale", 1}}, numbers);
  text += card_text('#', deck::law_33_gas, {}, numbers);
  text += card_text('#', input::DeckCard(deck::law_33_yield).first(3), {}, numbers);
  return text + function_text(points.loading.front().curve, id,
                              "Yield stress against volumetric strain V/V0 - 1, negative in compression",
                              true, numbers);
}

/// The moduli are those of a sudden strain, and the ratios shares of them: Flag_Rigi 0, which every version
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
  text += card_text('#', deck::law_62_flags, {{"N", terms.size()}, {"M", branches.size()}, {"Flag_Visc", 1}},
                    numbers);
  text += "#               mu_i\n";
  for (const auto& [modulus, exponent] : terms) text += numbers.field(Content::stress, modulus);
  text += "\n#            alpha_i\n";
  for (const auto& [modulus, exponent] : terms) text += numbers.field(Content::number, exponent);
  if (!branches.empty()) {
    text += "\n#            gamma_i\n";
    for (const auto& [ratio, time] : branches) text += numbers.field(Content::number, ratio);
    text += "\n#              tau_i\n";
    for (const auto& [ratio, time] : branches) text += numbers.field(Content::time, time);
  }
  text += "\n#               nu_i\n";
  for (std::size_t i = 0; i < terms.size(); ++i) text += numbers.field(Content::number, 0);
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
