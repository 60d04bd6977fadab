#include <algorithm>

#include <fmt/format.h>

#include "output/deck/deck_text.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t columns = 80;

std::string curve_text(const TableCurve& curve, int id, const std::string& title, DeckNumbers& numbers) {
  std::string points = numbers.point(0, 0);
  for (std::size_t i = 0; i < curve.strain.size(); ++i)
    points += numbers.point(curve.strain[i], curve.stress[i]);
  return define_curve(title, id, "$           STRAIN A1           STRESS O1", points);
}

/// A table of the classic kind, directly followed by its curves.
std::string table_text(const MaterialPoints& points, int id, DeckNumbers& numbers) {
  std::string text = fmt::format(
      "*DEFINE_TABLE_TITLE\nCurves by strain rate\n$     TBID\n{:>10}\n"
      "$               RATE\n",
      id);
  for (const PointsAtRate& at : points.loading) text += numbers.field(input::Content::rate, at.rate) + "\n";
  for (std::size_t i = 0; i < points.loading.size(); ++i)
    text +=
        curve_text(points.loading[i].curve, id + 1 + static_cast<int>(i),
                   fmt::format("Nominal stress against strain at {:g} 1/s", points.loading[i].rate), numbers);
  return text;
}

const input::LsDynaFoam& foam_of(const std::string& format) {
  return *std::ranges::find_if(input::ls_dyna_foams,
                               [&](const input::LsDynaFoam& each) { return format.ends_with(each.number); });
}

/// SFLAG 1: rates of the nominal strain.
std::string cards_of(const Material& material, const MaterialPoints& points, const std::string& format,
                     int id, DeckNumbers& numbers, std::size_t width) {
  CardValues values{{"MID", id},
                    {"LCID", id},
                    {"TBID", id},
                    {"TID", id},
                    {"SFLAG", 1},
                    {"EXPON", 1},
                    {"RO", *material.density}};
  if (const auto* const crushable = std::get_if<CrushableFoam>(&material.law)) {
    values["E"] = crushable->unloading_modulus;
  } else {
    const Foam& foam = std::get<Foam>(material.law);
    values["E"] = steepest_line(points);
    values["HU"] = written_unloading_factor(foam);
    values["SHAPE"] = foam.unloading_shape;
  }
  std::string text;
  for (const input::DeckCard card : foam_of(format).cards)
    text += card_text('$', card, values, numbers, width);
  return text;
}

}  // namespace

std::string ls_dyna_material(const Material& material, const MaterialPoints& points,
                             const MaterialDeckOptions& options, DeckNumbers& numbers) {
  const bool has_table = options.format == "ls-dyna-083" || options.format == "ls-dyna-163";
  const bool log_log = options.format == "ls-dyna-083" && points.loading.size() > 1 && !points.linear_in_rate;
  // Fields have 20 columns if 10 do not hold a number.
  DeckNumbers tried(options.units);
  (void)cards_of(material, points, options.format, options.first_id, tried, 10);
  const bool is_long = tried.rounded() > 0;
  std::string text = fmt::format("*MAT_{}{}_TITLE{}\n{}\n", foam_of(options.format).words,
                                 log_log ? "_LOG_LOG_INTERPOLATION" : "", is_long ? " +" : "",
                                 deck_title(material, columns));
  text += cards_of(material, points, options.format, options.first_id, numbers, is_long ? 20 : 10);
  return text + (has_table ? table_text(points, options.first_id, numbers)
                           : curve_text(points.loading.front().curve, options.first_id,
                                        "Nominal stress against strain", numbers));
}

}  // namespace dashpad::output
