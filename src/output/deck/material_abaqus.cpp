// Foams of Abaqus: *LOW DENSITY FOAM and *HYPERFOAM, with their curves as test data.

#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "output/deck/deck_text.hpp"

namespace dashpad::output {

std::string abaqus_name(const Material& material) {
  std::string name;
  for (const char c : material.name)
    name += std::isalnum(static_cast<unsigned char>(c)) || c == '-' ? c : '_';
  if (name.empty() || !std::isalpha(static_cast<unsigned char>(name.front()))) name = "FOAM-" + name;
  return name.substr(0, 80);
}

namespace {

class TestRows {
 public:
  explicit TestRows(DeckNumbers& numbers) : numbers_(numbers) {}

  /// Stress and strain of a point with a sign, and a rate if there is one.
  void add(double sign, double strain, double stress, std::optional<double> rate = {}) {
    text_ +=
        number(input::Content::stress, sign * stress) + ", " + number(input::Content::number, sign * strain);
    if (rate) text_ += ", " + number(input::Content::rate, *rate);
    text_ += "\n";
  }
  void add(double sign, const TableCurve& curve, std::optional<double> rate = {}) {
    add(sign, 0, 0, rate);
    for (std::size_t i = 0; i < curve.strain.size(); ++i) add(sign, curve.strain[i], curve.stress[i], rate);
  }
  [[nodiscard]] std::string number(input::Content content, double value) {
    std::string text = numbers_.field(content, value == 0 ? 0 : value);
    return text.substr(text.find_first_not_of(' '));
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  DeckNumbers& numbers_;
  std::string text_;
};

std::string hyperfoam_text(const MaterialPoints& points, const HyperfoamCurve* form, TestRows& rows) {
  if (form == nullptr) {
    rows.add(-1, points.loading.front().curve);
    return "*HYPERFOAM, N=2, TEST DATA INPUT, POISSON=0.0\n*UNIAXIAL TEST DATA\n" + rows.text();
  }
  const bool has_second = form->second_modulus > 0;
  std::string text = fmt::format("*HYPERFOAM, N={}\n", has_second ? 2 : 1);
  const auto add = [&](input::Content content, double value, const char* after) {
    text += rows.number(content, value) + after;
  };
  add(input::Content::stress, form->first_modulus, ", ");
  add(input::Content::number, form->first_exponent, ", ");
  if (has_second) {
    add(input::Content::stress, form->second_modulus, ", ");
    add(input::Content::number, form->second_exponent, ", ");
  }
  return text + (has_second ? "0.0, 0.0\n" : "0.0\n");
}

}  // namespace

std::string abaqus_material(const Material& material, const MaterialPoints& points,
                            const MaterialDeckOptions& options, DeckNumbers& numbers) {
  TestRows rows(numbers);
  std::string text = fmt::format("*MATERIAL, NAME={}\n*DENSITY\n{}\n", abaqus_name(material),
                                 rows.number(input::Content::density, *material.density));
  if (options.format == "abaqus-hyperfoam") {
    const auto* const form = std::get_if<HyperfoamCurve>(&foam_curves(material.law)->base);
    return text + hyperfoam_text(points, options.places_points() ? nullptr : form, rows);
  }
  for (const PointsAtRate& at : points.loading) rows.add(1, at.curve, at.rate);
  // Unloading is given at the negative rate.
  if (points.unloading) rows.add(1, *points.unloading, -points.loading.front().rate);
  return text + "*LOW DENSITY FOAM, RATE EXTRAPOLATION=NO\n*UNIAXIAL TEST DATA, DIRECTION=COMPRESSION\n" +
         rows.text();
}

}  // namespace dashpad::output
