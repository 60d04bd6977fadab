// Foams as *MAT keywords of LS-DYNA.

#include <fmt/format.h>

#include "output/deck/material_points.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t columns = 80;

/// A line of a material's card: names of its fields, and numbers in fields of `width` columns.
class CardLine {
 public:
  CardLine(DeckNumbers& numbers, std::size_t width) : numbers_(numbers), width_(width) {}

  CardLine& id(const char* name, int value) { return add(name, fmt::format("{:>{}}", value, width_)); }
  CardLine& plain(const char* name, double value) { return add(name, numbers_.plain(value, width_)); }
  CardLine& stress(const char* name, double value) { return add(name, numbers_.stress(value, width_)); }
  CardLine& density(const char* name, double value) { return add(name, numbers_.density(value, width_)); }
  [[nodiscard]] std::string text() const { return "$" + names_ + "\n" + values_ + "\n"; }

 private:
  CardLine& add(const char* name, const std::string& field) {
    names_ += fmt::format("{:>{}}", name, names_.empty() ? width_ - 1 : width_);
    values_ += field;
    return *this;
  }

  DeckNumbers& numbers_;
  std::size_t width_;
  std::string names_, values_;
};

std::string low_density_cards(const Material& material, const Foam& foam, double modulus, int id,
                              DeckNumbers& numbers, std::size_t width) {
  CardLine first(numbers, width), second(numbers, width);
  first.id("MID", id).density("RO", *material.density).stress("E", modulus).id("LCID", id).plain("TC", 0);
  first.plain("HU", written_unloading_factor(foam)).plain("BETA", 0).plain("DAMP", 0);
  second.plain("SHAPE", foam.unloading_shape).plain("FAIL", 0).plain("BVFLAG", 0).plain("ED", 0);
  second.plain("BETA1", 0).plain("KCON", 0).plain("REF", 0);
  return first.text() + second.text();
}

std::string fu_chang_cards(const Material& material, const Foam& foam, double modulus, int id,
                           DeckNumbers& numbers, std::size_t width) {
  CardLine first(numbers, width), second(numbers, width), third(numbers, width), fourth(numbers, width),
      fifth(numbers, width);
  first.id("MID", id).density("RO", *material.density).stress("E", modulus).plain("KCON", 0).plain("TC", 0);
  first.plain("FAIL", 0).plain("DAMP", 0).id("TBID", id);
  // SFLAG 1: the rates are those of the nominal strain.
  second.plain("BVFLAG", 0).plain("SFLAG", 1).plain("RFLAG", 0).plain("TFLAG", 0).id("PVID", 0);
  second.plain("SRAF", 0).plain("REF", 0).plain("HU", written_unloading_factor(foam));
  for (const char* const name : {"D0", "N0", "N1", "N2", "N3", "C0", "C1", "C2"}) third.plain(name, 0);
  for (const char* const name : {"C3", "C4", "C5", "AIJ", "SIJ", "MINR", "MAXR"}) fourth.plain(name, 0);
  fourth.plain("SHAPE", foam.unloading_shape);
  fifth.plain("EXPON", 1).plain("RIULD", 0);
  return first.text() + second.text() + third.text() + fourth.text() + fifth.text();
}

std::string crushable_cards(const Material& material, const CrushableFoam& foam, bool modified, int id,
                            DeckNumbers& numbers, std::size_t width) {
  CardLine first(numbers, width), second(numbers, width);
  first.id("MID", id).density("RO", *material.density).stress("E", foam.unloading_modulus).plain("PR", 0);
  first.id(modified ? "TID" : "LCID", id).plain("TSC", 0).plain("DAMP", 0);
  if (!modified) return first.id("MODEL", 0).text();
  first.plain("NCYCLE", 0);
  second.plain("SRCLMT", 0).id("SFLAG", 1);
  return first.text() + second.text();
}

std::string curve_text(const TableCurve& curve, int id, const std::string& title, DeckNumbers& numbers) {
  std::string text = fmt::format(
      "*DEFINE_CURVE_TITLE\n{}\n"
      "$     LCID      SIDR       SFA       SFO      OFFA      OFFO    DATTYP\n"
      "{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n"
      "$           STRAIN A1           STRESS O1\n{:>20}{:>20}\n",
      title, id, 0, "1.0", "1.0", "0.0", "0.0", 0, "0.0", "0.0");
  for (std::size_t i = 0; i < curve.strain.size(); ++i)
    text += numbers.plain(curve.strain[i], 20) + numbers.stress(curve.stress[i], 20) + "\n";
  return text;
}

/// The classic kind of table: its curves follow at once.
std::string table_text(const MaterialPoints& points, int id, DeckNumbers& numbers) {
  std::string text = fmt::format(
      "*DEFINE_TABLE_TITLE\nCurves by strain rate\n$     TBID\n{:>10}\n"
      "$               RATE\n",
      id);
  for (const PointsAtRate& at : points.loading) text += numbers.rate(at.rate, 20) + "\n";
  for (std::size_t i = 0; i < points.loading.size(); ++i)
    text +=
        curve_text(points.loading[i].curve, id + 1 + static_cast<int>(i),
                   fmt::format("Nominal stress over strain at {:g} 1/s", points.loading[i].rate), numbers);
  return text;
}

std::string cards_of(const Material& material, const MaterialPoints& points, const std::string& format,
                     int id, DeckNumbers& numbers, std::size_t width) {
  if (const auto* const crushable = std::get_if<CrushableFoam>(&material.law))
    return crushable_cards(material, *crushable, format == "ls-dyna-163", id, numbers, width);
  const Foam& foam = std::get<Foam>(material.law);
  const double modulus = steepest_line(points);
  return format == "ls-dyna-083" ? fu_chang_cards(material, foam, modulus, id, numbers, width)
                                 : low_density_cards(material, foam, modulus, id, numbers, width);
}

const char* keyword_for(const std::string& format) {
  for (const MaterialDeckFormat& each : material_deck_formats())
    if (format == each.name) return each.card;
  return "";
}

}  // namespace

std::string ls_dyna_material(const Material& material, const MaterialPoints& points,
                             const MaterialDeckOptions& options, DeckNumbers& numbers) {
  const bool has_table = options.format == "ls-dyna-083" || options.format == "ls-dyna-163";
  const bool log_log = options.format == "ls-dyna-083" && points.loading.size() > 1 && !points.linear_in_rate;
  // Fields of 20 columns where 10 do not hold a number.
  DeckNumbers tried(options.units);
  (void)cards_of(material, points, options.format, options.first_id, tried, 10);
  const bool is_long = tried.rounded() > 0;
  std::string text =
      fmt::format("{}{}_TITLE{}\n{}\n", keyword_for(options.format), log_log ? "_LOG_LOG_INTERPOLATION" : "",
                  is_long ? " +" : "", deck_title(material, columns));
  text += cards_of(material, points, options.format, options.first_id, numbers, is_long ? 20 : 10);
  return text + (has_table ? table_text(points, options.first_id, numbers)
                           : curve_text(points.loading.front().curve, options.first_id,
                                        "Nominal stress over strain", numbers));
}

}  // namespace dashpad::output
